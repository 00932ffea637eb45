#pragma once

#include <span>
#include <vector>

#include "simcore/dynamics/contact_memory.h"

/// Friction limits that follow the normal forces of the same step.
///
/// ODE's direct solver fixes friction limits before it solves. Limits taken from a frictionless
/// solve (its "approximation 1") leave a wheel that is pressed to a wall only by the friction of
/// the others without grip. So limits are guessed from the last step and the step is solved again
/// until they agree with the normal forces found: a fixed point. The friction box is narrow and
/// turned against the sliding direction, or along the tangential force of a wheel that sticks, so
/// that it stands for the friction cone there.
namespace simcore::dynamics {

struct FrictionBox {
    bool fromNormalForce = true;     ///< no guess yet: let the solver approximate
    Vec3 direction = Vec3::UnitX();  ///< unit, in the contact plane
    double along = 0.0;              ///< limit along direction [N]
    double across = 0.0;             ///< limit across it [N]
};

class FrictionBounds {
  public:
    /// First guesses for these contacts, from the forces remembered of the last step.
    /// @param frictions  Coulomb coefficient of each contact [-]
    void begin(std::span<const contact::Contact> contacts, std::span<const double> frictions);

    const FrictionBox& box(std::size_t contact) const { return boxes_[contact]; }

    /// Takes the forces found with the present boxes and the wheels' velocities at the contacts
    /// after the step. True when they agree; else the boxes are improved.
    bool update(std::span<const contact::Contact> contacts, std::span<const Vec3> forces,
                std::span<const Vec3> velocities);

    /// Remembers the forces of the accepted solve.
    void end(std::span<const contact::Contact> contacts, std::span<const Vec3> forces) {
        memory_.remember(contacts, forces);
    }

    void clear() { memory_.clear(); }

    void save(std::vector<double>& numbers) const { memory_.save(numbers); }

    void restore(std::span<const double> numbers) { memory_.restore(numbers); }

  private:
    std::vector<double> frictions_;
    int updates_ = 0;
    std::vector<FrictionBox> boxes_;
    ContactMemory memory_;
};

}  // namespace simcore::dynamics
