#include "simcore/review/way_review.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "simcore/base/text.h"
#include "simcore/dynamics/engine.h"
#include "simcore/statics/traverse.h"

namespace simcore::review {
namespace {

using statics::Traverse;
using statics::TraverseSample;

/// So strong that no motor is at its limit: no rover that size needs a thousand times its torque.
constexpr double kStrong = 1e3;

/// The least friction under the wheels that touch.
double frictionUnder(const run::ResolvedRun& run, const TraverseSample& sample) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& contact : statics::rollingAlong(sample.pose, run.speed < 0.0)) {
        least =
            std::min(least, project::groundAt(run, contact.point.x(), contact.point.y()).friction);
    }
    return std::isfinite(least) ? least : run.friction;
}

/// A way, and where on it the ground falls short of what is asked for by most.
struct Climb {
    Traverse traverse;
    std::size_t hardest = 0;
    bool arrives = false;     ///< with some friction
    bool sufficient = false;  ///< with that of the ground
};

Climb climb(const run::ResolvedRun& run, const mechanism::Mechanism& rover,
            const std::function<bool()>& goOn) {
    statics::StaticModel model(rover, run.joints);
    statics::PoseSolver solver(model, *run.terrain);
    statics::TraverseRequest request;
    request.distance = run.distance;
    request.backwards = run.speed < 0.0;
    Climb climb;
    climb.traverse =
        traverse(solver, request, [&](const TraverseSample&) { return !goOn || goOn(); });
    climb.arrives = std::isfinite(climb.traverse.frictionRequired());
    climb.sufficient = climb.arrives;
    double worst = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < climb.traverse.samples.size(); ++i) {
        const TraverseSample& sample = climb.traverse.samples[i];
        if (!sample.climbs || !sample.study.feasible) {
            continue;
        }
        const double short_ = sample.study.frictionRequired - frictionUnder(run, sample);
        climb.sufficient = climb.sufficient && short_ <= 0.0;
        if (short_ > worst) {
            worst = short_;
            climb.hardest = i;
        }
    }
    return climb;
}

Finding findingOf(const run::ResolvedRun& run, std::string kind, std::string remedy) {
    Finding finding;
    finding.kind = std::move(kind);
    finding.element = Text::of("scenario {}", run.scenario);
    finding.remedy = std::move(remedy);
    return finding;
}

Finding tooLittleFriction(const run::ResolvedRun& run, const Climb& strong) {
    Finding finding =
        findingOf(run, "friction",
                  Text::of("Lower the obstacle, change the suspension, or raise the friction."));
    const auto& samples = strong.traverse.samples;
    if (samples.empty()) {
        finding.reason = Text::of("the rover finds no way to stand at its start.");
        return finding;
    }
    if (!strong.arrives) {
        finding.reason =
            Text::of("no friction is enough: at x = {:.2f} m no torques move the rover on.",
                     samples.back().distance);
        finding.value = run.friction;
        finding.limit = std::numeric_limits<double>::infinity();
        return finding;
    }
    const TraverseSample& hardest = samples[strong.hardest];
    finding.value = frictionUnder(run, hardest);
    finding.limit = hardest.study.frictionRequired;
    finding.reason =
        Text::of("at x = {:.2f} m it asks for a friction of {:.2f}, and the ground gives {:.2f}.",
                 hardest.distance, finding.limit, finding.value);
    return finding;
}

/// The wheel whose motor is asked for most beyond its limit where the motors do not suffice.
Finding tooLittleTorque(const run::ResolvedRun& run, const Climb& strong) {
    Finding finding = findingOf(
        run, "torque", Text::of("Take stronger motors, smaller wheels or a lower obstacle."));
    double most = 0.0, at = 0.0;
    std::string wheel;
    for (const TraverseSample& sample : strong.traverse.samples) {
        for (std::size_t i = 0; i < sample.study.wheels.size() && sample.climbs; ++i) {
            const double limit = run.mechanism.wheels[i].torqueLimit;
            const double torque = std::abs(sample.study.wheels[i].torque);
            if (torque / limit > most) {
                most = torque / limit;
                at = sample.distance;
                wheel = sample.study.wheels[i].name;
                finding.value = limit;
                finding.limit = torque;
            }
        }
    }
    finding.reason = Text::of(
        "at x = {:.2f} m it asks for {:.2f} N m at wheel {}, and its motor gives {:.2f} N m.", at,
        finding.limit, wheel, finding.value);
    return finding;
}

}  // namespace

bool hasObstacles(const project::Scenario& scenario) {
    using project::TerrainKind;
    const TerrainKind kind = scenario.terrain.kind;
    return kind != TerrainKind::Flat && kind != TerrainKind::Ramp &&
           kind != TerrainKind::CrossSlope;
}

std::vector<Finding> reviewWay(const project::Project& project, const std::string& scenario,
                               const project::ProjectFiles& files,
                               const std::function<bool()>& goOn) {
    const auto found = run::findScenario(project, scenario);
    if (!found || !(*found)->variant.empty() || !hasObstacles(**found)) {
        return {};
    }
    run::RunRequest request;
    request.scenario = scenario;
    request.files = files;
    const auto run = run::prepareRun(project, request);
    if (!run || run->mechanism.wheels.empty()) {
        return {};
    }
    const auto stopped = [](const Climb& climb) {
        return climb.traverse.end == statics::TraverseEnd::Stopped;
    };
    const Climb asBuilt = climb(*run, run->mechanism, goOn);
    if (asBuilt.sufficient || stopped(asBuilt)) {
        return {};
    }
    // Is it the motors? Then stronger ones would do.
    mechanism::Mechanism stronger = run->mechanism;
    for (mechanism::Wheel& wheel : stronger.wheels) {
        wheel.torqueLimit = kStrong * std::max(wheel.torqueLimit,
                                               stronger.mass() * dynamics::kGravity * wheel.radius);
    }
    const Climb strong = climb(*run, stronger, goOn);
    if (stopped(strong)) {
        return {};
    }
    return {strong.sufficient ? tooLittleTorque(*run, strong) : tooLittleFriction(*run, strong)};
}

}  // namespace simcore::review
