#include "simcore/io/json_format.h"

#include <cmath>

#include <fmt/format.h>

namespace simcore::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLineWidth = 110;

std::string scalar(const Json& value) {
    if (!value.is_number_float()) {
        return value.dump();
    }
    const std::string text = fmt::format("{}", value.get<double>());
    return text == "-0" ? "-0.0" : text;  // "-0" would be read as a whole number, without its sign
}

std::string inlined(const Json& value) {
    if (!value.is_structured()) {
        return scalar(value);
    }
    std::string text = value.is_object() ? "{" : "[";
    bool first = true;
    for (auto it = value.begin(); it != value.end(); ++it) {
        text += first ? "" : ", ";
        first = false;
        if (value.is_object()) {
            text += Json(it.key()).dump() + ": ";
        }
        text += inlined(*it);
    }
    return text + (value.is_object() ? "}" : "]");
}

void write(const Json& value, std::size_t indent, std::size_t column, std::string& out) {
    const std::string oneLine = inlined(value);
    const bool topLevel = indent == 0;
    if (!value.is_structured() || value.empty() ||
        (!topLevel && column + oneLine.size() <= kLineWidth)) {
        out += oneLine;
        return;
    }
    const std::string pad(indent + 2, ' ');
    out += value.is_object() ? "{\n" : "[\n";
    bool first = true;
    for (auto it = value.begin(); it != value.end(); ++it) {
        out += first ? "" : ",\n";
        first = false;
        std::string head = pad;
        if (value.is_object()) {
            head += Json(it.key()).dump() + ": ";
        }
        out += head;
        write(*it, indent + 2, head.size() + 1, out);
    }
    out += "\n" + std::string(indent, ' ') + (value.is_object() ? "}" : "]");
}

}  // namespace

std::string formatJson(const Json& value) {
    std::string out;
    write(value, 0, 0, out);
    out += "\n";
    return out;
}

nlohmann::ordered_json numberOrNull(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

}  // namespace simcore::io
