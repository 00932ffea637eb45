#include "simcore/dynamics/ode_gear.h"

#include <cmath>
#include <numbers>

#include "simcore/dynamics/ode_world.h"

namespace simcore::dynamics {
namespace {

using mechanism::Joint;

// The spider must not be felt: a gram, and the inertia of a gram at the mesh radius.
constexpr double kSpiderMass = 1e-3;
constexpr double kMeshRadius = 0.1;
// Share of the gear error corrected per step.
constexpr double kErrorReduction = 0.2;
// Sine below which two pins count as parallel.
constexpr double kParallel = 1e-6;

}  // namespace

int carrierOf(const mechanism::Mechanism& mechanism, const mechanism::Gear& gear) {
    const Joint& a = mechanism.joints[static_cast<std::size_t>(gear.firstJoint)];
    const Joint& b = mechanism.joints[static_cast<std::size_t>(gear.secondJoint)];
    if (a.first == b.first || a.first == b.second) {
        return a.first;
    }
    return a.second == b.first || a.second == b.second ? a.second : -1;
}

OdeGear::OdeGear(dWorldID world, const mechanism::Mechanism& mechanism, const mechanism::Gear& gear,
                 const std::vector<dBodyID>& bodies) {
    const int carrier = carrierOf(mechanism, gear);
    carrier_ = bodies[static_cast<std::size_t>(carrier)];
    carrierCom_ = mechanism.bodies[static_cast<std::size_t>(carrier)].com;
    const Joint& first = mechanism.joints[static_cast<std::size_t>(gear.firstJoint)];
    const Joint& second = mechanism.joints[static_cast<std::size_t>(gear.secondJoint)];
    center_ = 0.5 * (first.point + second.point);
    // At right angles to both pins.
    const Vec3 across = first.axis.cross(second.axis);
    const Vec3 other = std::abs(first.axis.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
    spiderAxis_ = (across.norm() > kParallel ? across : first.axis.cross(other)).normalized();
    // A pinned body turning by w moves its mesh by w r along the tooth, the spider turning by g by
    // -g c, where c is the mesh's place along the pin axis: g = -w r / c. The first mesh has
    // c = -r, so the spider turns as the first body does; the second has c = -r ratio.
    for (const Joint* joint : {&first, &second}) {
        // The turns a gear couples are those of second bodies against first ones.
        const bool carrierFirst = joint->first == carrier;
        const Vec3 axis = carrierFirst ? joint->axis : Vec3(-joint->axis);
        const double place = joint == &first ? -kMeshRadius : -kMeshRadius * gear.ratio;
        Vec3 point = joint->point + kMeshRadius * spiderAxis_;
        point += (place - (point - center_).dot(axis)) * axis;
        const int pinned = carrierFirst ? joint->second : joint->first;
        meshes_.push_back({bodies[static_cast<std::size_t>(pinned)], axis, axis.cross(spiderAxis_),
                           point, place, -kMeshRadius / place});
    }
    dMass mass;
    const double inertia = kSpiderMass * kMeshRadius * kMeshRadius;
    dMassSetParameters(&mass, kSpiderMass, 0, 0, 0, inertia, inertia, inertia, 0, 0, 0);
    spider_ = dBodyCreate(world);
    dBodySetMass(spider_, &mass);
    dBodySetPosition(spider_, center_.x(), center_.y(), center_.z());
    dBodySetGravityMode(spider_, 0);
    const dJointID pin = dJointCreateHinge(world, nullptr);
    dJointAttach(pin, spider_, carrier_);
    dJointSetHingeAnchor(pin, center_.x(), center_.y(), center_.z());
    dJointSetHingeAxis(pin, spiderAxis_.x(), spiderAxis_.y(), spiderAxis_.z());
}

void OdeGear::addMeshes(dWorldID world, dJointGroupID group, double step) const {
    const auto rotationOf = [](dBodyID body) {
        const dReal* q = dBodyGetQuaternion(body);
        return Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
    };
    const auto turnOf = [&](dBodyID body, const Vec3& axis) {
        return turnAbout(rotationOf(carrier_).conjugate() * rotationOf(body), axis);
    };
    const Eigen::Quaterniond R = rotationOf(carrier_);
    const Vec3 origin = toVec3(dBodyGetPosition(carrier_)) - R * carrierCom_;
    const double spiderTurn = turnOf(spider_, spiderAxis_);
    for (const Mesh& mesh : meshes_) {
        const Vec3 point = origin + R * mesh.point;
        const Vec3 tooth = R * mesh.tooth;
        const Vec3 normal = R * spiderAxis_;
        const double error = std::remainder(
            mesh.turnSign * turnOf(mesh.pinned, mesh.pinAxis) - spiderTurn, 2.0 * std::numbers::pi);
        dContact c{};
        c.surface.mode = dContactMu2 | dContactFDir1 | dContactSoftCFM | dContactMotion1;
        c.surface.mu = dInfinity;
        c.surface.mu2 = 0.0;
        c.surface.soft_cfm = kNoForce;
        // The row asks for pinned minus spider speed along the tooth; the error shrinks with it.
        c.surface.motion1 = kErrorReduction / step * mesh.spiderArm * error;
        toOde(c.geom.pos, point);
        toOde(c.geom.normal, normal);
        toOde(c.fdir1, tooth);
        const dJointID joint = dJointCreateContact(world, group, &c);
        dJointAttach(joint, mesh.pinned, spider_);
    }
}

}  // namespace simcore::dynamics
