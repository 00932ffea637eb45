#pragma once

#include <stdexcept>

#include "simcore/project/resolve.h"
#include "tests/support/projects.h"

/// Mechanisms of the shipped projects.
namespace testsupport {

inline simcore::mechanism::Mechanism mechanismOf(const std::string& name) {
    auto mechanism = simcore::project::resolve(shipped(name));
    if (!mechanism) {
        throw std::runtime_error(toString(mechanism.problems()));
    }
    return std::move(mechanism).value();
}

}  // namespace testsupport
