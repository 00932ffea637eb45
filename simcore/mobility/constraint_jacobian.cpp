#include "simcore/mobility/constraint_jacobian.h"

#include <algorithm>
#include <cmath>

namespace simcore::mobility {
namespace {

using mechanism::Freedom;
using mechanism::FreedomKind;
using mechanism::Mechanism;

class Assembler {
  public:
    explicit Assembler(const Mechanism& mechanism)
        : mechanism_(mechanism),
          length_(mechanism.wheelbase()) {
        for (const mechanism::Body& body : mechanism.bodies) {
            firstColumn_.push_back(body.fixed ? -1 : columns_);
            columns_ += body.fixed ? 0 : 6;
        }
    }

    void addJoint(int index, Model model) {
        const mechanism::Joint& joint = mechanism_.joints[static_cast<std::size_t>(index)];
        const auto& freedoms = model == Model::Built ? joint.built : joint.relaxed;
        for (const Vec3& direction : held(freedoms, FreedomKind::Slide)) {
            add({joint.name, "slide", direction, index, -1, 0.0}, Priority::JointSlide);
            addSlide(joint.first, joint.second, joint.point, direction);
        }
        for (const Vec3& direction : held(freedoms, FreedomKind::Turn)) {
            add({joint.name, "turn", direction, index, -1, 0.0}, Priority::JointTurn);
            addTurn(joint.first, joint.second, direction);
        }
    }

    void addContact(int index, Model model) {
        const mechanism::Wheel& wheel = mechanism_.wheels[static_cast<std::size_t>(index)];
        const std::string name = "contact " + wheel.name;
        const Vec3 up = Vec3::UnitZ();
        const Vec3 forward = wheel.axis.cross(up).normalized();
        const Vec3 point = wheel.center - wheel.radius * forward.cross(wheel.axis);
        add({name, "slide", up, -1, index, 0.0}, Priority::ContactNormal);
        addSlide(-1, wheel.body, point, up);
        add({name, "slide", forward, -1, index, 0.0}, Priority::ContactRolling);
        addSlide(-1, wheel.body, point, forward);
        if (model == Model::Built || !wheel.relaxedLateral) {
            const Vec3 lateral = up.cross(forward);
            add({name, "slide", lateral, -1, index, 0.0}, Priority::ContactLateral);
            addSlide(-1, wheel.body, point, lateral);
        }
    }

    /// turn(second) - ratio turn(first) = 0.
    void addGear(const mechanism::Gear& gear) {
        const mechanism::Joint& first =
            mechanism_.joints[static_cast<std::size_t>(gear.firstJoint)];
        const mechanism::Joint& second =
            mechanism_.joints[static_cast<std::size_t>(gear.secondJoint)];
        add({gear.name, "gear", second.axis, gear.secondJoint, -1, 0.0}, Priority::Gear);
        addTurn(second.first, second.second, second.axis);
        addTurn(first.first, first.second, -gear.ratio * first.axis);
    }

    ConstraintJacobian finish() {
        ConstraintJacobian jacobian;
        jacobian.matrix.setZero(static_cast<Eigen::Index>(names_.size()), columns_);
        for (const Entry& entry : entries_) {
            jacobian.matrix.block<1, 3>(entry.row, entry.column) += entry.linear.transpose();
            jacobian.matrix.block<1, 3>(entry.row, entry.column + 3) += entry.angular.transpose();
        }
        jacobian.firstColumn = std::move(firstColumn_);
        jacobian.names = std::move(names_);
        jacobian.priorities = std::move(priorities_);
        return jacobian;
    }

  private:
    struct Entry {
        Eigen::Index row;
        int column;
        Vec3 linear;
        Vec3 angular;
    };

    static std::vector<Vec3> held(const std::vector<Freedom>& freedoms, FreedomKind kind) {
        std::vector<Vec3> free;
        for (const Freedom& freedom : freedoms) {
            if (freedom.kind == kind) {
                free.push_back(freedom.direction);
            }
        }
        return orthogonalComplement(free);
    }

    void add(ConstraintName name, Priority priority) {
        names_.push_back(std::move(name));
        priorities_.push_back(priority);
    }

    void addEntry(int body, const Vec3& linear, const Vec3& angular) {
        const int column = body < 0 ? -1 : firstColumn_[static_cast<std::size_t>(body)];
        if (column >= 0) {
            entries_.push_back(
                {static_cast<Eigen::Index>(names_.size()) - 1, column, linear, angular});
        }
    }

    /// Relative velocity of the two bodies at `point` along `direction`: d.(v + w x p) / L.
    void addSlide(int first, int second, const Vec3& point, const Vec3& direction) {
        const Vec3 angular = point.cross(direction) / length_;
        addEntry(second, direction, angular);
        addEntry(first, -direction, -angular);
    }

    void addTurn(int first, int second, const Vec3& direction) {
        addEntry(second, Vec3::Zero(), direction);
        addEntry(first, Vec3::Zero(), -direction);
    }

    const Mechanism& mechanism_;
    double length_;
    int columns_ = 0;
    std::vector<int> firstColumn_;
    std::vector<ConstraintName> names_;
    std::vector<Priority> priorities_;
    std::vector<Entry> entries_;
};

}  // namespace

std::vector<Vec3> orthogonalComplement(const std::vector<Vec3>& directions) {
    std::vector<Vec3> basis;  // orthonormal, spans the given directions and then the complement
    const auto rest = [&](Vec3 v) {
        for (const Vec3& b : basis) {
            v -= v.dot(b) * b;
        }
        return v;
    };
    for (const Vec3& direction : directions) {
        const Vec3 v = rest(direction);
        if (v.norm() > 1e-9) {
            basis.push_back(v.normalized());
        }
    }
    std::vector<Vec3> complement;
    while (basis.size() < 3) {
        Vec3 best = Vec3::Zero();
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 v = rest(Vec3::Unit(axis));
            if (v.norm() > best.norm() + 1e-9) {
                best = v;
            }
        }
        best.normalize();
        basis.push_back(best);
        complement.push_back(best);
    }
    return complement;
}

ConstraintJacobian constraintJacobian(const Mechanism& mechanism, Model model) {
    Assembler assembler(mechanism);
    for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
        assembler.addJoint(static_cast<int>(i), model);
    }
    for (std::size_t i = 0; i < mechanism.wheels.size(); ++i) {
        assembler.addContact(static_cast<int>(i), model);
    }
    for (const mechanism::Gear& gear : mechanism.gears) {
        assembler.addGear(gear);
    }
    return assembler.finish();
}

}  // namespace simcore::mobility
