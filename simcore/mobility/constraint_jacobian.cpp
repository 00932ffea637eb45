#include "simcore/mobility/constraint_jacobian.h"

#include "simcore/mobility/constraint_system.h"

namespace simcore::mobility {

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

ConstraintJacobian constraintJacobian(const mechanism::Mechanism& mechanism, Model model) {
    return constraintJacobian(mechanism, model, drawnStance(mechanism));
}

ConstraintJacobian constraintJacobian(const mechanism::Mechanism& mechanism, Model model,
                                      const Stance& stance) {
    return ConstraintSystem(mechanism, model, stance).jacobian();
}

}  // namespace simcore::mobility
