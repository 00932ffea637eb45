#include "simcore/statics/static_study.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simcore/base/text.h"
#include "simcore/dynamics/engine.h"
#include "simcore/mobility/stance.h"

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
/// place of a side have the same contact angle, and the rover does not lean.
bool alikeLeftAndRight(const Mechanism& mechanism, const std::vector<Pose>& poses,
                       std::span<const Contact> contacts) {
    constexpr double kSame = 1e-6;
    for (const Contact& a : contacts) {
        for (const Contact& b : contacts) {
            const Vec3 apart = mechanism.wheels[static_cast<std::size_t>(a.wheel)].center -
                               mechanism.wheels[static_cast<std::size_t>(b.wheel)].center;
            const bool opposite = std::abs(apart.x()) < kSame && std::abs(apart.z()) < kSame;
            if (opposite && (a.normal - b.normal).norm() > kSame) {
                return false;
            }
        }
        if (std::abs(a.normal.y()) > kSame) {
            return false;
        }
    }
    const Mat3& chassis = poses[static_cast<std::size_t>(mechanism.chassis)].rotation.matrix();
    return std::abs(mechanism.centerOfMass().y()) < kSame && std::abs(chassis(2, 1)) < kSame;
}

Problems problemsOf(const Mechanism& mechanism, const StudyRequest& request) {
    Problems problems = dynamics::whyNoEngineCanRun(mechanism);
    if (mechanism.wheels.empty()) {
        problems.push_back(wrong(Text::of("rover {}", mechanism.name),
                                 Text::of("it has no wheels to stand on."),
                                 Text::of("Give it wheels.")));
    }
    for (const WheelAngle& at : request.angles) {
        if (mechanism.findWheel(at.wheel) < 0) {
            problems.push_back(wrong(Text::of("contact {}", at.wheel),
                                     Text::of("there is no such wheel."),
                                     Text::of("Wheels are: {}.", wheelNames(mechanism))));
        }
        if (!(std::abs(at.angle) <= 0.5 * std::numbers::pi + 1e-9)) {
            problems.push_back(
                wrong(Text::of("contact {}", at.wheel),
                      Text::of("ground that hangs over cannot carry a wheel."),
                      Text::of("Give an angle from -90 to 90 degrees; 90 is a wall ahead.")));
        }
    }
    return problems;
}

/// What a rover needs with these contacts at the pose placed last.
Study studyContacts(StaticModel& model, const std::vector<Contact>& contacts,
                    std::span<const JointStop> stops, std::optional<ContactSet> asked,
                    bool searched) {
    const Mechanism& mechanism = model.mechanism();
    const ContactSet set = asked.value_or(
        alikeLeftAndRight(mechanism, model.poses(), contacts) ? ContactSet::Free : ContactSet::All);
    const Equilibrium equilibrium = model.equilibrium(contacts, set, dynamics::kGravity, stops);
    const Traction traction(equilibrium, mechanism, contacts);

    Study study;
    study.equations = 6 * static_cast<int>(std::count_if(
                              mechanism.bodies.begin(), mechanism.bodies.end(),
                              [](const mechanism::Body& body) { return !body.fixed; }));
    study.internalReactions = study.equations - model.motions();
    study.rows = static_cast<int>(equilibrium.matrix.rows());
    study.unknowns = static_cast<int>(equilibrium.matrix.cols());
    study.dimension = traction.dimension();
    study.tipOver = tipOverAngle(mechanism.centerOfMass(model.poses()), contacts);
    study.rollingConflict = model.rollingConflict(contacts);
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        study.wheels.push_back({});
        study.wheels.back().name = wheel.name;
        study.wheels.back().touches = false;
    }
    for (const Contact& contact : contacts) {
        WheelStudy& wheel = study.wheels[static_cast<std::size_t>(contact.wheel)];
        const mechanism::Wheel& at = mechanism.wheels[static_cast<std::size_t>(contact.wheel)];
        wheel.touches = true;
        wheel.contactAngle = mobility::contactAngle(
            contact.normal, model.poses()[static_cast<std::size_t>(at.body)].rotation * at.axis);
    }
    for (const WheelStudy& wheel : study.wheels) {
        if (!wheel.touches) {
            study.flags.push_back("hanging " + wheel.name);
        }
    }
    const Solution equal = traction.equalTorque();
    if (equal.way != Way::None) {
        study.equalTorque = equal.forces.maxTorque();
        study.equalMaxRatio = equal.friction;
        if (equal.forces.minNormal() < 0.0) {
            study.flags.emplace_back("equal-torque-lifts-a-wheel");
        }
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            WheelStudy& wheel = study.wheels[static_cast<std::size_t>(contacts[i].wheel)];
            wheel.equalNormal = equal.forces.normal[i];
            wheel.equalRatio = equal.forces.ratio(i);
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
    if (searched) {
        study.minimumTorque = traction.best(Objective::Torque).forces.maxTorque();
        const Solution thrifty = traction.best(Objective::Energy);
        study.leastSquaresRatio = thrifty.friction;
        for (const double torque : thrifty.forces.torque) {
            study.leastSquares += torque * torque;
        }
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const auto w = static_cast<std::size_t>(contacts[i].wheel);
        WheelStudy& wheel = study.wheels[w];
        wheel.normal = best.forces.normal[i];
        wheel.traction = best.forces.traction[i];
        wheel.lateral = best.forces.lateral[i];
        wheel.torque = best.forces.torque[w];
        wheel.ratio = best.forces.ratio(i);
        if (std::abs(wheel.torque) > 0.999 * mechanism.wheels[w].torqueLimit) {
            study.flags.push_back("torque-limit " + wheel.name);
        }
        constexpr double kLifting = 1e-3;  // [N]
        if (wheel.normal < kLifting) {
            study.flags.push_back("lifting " + wheel.name);
        }
    }
    return study;
}

/// Turns left, seen from above, from o over a to b.
double turn(const Vec3& o, const Vec3& a, const Vec3& b) {
    return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

/// The corners of what the points surround, seen from above, to the left round it (A. M. Andrew,
/// Inf. Process. Lett. 9, 1979).
std::vector<Vec3> hull(std::vector<Vec3> points) {
    std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
        return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
    });
    std::vector<Vec3> corners;
    for (const int way : {0, 1}) {
        const std::size_t first = corners.size();
        for (const Vec3& point : points) {
            while (corners.size() >= first + 2 &&
                   turn(corners[corners.size() - 2], corners.back(), point) <= 0.0) {
                corners.pop_back();
            }
            corners.push_back(point);
        }
        corners.pop_back();
        if (way == 0) {
            std::reverse(points.begin(), points.end());
        }
    }
    return corners;
}

}  // namespace

double tipOverAngle(const Vec3& centerOfMass, std::span<const Contact> contacts) {
    std::vector<Vec3> points;
    for (const Contact& contact : contacts) {
        points.push_back(contact.point);
    }
    if (points.size() < 3) {
        return 0.0;
    }
    const std::vector<Vec3> corners = hull(std::move(points));
    if (corners.size() < 3) {
        return 0.0;
    }
    double least = std::numbers::pi;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 side = (corners[(i + 1) % corners.size()] - corners[i]).normalized();
        const auto square = [&](const Vec3& v) { return Vec3(v - v.dot(side) * side); };
        const Vec3 down = square(-Vec3::UnitZ());
        const Vec3 to = square(corners[i] - centerOfMass);
        // Positive while the centre of mass is over the inner side.
        const double angle = std::atan2(side.dot(to.cross(down)), to.dot(down));
        least = std::min(least, std::max(0.0, angle));
    }
    return least;
}

std::vector<int> limitingWheels(const Study& study) {
    std::vector<int> limiting;
    for (std::size_t i = 0; i < study.wheels.size(); ++i) {
        const WheelStudy& wheel = study.wheels[i];
        if (study.feasible && wheel.touches && wheel.ratio >= 0.999 * study.frictionRequired) {
            limiting.push_back(static_cast<int>(i));
        }
    }
    return limiting;
}

std::vector<JointStop> stopsOf(const StaticModel& model, const StandingPose& pose) {
    std::vector<JointStop> stops;
    for (const int index : pose.jointsAtStop) {
        const mechanism::Joint& joint = model.mechanism().joints[static_cast<std::size_t>(index)];
        const double middle = 0.5 * (joint.stops->first + joint.stops->second);
        const bool lower = mechanism::jointAngle(joint, pose.bodies) < middle;
        stops.push_back({index, lower ? 1.0 : -1.0});
    }
    return stops;
}

Study studyPose(StaticModel& model, const StandingPose& pose, std::optional<ContactSet> contacts,
                bool backwards, bool searched) {
    dynamics::TreeState state = pose.state;
    model.place(state);
    Study study = studyContacts(model, rollingAlong(pose, backwards), stopsOf(model, pose),
                                contacts, searched);
    // What carries the body is no wheel's to hold.
    study.feasible = study.feasible && pose.bodiesTouching.empty();
    for (const int body : pose.bodiesTouching) {
        study.flags.push_back("touching " +
                              model.mechanism().bodies[static_cast<std::size_t>(body)].name);
    }
    for (const int joint : pose.jointsAtStop) {
        study.flags.push_back("stop " +
                              model.mechanism().joints[static_cast<std::size_t>(joint)].name);
    }
    return study;
}

Result<Study> studyDrawnPose(const Mechanism& mechanism, const StudyRequest& request) {
    if (Problems problems = problemsOf(mechanism, request); hasCritical(problems)) {
        return problems;
    }
    std::vector<double> angles(mechanism.wheels.size(), 0.0);
    for (const WheelAngle& at : request.angles) {
        angles[static_cast<std::size_t>(mechanism.findWheel(at.wheel))] = at.angle;
    }
    StaticModel model(mechanism, request.joints);
    std::vector<Contact> contacts;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        contacts.push_back(
            contactAtAngle(mechanism, static_cast<int>(i), model.poses(), angles[i]));
    }
    return studyContacts(model, contacts, {}, request.contacts, true);
}

}  // namespace simcore::statics
