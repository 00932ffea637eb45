#include "tests/boundary/link_rules.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <regex>
#include <stdexcept>

namespace boundary {
namespace {

const std::regex& patternOf(Toolkit toolkit) {
    // A name, a file, a linker flag or a CMake variable's content: "Qt6::Core", "libQt6Core.so.6",
    // "-losgViewer", "osgDB", "OpenGL::GL", "libGLX.so".
    static const std::regex kQt(R"(.*(\bQt\d?\w*::|(^|/|lib|-l)Qt\d|qcustomplot).*)",
                                std::regex::icase);
    static const std::regex kOsg(R"(.*((^|/|lib|-l|\b)osg|OpenSceneGraph|OpenThreads).*)",
                                 std::regex::icase);
    static const std::regex kGl(
        R"(.*((^|/|lib|-l)(Open)?(GL|EGL|GLX|GLU|GLdispatch)\b|OpenGL::).*)");
    switch (toolkit) {
        case Toolkit::Qt:
            return kQt;
        case Toolkit::OpenSceneGraph:
            return kOsg;
        case Toolkit::OpenGL:
            return kGl;
    }
    throw std::invalid_argument("no such toolkit");
}

}  // namespace

std::vector<std::string> linksOf(const std::vector<std::string>& names,
                                 const std::vector<Toolkit>& toolkits) {
    std::vector<std::string> found;
    for (const std::string& name : names) {
        for (const Toolkit toolkit : toolkits) {
            if (std::regex_match(name, patternOf(toolkit))) {
                found.push_back(name);
                break;
            }
        }
    }
    return found;
}

std::vector<std::string> readLines(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) {
        throw std::runtime_error("cannot read " + file.string());
    }
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) {
        if (!line.empty()) {
            lines.push_back(line);
        }
    }
    return lines;
}

std::vector<std::string> sharedLibrariesOf(const std::filesystem::path& program) {
    FILE* pipe = popen(("ldd '" + program.string() + "'").c_str(), "r");
    if (pipe == nullptr) {
        throw std::runtime_error("cannot run ldd");
    }
    std::vector<std::string> lines;
    std::array<char, 512> buffer{};
    while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
        std::string line(buffer.data());
        const std::size_t begin = line.find_first_not_of(" \t");
        const std::size_t end = line.find_first_of(" \n", begin == std::string::npos ? 0 : begin);
        if (begin != std::string::npos) {
            lines.push_back(line.substr(begin, end - begin));
        }
    }
    pclose(pipe);
    return lines;
}

}  // namespace boundary
