#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "simcore/contact/body_contacts.h"
#include "simcore/dynamics/engine.h"
#include "tests/support/carts.h"
#include "tests/support/free_body_engine.h"

/// The engines that the conformance suite runs on, and a world to run one in.
namespace testsupport {

using simcore::dynamics::BodyVelocity;
using simcore::dynamics::Engine;
using simcore::dynamics::EngineMaker;
using simcore::dynamics::EngineSettings;

enum class Can { Contacts, Joints };

struct EngineCase {
    std::string name;
    std::set<Can> can;
    EngineMaker make;
    /// How far the friction of a sliding contact may be off mu times its normal force [-].
    double frictionSlack = 0.0;
};

/// GoogleTest's name of an engine.
inline void PrintTo(const EngineCase& engine, std::ostream* out) {  // NOLINT: name given by gtest
    *out << engine.name;
}

inline const std::vector<EngineCase>& allEngines() {
    // ODE's limits agree with its normal forces to 1 %, and its boxes have corners 1 % outside the
    // cone (docs/engines.md); the others iterate forces until they agree to well below 1e-4.
    static const std::vector<EngineCase> engines{
        {"Ode", {Can::Contacts, Can::Joints}, simcore::dynamics::makeOdeEngine, 0.02},
        {"Reduced", {Can::Contacts, Can::Joints}, simcore::dynamics::makeReducedEngine, 1e-4},
        {"FreeBody", {Can::Contacts}, makeFreeBodyEngine, 1e-4}};
    return engines;
}

inline std::vector<EngineCase> enginesThatCan(Can what) {
    std::vector<EngineCase> found;
    for (const EngineCase& engine : allEngines()) {
        if (engine.can.contains(what)) {
            found.push_back(engine);
        }
    }
    return found;
}

inline std::string nameOfCase(const ::testing::TestParamInfo<EngineCase>& info) {
    return info.param.name;
}

/// An engine with what it runs on; the torques last until they are changed.
class World {
  public:
    World(const EngineCase& engine, Mechanism mechanism, double gravity, double step = 0.001,
          simcore::mechanism::Model joints = simcore::mechanism::Model::Built)
        : mechanism_(std::move(mechanism)),
          step_(step),
          engine_(engine.make(mechanism_, {step, gravity, joints})),
          drive(mechanism_.wheels.size(), 0.0),
          external(mechanism_.wheels.size(), 0.0) {}

    /// From here on the wheels, and bodies with shapes, touch this ground.
    void placeOn(const simcore::terrain::Terrain& terrain, double friction) {
        finder_ = std::make_unique<simcore::contact::WheelContactFinder>(mechanism_, terrain, 2,
                                                                         engine_->contactMargin());
        bodyFinder_ = std::make_unique<simcore::contact::BodyContactFinder>(
            mechanism_, terrain, engine_->contactMargin());
        friction_ = friction;
    }

    void step() {
        if (finder_) {
            contacts_ = finder_->find(engine_->poses());
            const auto& ofBodies = bodyFinder_->find(engine_->poses());
            contacts_.insert(contacts_.end(), ofBodies.begin(), ofBodies.end());
        }
        frictions_.assign(contacts_.size(), friction_);
        engine_->step({drive, external, contacts_, frictions_, motors});
    }

    void run(double seconds) {
        for (long i = std::lround(seconds / step_); i > 0; --i) {
            step();
        }
    }

    Vec3 momentum() const {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
            sum += mechanism_.bodies[i].mass * engine_->velocities()[i].linear;
        }
        return sum;
    }

    /// About the world's origin.
    Vec3 angularMomentum() const {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
            const Body& body = mechanism_.bodies[i];
            const BodyVelocity& velocity = engine_->velocities()[i];
            sum += (engine_->poses()[i] * body.com).cross(body.mass * velocity.linear) +
                   inertia(i) * velocity.angular;
        }
        return sum;
    }

    double kineticEnergy() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
            const BodyVelocity& velocity = engine_->velocities()[i];
            sum += 0.5 * mechanism_.bodies[i].mass * velocity.linear.squaredNorm() +
                   0.5 * velocity.angular.dot(inertia(i) * velocity.angular);
        }
        return sum;
    }

    /// Sum of the contact forces along the given direction [N].
    double contactForce(const Vec3& direction) const {
        double sum = 0.0;
        for (const Vec3& force : engine_->contactForces()) {
            sum += force.dot(direction);
        }
        return sum;
    }

    /// Of the last step.
    const std::vector<simcore::contact::Contact>& contacts() const { return contacts_; }

    Engine& engine() { return *engine_; }

    const Engine& engine() const { return *engine_; }

    const Mechanism& mechanism() const { return mechanism_; }

  private:
    Mat3 inertia(std::size_t body) const {
        const Mat3 R = engine_->poses()[body].rotation.toRotationMatrix();
        return R * mechanism_.inertiaWithRotor(body) * R.transpose();
    }

    const Mechanism mechanism_;
    double step_;
    std::unique_ptr<Engine> engine_;
    std::unique_ptr<simcore::contact::WheelContactFinder> finder_;
    std::unique_ptr<simcore::contact::BodyContactFinder> bodyFinder_;
    std::vector<simcore::contact::Contact> contacts_;
    double friction_ = 0.7;
    std::vector<double> frictions_;

  public:
    std::vector<double> drive;
    std::vector<double> external;
    std::vector<simcore::dynamics::JointMotor> motors;
};

}  // namespace testsupport
