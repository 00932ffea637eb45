#include "simcore/statics/static_study.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "simcore/dynamics/engine.h"

namespace simcore::statics {
namespace {

using mechanism::Mechanism;

Problem wrong(const std::string& element, std::string reason, std::string remedy) {
    return {Severity::Critical, element, std::move(reason), std::move(remedy)};
}

std::string wheelNames(const Mechanism& mechanism) {
    std::string names;
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        names += (names.empty() ? "" : ", ") + wheel.name;
    }
    return names;
}

/// Whether the forces may be taken to be the same left and right: all wheels that stand at the same
/// x have the same contact angle.
bool alikeLeftAndRight(const Mechanism& mechanism, const std::vector<double>& angles) {
    constexpr double kSame = 1e-6;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const Vec3 apart = mechanism.wheels[i].center - mechanism.wheels[k].center;
            const bool opposite = std::abs(apart.x()) < kSame && std::abs(apart.z()) < kSame;
            if (opposite && std::abs(angles[i] - angles[k]) > kSame) {
                return false;
            }
        }
    }
    return std::abs(mechanism.centerOfMass().y()) < kSame;
}

Problems problemsOf(const Mechanism& mechanism, const StudyRequest& request) {
    Problems problems = dynamics::whyNoEngineCanRun(mechanism);
    if (mechanism.wheels.empty()) {
        problems.push_back(
            wrong("rover " + mechanism.name, "it has no wheels to stand on.", "Give it wheels."));
    }
    for (const WheelAngle& at : request.angles) {
        if (mechanism.findWheel(at.wheel) < 0) {
            problems.push_back(wrong("contact " + at.wheel, "there is no such wheel.",
                                     "Wheels are: " + wheelNames(mechanism) + "."));
        }
        if (!(std::abs(at.angle) <= 0.5 * std::numbers::pi + 1e-9)) {
            problems.push_back(wrong("contact " + at.wheel,
                                     "ground that hangs over cannot carry a wheel.",
                                     "Give an angle from -90 to 90 degrees; 90 is a wall ahead."));
        }
    }
    return problems;
}

}  // namespace

Result<Study> studyDrawnPose(const Mechanism& mechanism, const StudyRequest& request) {
    if (Problems problems = problemsOf(mechanism, request); hasCritical(problems)) {
        return problems;
    }
    std::vector<double> angles(mechanism.wheels.size(), 0.0);
    for (const WheelAngle& at : request.angles) {
        angles[static_cast<std::size_t>(mechanism.findWheel(at.wheel))] = at.angle;
    }
    const ContactSet set = request.contacts.value_or(
        alikeLeftAndRight(mechanism, angles) ? ContactSet::Free : ContactSet::All);
    StaticModel model(mechanism, request.joints);
    std::vector<Contact> contacts;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        contacts.push_back(
            contactAtAngle(mechanism, static_cast<int>(i), model.poses(), angles[i]));
    }
    const Equilibrium equilibrium = model.equilibrium(contacts, set, dynamics::kGravity);
    const Traction traction(equilibrium, mechanism, contacts);

    Study study;
    study.equations = 6 * static_cast<int>(std::count_if(
                              mechanism.bodies.begin(), mechanism.bodies.end(),
                              [](const mechanism::Body& body) { return !body.fixed; }));
    study.internalReactions = study.equations - model.motions();
    study.rows = static_cast<int>(equilibrium.matrix.rows());
    study.unknowns = static_cast<int>(equilibrium.matrix.cols());
    study.dimension = traction.dimension();
    const Solution equal = traction.equalTorque();
    if (equal.way != Way::None) {
        study.equalTorque = equal.forces.maxTorque();
        study.equalMaxRatio = equal.friction;
        if (equal.forces.minNormal() < 0.0) {
            study.flags.emplace_back("equal-torque-lifts-a-wheel");
        }
    } else {
        study.flags.emplace_back("no-equal-torque");
    }
    const Solution best = traction.best(Objective::Friction);
    study.feasible = best.way != Way::None;
    if (!study.feasible) {
        study.flags.emplace_back("no-torques-hold-it");
        return study;
    }
    study.flags.emplace_back(best.way == Way::FixedPoint ? "ratios-equal" : "search");
    study.frictionRequired = best.friction;
    study.minimumTorque = traction.best(Objective::Torque).forces.maxTorque();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        WheelStudy wheel;
        wheel.name = mechanism.wheels[i].name;
        wheel.contactAngle = angles[i];
        wheel.normal = best.forces.normal[i];
        wheel.traction = best.forces.traction[i];
        wheel.lateral = best.forces.lateral[i];
        wheel.torque = best.forces.torque[i];
        wheel.ratio = best.forces.ratio(i);
        study.wheels.push_back(wheel);
        if (std::abs(wheel.torque) > 0.999 * mechanism.wheels[i].torqueLimit) {
            study.flags.push_back("torque-limit " + wheel.name);
        }
        constexpr double kLifting = 1e-3;  // [N]
        if (wheel.normal < kLifting) {
            study.flags.push_back("lifting " + wheel.name);
        }
    }
    return study;
}

}  // namespace simcore::statics
