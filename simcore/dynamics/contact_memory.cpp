#include "simcore/dynamics/contact_memory.h"

#include <stdexcept>

namespace simcore::dynamics {
namespace {

constexpr double kSameContact = 0.03;  // [m]
constexpr std::size_t kNumbers = 12;

}  // namespace

const ContactMemory::Remembered* ContactMemory::recall(const contact::Contact& contact) const {
    const Remembered* best = nullptr;
    double bestDistance = kSameContact;
    for (const Remembered& old : memory_) {
        if (old.wheel != contact.wheel || old.body != contact.body || old.slice != contact.slice) {
            continue;
        }
        const double distance = (old.point - contact.point).norm();
        if (distance < bestDistance) {
            best = &old;
            bestDistance = distance;
        }
    }
    return best;
}

void ContactMemory::remember(std::span<const contact::Contact> contacts,
                             std::span<const Vec3> forces) {
    memory_.resize(contacts.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const contact::Contact& c = contacts[i];
        memory_[i] = {c.wheel, c.body, c.slice, c.point, forces[i], c.normal};
    }
}

void ContactMemory::save(std::vector<double>& numbers) const {
    for (const Remembered& m : memory_) {
        numbers.insert(numbers.end(), {static_cast<double>(m.wheel), static_cast<double>(m.body),
                                       static_cast<double>(m.slice), m.point.x(), m.point.y(),
                                       m.point.z(), m.force.x(), m.force.y(), m.force.z(),
                                       m.normal.x(), m.normal.y(), m.normal.z()});
    }
}

void ContactMemory::restore(std::span<const double> numbers) {
    if (numbers.size() % kNumbers != 0) {
        throw std::invalid_argument("the state belongs to another mechanism");
    }
    memory_.clear();
    for (; !numbers.empty(); numbers = numbers.subspan(kNumbers)) {
        memory_.push_back({static_cast<int>(numbers[0]),
                           static_cast<int>(numbers[1]),
                           static_cast<int>(numbers[2]),
                           {numbers[3], numbers[4], numbers[5]},
                           {numbers[6], numbers[7], numbers[8]},
                           {numbers[9], numbers[10], numbers[11]}});
    }
}

}  // namespace simcore::dynamics
