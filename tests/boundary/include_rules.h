#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Which folder may include what: the layers simcore <- render <- widgets <- app, and each third
/// party library kept to the folders that wrap it.
namespace boundary {

/// One include that breaks a rule.
struct Violation {
    std::string file;  ///< relative to the scanned root, with "/"
    int line = 0;
    std::string include;
    std::string reason;
};

/// One line a violation, for a test's message.
std::string toString(const std::vector<Violation>& violations);

/// The rule that `include`, written in `file`, breaks; empty when it is allowed.
/// @param quoted  written with quotes instead of angle brackets
std::string whyForbidden(const std::string& file, const std::string& include, bool quoted);

struct Scan {
    int files = 0;
    int includes = 0;
    std::vector<Violation> violations;
};

/// Scans every source file below simcore, render, widgets and app of `root`.
Scan scanIncludes(const std::filesystem::path& root);

}  // namespace boundary
