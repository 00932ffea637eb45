#include "simcore/mechanism/mechanism.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace simcore::mechanism {
namespace {

template <class Element>
int findNamed(const std::vector<Element>& elements, const std::string& name) {
    const auto found = std::find_if(elements.begin(), elements.end(),
                                    [&](const Element& e) { return e.name == name; });
    return found == elements.end() ? -1 : static_cast<int>(found - elements.begin());
}

}  // namespace

double Mechanism::mass() const {
    double total = 0.0;
    for (const Body& body : bodies) {
        total += body.mass;
    }
    return total;
}

Vec3 Mechanism::centerOfMass() const {
    return centerOfMass(std::vector<Pose>(bodies.size()));
}

Vec3 Mechanism::centerOfMass(const std::vector<Pose>& poses) const {
    Vec3 moment = Vec3::Zero();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        moment += bodies[i].mass * (poses[i] * bodies[i].com);
    }
    const double total = mass();
    return total > 0.0 ? Vec3(moment / total) : Vec3::Zero();
}

Mat3 Mechanism::inertiaWithRotor(std::size_t body) const {
    Mat3 inertia = bodies[body].inertia;
    for (const Wheel& wheel : wheels) {
        if (wheel.body == static_cast<int>(body)) {
            inertia += wheel.rotorInertia * wheel.axis * wheel.axis.transpose();
        }
    }
    return inertia;
}

double Mechanism::wheelbase() const {
    if (wheels.size() < 2) {
        return 1.0;
    }
    double front = -std::numeric_limits<double>::infinity();
    double rear = std::numeric_limits<double>::infinity();
    for (const Wheel& wheel : wheels) {
        front = std::max(front, wheel.center.x());
        rear = std::min(rear, wheel.center.x());
    }
    // Two wheels side by side have no wheelbase to scale by.
    return front - rear > 1e-6 ? front - rear : 1.0;
}

std::vector<int> Mechanism::encoderJoints() const {
    std::vector<int> found;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const bool axle = std::any_of(wheels.begin(), wheels.end(), [i](const Wheel& wheel) {
            return wheel.axle == static_cast<int>(i);
        });
        const bool turns = std::any_of(
            joints[i].built.begin(), joints[i].built.end(), [&](const Freedom& freedom) {
                return freedom.kind == FreedomKind::Turn &&
                       std::abs(freedom.direction.dot(joints[i].axis)) > 1.0 - 1e-9;
            });
        if (turns && !axle) {
            found.push_back(static_cast<int>(i));
        }
    }
    return found;
}

int Mechanism::findBody(const std::string& partName) const {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto& parts = bodies[i].parts;
        if (std::find(parts.begin(), parts.end(), partName) != parts.end()) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

int Mechanism::findJoint(const std::string& jointName) const {
    return findNamed(joints, jointName);
}

int Mechanism::findWheel(const std::string& wheelName) const {
    return findNamed(wheels, wheelName);
}

}  // namespace simcore::mechanism
