#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "simcore/dynamics/contact_law.h"
#include "simcore/dynamics/engine.h"
#include "simcore/dynamics/friction_bounds.h"
#include "simcore/dynamics/loop_closures.h"
#include "simcore/dynamics/ode_joints.h"
#include "simcore/dynamics/ode_world.h"

namespace simcore::dynamics {
namespace {

/// State of one body as ODE integrates it: of its centre of mass.
struct BodyState {
    Vec3 position;  ///< centre of mass, world [m]
    Eigen::Quaterniond rotation;
    BodyVelocity velocity;
};

constexpr std::size_t kNumbersPerBody = 13;
/// Solves per step at most: the friction bounds must agree with the normal forces of this step.
constexpr int kMaxPasses = 12;
/// Repetitions of a solve that ODE gave up, and by how much, relatively, they change its friction
/// limits: far below the 1 % to which limits are iterated, far above rounding (assumed).
constexpr int kMaxRepetitions = 4;
constexpr double kRepetitionChange = 1e-5;

class OdeEngine final : public Engine {
  public:
    OdeEngine(const mechanism::Mechanism& mechanism, const EngineSettings& settings);

    std::string name() const override { return "ode"; }

    double contactMargin() const override { return kContactMargin; }

    void reset() override;
    void step(const StepInput& input) override;

    const std::vector<Pose>& poses() const override { return poses_; }

    const std::vector<BodyVelocity>& velocities() const override { return velocities_; }

    const std::vector<Vec3>& contactForces() const override { return contactForces_; }

    const std::vector<JointReaction>& jointReactions() const override { return jointReactions_; }

    void writeState(std::vector<double>& numbers) const override;
    void restoreState(std::span<const double> state) override;

    const EngineCounters& counters() const override { return counters_; }

  private:
    void makeBodies();
    void loadState(const std::vector<BodyState>& state);
    void readState();
    void applyForces(const StepInput& input);
    void applySpring(const mechanism::Spring& spring);
    void solve(const StepInput& input, const OdeSolve& solve);
    void makeContacts(const StepInput& input, int repetition);
    void readContacts(const StepInput& input);
    void updatePoses();

    const mechanism::Mechanism mechanism_;
    EngineSettings settings_;
    OdeWorld world_;
    std::vector<dBodyID> bodies_;
    std::unique_ptr<OdeJoints> joints_;
    std::vector<BodyState> state_;
    FrictionBounds bounds_;
    std::vector<dJointFeedback> feedback_;
    std::vector<Pose> poses_;
    std::vector<BodyVelocity> velocities_;
    std::vector<Vec3> contactForces_;
    std::vector<Vec3> contactVelocities_;
    std::vector<JointReaction> jointReactions_;
    const std::vector<bool> determined_;  ///< of every joint, at the drawn pose
    EngineCounters counters_;
};

OdeEngine::OdeEngine(const mechanism::Mechanism& mechanism, const EngineSettings& settings)
    : mechanism_(mechanism),
      settings_(settings),
      determined_(determinedJoints(mechanism, settings.joints)) {
    if (const Problems problems = whyOdeCannotRun(mechanism); !problems.empty()) {
        throw std::invalid_argument(toString(problems));
    }
    dWorldSetGravity(world_.world(), 0.0, 0.0, -settings.gravity);
    makeBodies();
    joints_ = std::make_unique<OdeJoints>(world_.world(), mechanism_, settings.joints, bodies_);
    reset();
}

void OdeEngine::makeBodies() {
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
        const mechanism::Body& body = mechanism_.bodies[i];
        const Mat3 inertia = mechanism_.inertiaWithRotor(i);
        dMass mass;
        dMassSetParameters(&mass, body.mass, 0, 0, 0, inertia(0, 0), inertia(1, 1), inertia(2, 2),
                           inertia(0, 1), inertia(0, 2), inertia(1, 2));
        const dBodyID id = dBodyCreate(world_.world());
        dBodySetMass(id, &mass);
        dBodySetPosition(id, body.com.x(), body.com.y(), body.com.z());
        dBodySetGyroscopicMode(id, 1);
        if (body.fixed) {
            dBodySetKinematic(id);
        }
        bodies_.push_back(id);
    }
}

void OdeEngine::reset() {
    state_.clear();
    for (const mechanism::Body& body : mechanism_.bodies) {
        state_.push_back({body.com, Eigen::Quaterniond::Identity(), {}});
    }
    for (const Vec3& position : joints_->auxiliaryPositions()) {
        state_.push_back({position, Eigen::Quaterniond::Identity(), {}});
    }
    bounds_.clear();
    contactForces_.clear();
    jointReactions_.clear();
    counters_ = {};
    updatePoses();
}

void OdeEngine::loadState(const std::vector<BodyState>& state) {
    const std::vector<dBodyID>& ids = joints_->allBodies();
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const BodyState& s = state[i];
        const dQuaternion q{s.rotation.w(), s.rotation.x(), s.rotation.y(), s.rotation.z()};
        dBodySetPosition(ids[i], s.position.x(), s.position.y(), s.position.z());
        dBodySetQuaternion(ids[i], q);
        dBodySetLinearVel(ids[i], s.velocity.linear.x(), s.velocity.linear.y(),
                          s.velocity.linear.z());
        dBodySetAngularVel(ids[i], s.velocity.angular.x(), s.velocity.angular.y(),
                           s.velocity.angular.z());
        dBodySetForce(ids[i], 0, 0, 0);
        dBodySetTorque(ids[i], 0, 0, 0);
    }
}

void OdeEngine::readState() {
    const std::vector<dBodyID>& ids = joints_->allBodies();
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const dReal* q = dBodyGetQuaternion(ids[i]);
        state_[i] = {toVec3(dBodyGetPosition(ids[i])),
                     Eigen::Quaterniond(q[0], q[1], q[2], q[3]),
                     {toVec3(dBodyGetLinearVel(ids[i])), toVec3(dBodyGetAngularVel(ids[i]))}};
    }
}

void OdeEngine::updatePoses() {
    poses_.resize(mechanism_.bodies.size());
    velocities_.resize(mechanism_.bodies.size());
    for (std::size_t i = 0; i < poses_.size(); ++i) {
        poses_[i].rotation = state_[i].rotation;
        poses_[i].position = state_[i].position - state_[i].rotation * mechanism_.bodies[i].com;
        velocities_[i] = state_[i].velocity;
    }
}

void OdeEngine::applySpring(const mechanism::Spring& spring) {
    const auto first = static_cast<std::size_t>(spring.first);
    const auto second = static_cast<std::size_t>(spring.second);
    if (spring.joint >= 0) {
        const mechanism::Joint& joint = mechanism_.joints[static_cast<std::size_t>(spring.joint)];
        const double torque = spring.preload - spring.stiffness * jointAngle(joint, poses_) -
                              spring.damping * jointRate(joint, poses_, velocities_);
        const Vec3 t = torque * (poses_[first].rotation * joint.axis);
        dBodyAddTorque(bodies_[second], t.x(), t.y(), t.z());
        dBodyAddTorque(bodies_[first], -t.x(), -t.y(), -t.z());
        return;
    }
    const Vec3 a = poses_[first] * spring.firstPoint;
    const Vec3 b = poses_[second] * spring.secondPoint;
    const auto velocityAt = [&](std::size_t body, const Vec3& p) -> Vec3 {
        return velocities_[body].linear +
               velocities_[body].angular.cross(p - state_[body].position);
    };
    const Vec3 direction = (b - a).normalized();
    const double drawnLength = (spring.secondPoint - spring.firstPoint).norm();
    const double rate = direction.dot(velocityAt(second, b) - velocityAt(first, a));
    const double push =
        spring.preload + spring.stiffness * (drawnLength - (b - a).norm()) - spring.damping * rate;
    const Vec3 f = push * direction;
    dBodyAddForceAtPos(bodies_[second], f.x(), f.y(), f.z(), b.x(), b.y(), b.z());
    dBodyAddForceAtPos(bodies_[first], -f.x(), -f.y(), -f.z(), a.x(), a.y(), a.z());
}

void OdeEngine::applyForces(const StepInput& input) {
    for (const mechanism::Spring& spring : mechanism_.springs) {
        applySpring(spring);
    }
    for (const mechanism::Joint& joint : mechanism_.joints) {
        if (joint.damping > 0.0) {
            const auto first = static_cast<std::size_t>(joint.first);
            const Vec3 t = -joint.damping * jointRate(joint, poses_, velocities_) *
                           (poses_[first].rotation * joint.axis);
            dBodyAddTorque(bodies_[static_cast<std::size_t>(joint.second)], t.x(), t.y(), t.z());
            dBodyAddTorque(bodies_[first], -t.x(), -t.y(), -t.z());
        }
    }
    for (std::size_t i = 0; i < mechanism_.wheels.size(); ++i) {
        const mechanism::Wheel& wheel = mechanism_.wheels[i];
        const auto body = static_cast<std::size_t>(wheel.body);
        const Vec3 axis_W = poses_[body].rotation * wheel.axis;
        const Vec3 drive = input.wheelTorques[i] * axis_W;
        const Vec3 onWheel = drive + input.externalTorques[i] * axis_W;
        dBodyAddTorque(bodies_[body], onWheel.x(), onWheel.y(), onWheel.z());
        dBodyAddTorque(bodies_[static_cast<std::size_t>(wheel.carrier)], -drive.x(), -drive.y(),
                       -drive.z());
    }
}

void OdeEngine::makeContacts(const StepInput& input, int repetition) {
    feedback_.assign(input.contacts.size(), {});
    for (std::size_t i = 0; i < input.contacts.size(); ++i) {
        const contact::Contact& touch = input.contacts[i];
        const FrictionBox& box = bounds_.box(i);
        dContact c{};
        c.surface.mode = dContactMu2 | dContactFDir1 | dContactSlip1 | dContactSlip2 |
                         dContactSoftERP | dContactSoftCFM | dContactMotionN;
        // The rate that is asked for is given whole: ODE's own share of the depth is none.
        c.surface.soft_erp = 0.0;
        c.surface.soft_cfm = 1.0 / contactResistance(settings_.step);
        c.surface.motionN = contactRate(touch.depth, settings_.step);
        c.surface.slip1 = c.surface.slip2 = 1.0 / kStickingDamping;
        if (box.fromNormalForce) {
            c.surface.mode |= dContactApprox1;
            c.surface.mu = c.surface.mu2 = input.frictions[i];
        } else {
            c.surface.mu = box.along;
            c.surface.mu2 = box.across;
        }
        const double change = kRepetitionChange * repetition * static_cast<double>(i + 1);
        c.surface.mu *= 1.0 + change;
        c.surface.mu2 *= 1.0 - 0.5 * change;
        toOde(c.geom.pos, touch.point);
        toOde(c.geom.normal, touch.normal);
        toOde(c.fdir1, box.direction);
        c.geom.depth = touch.depth;
        const int body = bodyOf(touch, mechanism_);
        const dJointID joint = dJointCreateContact(world_.world(), world_.contactGroup(), &c);
        dJointAttach(joint, bodies_[static_cast<std::size_t>(body)], nullptr);
        dJointSetFeedback(joint, &feedback_[i]);
    }
}

void OdeEngine::readContacts(const StepInput& input) {
    contactForces_.resize(feedback_.size());
    contactVelocities_.resize(feedback_.size());
    for (std::size_t i = 0; i < feedback_.size(); ++i) {
        contactForces_[i] = toVec3(feedback_[i].f1);
        const contact::Contact& touch = input.contacts[i];
        const int body = bodyOf(touch, mechanism_);
        const dBodyID wheel = bodies_[static_cast<std::size_t>(body)];
        const Vec3 arm = touch.point - state_[static_cast<std::size_t>(body)].position;
        contactVelocities_[i] =
            toVec3(dBodyGetLinearVel(wheel)) + toVec3(dBodyGetAngularVel(wheel)).cross(arm);
    }
}

/// Fills contactForces_ and contactVelocities_, and leaves ODE's bodies where the step takes them.
void OdeEngine::solve(const StepInput& input, const OdeSolve& solve) {
    // ODE's solver lets rows reach their limits one after another, and gives up when two do so at
    // once: all rows that it has not come to get no force. Limits that are alike, as a rover's are
    // that is the same left and right, do that now and then. So they are made unlike.
    for (int repetition = 0; repetition <= kMaxRepetitions; ++repetition) {
        const long messagesBefore = odeMessagesOnThisThread();
        // Every solve, and so every step, starts from the stored state: that makes solves
        // repeatable and a restored run continue bit for bit.
        loadState(state_);
        applyForces(input);
        makeContacts(input, repetition);
        joints_->prepare(solve, input.motors);
        dWorldStep(world_.world(), settings_.step);
        readContacts(input);
        dJointGroupEmpty(world_.contactGroup());
        ++counters_.passes;
        if (odeMessagesOnThisThread() == messagesBefore) {
            return;
        }
    }
    ++counters_.solverMessages;
}

void OdeEngine::step(const StepInput& input) {
    bounds_.begin(input.contacts, input.frictions);
    const OdeSolve world{world_.world(), world_.contactGroup(), settings_.step, mechanism_, poses_};
    for (int pass = 1;; ++pass) {
        solve(input, world);
        const bool settled = bounds_.update(input.contacts, contactForces_, contactVelocities_);
        if (settled || pass == kMaxPasses) {
            break;
        }
    }
    bounds_.end(input.contacts, contactForces_);
    joints_->readReactions(world, jointReactions_);
    for (std::size_t i = 0; i < jointReactions_.size(); ++i) {
        jointReactions_[i].determined = determined_[i];
    }
    readState();
    updatePoses();
    ++counters_.steps;
}

void OdeEngine::writeState(std::vector<double>& numbers) const {
    numbers.clear();
    numbers.reserve(state_.size() * kNumbersPerBody);
    for (const BodyState& s : state_) {
        const Eigen::Vector4d& q = s.rotation.coeffs();
        numbers.insert(numbers.end(),
                       {s.position.x(), s.position.y(), s.position.z(), q[0], q[1], q[2], q[3]});
        for (const Vec3& v : {s.velocity.linear, s.velocity.angular}) {
            numbers.insert(numbers.end(), {v.x(), v.y(), v.z()});
        }
    }
    bounds_.save(numbers);
}

void OdeEngine::restoreState(std::span<const double> numbers) {
    const std::size_t bodyNumbers = state_.size() * kNumbersPerBody;
    if (numbers.size() < bodyNumbers) {
        throw std::invalid_argument("the state belongs to another mechanism");
    }
    for (std::size_t i = 0; i < state_.size(); ++i) {
        const double* n = numbers.data() + i * kNumbersPerBody;
        state_[i].position = {n[0], n[1], n[2]};
        state_[i].rotation.coeffs() = Eigen::Vector4d(n[3], n[4], n[5], n[6]);
        state_[i].velocity = {{n[7], n[8], n[9]}, {n[10], n[11], n[12]}};
    }
    bounds_.restore(numbers.subspan(bodyNumbers));
    updatePoses();
}

}  // namespace

std::unique_ptr<Engine> makeOdeEngine(const mechanism::Mechanism& mechanism,
                                      const EngineSettings& settings) {
    return std::make_unique<OdeEngine>(mechanism, settings);
}

}  // namespace simcore::dynamics
