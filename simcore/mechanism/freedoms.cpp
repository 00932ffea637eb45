#include "simcore/mechanism/freedoms.h"

namespace simcore::mechanism {

const std::vector<Freedom>& freedomsOf(const Joint& joint, Model model) {
    return model == Model::Built ? joint.built : joint.relaxed;
}

std::vector<Vec3> directionsOf(const std::vector<Freedom>& freedoms, FreedomKind kind) {
    std::vector<Vec3> directions;
    for (const Freedom& freedom : freedoms) {
        if (freedom.kind == kind) {
            directions.push_back(freedom.direction);
        }
    }
    return directions;
}

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

double jointAngle(const Joint& joint, const std::vector<Pose>& poses) {
    return turnAbout(poses[static_cast<std::size_t>(joint.first)].rotation.conjugate() *
                         poses[static_cast<std::size_t>(joint.second)].rotation,
                     joint.axis);
}

}  // namespace simcore::mechanism
