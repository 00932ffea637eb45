#include "simcore/io/project_file.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "simcore/base/text.h"
#include "simcore/io/atomic_file.h"
#include "simcore/io/json_format.h"
#include "simcore/project/fields.h"
#include "simcore/project/names.h"

namespace simcore::io {
namespace {

using Json = nlohmann::ordered_json;
// Sorted keys: looking one up among very many must not be slow.
using ReadJson = nlohmann::json;
using project::Quantity;

constexpr const char* kFormat = "roverstudio-project";
constexpr const char* kPartsFormat = "roverstudio-parts";
constexpr int kVersion = 1;
// A project nests about ten levels; this only keeps hostile files from filling the stack, since
// JSON is written recursively.
constexpr int kDeepestNesting = 100;

/// What a piece of JSON is, for people.
std::string typeOf(const ReadJson& json) {
    return json.is_null()      ? Text::of("null")
           : json.is_boolean() ? Text::of("boolean")
           : json.is_string()  ? Text::of("string")
           : json.is_array()   ? Text::of("array")
           : json.is_object()  ? Text::of("object")
                               : Text::of("number");
}

/// Reads JSON into the value tree; collects every problem instead of stopping at the first.
class Reader {
  public:
    Reader(std::string source, Problems& problems)
        : source_(std::move(source)),
          problems_(problems) {}

    template <class T>
    void read(const ReadJson& json, const std::string& place, T& value);

    void problem(const std::string& place, std::string reason, std::string remedy) {
        problems_.push_back({Severity::Critical,
                             source_ + ": " + (place.empty() ? Text::of("file") : place),
                             std::move(reason), std::move(remedy)});
    }

  private:
    template <class T>
    class FieldReader;

    /// @param wanted  marked
    void wrongType(const std::string& place, const char* wanted, const ReadJson& json) {
        problem(place, Text::of("expected {}, found {}.", Text::translated(wanted), typeOf(json)),
                Text::of("Correct the value."));
    }

    void readQuantity(const ReadJson& json, const std::string& place, Quantity& value) {
        if (json.is_number()) {
            value = Quantity(json.get<double>());
        } else if (json.is_string() && !json.get_ref<const std::string&>().empty()) {
            value = Quantity::expression(json.get<std::string>());
        } else {
            wrongType(place, Text::mark("a number or an expression in quotes"), json);
        }
    }

    template <class Enum>
    void readEnum(const ReadJson& json, const std::string& place, Enum& value) {
        if (!json.is_string()) {
            wrongType(place, Text::mark("a name in quotes"), json);
            return;
        }
        if (const auto found = project::fromName<Enum>(json.get<std::string>())) {
            value = *found;
        } else {
            problem(place, Text::of("'{}' is not known.", json.get<std::string>()),
                    Text::of("Use one of: {}.", fmt::join(project::allNames<Enum>(), ", ")));
        }
    }

    template <class T, std::size_t N>
    void readArray(const ReadJson& json, const std::string& place, std::array<T, N>& value) {
        if (!json.is_array() || json.size() != N) {
            problem(place, Text::of("expected a list of {} numbers.", N),
                    Text::of("Give exactly that many, in square brackets."));
            return;
        }
        for (std::size_t i = 0; i < N; ++i) {
            read(json[i], fmt::format("{}[{}]", place, i), value[i]);
        }
    }

    template <class T>
    void readVector(const ReadJson& json, const std::string& place, std::vector<T>& value) {
        if (!json.is_array()) {
            wrongType(place, Text::mark("a list"), json);
            return;
        }
        value.clear();
        value.resize(json.size());
        for (std::size_t i = 0; i < json.size(); ++i) {
            std::string itemPlace = fmt::format("{}[{}]", place, i);
            if (json[i].is_object() && json[i].contains("name") && json[i]["name"].is_string()) {
                itemPlace += " (" + json[i]["name"].template get<std::string>() + ")";
            }
            read(json[i], itemPlace, value[i]);
        }
    }

    /// Terrains may hold terrains; the deepest project that makes sense has fewer levels.
    static constexpr int kDeepest = 20;

    std::string source_;
    Problems& problems_;
    int depth_ = 0;
};

template <class T>
class Reader::FieldReader {
  public:
    FieldReader(Reader& reader, const ReadJson& json, const std::string& place, T& value)
        : reader_(reader),
          json_(json),
          place_(place),
          value_(value) {}

    template <class M>
    void required(const char* key, M T::*member) {
        if (!json_.contains(key)) {
            known_.insert(key);
            reader_.problem(place_, Text::of("'{}' is missing.", key), Text::of("Add it."));
            return;
        }
        optional(key, member);
    }

    template <class M>
    void optional(const char* key, M T::*member) {
        known_.insert(key);
        const auto found = json_.find(key);
        if (found != json_.end()) {
            reader_.read(*found, place_.empty() ? key : place_ + "." + key, value_.*member);
        }
    }

    void reportUnknownKeys() const {
        for (auto it = json_.begin(); it != json_.end(); ++it) {
            if (!known_.contains(it.key())) {
                reader_.problem(place_, Text::of("'{}' is not a known key.", it.key()),
                                Text::of("Known here: {}.", fmt::join(known_, ", ")));
            }
        }
    }

    void know(const char* key) { known_.insert(key); }

  private:
    Reader& reader_;
    const ReadJson& json_;
    const std::string& place_;
    T& value_;
    std::set<std::string> known_;
};

template <class T>
inline constexpr bool kIsVector = false;
template <class T>
inline constexpr bool kIsVector<std::vector<T>> = true;
template <class T>
inline constexpr bool kIsArray = false;
template <class T, std::size_t N>
inline constexpr bool kIsArray<std::array<T, N>> = true;
template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

template <class T>
void Reader::read(const ReadJson& json, const std::string& place, T& value) {
    if constexpr (std::is_same_v<T, Quantity>) {
        readQuantity(json, place, value);
    } else if constexpr (std::is_same_v<T, std::string>) {
        json.is_string() ? void(value = json.get<std::string>())
                         : wrongType(place, Text::mark("text in quotes"), json);
    } else if constexpr (std::is_same_v<T, bool>) {
        json.is_boolean() ? void(value = json.get<bool>())
                          : wrongType(place, Text::mark("true or false"), json);
    } else if constexpr (std::is_same_v<T, int>) {
        const bool fits = json.is_number_integer() && json.get<double>() >= -2147483648.0 &&
                          json.get<double>() <= 2147483647.0;
        fits ? void(value = json.get<int>()) : wrongType(place, Text::mark("a whole number"), json);
    } else if constexpr (std::is_same_v<T, double>) {
        json.is_number() ? void(value = json.get<double>())
                         : wrongType(place, Text::mark("a number"), json);
    } else if constexpr (std::is_enum_v<T>) {
        readEnum(json, place, value);
    } else if constexpr (kIsArray<T>) {
        readArray(json, place, value);
    } else if constexpr (kIsVector<T>) {
        readVector(json, place, value);
    } else if constexpr (kIsOptional<T>) {
        read(json, place, value.emplace());
    } else {
        if (!json.is_object()) {
            wrongType(place, Text::mark("an object in braces"), json);
            return;
        }
        if (depth_ >= kDeepest) {
            problem(place, Text::of("objects lie too deep within each other."),
                    Text::of("Take some of them out."));
            return;
        }
        ++depth_;
        FieldReader<T> fields(*this, json, place, value);
        if constexpr (std::is_same_v<T, project::Project>) {
            fields.know("format");
            fields.know("version");
        }
        project::describe(fields, static_cast<const T*>(nullptr));
        fields.reportUnknownKeys();
        --depth_;
    }
}

/// Writes the value tree to JSON; optional fields at their default are left out.
template <class T>
Json toJson(const T& value);

template <class T>
class FieldWriter {
  public:
    explicit FieldWriter(const T& value) : value_(value) {}

    template <class M>
    void required(const char* key, M T::*member) {
        json[key] = toJson(value_.*member);
    }

    template <class M>
    void optional(const char* key, M T::*member) {
        static const T defaults{};
        if (!(value_.*member == defaults.*member)) {
            required(key, member);
        }
    }

    Json json = Json::object();

  private:
    const T& value_;
};

template <class T>
Json toJson(const T& value) {
    if constexpr (std::is_same_v<T, Quantity>) {
        return value.isLiteral() ? Json(value.literal()) : Json(value.text());
    } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
        return Json(value);
    } else if constexpr (std::is_enum_v<T>) {
        return Json(project::nameOf(value));
    } else if constexpr (kIsArray<T> || kIsVector<T>) {
        Json list = Json::array();
        for (const auto& item : value) {
            list.push_back(toJson(item));
        }
        return list;
    } else if constexpr (kIsOptional<T>) {
        return toJson(value.value());
    } else {
        FieldWriter<T> fields(value);
        project::describe(fields, static_cast<const T*>(nullptr));
        return fields.json;
    }
}

std::string lineAndColumn(std::string_view text, std::size_t byte) {
    std::size_t line = 1;
    std::size_t column = 1;
    for (std::size_t i = 0; i + 1 < byte && i < text.size(); ++i) {
        if (text[i] == '\n') {
            ++line;
            column = 1;
        } else {
            ++column;
        }
    }
    return Text::of("line {}, column {}", line, column);
}

/// Brackets within brackets beyond kDeepestNesting.
struct TooDeep {};

/// Parses JSON and reports keys given twice: the library would keep the last one silently.
ReadJson parseJson(std::string_view text, Reader& reader) {
    std::vector<std::set<std::string>> keys;
    const auto callback = [&](int depth, nlohmann::json::parse_event_t event, ReadJson& parsed) {
        if (depth > kDeepestNesting) {
            throw TooDeep{};
        }
        if (event == ReadJson::parse_event_t::object_start) {
            keys.emplace_back();
        } else if (event == ReadJson::parse_event_t::object_end) {
            keys.pop_back();
        } else if (event == ReadJson::parse_event_t::key &&
                   !keys.back().insert(parsed.get<std::string>()).second) {
            reader.problem(
                "", Text::of("key '{}' is given twice in one object.", parsed.get<std::string>()),
                Text::of("Remove one of them."));
        }
        return true;
    };
    return ReadJson::parse(text, callback);
}

/// The JSON of a text, with line and column where it is none.
Result<ReadJson> readJson(std::string_view text, const std::string& sourceName, Reader& reader) {
    try {
        return parseJson(text, reader);
    } catch (const ReadJson::parse_error& error) {
        std::string reason = error.what();
        reason = reason.substr(reason.find("] ") == std::string::npos ? 0 : reason.find("] ") + 2);
        return Problem{
            Severity::Critical, sourceName + ": " + lineAndColumn(text, error.byte),
            Text::of("this is not valid JSON ({}).", reason),
            Text::of("Correct the text there; a comma or a quote is often missing just before.")};
    } catch (const TooDeep&) {
        return Problem{Severity::Critical, sourceName,
                       Text::of("its brackets nest deeper than {} levels.", kDeepestNesting),
                       Text::of("Correct the file; a project needs about ten.")};
    } catch (const ReadJson::exception& error) {
        return Problem{Severity::Critical, sourceName,
                       Text::of("the text cannot be read ({}).", error.what()),
                       Text::of("Correct the file.")};
    }
}

}  // namespace

Result<project::Project> parseProject(std::string_view text, const std::string& sourceName) {
    Problems problems;
    Reader reader(sourceName, problems);
    const auto parsed = readJson(text, sourceName, reader);
    if (!parsed) {
        return parsed.problems();
    }
    const ReadJson& json = *parsed;
    if (!json.is_object() || !json.contains("format") || json["format"] != kFormat) {
        return Problem{Severity::Critical, sourceName,
                       Text::of("this is not a RoverStudio project."),
                       Text::of("A project has \"format\": \"{}\".", kFormat)};
    }
    if (!json.contains("version") || !json["version"].is_number_integer() ||
        json["version"] != kVersion) {
        return Problem{
            Severity::Critical, sourceName,
            Text::of("file version {} is not one this program reads ({}).",
                     json.contains("version") ? json["version"].dump() : Text::of("(none)"),
                     kVersion),
            Text::of("Open it with the RoverStudio version that wrote it.")};
    }
    project::Project project;
    reader.read(json, "", project);
    if (hasCritical(problems)) {
        return problems;
    }
    return Result<project::Project>(std::move(project), std::move(problems));
}

Result<project::Project> loadProject(const std::filesystem::path& file) {
    const auto text = readFile(file);
    return text ? parseProject(*text, file.string()) : text.problems();
}

std::string formatProject(const project::Project& project) {
    Json json = Json::object();
    json["format"] = kFormat;
    json["version"] = kVersion;
    const Json fields = toJson(project);
    for (auto it = fields.begin(); it != fields.end(); ++it) {
        json[it.key()] = *it;
    }
    return formatJson(json);
}

Result<bool> saveProject(const project::Project& project, const std::filesystem::path& file) {
    return writeFileAtomically(file, formatProject(project));
}

std::string formatParts(const project::Parts& parts) {
    Json json = Json::object();
    json["format"] = kPartsFormat;
    json["version"] = kVersion;
    json["elements"] = toJson(parts.elements);
    json["shapes"] = toJson(parts.shapes);
    json["needed"] = toJson(parts.needed);
    return formatJson(json);
}

Result<project::Parts> parseParts(std::string_view text) {
    const std::string source = Text::of("clipboard");
    const Problem foreign{Severity::Critical, source, Text::of("it holds no parts of a rover."),
                          Text::of("Copy parts in RoverStudio first.")};
    Problems problems;
    Reader reader(source, problems);
    const auto parsed = readJson(text, source, reader);
    if (!parsed || !parsed->is_object() || !parsed->contains("format") ||
        (*parsed)["format"] != kPartsFormat) {
        return foreign;
    }
    const ReadJson& json = *parsed;
    if (!json.contains("version") || json["version"] != kVersion || !json.contains("elements") ||
        !json.contains("needed")) {
        return Problem{Severity::Critical, source, Text::of("it holds parts of another version."),
                       Text::of("Copy them with this version of RoverStudio.")};
    }
    project::Parts parts;
    reader.read(json["elements"], "elements", parts.elements);
    if (json.contains("shapes")) {
        reader.read(json["shapes"], "shapes", parts.shapes);
    }
    reader.read(json["needed"], "needed", parts.needed);
    if (hasCritical(problems)) {
        return problems;
    }
    return Result<project::Parts>(std::move(parts), std::move(problems));
}

namespace {

/// A folder of the assets: beside the program, or in the source tree.
std::filesystem::path assetsFolder(const char* name) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    for (const fs::path& candidate : {program.parent_path() / "../share/roverstudio" / name,
                                      fs::path(ROVER_ASSETS_DIR) / name}) {
        if (fs::is_directory(candidate, error)) {
            return fs::weakly_canonical(candidate, error);
        }
    }
    return {};
}

}  // namespace

std::filesystem::path examplesFolder() {
    return assetsFolder("projects");
}

std::vector<std::filesystem::path> templateFiles() {
    std::vector<std::pair<std::size_t, std::filesystem::path>> found;
    std::error_code error;
    for (const auto& entry :
         std::filesystem::directory_iterator(assetsFolder("templates"), error)) {
        if (entry.path().extension() != ".rover") {
            continue;
        }
        if (const auto project = loadProject(entry.path())) {
            std::size_t bodies = 0;
            for (const project::Body& body : project->rover.bodies) {
                bodies += body.mirror ? 2 : 1;
            }
            found.emplace_back(bodies, entry.path());
        }
    }
    std::sort(found.begin(), found.end());
    std::vector<std::filesystem::path> files;
    files.reserve(found.size());
    for (auto& [bodies, file] : found) {
        files.push_back(std::move(file));
    }
    return files;
}

}  // namespace simcore::io
