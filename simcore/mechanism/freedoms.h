#pragma once

#include <vector>

#include "simcore/mechanism/mechanism.h"

/// What the joints of a mechanism leave free, and how far they have turned.
namespace simcore::mechanism {

/// Which freedoms the joints have: those the rover is built with, or those of the relaxed model.
enum class Model { Built, Relaxed };

const std::vector<Freedom>& freedomsOf(const Joint& joint, Model model);

/// Directions of the freedoms of one kind, in their order.
std::vector<Vec3> directionsOf(const std::vector<Freedom>& freedoms, FreedomKind kind);

/// Orthonormal directions at right angles to all of `directions`, as close to the rover's axes as
/// can be.
std::vector<Vec3> orthogonalComplement(const std::vector<Vec3>& directions);

/// Turn of a joint's second body against its first about the joint's axis [rad], (-pi, pi].
double jointAngle(const Joint& joint, const std::vector<Pose>& poses);

}  // namespace simcore::mechanism
