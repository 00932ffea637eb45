#pragma once

#include <string>

#include "simcore/base/random.h"
#include "tests/support/carts.h"

/// Mechanisms by lot: trees of all kinds of joints, plane, spherical and spatial loops, gears,
/// springs, driven wheels. The size of a small rover, with springs that swing within a second.
namespace testsupport {

enum class Lot { Tree, Gears, PlaneLoops, SphericalLoop, SpatialLoop };

inline const char* nameOf(Lot lot) {
    constexpr const char* kNames[] = {"Tree", "Gears", "PlaneLoops", "SphericalLoop",
                                      "SpatialLoop"};
    return kNames[static_cast<int>(lot)];
}

class RandomMechanism {
  public:
    RandomMechanism(Lot lot, std::uint64_t seed)
        : random_(1000 * static_cast<std::uint64_t>(lot) + seed),
          lot_(lot),
          common_(direction()),
          center_(point()) {
        mechanism_.name = std::string(nameOf(lot)) + std::to_string(seed);
        const bool loops = lot != Lot::Tree && lot != Lot::Gears;
        grow(loops ? 4 + below(3) : 3 + below(4), random_.uniform(0.0, 1.0) < 0.65);
        if (loops) {
            closeLoops(lot == Lot::PlaneLoops ? 1 + below(2) : 1);
        }
        if (lot == Lot::Gears) {
            addGear();
        }
        addSprings();
        addWheels();
    }

    const Mechanism& mechanism() const { return mechanism_; }

  private:
    int below(int count) { return static_cast<int>(random_.next() % static_cast<unsigned>(count)); }

    Vec3 point() {
        return {random_.uniform(-0.4, 0.4), random_.uniform(-0.4, 0.4), random_.uniform(-0.4, 0.4)};
    }

    Vec3 direction() {
        for (;;) {
            const Vec3 v = point();
            if (v.norm() > 0.1 && v.norm() < 0.4) {
                return v.normalized();
            }
        }
    }

    /// A direction at no less than 30 degrees to the other.
    Vec3 directionApartFrom(const Vec3& other) {
        for (;;) {
            const Vec3 v = direction();
            if (v.cross(other).norm() > 0.5) {
                return v;
            }
        }
    }

    /// A box of random edges and attitude.
    Body body(int index) {
        Body body = makeBody("body" + std::to_string(index), random_.uniform(1.0, 4.0), point());
        const Vec3 square(std::pow(random_.uniform(0.2, 0.6), 2),
                          std::pow(random_.uniform(0.2, 0.6), 2),
                          std::pow(random_.uniform(0.2, 0.6), 2));
        const Mat3 R =
            Eigen::AngleAxisd(random_.uniform(-3.0, 3.0), direction()).toRotationMatrix();
        const Vec3 moments = body.mass / 12.0 * (Vec3::Constant(square.sum()) - square);
        body.inertia = R * moments.asDiagonal() * R.transpose();
        return body;
    }

    std::vector<Freedom> freedoms(const Vec3& axis) {
        const Freedom turn{FreedomKind::Turn, axis};
        const double lot = random_.uniform(0.0, 1.0);
        if (lot < 0.4) {
            return {turn};
        }
        if (lot < 0.5) {
            return {{FreedomKind::Slide, direction()}};
        }
        if (lot < 0.6) {
            return {turn, {FreedomKind::Slide, axis}};
        }
        if (lot < 0.7) {  // a universal joint
            return {turn, {FreedomKind::Turn, axis.cross(directionApartFrom(axis)).normalized()}};
        }
        if (lot < 0.8) {  // one with oblique axes
            return {turn, {FreedomKind::Turn, directionApartFrom(axis)}};
        }
        if (lot < 0.9) {
            return {{FreedomKind::Turn, Vec3::UnitX()},
                    {FreedomKind::Turn, Vec3::UnitY()},
                    {FreedomKind::Turn, Vec3::UnitZ()}};
        }
        // A plane, about an axis in any direction.
        const Vec3 first = direction();
        return {turn, {FreedomKind::Slide, first}, {FreedomKind::Slide, directionApartFrom(first)}};
    }

    /// A joint between two bodies of the kind that this lot has.
    void join(int first, int second) {
        const Vec3 middle = 0.5 * (mechanism_.bodies[static_cast<std::size_t>(first)].com +
                                   mechanism_.bodies[static_cast<std::size_t>(second)].com);
        const Vec3 place = middle + 0.3 * point();
        if (random_.next() % 2 == 0) {
            std::swap(first, second);
        }
        Vec3 axis = direction();
        if (lot_ == Lot::PlaneLoops) {
            axis = random_.next() % 2 == 0 ? common_ : Vec3(-common_);
        } else if (lot_ == Lot::SphericalLoop) {
            axis = (place - center_).normalized();
        }
        const std::string name = "joint" + std::to_string(mechanism_.joints.size());
        Joint joint = makePin(name, first, second, place, axis);
        if (lot_ == Lot::Tree || lot_ == Lot::SpatialLoop) {
            joint.built = freedoms(axis);
        } else if (lot_ == Lot::PlaneLoops && random_.uniform(0.0, 1.0) < 0.15) {
            joint.built = {{FreedomKind::Slide, axis.cross(direction()).normalized()}};
        }
        joint.relaxed = joint.built;
        if (isPin(joint) && random_.next() % 2 == 0) {
            joint.damping = random_.uniform(0.0, 0.3);
        }
        mechanism_.joints.push_back(joint);
    }

    static bool isPin(const Joint& joint) {
        return joint.built.size() == 1 && joint.built[0].kind == FreedomKind::Turn;
    }

    void grow(int count, bool fixed) {
        for (int i = 0; i < count; ++i) {
            mechanism_.bodies.push_back(body(i));
            if (i > 0) {
                // Loops are closed between the ends of a chain.
                join(lot_ == Lot::Tree ? below(i) : lot_ == Lot::Gears ? below(2) % i : i - 1, i);
            }
        }
        mechanism_.bodies[0].fixed = fixed;
        mechanism_.chassis = below(count);
    }

    void closeLoops(int loops) {
        const int last = static_cast<int>(mechanism_.bodies.size()) - 1;
        join(0, last);
        if (loops > 1 && last >= 5) {
            join(last, 1 + below(2));
        }
    }

    /// Between pins that turn in one body, which is what ODE can.
    void addGear() {
        for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
            for (std::size_t j = i + 1; j < mechanism_.joints.size(); ++j) {
                const Joint& a = mechanism_.joints[i];
                const Joint& b = mechanism_.joints[j];
                const bool together = a.first == b.first || a.first == b.second ||
                                      a.second == b.first || a.second == b.second;
                if (together) {
                    Gear gear;
                    gear.name = "gear";
                    gear.firstJoint = static_cast<int>(i);
                    gear.secondJoint = static_cast<int>(j);
                    gear.ratio = random_.uniform(0.5, 2.0) * (random_.next() % 2 == 0 ? 1.0 : -1.0);
                    mechanism_.gears = {gear};
                    return;
                }
            }
        }
    }

    void addSprings() {
        const int count = static_cast<int>(mechanism_.bodies.size());
        for (int i = 0; i < 2; ++i) {
            simcore::mechanism::Spring spring;
            spring.first = below(count);
            spring.second = (spring.first + 1 + below(count - 1)) % count;
            spring.firstPoint =
                mechanism_.bodies[static_cast<std::size_t>(spring.first)].com + 0.3 * point();
            spring.secondPoint =
                mechanism_.bodies[static_cast<std::size_t>(spring.second)].com + 0.3 * point();
            spring.stiffness = random_.uniform(0.0, 100.0);
            spring.preload = random_.uniform(-20.0, 20.0);
            spring.damping = random_.uniform(0.0, 3.0);
            mechanism_.springs.push_back(spring);
        }
        for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
            const Joint& joint = mechanism_.joints[i];
            if (isPin(joint) && random_.next() % 2 == 0) {
                simcore::mechanism::Spring spring;
                spring.joint = static_cast<int>(i);
                spring.first = joint.first;
                spring.second = joint.second;
                spring.stiffness = random_.uniform(0.0, 5.0);
                spring.preload = random_.uniform(-1.0, 1.0);
                spring.damping = random_.uniform(0.0, 0.2);
                mechanism_.springs.push_back(spring);
            }
        }
    }

    /// Every third pin's second body is a wheel that can be driven, with a motor's rotor.
    void addWheels() {
        for (std::size_t i = 0; i < mechanism_.joints.size(); i += 3) {
            const Joint& joint = mechanism_.joints[i];
            if (isPin(joint)) {
                Wheel wheel;
                wheel.name = "wheel" + std::to_string(i);
                wheel.body = joint.second;
                wheel.carrier = joint.first;
                wheel.axle = static_cast<int>(i);
                wheel.center = joint.point;
                wheel.axis = joint.axis;
                wheel.radius = 0.1;
                wheel.width = 0.05;
                wheel.rotorInertia = 0.02;
                mechanism_.wheels.push_back(wheel);
            }
        }
    }

    simcore::Random random_;
    Lot lot_;
    Vec3 common_;  ///< axis of all pins of a plane mechanism
    Vec3 center_;  ///< of a spherical one
    Mechanism mechanism_;
};

}  // namespace testsupport
