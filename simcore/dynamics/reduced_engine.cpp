#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "simcore/dynamics/contact_memory.h"
#include "simcore/dynamics/engine.h"
#include "simcore/dynamics/impulse_solver.h"
#include "simcore/dynamics/loop_closures.h"

namespace simcore::dynamics {
namespace {

// Contacts are stiff springs with dampers, solved implicitly: the same physics at every step. The
// damping is critical for 6 kg, a rover's share on one wheel (assumed): with less, wheels bounce at
// edges where the step is short enough to show it, and slip the more the shorter it is.
constexpr double kContactStiffness = 1e6;  // [N/m]
constexpr double kContactDamping = 5000;   // [N s/m]
/// What a wheel that sticks creeps: 0.1 um/s per newton (assumed).
constexpr double kStickingDamping = 1e7;  // [N s/m]
/// Share of a rover's mass that one of its contacts moves along the normal (assumed).
constexpr double kContactShare = 1.0 / 12.0;
/// Contacts are wanted from this far before they touch [m] (assumed).
constexpr double kContactMargin = 1e-3;
// The same for stops of joints, on arms of 0.1 m.
constexpr double kStopStiffness = 1e4;  // [N m/rad]
constexpr double kStopDamping = 15;     // [N m s/rad]
/// Stops further away than this are left out [rad].
constexpr double kStopMargin = 0.2;
/// A motor within its limit holds its rate to 1 urad/s per newton metre (assumed).
constexpr double kMotorDamping = 1e6;  // [N m s/rad]
/// A joint with dry friction turns from this rate on [rad/s] (assumed).
constexpr double kTurning = 1e-3;
/// Square of angular frequency times step from which a spring is stiff: symplectic Euler is stable
/// up to 4.
constexpr double kStiffSpring = 0.5;
/// Agreement asked of contact forces [N].
constexpr double kForceTolerance = 1e-3;
/// From this turn of a loop's motion in time on, what projection costs is given back [1/s]. Slower
/// ones lose less than the square of it times the step of their energy in a second.
constexpr double kTurnThatCosts = 0.5;
/// A step is divided when the motion of a loop turns by more than this share in it, as it does next
/// to singular poses; at most so often.
constexpr double kFastTurn = 0.05;
constexpr int kMostDivisions = 7;
/// Next to a singular pose: the user is told, and energy is watched.
constexpr double kPoorPivots = 0.02;
/// Share of the kinetic energy that a passage of a singular pose may cost.
constexpr double kEnergyTolerance = 0.01;
/// Room for contacts from the start; more get theirs when they come.
constexpr std::size_t kContactRoom = 256;

/// A wrench that acts between two bodies.
struct Between {
    int first = -1;
    int second = -1;
    std::vector<SignedRate> rates;
};

/// A spring or damper and how far it was before the step.
struct Elastic {
    const mechanism::Spring* spring = nullptr;  ///< null: only a damper
    int joint = -1;                             ///< its axis; -1: between two points
    double damping = 0.0;
    Between between;
    bool implicit = false;  ///< too stiff for the step to swing

    // in this step
    Vec6 wrench = Vec6::Zero();  ///< per unit of force or torque, on the second body
    double push = 0.0;           ///< at its length before the step, without damping
    double resisted = 0.0;       ///< per unit of rate at the end of the step [N s/m] or [N m s/rad]
};

/// A root that floats, and all that hangs from it.
struct Float {
    int body = -1;            ///< of the mechanism
    int rate = 0;             ///< the first of its six
    std::vector<int> bodies;  ///< positions in the tree
};

struct Turner {
    int joint = -1;
    Between between;
};

class ReducedEngine final : public Engine {
  public:
    ReducedEngine(const mechanism::Mechanism& mechanism, const EngineSettings& settings);

    std::string name() const override { return "reduced"; }

    double contactMargin() const override { return kContactMargin; }

    void reset() override;
    void step(const StepInput& input) override;

    const std::vector<Pose>& poses() const override { return motion_.poses(); }

    const std::vector<BodyVelocity>& velocities() const override { return velocities_; }

    const std::vector<Vec3>& contactForces() const override { return contactForces_; }

    const std::vector<JointReaction>& jointReactions() const override;

    void writeState(std::vector<double>& numbers) const override;
    void restoreState(std::span<const double> state) override;

    const EngineCounters& counters() const override { return counters_; }

    std::string trouble() const override { return trouble_; }

  private:
    Between between(int first, int second) const;
    void push(const Between& between, const Vec6& wrench, std::vector<Vec6>& wrenches) const;
    Vec6 axisOf(const mechanism::Joint& joint) const;
    static double rateOf(const Between& between, const Vec6& wrench,
                         const std::vector<Vec6>& screws, const std::vector<double>& rates);
    void toIndependent(const Between& between, const Vec6& wrench, std::vector<int>& indices,
                       std::vector<double>& factors) const;
    void makePattern();
    void mapBody(int position);
    void cover(const StepInput& input, double dt, int divisions);
    void solve(const StepInput& input);
    double motion();
    void followChoice();
    void commit();
    void watchEnergy();
    void warn(std::string text);
    ScalarRow& addRow(int joint, const Vec6& wrench);
    void applyTorques(const StepInput& input);
    void applyElastics();
    void chooseImplicit();
    void assembleMass();
    void makeMass();
    void makeContacts(const StepInput& input);
    void makeStops();
    void makeMotors(const StepInput& input);
    void conserveMomentum();
    void keepLoopEnergy();
    void inertiaTimes(const std::vector<double>& rates);
    void projectForces(double scale, Eigen::VectorXd& momentum) const;
    void takeMomentum();
    void updateVelocities();

    const mechanism::Mechanism mechanism_;
    EngineSettings settings_;
    SpanningTree tree_;
    TreeMotion motion_;
    LoopClosures loops_;
    std::vector<Elastic> elastics_;
    std::vector<Turner> turners_;  ///< of every joint
    std::vector<Float> floats_;
    TreeState state_;
    std::vector<RateTerm> termsOfRates_;  ///< of the pose that its rates were solved at
    int choiceOfRates_ = -1;
    double dt_ = 0.0;            ///< of the step, or of the part of it that is being made
    std::vector<Vec6> momenta_;  ///< of what floats, about momentaPoints_
    std::vector<Vec3> momentaPoints_;
    ContactMemory memory_;

    int choice_ = -1;      ///< that the pattern was made for
    int firstChoice_ = 0;  ///< the drawn pose's
    PatternedLu lu_;
    double contactMass_;
    ImpulseProblem problem_;
    ImpulseSolver solver_;
    ImpulseCounters impulses_;
    std::vector<std::size_t> rowTouches_;     ///< the input's contact of each contact row
    std::vector<const JointMotor*> motorOf_;  ///< of every joint; null = none
    std::vector<ScalarRow> rows_;             ///< room for the problem's
    std::vector<int> rowJoints_;              ///< joint of each
    std::vector<Vec6> rowWrenches_;
    std::vector<double> depths_;  ///< of the input's contacts, now
    std::vector<Vec6> wrenches_;  ///< on the tree's bodies from outside, gravity not included
    std::vector<double> forces_;
    std::vector<double> accelerations_;
    std::vector<double> resting_;  ///< no rates
    std::vector<Vec6> noWrenches_;
    Eigen::VectorXd along_;
    RowMajor factored_;
    std::vector<double> change_;
    std::vector<std::size_t> places_;  ///< of independent rates in a wheel's map
    Eigen::VectorXd u_;
    std::vector<Vec6> twists_;
    std::vector<BodyVelocity> velocities_;
    std::vector<Vec3> contactForces_;

    // The last step, or the last part of it, for its reactions.
    TreeState before_;
    std::vector<Vec6> screwsBefore_;
    std::vector<RateTerm> termsBefore_;
    int choiceBefore_ = -1;
    std::vector<Vec6> momentaBefore_;
    std::vector<Vec3> pointsBefore_;
    double energyLost_ = 0.0;     ///< by projection, in the passage of a singular pose [J]
    double energyEntered_ = 0.0;  ///< kinetic, where it began [J]
    bool passing_ = false;
    bool closed_ = true;
    std::string trouble_;
    std::vector<int> indices_;
    std::vector<double> factors_;
    std::vector<double> ratesAfter_;
    std::vector<Vec6> jointPushes_;  ///< by stops and motors, on the second body
    mutable TreeMotion scratch_;
    mutable LoopClosures scratchLoops_;
    mutable bool reactionsKnown_ = false;
    mutable std::vector<JointReaction> reactions_;
    EngineCounters counters_;
};

ReducedEngine::ReducedEngine(const mechanism::Mechanism& mechanism, const EngineSettings& settings)
    : mechanism_(mechanism),
      settings_(settings),
      tree_(mechanism_, settings.joints),
      motion_(mechanism_, tree_),
      loops_(mechanism_, tree_, settings.joints),
      contactMass_(kContactShare * mechanism_.mass()),
      scratch_(mechanism_, tree_),
      scratchLoops_(mechanism_, tree_, settings.joints) {
    if (const Problems problems = whyReducedCannotRun(mechanism, settings.joints);
        !problems.empty()) {
        throw std::invalid_argument(toString(problems));
    }
    for (const mechanism::Spring& spring : mechanism_.springs) {
        Elastic elastic;
        elastic.spring = &spring;
        elastic.joint = spring.joint;
        elastic.damping = spring.damping;
        elastic.between = between(spring.first, spring.second);
        elastics_.push_back(std::move(elastic));
    }
    for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
        const mechanism::Joint& joint = mechanism_.joints[i];
        turners_.push_back({static_cast<int>(i), between(joint.first, joint.second)});
        if (joint.damping > 0.0) {
            Elastic elastic;
            elastic.joint = static_cast<int>(i);
            elastic.damping = joint.damping;
            elastic.between = turners_.back().between;
            elastics_.push_back(std::move(elastic));
        }
    }
    std::vector<int> floatOf;
    for (const TreeBody& at : tree_.bodies()) {
        const int position = static_cast<int>(floatOf.size());
        if (at.parent >= 0) {
            floatOf.push_back(floatOf[static_cast<std::size_t>(at.parent)]);
        } else if (at.joint < 0) {
            floatOf.push_back(static_cast<int>(floats_.size()));
            floats_.push_back({at.body, at.elements.front().rate, {}});
        } else {
            floatOf.push_back(-1);
        }
        if (floatOf.back() >= 0) {
            floats_[static_cast<std::size_t>(floatOf.back())].bodies.push_back(position);
        }
    }
    const auto bodies = tree_.bodies().size();
    const auto rates = static_cast<std::size_t>(tree_.rateCount());
    wrenches_.assign(bodies, Vec6::Zero());
    twists_.assign(bodies, Vec6::Zero());
    forces_.assign(rates, 0.0);
    accelerations_.assign(rates, 0.0);
    resting_.assign(rates, 0.0);
    noWrenches_.assign(bodies, Vec6::Zero());
    change_.assign(rates, 0.0);
    rows_.resize(4 * mechanism_.joints.size());
    rowJoints_.reserve(rows_.size());
    rowWrenches_.reserve(rows_.size());
    problem_.contacts.reserve(kContactRoom);
    rowTouches_.reserve(kContactRoom);
    depths_.reserve(kContactRoom);
    contactForces_.reserve(kContactRoom);
    memory_.reserve(kContactRoom);
    for (ScalarRow& row : rows_) {
        row.indices.reserve(rates);
        row.factors.reserve(rates);
    }
    indices_.reserve(rates);
    factors_.reserve(rates);
    problem_.touched.reserve(bodies);
    solver_.reserve(kContactRoom, rows_.size(), rates);
    reset();
}

Between ReducedEngine::between(int first, int second) const {
    return {first, second, relativeRates(tree_, first, second)};
}

void ReducedEngine::reset() {
    state_ = tree_.drawnState();
    loops_.reset(state_, motion_);
    firstChoice_ = loops_.choice();
    choiceOfRates_ = -1;
    momenta_.assign(floats_.size(), Vec6::Zero());
    momentaPoints_.assign(floats_.size(), Vec3::Zero());
    memory_.clear();
    contactForces_.clear();
    reactions_.clear();
    reactionsKnown_ = true;
    counters_ = {};
    impulses_ = {};
    trouble_.clear();
    passing_ = false;
    dt_ = settings_.step;
    for (const std::string& loop : loops_.rigidLoops()) {
        warn(loop + " cannot move");
    }
    velocities_.assign(mechanism_.bodies.size(), {});
    chooseImplicit();
}

void ReducedEngine::push(const Between& between, const Vec6& wrench,
                         std::vector<Vec6>& wrenches) const {
    pushBetween(tree_, between.first, between.second, wrench, wrenches);
}

Vec6 ReducedEngine::axisOf(const mechanism::Joint& joint) const {
    return spatial(motion_.poses()[static_cast<std::size_t>(joint.first)].rotation * joint.axis,
                   Vec3::Zero());
}

double ReducedEngine::rateOf(const Between& between, const Vec6& wrench,
                             const std::vector<Vec6>& screws, const std::vector<double>& rates) {
    double rate = 0.0;
    for (const SignedRate& signed_ : between.rates) {
        const auto j = static_cast<std::size_t>(signed_.rate);
        rate += signed_.sign * wrench.dot(screws[j]) * rates[j];
    }
    return rate;
}

void ReducedEngine::toIndependent(const Between& between, const Vec6& wrench,
                                  std::vector<int>& indices, std::vector<double>& factors) const {
    indices.clear();
    factors.clear();
    for (const SignedRate& signed_ : between.rates) {
        const double lever =
            signed_.sign * wrench.dot(motion_.screws()[static_cast<std::size_t>(signed_.rate)]);
        for (const RateTerm& term : loops_.terms(signed_.rate)) {
            const auto at = std::find(indices.begin(), indices.end(), term.index);
            if (at == indices.end()) {
                indices.push_back(term.index);
                factors.push_back(lever * term.factor);
            } else {
                factors[static_cast<std::size_t>(at - indices.begin())] += lever * term.factor;
            }
        }
    }
}

void ReducedEngine::makePattern() {
    choice_ = loops_.choice();
    const int n = loops_.independentCount();
    lu_.reset(n);
    const auto wayOf = [this](const TreeBody& at) {
        std::vector<SignedRate> rates;
        for (int rate = at.lastRate; rate >= 0; rate = tree_.rateBefore(rate)) {
            rates.push_back({rate, 1.0});
        }
        return rates;
    };
    const auto indicesOf = [this](const std::vector<SignedRate>& rates) {
        std::vector<int> indices;
        for (const SignedRate& signed_ : rates) {
            for (const RateTerm& term : loops_.terms(signed_.rate)) {
                indices.push_back(term.index);
            }
        }
        return indices;
    };
    for (const TreeBody& at : tree_.bodies()) {
        lu_.couple(indicesOf(wayOf(at)));
    }
    problem_.bodies.clear();
    for (const TreeBody& at : tree_.bodies()) {
        RateMap map;
        map.indices = indicesOf(wayOf(at));
        std::sort(map.indices.begin(), map.indices.end());
        map.indices.erase(std::unique(map.indices.begin(), map.indices.end()), map.indices.end());
        map.twists.resize(map.indices.size());
        problem_.bodies.push_back(std::move(map));
    }
    for (const Elastic& elastic : elastics_) {
        lu_.couple(indicesOf(elastic.between.rates));
    }
    for (const Turner& turner : turners_) {
        lu_.couple(indicesOf(turner.between.rates));
    }
    lu_.close();
    problem_.mass.resize(n, n);
    problem_.momentum.resize(n);
}

void ReducedEngine::mapBody(int position) {
    places_.resize(static_cast<std::size_t>(loops_.independentCount()));
    RateMap& map = problem_.bodies[static_cast<std::size_t>(position)];
    for (std::size_t i = 0; i < map.indices.size(); ++i) {
        map.twists[i].setZero();
        places_[static_cast<std::size_t>(map.indices[i])] = i;
    }
    int rate = tree_.bodies()[static_cast<std::size_t>(position)].lastRate;
    for (; rate >= 0; rate = tree_.rateBefore(rate)) {
        for (const RateTerm& term : loops_.terms(rate)) {
            map.twists[places_[static_cast<std::size_t>(term.index)]] +=
                term.factor * motion_.screws()[static_cast<std::size_t>(rate)];
        }
    }
}

void ReducedEngine::applyTorques(const StepInput& input) {
    std::fill(wrenches_.begin(), wrenches_.end(), Vec6::Zero());
    for (std::size_t i = 0; i < mechanism_.wheels.size(); ++i) {
        const mechanism::Wheel& wheel = mechanism_.wheels[i];
        const Vec3 axis =
            motion_.poses()[static_cast<std::size_t>(wheel.body)].rotation * wheel.axis;
        const auto act = [&](int body, double torque) {
            if (const int at = tree_.positionOf(body); at >= 0) {
                wrenches_[static_cast<std::size_t>(at)] += spatial(torque * axis, Vec3::Zero());
            }
        };
        act(wheel.body, input.wheelTorques[i] + input.externalTorques[i]);
        act(wheel.carrier, -input.wheelTorques[i]);
    }
}

// Dampers push with their rate after the step, so that no damping is too strong for it.
void ReducedEngine::applyElastics() {
    const double dt = dt_;
    for (Elastic& elastic : elastics_) {
        double stiffness = 0.0;
        elastic.push = 0.0;
        if (elastic.joint >= 0) {
            const mechanism::Joint& joint =
                mechanism_.joints[static_cast<std::size_t>(elastic.joint)];
            elastic.wrench = axisOf(joint);
            if (elastic.spring != nullptr) {
                stiffness = elastic.spring->stiffness;
                elastic.push =
                    elastic.spring->preload - stiffness * jointAngle(joint, motion_.poses());
            }
        } else {
            const mechanism::Spring& spring = *elastic.spring;
            const Vec3 a =
                motion_.poses()[static_cast<std::size_t>(spring.first)] * spring.firstPoint;
            const Vec3 b =
                motion_.poses()[static_cast<std::size_t>(spring.second)] * spring.secondPoint;
            const Vec3 direction = (b - a).normalized();
            const double drawn = (spring.secondPoint - spring.firstPoint).norm();
            elastic.wrench = forceAt(
                direction, b - motion_.origin(tree_.positionOf(spring.second) >= 0 ? spring.second
                                                                                   : spring.first));
            stiffness = spring.stiffness;
            elastic.push = spring.preload + stiffness * (drawn - (b - a).norm());
        }
        elastic.resisted = elastic.damping + (elastic.implicit ? dt * stiffness : 0.0);
        push(elastic.between, elastic.push * elastic.wrench, wrenches_);
    }
}

// Springs push with their length before the step, which keeps energy, unless they are so stiff that
// a step is too long for them: those push with their length after it, which damps them.
void ReducedEngine::chooseImplicit() {
    makePattern();
    motion_.weigh();
    std::fill(wrenches_.begin(), wrenches_.end(), Vec6::Zero());
    for (Elastic& elastic : elastics_) {
        elastic.implicit = false;
    }
    applyElastics();
    makeMass();
    RowMajor mass = problem_.mass;
    lu_.factor(mass);
    std::vector<int> indices;
    std::vector<double> factors;
    for (Elastic& elastic : elastics_) {
        if (elastic.spring == nullptr) {
            continue;
        }
        toIndependent(elastic.between, elastic.wrench, indices, factors);
        Eigen::VectorXd push = Eigen::VectorXd::Zero(loops_.independentCount());
        for (std::size_t i = 0; i < indices.size(); ++i) {
            push[indices[i]] = factors[i];
        }
        Eigen::VectorXd moved = push;
        lu_.solve(mass, moved);
        const double square = elastic.spring->stiffness * push.dot(moved);  // [rad^2/s^2]
        elastic.implicit = dt_ * dt_ * square > kStiffSpring;
    }
}

void ReducedEngine::assembleMass() {
    problem_.mass.setZero();
    motion_.massMatrix([this](int i, int j, double value) {
        for (const RateTerm& a : loops_.terms(i)) {
            for (const RateTerm& b : loops_.terms(j)) {
                const double part = a.factor * b.factor * value;
                problem_.mass(a.index, b.index) += part;
                if (i != j) {
                    problem_.mass(b.index, a.index) += part;
                }
            }
        }
    });
}

void ReducedEngine::makeMass() {
    const double dt = dt_;
    assembleMass();
    // The momentum that the old rates bring, with the forces of a step, within what joints allow.
    for (std::size_t i = 0; i < accelerations_.size(); ++i) {
        accelerations_[i] = -state_.rates[i] / dt;
    }
    motion_.inverseDynamics(state_.rates, accelerations_, settings_.gravity, wrenches_, forces_);
    conserveMomentum();
    projectForces(-dt, problem_.momentum);
    keepLoopEnergy();
    for (const Elastic& elastic : elastics_) {
        toIndependent(elastic.between, elastic.wrench, indices_, factors_);
        for (std::size_t i = 0; i < indices_.size(); ++i) {
            for (std::size_t j = 0; j < indices_.size(); ++j) {
                problem_.mass(indices_[i], indices_[j]) +=
                    dt * elastic.resisted * factors_[i] * factors_[j];
            }
        }
    }
}

/// H q' into forces_.
void ReducedEngine::inertiaTimes(const std::vector<double>& rates) {
    // As the force of that acceleration from rest without weight.
    motion_.inverseDynamics(resting_, rates, 0.0, noWrenches_, forces_);
}

/// P^T times forces_, scaled.
void ReducedEngine::projectForces(double scale, Eigen::VectorXd& momentum) const {
    momentum.setZero(loops_.independentCount());
    for (std::size_t j = 0; j < forces_.size(); ++j) {
        for (const RateTerm& term : loops_.terms(static_cast<int>(j))) {
            momentum[term.index] += scale * term.factor * forces_[j];
        }
    }
}

// Rates q' = P u of the last pose, projected by P'^T H onto the motion P' u' of this one, lose the
// energy of their part across it, as if the loops turned in little impacts. To third order in the
// step that part is given back by projecting with the mean of P and P' instead, that is by adding
// (P' - P)^T H d / 2 with d the part of (P' - P) u across the new motion.
void ReducedEngine::keepLoopEnergy() {
    if (choiceOfRates_ != loops_.choice() || loops_.turnOf(state_.rates) < kTurnThatCosts * dt_) {
        return;
    }
    std::vector<double>& across = accelerations_;
    for (std::size_t j = 0; j < across.size(); ++j) {
        across[j] = -state_.rates[j];
        for (const RateTerm& term : loops_.terms(static_cast<int>(j))) {
            across[j] +=
                term.factor * state_.rates[static_cast<std::size_t>(loops_.rateOf(term.index))];
        }
    }
    inertiaTimes(across);
    projectForces(1.0, along_);
    factored_ = problem_.mass;
    lu_.factor(factored_);
    lu_.solve(factored_, along_);
    for (std::size_t j = 0; j < across.size(); ++j) {
        for (const RateTerm& term : loops_.terms(static_cast<int>(j))) {
            across[j] -= term.factor * along_[term.index];
        }
    }
    inertiaTimes(across);
    for (std::size_t j = 0; j < forces_.size(); ++j) {
        const std::size_t first = loops_.firstTerm(static_cast<int>(j));
        const std::span<const RateTerm> terms = loops_.terms(static_cast<int>(j));
        for (std::size_t k = 0; k < terms.size(); ++k) {
            problem_.momentum[terms[k].index] +=
                0.5 * (terms[k].factor - termsOfRates_[first + k].factor) * forces_[j];
        }
    }
}

// What floats keeps its momentum to the last digit: the rates of its root are asked for what it had
// after the last step and what came from outside since, not for inertia times old rates at the new
// pose, which is the same to first order only.
void ReducedEngine::conserveMomentum() {
    const double dt = dt_;
    for (std::size_t k = 0; k < floats_.size(); ++k) {
        const Float& root = floats_[k];
        Vec6 momentum = momenta_[k];
        momentum.head<3>() -=
            (motion_.origin(root.body) - momentaPoints_[k]).cross(momentum.tail<3>());
        for (const int body : root.bodies) {
            const auto b = static_cast<std::size_t>(body);
            momentum += dt * (wrenches_[b] + motion_.weight(b, settings_.gravity));
        }
        for (int rate = root.rate; rate < root.rate + 6; ++rate) {
            const auto j = static_cast<std::size_t>(rate);
            forces_[j] = -motion_.screws()[j].dot(momentum) / dt;
        }
    }
}

void ReducedEngine::takeMomentum() {
    motion_.twists(state_.rates, twists_);
    for (std::size_t k = 0; k < floats_.size(); ++k) {
        Vec6& momentum = momenta_[k];
        momentum.setZero();
        momentaPoints_[k] = motion_.origin(floats_[k].body);
        for (const int body : floats_[k].bodies) {
            const auto b = static_cast<std::size_t>(body);
            momentum += motion_.inertia(b) * twists_[b];
        }
    }
}

void ReducedEngine::makeContacts(const StepInput& input) {
    const double dt = dt_;
    problem_.normalCompliance = 1.0 / (dt * (kContactStiffness * dt + kContactDamping));
    problem_.tangentialCompliance = 1.0 / (dt * kStickingDamping);
    problem_.tolerance = kForceTolerance * dt;
    problem_.contactMass = contactMass_;
    problem_.contacts.clear();
    problem_.touched.clear();
    rowTouches_.clear();
    for (std::size_t i = 0; i < input.contacts.size(); ++i) {
        const contact::Contact& touch = input.contacts[i];
        const int body = bodyOf(touch, mechanism_);
        const int position = tree_.positionOf(body);
        if (position < 0) {
            continue;  // fixed: it bears anything
        }
        if (std::find(problem_.touched.begin(), problem_.touched.end(), position) ==
            problem_.touched.end()) {
            problem_.touched.push_back(position);
            mapBody(position);
        }
        rowTouches_.push_back(i);
        ContactRow& row = problem_.contacts.emplace_back();
        row.body = position;
        const Vec3 arm = touch.point - motion_.origin(body);
        const Vec3 side = touch.normal.cross(touch.forward);
        row.wrenches.col(0) = forceAt(touch.normal, arm);
        row.wrenches.col(1) = forceAt(touch.forward, arm);
        row.wrenches.col(2) = forceAt(side, arm);
        row.friction = input.frictions[i];
        const double depth = depths_[i];
        row.bound = depth > 0.0
                        ? depth * kContactStiffness / (kContactStiffness * dt + kContactDamping)
                        : depth / dt;
        row.impulse.setZero();
        if (const ContactMemory::Remembered* old = memory_.recall(touch)) {
            row.impulse = dt * Vec3(old->force.dot(touch.normal), old->force.dot(touch.forward),
                                    old->force.dot(side));
        }
    }
}

ScalarRow& ReducedEngine::addRow(int joint, const Vec6& wrench) {
    ScalarRow& row = rows_[rowJoints_.size()];
    toIndependent(turners_[static_cast<std::size_t>(joint)].between, wrench, row.indices,
                  row.factors);
    row.impulse = 0.0;
    rowJoints_.push_back(joint);
    rowWrenches_.push_back(wrench);
    return row;
}

void ReducedEngine::makeStops() {
    const double dt = dt_;
    for (const Turner& turner : turners_) {
        const mechanism::Joint& joint = mechanism_.joints[static_cast<std::size_t>(turner.joint)];
        if (!joint.stops) {
            continue;
        }
        const double angle = jointAngle(joint, motion_.poses());
        for (const double sign : {1.0, -1.0}) {
            const double gap =
                sign > 0.0 ? angle - joint.stops->first : joint.stops->second - angle;
            const Vec6 wrench = sign * axisOf(joint);
            if (gap >
                kStopMargin +
                    std::abs(rateOf(turner.between, wrench, motion_.screws(), state_.rates)) * dt) {
                continue;
            }
            ScalarRow& row = addRow(turner.joint, wrench);
            row.compliance = 1.0 / (dt * (kStopStiffness * dt + kStopDamping));
            row.bound = gap < 0.0 ? -gap * kStopStiffness / (kStopStiffness * dt + kStopDamping)
                                  : -gap / dt;
            row.least = 0.0;
            row.most = std::numeric_limits<double>::infinity();
            row.start = gap < 0.0 ? 0 : -1;
        }
    }
}

void ReducedEngine::makeMotors(const StepInput& input) {
    motorOf_.assign(turners_.size(), nullptr);
    for (const JointMotor& motor : input.motors) {
        motorOf_[static_cast<std::size_t>(motor.joint)] = &motor;
    }
    for (const Turner& turner : turners_) {
        const auto index = static_cast<std::size_t>(turner.joint);
        const JointMotor turning = withFriction(mechanism_.joints[index], motorOf_[index]);
        if (motorOf_[index] == nullptr && turning.torqueLimit == 0.0) {
            continue;
        }
        const Vec6 wrench = axisOf(mechanism_.joints[index]);
        ScalarRow& row = addRow(turner.joint, wrench);
        row.compliance = 1.0 / (dt_ * kMotorDamping);
        row.bound = turning.rate;
        row.most = dt_ * turning.torqueLimit;
        row.least = -row.most;
        row.start = 0;
        if (motorOf_[index] == nullptr) {
            // A joint that turns goes on to be braked.
            const double rate = rateOf(turner.between, wrench, motion_.screws(), state_.rates);
            row.start = rate > kTurning ? -1 : (rate < -kTurning ? 1 : 0);
        }
    }
}

void ReducedEngine::step(const StepInput& input) {
    depths_.clear();
    for (const contact::Contact& touch : input.contacts) {
        depths_.push_back(touch.depth);
    }
    contactForces_.assign(input.contacts.size(), Vec3::Zero());
    const long dividedBefore = counters_.dividedSteps;
    cover(input, settings_.step, 0);
    counters_.dividedSteps = std::min(counters_.dividedSteps, dividedBefore + 1);
    memory_.remember(input.contacts, contactForces_);
    reactionsKnown_ = false;
    ++counters_.steps;
    counters_.passes = impulses_.iterations;
    counters_.fallbacks = impulses_.fallbacks;
    counters_.solverMessages = impulses_.failures;
    counters_.worstResidual = impulses_.residual / settings_.step;
}

/// Makes a step, or in halves when a loop turns too far in it.
void ReducedEngine::cover(const StepInput& input, double dt, int divisions) {
    dt_ = dt;
    solve(input);
    if (motion() > kFastTurn && divisions < kMostDivisions) {
        state_ = before_;
        termsOfRates_ = termsBefore_;
        choiceOfRates_ = choiceBefore_;
        momenta_ = momentaBefore_;
        momentaPoints_ = pointsBefore_;
        loops_.close(state_, motion_);
        ++counters_.dividedSteps;
        cover(input, 0.5 * dt, divisions + 1);
        cover(input, 0.5 * dt, divisions + 1);
        return;
    }
    commit();
}

/// Finds the rates after the step.
void ReducedEngine::solve(const StepInput& input) {
    if (choice_ != loops_.choice()) {
        makePattern();
    }
    motion_.weigh();
    applyTorques(input);
    applyElastics();
    makeMass();
    makeContacts(input);
    rowJoints_.clear();
    rowWrenches_.clear();
    makeStops();
    makeMotors(input);
    problem_.rows = std::span(rows_).first(rowJoints_.size());
    u_.resize(loops_.independentCount());
    for (Eigen::Index i = 0; i < u_.size(); ++i) {
        u_[i] = state_.rates[static_cast<std::size_t>(loops_.rateOf(static_cast<int>(i)))];
    }
    solver_.solve(problem_, lu_, u_, impulses_);
}

/// Moves everything with them. By how much the loops' motion turned on the way.
double ReducedEngine::motion() {
    before_ = state_;
    termsBefore_ = termsOfRates_;
    choiceBefore_ = choiceOfRates_;
    termsOfRates_ = loops_.allTerms();
    choiceOfRates_ = loops_.choice();
    momentaBefore_ = momenta_;
    pointsBefore_ = momentaPoints_;
    for (std::size_t j = 0; j < state_.rates.size(); ++j) {
        double rate = 0.0;
        for (const RateTerm& term : loops_.terms(static_cast<int>(j))) {
            rate += term.factor * u_[term.index];
        }
        state_.rates[j] = rate;
        change_[j] = dt_ * rate;
    }
    ratesAfter_ = state_.rates;
    takeMomentum();
    updateVelocities();
    screwsBefore_ = motion_.screws();
    advance(tree_, state_, change_);
    closed_ = loops_.close(state_, motion_);
    if (loops_.choice() != choiceOfRates_) {
        followChoice();
    }
    return closed_ ? loops_.turnOf(ratesAfter_) : std::numeric_limits<double>::infinity();
}

/// The terms of the last pose, for the new choice of dependent rates.
void ReducedEngine::followChoice() {
    TreeState last = before_;
    loops_.close(last, scratch_);
    const int choice = loops_.choice();
    termsOfRates_ = loops_.allTerms();
    closed_ = loops_.close(state_, motion_);
    choiceOfRates_ = loops_.choice() == choice ? choice : -1;
}

/// Takes the step, or the part of it, for made.
void ReducedEngine::commit() {
    const double share = dt_ / settings_.step;
    for (std::size_t i = 0; i < rowTouches_.size(); ++i) {
        const ContactRow& row = problem_.contacts[i];
        const Vec6 wrench = row.wrenches * row.impulse / dt_;
        contactForces_[rowTouches_[i]] += share * wrench.tail<3>();
        depths_[rowTouches_[i]] -= dt_ * row.velocity[0];
        wrenches_[static_cast<std::size_t>(row.body)] += wrench;
    }
    for (const Elastic& elastic : elastics_) {
        const double rate = rateOf(elastic.between, elastic.wrench, screwsBefore_, ratesAfter_);
        push(elastic.between, -elastic.resisted * rate * elastic.wrench, wrenches_);
    }
    jointPushes_.assign(mechanism_.joints.size(), Vec6::Zero());
    for (std::size_t k = 0; k < problem_.rows.size(); ++k) {
        jointPushes_[static_cast<std::size_t>(rowJoints_[k])] +=
            problem_.rows[k].impulse / dt_ * rowWrenches_[k];
    }
    if (!closed_) {
        trouble_ = loops_.brokenLoop() + " cannot be closed";
    }
    counters_.leastPivotRatio = std::min(counters_.leastPivotRatio, loops_.pivotRatio());
    counters_.choices = loops_.choice() - firstChoice_;
    for (const std::string& loop : loops_.loopsDrawnSingular()) {
        warn(loop + " is drawn in a singular pose: which way it went on from there is chance");
    }
    watchEnergy();
}

void ReducedEngine::warn(std::string text) {
    std::vector<std::string>& warnings = counters_.warnings;
    if (std::find(warnings.begin(), warnings.end(), text) == warnings.end()) {
        warnings.push_back(std::move(text));
    }
}

// Joints do no work. What the projection onto the loops' new motion changes of the energy all the
// same is small; next to a singular pose, where loops turn fast, it is added up.
void ReducedEngine::watchEnergy() {
    if (loops_.pivotRatio() > kPoorPivots) {
        passing_ = false;
        return;
    }
    warn(loops_.poorestLoop() + " passed next to a singular pose");
    if (choice_ != loops_.choice()) {
        makePattern();
    }
    motion_.weigh();
    inertiaTimes(state_.rates);
    const double before =
        0.5 * std::inner_product(forces_.begin(), forces_.end(), state_.rates.begin(), 0.0);
    assembleMass();
    projectForces(1.0, problem_.momentum);
    keepLoopEnergy();
    const Eigen::VectorXd momentum = problem_.momentum;
    Eigen::VectorXd rates = momentum;
    lu_.factor(problem_.mass);
    lu_.solve(problem_.mass, rates);
    const double after = 0.5 * rates.dot(momentum);
    if (!passing_) {
        passing_ = true;
        energyLost_ = 0.0;
        energyEntered_ = before;
    }
    energyLost_ += before - after;
    if (std::abs(energyLost_) > kEnergyTolerance * std::max(energyEntered_, before)) {
        trouble_ = loops_.poorestLoop() +
                   " passed a singular pose, where energy could not be kept within 1 %";
    }
}

// Those of the step's motion: at the pose that the rates were solved at.
void ReducedEngine::updateVelocities() {
    for (std::size_t k = 0; k < twists_.size(); ++k) {
        const auto body = static_cast<std::size_t>(tree_.bodies()[k].body);
        const Vec3 center = motion_.poses()[body] * mechanism_.bodies[body].com -
                            motion_.origin(tree_.bodies()[k].body);
        const Vec3 angular = twists_[k].head<3>();
        velocities_[body] = {twists_[k].tail<3>() + angular.cross(center), angular};
    }
}

// Newton and Euler's equations of every body give what its joint carries, once the loops' share is
// known: that follows from what the tree alone cannot balance.
const std::vector<JointReaction>& ReducedEngine::jointReactions() const {
    if (reactionsKnown_) {
        return reactions_;
    }
    reactionsKnown_ = true;
    scratch_.place(before_);
    scratch_.weigh();
    std::vector<Vec6> wrenches = wrenches_;
    std::vector<Vec6> joints = jointPushes_;
    for (const Turner& turner : turners_) {
        push(turner.between, jointPushes_[static_cast<std::size_t>(turner.joint)], wrenches);
    }
    std::vector<double> accelerations(ratesAfter_.size());
    for (std::size_t j = 0; j < accelerations.size(); ++j) {
        accelerations[j] = (ratesAfter_[j] - before_.rates[j]) / dt_;
    }
    std::vector<double> forces(accelerations.size(), 0.0);
    scratch_.inverseDynamics(before_.rates, accelerations, settings_.gravity, wrenches, forces);
    scratchLoops_.react(scratch_, forces, wrenches, joints);
    const std::vector<bool> determined = scratchLoops_.determinedJoints(scratch_);
    std::vector<Vec6> transmitted;
    scratch_.inverseDynamics(before_.rates, accelerations, settings_.gravity, wrenches, forces,
                             &transmitted);
    for (std::size_t k = 0; k < transmitted.size(); ++k) {
        const TreeBody& at = tree_.bodies()[k];
        if (at.joint >= 0) {
            const auto joint = static_cast<std::size_t>(at.joint);
            const bool forwards = mechanism_.joints[joint].second == at.body;
            joints[joint] += forwards ? transmitted[k] : Vec6(-transmitted[k]);
        }
    }
    reactions_.resize(joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const mechanism::Joint& joint = mechanism_.joints[i];
        const Vec3 point =
            scratch_.poses()[static_cast<std::size_t>(joint.second)] * joint.point -
            scratch_.origin(tree_.positionOf(joint.second) >= 0 ? joint.second : joint.first);
        const Vec3 force = joints[i].tail<3>();
        reactions_[i] = {force, joints[i].head<3>() - point.cross(force), determined[i]};
    }
    return reactions_;
}

void ReducedEngine::writeState(std::vector<double>& numbers) const {
    numbers.assign(state_.coordinates.begin(), state_.coordinates.end());
    numbers.insert(numbers.end(), state_.rates.begin(), state_.rates.end());
    for (const Eigen::Quaterniond& ball : state_.balls) {
        numbers.insert(numbers.end(), {ball.x(), ball.y(), ball.z(), ball.w()});
    }
    for (std::size_t k = 0; k < momenta_.size(); ++k) {
        numbers.insert(numbers.end(), momenta_[k].begin(), momenta_[k].end());
        numbers.insert(numbers.end(), momentaPoints_[k].begin(), momentaPoints_[k].end());
    }
    for (const BodyVelocity& velocity : velocities_) {
        for (const Vec3& v : {velocity.linear, velocity.angular}) {
            numbers.insert(numbers.end(), v.begin(), v.end());
        }
    }
    const bool sameChoice = choiceOfRates_ == loops_.choice();
    numbers.push_back(sameChoice ? static_cast<double>(termsOfRates_.size()) : 0.0);
    for (std::size_t k = 0; sameChoice && k < termsOfRates_.size(); ++k) {
        numbers.push_back(termsOfRates_[k].factor);
    }
    loops_.save(numbers);
    memory_.save(numbers);
}

void ReducedEngine::restoreState(std::span<const double> numbers) {
    const std::size_t n = state_.rates.size();
    const std::size_t first = 2 * n + 4 * state_.balls.size();
    const std::size_t own = first + 9 * momenta_.size() + 6 * velocities_.size();
    if (numbers.size() < own + 1 ||
        numbers.size() < own + 1 + static_cast<std::size_t>(numbers[own])) {
        throw std::invalid_argument("the state belongs to another mechanism");
    }
    std::copy_n(numbers.begin(), n, state_.coordinates.begin());
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(n), n, state_.rates.begin());
    for (std::size_t i = 0; i < state_.balls.size(); ++i) {
        const double* q = numbers.data() + 2 * n + 4 * i;
        state_.balls[i].coeffs() = Eigen::Vector4d(q[0], q[1], q[2], q[3]);
    }
    const double* six = numbers.data() + first;
    for (std::size_t k = 0; k < momenta_.size(); ++k) {
        momenta_[k] = Vec6(six);
        momentaPoints_[k] = Vec3(six + 6);
        six += 9;
    }
    for (BodyVelocity& velocity : velocities_) {
        velocity = {Vec3(six), Vec3(six + 3)};
        six += 6;
    }
    const std::span<const double> factors =
        numbers.subspan(own + 1, static_cast<std::size_t>(numbers[own]));
    std::span<const double> rest = numbers.subspan(own + 1 + factors.size());
    loops_.restore(rest);
    memory_.restore(rest);
    loops_.close(state_, motion_);
    termsOfRates_ = loops_.allTerms();
    choiceOfRates_ = factors.size() == termsOfRates_.size() ? loops_.choice() : -1;
    for (std::size_t k = 0; choiceOfRates_ >= 0 && k < factors.size(); ++k) {
        termsOfRates_[k].factor = factors[k];
    }
    reactionsKnown_ = true;
    reactions_.clear();
}

}  // namespace

Problems whyReducedCannotRun(const mechanism::Mechanism& mechanism, mechanism::Model joints) {
    Problems problems = whyNoEngineCanRun(mechanism);
    if (!problems.empty()) {
        return problems;
    }
    const SpanningTree tree(mechanism, joints);
    TreeMotion motion(mechanism, tree);
    LoopClosures loops(mechanism, tree, joints);
    TreeState state = tree.drawnState();
    loops.reset(state, motion);
    if (loops.independentCount() == 0) {
        std::string what = "nothing in it can move";
        for (const std::string& loop : loops.rigidLoops()) {
            what += "; " + loop + " holds its bodies";
        }
        problems.push_back({Severity::Critical, "rover " + mechanism.name, what + ".",
                            "Give a joint of the loop another freedom, or free a body."});
    }
    return problems;
}

std::unique_ptr<Engine> makeReducedEngine(const mechanism::Mechanism& mechanism,
                                          const EngineSettings& settings) {
    return std::make_unique<ReducedEngine>(mechanism, settings);
}

}  // namespace simcore::dynamics
