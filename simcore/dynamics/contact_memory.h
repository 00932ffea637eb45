#pragma once

#include <span>
#include <vector>

#include "simcore/contact/wheel_contact.h"

namespace simcore::dynamics {

/// The contact forces of the last step, to start the next one from: a contact is the same one when
/// it is on the same disc of the same wheel (or body) and within 30 mm.
class ContactMemory {
  public:
    struct Remembered {
        int wheel = 0;
        int body = 0;  ///< of contacts that are no wheel's
        int slice = 0;
        Vec3 point = Vec3::Zero();  ///< world [m]
        Vec3 force = Vec3::Zero();  ///< of the ground on the wheel, world [N]
        Vec3 normal = Vec3::UnitZ();
    };

    /// The nearest one that is the same; null when there is none.
    const Remembered* recall(const contact::Contact& contact) const;
    void remember(std::span<const contact::Contact> contacts, std::span<const Vec3> forces);

    void clear() { memory_.clear(); }

    void reserve(std::size_t contacts) { memory_.reserve(contacts); }

    void save(std::vector<double>& numbers) const;
    /// @throws std::invalid_argument when these are not whole contacts
    void restore(std::span<const double> numbers);

  private:
    std::vector<Remembered> memory_;
};

}  // namespace simcore::dynamics
