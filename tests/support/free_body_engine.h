#pragma once

#include "simcore/dynamics/engine.h"

namespace testsupport {

/// A second engine behind the port, written in an afternoon: free rigid bodies by their momenta,
/// contacts as springs and dampers with viscous friction below the Coulomb limit, many substeps.
/// It has no joints, springs or gears.
/// @throws std::invalid_argument when the mechanism has any
std::unique_ptr<simcore::dynamics::Engine> makeFreeBodyEngine(
    const simcore::mechanism::Mechanism& mechanism,
    const simcore::dynamics::EngineSettings& settings);

}  // namespace testsupport
