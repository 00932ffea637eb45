#include "tests/support/free_body_engine.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace testsupport {
namespace {

using namespace simcore;
using namespace simcore::dynamics;

constexpr double kSubstep = 5e-5;       // [s]
constexpr double kStiffness = 1e4;      // of a contact, per mass [N/(m kg)]
constexpr double kDamping = 100.0;      // [N s/(m kg)]
constexpr double kTangential = 1000.0;  // [N s/(m kg)]
constexpr std::size_t kNumbersPerBody = 13;

struct State {
    Vec3 position;
    Eigen::Quaterniond rotation;
    Vec3 momentum;  // linear
    Vec3 spin;      // angular momentum about the centre of mass, world
};

Eigen::Quaterniond turned(const Eigen::Quaterniond& rotation, const Vec3& turn) {
    const double angle = turn.norm();
    return angle > 0.0 ? (Eigen::AngleAxisd(angle, turn / angle) * rotation).normalized()
                       : rotation;
}

class FreeBodyEngine final : public Engine {
  public:
    FreeBodyEngine(const mechanism::Mechanism& mechanism, const EngineSettings& settings)
        : mechanism_(mechanism),
          settings_(settings) {
        if (!mechanism.joints.empty() || !mechanism.springs.empty() || !mechanism.gears.empty()) {
            throw std::invalid_argument("free bodies only");
        }
        reset();
    }

    std::string name() const override { return "free-body"; }

    void reset() override {
        state_.clear();
        for (const mechanism::Body& body : mechanism_.bodies) {
            state_.push_back(
                {body.com, Eigen::Quaterniond::Identity(), Vec3::Zero(), Vec3::Zero()});
        }
        contactForces_.clear();
        counters_ = {};
        publish();
    }

    void step(const StepInput& input) override {
        const int substeps = static_cast<int>(std::ceil(settings_.step / kSubstep));
        const double h = settings_.step / substeps;
        std::vector<Vec3> torques(state_.size(), Vec3::Zero());
        for (std::size_t i = 0; i < input.wheelTorques.size(); ++i) {
            const mechanism::Wheel& wheel = mechanism_.wheels[i];
            const auto body = static_cast<std::size_t>(wheel.body);
            const Vec3 axis = state_[body].rotation * wheel.axis;
            torques[body] += (input.wheelTorques[i] + input.externalTorques[i]) * axis;
            torques[static_cast<std::size_t>(wheel.carrier)] -= input.wheelTorques[i] * axis;
        }
        std::vector<double> depths;
        std::vector<Vec3> arms;
        for (const contact::Contact& contact : input.contacts) {
            depths.push_back(contact.depth);
            arms.push_back(contact.point - state_[bodyOf(contact)].position);
        }
        contactForces_.assign(input.contacts.size(), Vec3::Zero());
        for (int substep = 0; substep < substeps; ++substep) {
            for (std::size_t i = 0; i < state_.size(); ++i) {
                state_[i].momentum.z() -= mechanism_.bodies[i].mass * settings_.gravity * h;
                state_[i].spin += torques[i] * h;
            }
            for (std::size_t k = 0; k < input.contacts.size(); ++k) {
                const Vec3 force =
                    push(input.contacts[k], arms[k], input.frictions[k], h, depths[k]);
                State& state = state_[bodyOf(input.contacts[k])];
                state.momentum += force * h;
                state.spin += arms[k].cross(force) * h;
                contactForces_[k] += force / substeps;
            }
            for (std::size_t i = 0; i < state_.size(); ++i) {
                move(i, h);
            }
        }
        publish();
        ++counters_.steps;
        ++counters_.passes;
    }

    const std::vector<Pose>& poses() const override { return poses_; }

    const std::vector<BodyVelocity>& velocities() const override { return velocities_; }

    const std::vector<Vec3>& contactForces() const override { return contactForces_; }

    const std::vector<JointReaction>& jointReactions() const override { return noReactions_; }

    void writeState(std::vector<double>& numbers) const override {
        numbers.clear();
        for (const State& s : state_) {
            for (const Vec3& v : {s.position, s.momentum, s.spin}) {
                numbers.insert(numbers.end(), {v.x(), v.y(), v.z()});
            }
            const Eigen::Vector4d& q = s.rotation.coeffs();
            numbers.insert(numbers.end(), {q[0], q[1], q[2], q[3]});
        }
    }

    void restoreState(std::span<const double> numbers) override {
        if (numbers.size() != state_.size() * kNumbersPerBody) {
            throw std::invalid_argument("the state belongs to another mechanism");
        }
        for (std::size_t i = 0; i < state_.size(); ++i) {
            const double* n = numbers.data() + i * kNumbersPerBody;
            state_[i].position = {n[0], n[1], n[2]};
            state_[i].momentum = {n[3], n[4], n[5]};
            state_[i].spin = {n[6], n[7], n[8]};
            state_[i].rotation.coeffs() = Eigen::Vector4d(n[9], n[10], n[11], n[12]);
        }
        publish();
    }

    const EngineCounters& counters() const override { return counters_; }

  private:
    std::size_t bodyOf(const contact::Contact& contact) const {
        return static_cast<std::size_t>(contact::bodyOf(contact, mechanism_));
    }

    Vec3 angularVelocity(std::size_t body, const Eigen::Quaterniond& rotation) const {
        const Mat3 R = rotation.toRotationMatrix();
        return R * mechanism_.bodies[body].inertia.inverse() * R.transpose() * state_[body].spin;
    }

    Vec3 push(const contact::Contact& contact, const Vec3& arm, double friction, double h,
              double& depth) const {
        const std::size_t body = bodyOf(contact);
        const double mass = mechanism_.bodies[body].mass;
        const Vec3 velocity =
            state_[body].momentum / mass + angularVelocity(body, state_[body].rotation).cross(arm);
        const double approach = -velocity.dot(contact.normal);
        depth += approach * h;
        const double normal =
            depth > 0.0 ? std::max(0.0, mass * (kStiffness * depth + kDamping * approach)) : 0.0;
        const Vec3 sliding = velocity + approach * contact.normal;
        const double speed = sliding.norm();
        const double tangential = std::min(friction * normal, kTangential * mass * speed);
        return normal * contact.normal - (speed > 0.0 ? tangential / speed : 0.0) * sliding;
    }

    void move(std::size_t body, double h) {
        State& state = state_[body];
        state.position += state.momentum / mechanism_.bodies[body].mass * h;
        const Vec3 start = angularVelocity(body, state.rotation);
        const Vec3 middle = angularVelocity(body, turned(state.rotation, 0.5 * h * start));
        state.rotation = turned(state.rotation, h * middle);
    }

    void publish() {
        poses_.resize(state_.size());
        velocities_.resize(state_.size());
        for (std::size_t i = 0; i < state_.size(); ++i) {
            poses_[i].rotation = state_[i].rotation;
            poses_[i].position = state_[i].position - state_[i].rotation * mechanism_.bodies[i].com;
            velocities_[i] = {state_[i].momentum / mechanism_.bodies[i].mass,
                              angularVelocity(i, state_[i].rotation)};
        }
    }

    const mechanism::Mechanism mechanism_;
    EngineSettings settings_;
    std::vector<State> state_;
    std::vector<Pose> poses_;
    std::vector<BodyVelocity> velocities_;
    std::vector<Vec3> contactForces_;
    std::vector<JointReaction> noReactions_;
    EngineCounters counters_;
};

}  // namespace

std::unique_ptr<Engine> makeFreeBodyEngine(const mechanism::Mechanism& mechanism,
                                           const EngineSettings& settings) {
    return std::make_unique<FreeBodyEngine>(mechanism, settings);
}

}  // namespace testsupport
