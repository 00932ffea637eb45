#include "simcore/dynamics/friction_bounds.h"

#include <algorithm>
#include <cmath>

namespace simcore::dynamics {
namespace {

// Agreement asked of limits and normal forces: relative, and absolute [N].
constexpr double kTolerance = 0.01;
constexpr double kToleranceForce = 0.01;
// Below this share of its limit a tangential force gives the box no direction.
constexpr double kDirected = 0.3;

// A narrow box's half width across its direction: its corners stand 1 % outside the cone. Wider,
// and corners would never agree.
constexpr double kAcross = 0.14;
// A wheel that sticks with less than this share of its limit gets a square box instead, which does
// not care which way its force turns.
constexpr double kLoose = 0.6;
// A wheel slides when its contact moves faster than this [m/s]; 1 % of the usual speed of travel.
constexpr double kSliding = 1e-3;

void setLimit(FrictionBox& box, double limit, bool loose) {
    box.along = limit;
    box.across = loose ? limit : kAcross * limit;
}

/// Turns the box by that share of the way. The box is the same both ways round.
void turn(FrictionBox& box, const Vec3& direction, double share) {
    const double sign = box.direction.dot(direction) < 0.0 ? -1.0 : 1.0;
    box.direction = ((1.0 - share) * sign * box.direction + share * direction).normalized();
}

Vec3 tangentialPart(const Vec3& force, const Vec3& normal) {
    return force - force.dot(normal) * normal;
}

}  // namespace

void FrictionBounds::begin(std::span<const contact::Contact> contacts,
                           std::span<const double> frictions) {
    frictions_.assign(frictions.begin(), frictions.end());
    updates_ = 0;
    boxes_.assign(contacts.size(), {});
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        FrictionBox& box = boxes_[i];
        box.direction = contacts[i].forward;
        if (const ContactMemory::Remembered* old = memory_.recall(contacts[i])) {
            box.fromNormalForce = false;
            const Vec3 tangential =
                tangentialPart(tangentialPart(old->force, old->normal), contacts[i].normal);
            const double limit = frictions[i] * std::max(0.0, old->force.dot(old->normal));
            setLimit(box, limit, tangential.norm() < kLoose * limit);
            if (tangential.norm() > kDirected * box.along && tangential.norm() > kToleranceForce) {
                box.direction = tangential.normalized();
            }
        }
    }
}

bool FrictionBounds::update(std::span<const contact::Contact> contacts,
                            std::span<const Vec3> forces, std::span<const Vec3> velocities) {
    bool agree = true;
    ++updates_;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        FrictionBox& box = boxes_[i];
        const Vec3& normal = contacts[i].normal;
        const double limit = frictions_[i] * std::max(0.0, forces[i].dot(normal));
        const Vec3 tangential = tangentialPart(forces[i], normal);
        const double size = tangential.norm();
        const double along = std::abs(tangential.dot(box.direction));
        const double across = std::abs(tangential.dot(normal.cross(box.direction)));
        const double slack = kTolerance * limit + kToleranceForce;
        const bool outside = size > limit + slack;
        const bool held = box.fromNormalForce || along > (1.0 - 1e-6) * box.along ||
                          across > (1.0 - 1e-6) * box.across;
        const bool short_ = held && size < (1.0 - kTolerance) * limit - slack;
        const bool guessed = box.fromNormalForce && size > 0.5 * limit;
        if (outside || short_ || guessed) {
            agree = false;
        }
        // From the third solve on the mean of what they ask for (Mann's iteration): where wheels
        // are wedged, more friction makes less load and the other way round, and whole or half
        // steps would go to and fro for ever.
        const double step = 1.0 / std::max(1, updates_ - 1);
        const Vec3 sliding = tangentialPart(velocities[i], normal);
        const bool slides = sliding.norm() > kSliding;
        setLimit(box, box.along + step * (limit - box.along), !slides && size < kLoose * limit);
        box.fromNormalForce = false;
        if (slides) {
            turn(box, -sliding.normalized(), step);
        } else if (size > kDirected * limit && size > kToleranceForce) {
            turn(box, tangential.normalized(), step);
        }
    }
    return agree;
}

}  // namespace simcore::dynamics
