#include "tests/boundary/include_rules.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>

namespace boundary {
namespace {

const std::array<const char*, 4> kLayers{"simcore", "render", "widgets", "app"};

/// Includes that match `pattern` belong to `library`, allowed below `folders` only.
struct Rule {
    const char* library;
    std::regex pattern;
    std::vector<std::string> folders;
};

const std::vector<Rule>& rules() {
    static const std::vector<Rule> kRules{
        {"QCustomPlot", std::regex(R"((.*/)?qcustomplot\.h)"), {"widgets/plots/"}},
        {"Qt",
         std::regex(R"((Q[A-Z]\w*|Qt\w*/.*|q[a-z0-9_]+\.h|ui_\w+\.h))"),
         {"widgets/", "app/roverstudio/"}},
        {"OpenSceneGraph",
         std::regex(R"((osg\w*|OpenThreads)/.*)"),
         {"render/", "widgets/viewport/"}},
        {"OpenGL",
         std::regex(R"((GL|GLES\w*|EGL|KHR|epoxy|GLFW)/.*)"),
         {"render/", "widgets/viewport/"}},
        {"ODE", std::regex(R"(ode/.*)"), {"simcore/dynamics/"}},
        {"nlohmann-json", std::regex(R"(nlohmann/.*)"), {"simcore/io/", "app/roversim/"}},
        {"SDL", std::regex(R"(SDL.*)"), {"widgets/session/"}},
        {"assimp", std::regex(R"(assimp/.*)"), {"simcore/io/"}},
        {"libpng", std::regex(R"(png\.h)"), {"simcore/io/"}},
        {"muParser", std::regex(R"(muParser\w*\.h)"), {"simcore/project/"}},
        {"CLI11", std::regex(R"(CLI/.*)"), {"app/"}},
        {"the tests", std::regex(R"(tests/.*)"), {}},
        {"app", std::regex(R"(app/.*)"), {"app/"}},
        {"widgets", std::regex(R"(widgets/.*)"), {"widgets/", "app/roverstudio/"}},
        {"render", std::regex(R"(render/.*)"), {"render/", "widgets/", "app/roverstudio/"}},
    };
    return kRules;
}

bool startsWith(const std::string& text, const std::string& prefix) {
    return text.compare(0, prefix.size(), prefix) == 0;
}

bool isSource(const std::filesystem::path& file) {
    static const std::array<const char*, 8> kEndings{".h",   ".hpp", ".hh", ".inl",
                                                     ".cpp", ".cc",  ".c",  ".cxx"};
    return std::find(kEndings.begin(), kEndings.end(), file.extension().string()) != kEndings.end();
}

void scanFile(const std::filesystem::path& path, const std::string& name, Scan& scan) {
    static const std::regex kInclude(R"(\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
    std::ifstream in(path);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        std::smatch match;
        if (!std::regex_match(line, match, kInclude)) {
            continue;
        }
        ++scan.includes;
        const std::string include = match[2];
        const std::string reason = whyForbidden(name, include, match[1] == "\"");
        if (!reason.empty()) {
            scan.violations.push_back({name, number, include, reason});
        }
    }
}

}  // namespace

std::string toString(const std::vector<Violation>& violations) {
    std::string text;
    for (const Violation& v : violations) {
        text += v.file + ":" + std::to_string(v.line) + ": " + v.include + ": " + v.reason + "\n";
    }
    return text;
}

std::string whyForbidden(const std::string& file, const std::string& include, bool quoted) {
    for (const Rule& rule : rules()) {
        if (!std::regex_match(include, rule.pattern)) {
            continue;
        }
        std::string allowed;
        for (const std::string& folder : rule.folders) {
            if (startsWith(file, folder)) {
                return {};
            }
            allowed += (allowed.empty() ? "" : ", ") + folder;
        }
        return std::string(rule.library) + " may be included " +
               (allowed.empty() ? "by no layer" : "only in " + allowed);
    }
    // A relative include would slip past the rules by naming no layer.
    const bool fromRoot = std::any_of(kLayers.begin(), kLayers.end(), [&](const char* layer) {
        return startsWith(include, std::string(layer) + "/");
    });
    const bool generated = include.size() > 4 && include.substr(include.size() - 4) == ".moc";
    if ((quoted && !fromRoot && !generated) || include.find("..") != std::string::npos) {
        return "own headers are included by their path from the root";
    }
    return {};
}

Scan scanIncludes(const std::filesystem::path& root) {
    Scan scan;
    for (const char* layer : kLayers) {
        if (!std::filesystem::exists(root / layer)) {
            continue;
        }
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / layer)) {
            if (entry.is_regular_file() && isSource(entry.path())) {
                ++scan.files;
                scanFile(entry.path(), entry.path().lexically_relative(root).generic_string(),
                         scan);
            }
        }
    }
    return scan;
}

}  // namespace boundary
