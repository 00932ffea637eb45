#pragma once

#include "simcore/contact/wheel_contact.h"
#include "tests/support/mechanisms.h"

/// A wheel on its own, without an engine: where does it touch?
namespace testsupport {

struct OneWheel {
    double radius = 0.1;
    double width = 0.05;

    /// Body 1 of a mechanism; its pose places the wheel in the world.
    simcore::mechanism::Mechanism mechanism() const {
        simcore::mechanism::Mechanism mechanism;
        mechanism.bodies = {makeBody("chassis", 1.0, simcore::Vec3::Zero()),
                            makeBody("wheel", 1.0, simcore::Vec3::Zero())};
        mechanism.joints = {makePin("axle", 0, 1, simcore::Vec3::Zero())};
        simcore::mechanism::Wheel wheel;
        wheel.name = "wheel";
        wheel.body = 1;
        wheel.axle = 0;
        wheel.carrier = 0;
        wheel.radius = radius;
        wheel.width = width;
        mechanism.wheels = {wheel};
        return mechanism;
    }

    std::vector<simcore::contact::Contact> contactsAt(
        const simcore::terrain::Terrain& terrain, const simcore::Vec3& center,
        const Eigen::Quaterniond& rotation = Eigen::Quaterniond::Identity(), int slices = 2,
        double margin = 0.0) const {
        const simcore::mechanism::Mechanism made = mechanism();
        simcore::contact::WheelContactFinder finder(made, terrain, slices, margin);
        std::vector<simcore::Pose> poses(2);
        poses[1] = {rotation, center};
        return finder.find(poses);
    }
};

}  // namespace testsupport
