#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simcore/base/problem.h"
#include "simcore/mobility/mobility.h"
#include "simcore/project/project.h"
#include "simcore/project/resolve.h"

/// What a designer should know of a rover that is no mistake in the file: it can be analysed and
/// run, but will not do well. docs/review.md lists every check with its limit.
namespace simcore::review {

/// A change that would settle a finding.
struct Fix {
    std::string label;  ///< "Step of 1 ms"
    project::Project project;
};

/// One thing found, with the number it is about and the limit it is held to.
struct Finding {
    std::string kind;  ///< "mass-ratio", ...: what may be hidden as a whole
    Severity severity = Severity::Warning;
    std::string element;  ///< what it concerns, as problems name it
    std::string reason;   ///< one sentence, with number and limit
    std::string remedy;   ///< one sentence
    double value = 0.0;   ///< SI
    double limit = 0.0;   ///< SI
    std::optional<Fix> fix;
};

/// Limits (assumed, unless a source is named in docs/review.md).
inline constexpr double kMostMassRatio = 200.0;    ///< heaviest over lightest body [-]
inline constexpr double kOffGround = 1e-3;         ///< a wheel over the lowest one [m]
inline constexpr double kLeastSupport = 0.1;       ///< of half the wheelbase or track [-]
inline constexpr double kMostWayPerStep = 0.01;    ///< of a wheel's radius [-]
inline constexpr double kThinnestGyration = 1e-3;  ///< least radius of gyration [m]
inline constexpr double kWidestGyration = 3.0;     ///< largest, over the rover's size [-]

/// The kinds there are, with a title each: for a list of what is hidden.
std::vector<std::pair<std::string, std::string>> kinds();

/// All findings, gravest first, then as the project has its parts. A fraction of a millisecond: it
/// may be called after every edit.
/// @param mechanism  of the project, with `parameters`
/// @param built      its analysis as built, `relaxed` that of the relaxed model
std::vector<Finding> review(const project::Project& project,
                            const project::ParameterValues& parameters,
                            const mechanism::Mechanism& mechanism, const mobility::Report& built,
                            const mobility::Report& relaxed);

/// The finding as the problems of a file are told.
Problem asProblem(const Finding& finding);

/// By how much the centre of mass lies inside the hull of the feet that stand lowest at the drawn
/// pose, seen from above: negative outside; nothing with fewer than three feet or all in a row [m].
std::optional<double> supportMargin(const mechanism::Mechanism& mechanism);

}  // namespace simcore::review
