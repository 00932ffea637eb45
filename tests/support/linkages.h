#pragma once

#include <cmath>

#include "tests/support/mechanisms.h"

/// Plane linkages on a fixed frame whose motion has a closed form. They move in the x-z plane;
/// their angles count from +x to +z, which is a negative turn about y.
namespace testsupport {

/// Quarter period of a pendulum released from `amplitude`, over that of small swings: 1 / agm.
inline double periodFactor(double amplitude) {
    double a = 1.0;
    double g = std::cos(amplitude / 2.0);
    for (int i = 0; i < 20; ++i) {
        const double mean = 0.5 * (a + g);
        g = std::sqrt(a * g);
        a = mean;
    }
    return 1.0 / a;
}

/// A plane four-bar on a fixed frame: crank at the origin, follower at (ground, 0), both upwards.
struct FourBar {
    double ground = 0.30, crank = 0.10, coupler = 0.28, follower = 0.22;

    /// Follower's angle to the frame for a crank angle, open branch [rad] (both from +x to +z).
    double followerAngle(double crankAngle) const {
        const double x = crank * std::cos(crankAngle) - ground;
        const double z = crank * std::sin(crankAngle);
        const double d2 = x * x + z * z;
        const double cosine =
            (follower * follower + d2 - coupler * coupler) / (2.0 * follower * std::sqrt(d2));
        return std::atan2(z, x) - std::acos(cosine);
    }

    Mechanism make(double crankAngle) const {
        const auto at = [](double x, double angle, double r) {
            return Vec3(x + r * std::cos(angle), 0.0, r * std::sin(angle));
        };
        const Vec3 a = Vec3::Zero();
        const Vec3 b = at(0.0, crankAngle, crank);
        const Vec3 c = at(ground, followerAngle(crankAngle), follower);
        const Vec3 d(ground, 0.0, 0.0);
        Mechanism mechanism;
        mechanism.bodies = {makeBody("frame", 5.0, 0.5 * d), makeBody("crank", 0.3, 0.5 * (a + b)),
                            makeBody("coupler", 0.4, 0.5 * (b + c)),
                            makeBody("follower", 0.35, 0.5 * (c + d))};
        mechanism.bodies[0].fixed = true;
        mechanism.joints = {makePin("a", 0, 1, a), makePin("b", 1, 2, b), makePin("c", 2, 3, c),
                            makePin("d", 0, 3, d)};
        return mechanism;
    }
};

}  // namespace testsupport
