#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "simcore/base/text.h"
#include "simcore/dynamics/contact_law.h"
#include "simcore/dynamics/contact_memory.h"
#include "simcore/dynamics/elastics.h"
#include "simcore/dynamics/engine.h"
#include "simcore/dynamics/floating_momentum.h"
#include "simcore/dynamics/impulse_solver.h"
#include "simcore/dynamics/loop_closures.h"
#include "simcore/dynamics/loop_energy.h"
#include "simcore/dynamics/scalar_rows.h"

namespace simcore::dynamics {
namespace {

/// Share of a rover's mass that one of its contacts moves along the normal (assumed).
constexpr double kContactShare = 1.0 / 12.0;
/// Agreement asked of contact forces [N].
constexpr double kForceTolerance = 1e-3;
/// A step is divided when the motion of a loop turns by more than this share in it, as it does next
/// to singular poses; at most so often.
constexpr double kFastTurn = 0.05;
constexpr int kMostDivisions = 7;
/// Next to a singular pose: the user is told, and energy is watched.
constexpr double kPoorPivots = 0.02;
/// Room for contacts from the start; more get theirs when they come.
constexpr std::size_t kContactRoom = 256;

/// What a step starts from, but for contacts and the choices of loops.
struct Instant {
    TreeState state;
    SolvedTerms solved;             ///< for its rates
    std::vector<Momentum> momenta;  ///< of what floats
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
    void makePattern();
    void mapBody(int position);
    void chooseStiff();
    void applyTorques(const StepInput& input);
    void makeMass();
    void makeContacts(const StepInput& input);
    void cover(const StepInput& input, double dt, int divisions);
    void solve(const StepInput& input);
    double move();
    void followChoice();
    void stepBack();
    void commit();
    void watchEnergy();
    void updateVelocities();
    void warn(std::string text);

    const mechanism::Mechanism mechanism_;
    EngineSettings settings_;
    SpanningTree tree_;
    TreeMotion motion_;
    LoopClosures loops_;
    ReducedInertia inertia_;
    LoopEnergy energy_;
    FloatingMomentum momentum_;
    Elastics elastics_;
    ScalarRows scalarRows_;
    Instant now_;
    double dt_ = 0.0;  ///< of the step, or of the part of it that is being made
    ContactMemory memory_;

    int choice_ = -1;      ///< that the pattern was made for
    int firstChoice_ = 0;  ///< the drawn pose's
    PatternedLu lu_;
    double contactMass_;
    ImpulseProblem problem_;
    ImpulseSolver solver_;
    ImpulseCounters impulses_;
    std::vector<std::size_t> rowTouches_;  ///< the input's contact of each contact row
    std::vector<double> depths_;           ///< of the input's contacts, now
    std::vector<Vec6> wrenches_;  ///< on the tree's bodies from outside, gravity not included
    std::vector<double> forces_;
    std::vector<double> accelerations_;
    std::vector<double> change_;
    std::vector<std::size_t> places_;  ///< of independent rates in a wheel's map
    Eigen::VectorXd u_;
    std::vector<Vec6> twists_;
    std::vector<BodyVelocity> velocities_;
    std::vector<Vec3> contactForces_;

    // The last step, or the last part of it, for its reactions.
    Instant before_;
    std::vector<Vec6> screwsBefore_;
    bool closed_ = true;
    std::string trouble_;
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
      inertia_(tree_, motion_, loops_),
      energy_(loops_, inertia_),
      momentum_(tree_),
      elastics_(mechanism_, tree_),
      scalarRows_(mechanism_, tree_),
      contactMass_(kContactShare * mechanism_.mass()),
      scratch_(mechanism_, tree_),
      scratchLoops_(mechanism_, tree_, settings.joints) {
    if (const Problems problems = whyReducedCannotRun(mechanism, settings.joints);
        !problems.empty()) {
        throw std::invalid_argument(toString(problems));
    }
    const auto bodies = tree_.bodies().size();
    const auto rates = static_cast<std::size_t>(tree_.rateCount());
    wrenches_.assign(bodies, Vec6::Zero());
    twists_.assign(bodies, Vec6::Zero());
    forces_.assign(rates, 0.0);
    accelerations_.assign(rates, 0.0);
    change_.assign(rates, 0.0);
    problem_.contacts.reserve(kContactRoom);
    rowTouches_.reserve(kContactRoom);
    depths_.reserve(kContactRoom);
    contactForces_.reserve(kContactRoom);
    memory_.reserve(kContactRoom);
    problem_.touched.reserve(bodies);
    solver_.reserve(kContactRoom, scalarRows_.mostRows(), rates);
    reset();
}

void ReducedEngine::reset() {
    now_ = {tree_.drawnState(), {}, std::vector<Momentum>(momentum_.count())};
    loops_.reset(now_.state, motion_);
    firstChoice_ = loops_.choice();
    energy_.reset();
    energy_.arrive(now_.state.rates);
    memory_.clear();
    contactForces_.clear();
    reactions_.clear();
    reactionsKnown_ = true;
    counters_ = {};
    impulses_ = {};
    trouble_.clear();
    dt_ = settings_.step;
    for (const std::string& loop : loops_.rigidLoops()) {
        warn(Text::of("{} cannot move", loop));
    }
    velocities_.assign(mechanism_.bodies.size(), {});
    chooseStiff();
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
    for (std::size_t k = 0; k < tree_.bodies().size(); ++k) {
        RateMap map;
        std::vector<SignedRate> way = wayOf(tree_.bodies()[k]);
        if (const FloatingRoot* root = loops_.rootOf(k)) {
            map.root = root->indices;
            std::erase_if(way, [&](const SignedRate& at) { return at.rate <= root->lastRate; });
        }
        map.indices = indicesOf(way);
        std::sort(map.indices.begin(), map.indices.end());
        map.indices.erase(std::unique(map.indices.begin(), map.indices.end()), map.indices.end());
        map.twists.resize(map.indices.size());
        problem_.bodies.push_back(std::move(map));
    }
    for (const Between* elastic : elastics_.betweens()) {
        lu_.couple(indicesOf(elastic->rates));
    }
    for (const Between& joint : scalarRows_.joints()) {
        lu_.couple(indicesOf(joint.rates));
    }
    lu_.close();
    lu_.shape(problem_.mass);
    problem_.momentum.resize(n);
}

void ReducedEngine::mapBody(int position) {
    places_.resize(static_cast<std::size_t>(loops_.independentCount()));
    RateMap& map = problem_.bodies[static_cast<std::size_t>(position)];
    for (std::size_t i = 0; i < map.indices.size(); ++i) {
        map.twists[i].setZero();
        places_[static_cast<std::size_t>(map.indices[i])] = i;
    }
    const int rootRate = loops_.lastRootRate(static_cast<std::size_t>(position));
    int rate = tree_.bodies()[static_cast<std::size_t>(position)].lastRate;
    for (; rate > rootRate; rate = tree_.rateBefore(rate)) {
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

void ReducedEngine::chooseStiff() {
    makePattern();
    motion_.weigh();
    std::fill(wrenches_.begin(), wrenches_.end(), Vec6::Zero());
    elastics_.resetStiff();
    elastics_.push(motion_, dt_, wrenches_);
    makeMass();
    RowMajor factored = problem_.mass;
    lu_.factor(factored);
    elastics_.findStiff(motion_, loops_, dt_, factored, lu_);
}

void ReducedEngine::makeMass() {
    inertia_.assemble(problem_.mass);
    // The momentum that the old rates bring, with the forces of a step, within what joints allow.
    const std::vector<double>& rates = now_.state.rates;
    for (std::size_t i = 0; i < accelerations_.size(); ++i) {
        accelerations_[i] = -rates[i] / dt_;
    }
    motion_.inverseDynamics(rates, accelerations_, settings_.gravity, wrenches_, forces_);
    momentum_.conserve(motion_, now_.momenta, wrenches_, settings_.gravity, dt_, forces_);
    inertia_.project(forces_, -dt_, problem_.momentum);
    energy_.giveBack(now_.solved, dt_, problem_.mass, lu_, problem_.momentum);
    elastics_.resist(motion_, loops_, dt_, problem_.mass);
}

void ReducedEngine::makeContacts(const StepInput& input) {
    const double dt = dt_;
    problem_.normalCompliance = 1.0 / (dt * contactResistance(dt));
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
        row.bound = contactRate(depths_[i], dt);
        row.impulse.setZero();
        if (const ContactMemory::Remembered* old = memory_.recall(touch)) {
            row.impulse = dt * Vec3(old->force.dot(touch.normal), old->force.dot(touch.forward),
                                    old->force.dot(side));
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
    if (move() > kFastTurn && divisions < kMostDivisions) {
        stepBack();
        ++counters_.dividedSteps;
        cover(input, 0.5 * dt, divisions + 1);
        // From an open loop nothing goes on: what came of it would be no numbers.
        if (trouble_.empty()) {
            cover(input, 0.5 * dt, divisions + 1);
        }
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
    elastics_.push(motion_, dt_, wrenches_);
    makeMass();
    makeContacts(input);
    problem_.rows = scalarRows_.make(motion_, loops_, now_.state.rates, input.motors, dt_);
    u_.resize(loops_.independentCount());
    for (Eigen::Index i = 0; i < u_.size(); ++i) {
        u_[i] = now_.state.rates[static_cast<std::size_t>(loops_.rateOf(static_cast<int>(i)))];
    }
    solver_.solve(problem_, lu_, u_, impulses_);
}

/// Moves everything with them. By how much the loops' motion turned on the way.
double ReducedEngine::move() {
    before_ = now_;
    now_.solved.terms = loops_.allTerms();
    now_.solved.choice = loops_.choice();
    std::vector<double>& rates = now_.state.rates;
    for (std::size_t j = 0; j < rates.size(); ++j) {
        rates[j] = 0.0;
        for (const RateTerm& term : loops_.terms(static_cast<int>(j))) {
            rates[j] += term.factor * u_[term.index];
        }
        change_[j] = dt_ * rates[j];
    }
    motion_.twists(rates, twists_);
    momentum_.take(motion_, twists_, now_.momenta);
    updateVelocities();
    screwsBefore_ = motion_.screws();
    advance(tree_, now_.state, change_);
    closed_ = loops_.close(now_.state, motion_);
    if (loops_.choice() != now_.solved.choice) {
        followChoice();
    }
    const double turn = energy_.arrive(rates);
    return closed_ ? turn : std::numeric_limits<double>::infinity();
}

/// The terms of the last pose, for the new choice of dependent rates.
void ReducedEngine::followChoice() {
    TreeState last = before_.state;
    loops_.close(last, scratch_);
    const int choice = loops_.choice();
    now_.solved.terms = loops_.allTerms();
    closed_ = loops_.close(now_.state, motion_);
    now_.solved.choice = loops_.choice() == choice ? choice : -1;
}

/// To where the step, or the part of it, started from.
void ReducedEngine::stepBack() {
    now_ = before_;
    loops_.close(now_.state, motion_);
    energy_.arrive(now_.state.rates);
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
    elastics_.damp(screwsBefore_, now_.state.rates, wrenches_);
    scalarRows_.wrenches(dt_, jointPushes_);
    if (!closed_) {
        trouble_ = Text::of("{} cannot be closed", loops_.brokenLoop());
    }
    counters_.leastPivotRatio = std::min(counters_.leastPivotRatio, loops_.pivotRatio());
    counters_.choices = loops_.choice() - firstChoice_;
    for (const std::string& loop : loops_.loopsDrawnSingular()) {
        warn(Text::of("{} is drawn in a singular pose: which way it went on from there is chance",
                      loop));
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
        energy_.leaveSingular();
        return;
    }
    warn(Text::of("{} passed next to a singular pose", loops_.poorestLoop()));
    if (choice_ != loops_.choice()) {
        makePattern();
    }
    motion_.weigh();
    if (!energy_.passSingular(now_.state.rates, now_.solved, dt_, lu_)) {
        trouble_ = Text::of("{} passed a singular pose, where energy could not be kept within 1 %",
                            loops_.poorestLoop());
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
    scratch_.place(before_.state);
    scratch_.weigh();
    std::vector<Vec6> wrenches = wrenches_;
    std::vector<Vec6> joints = jointPushes_;
    for (std::size_t i = 0; i < jointPushes_.size(); ++i) {
        const Between& bodies = scalarRows_.joints()[i];
        pushBetween(tree_, bodies.first, bodies.second, jointPushes_[i], wrenches);
    }
    const std::vector<double>& rates = before_.state.rates;
    std::vector<double> accelerations(rates.size());
    for (std::size_t j = 0; j < accelerations.size(); ++j) {
        accelerations[j] = (now_.state.rates[j] - rates[j]) / dt_;
    }
    std::vector<double> forces(accelerations.size(), 0.0);
    scratch_.inverseDynamics(rates, accelerations, settings_.gravity, wrenches, forces);
    scratchLoops_.react(scratch_, forces, wrenches, joints);
    const std::vector<bool> determined = scratchLoops_.determinedJoints(scratch_);
    std::vector<Vec6> transmitted;
    scratch_.inverseDynamics(rates, accelerations, settings_.gravity, wrenches, forces,
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
    const TreeState& state = now_.state;
    numbers.assign(state.coordinates.begin(), state.coordinates.end());
    numbers.insert(numbers.end(), state.rates.begin(), state.rates.end());
    for (const Eigen::Quaterniond& ball : state.balls) {
        numbers.insert(numbers.end(), {ball.x(), ball.y(), ball.z(), ball.w()});
    }
    for (const Momentum& momentum : now_.momenta) {
        numbers.insert(numbers.end(), momentum.about.begin(), momentum.about.end());
        numbers.insert(numbers.end(), momentum.point.begin(), momentum.point.end());
    }
    for (const BodyVelocity& velocity : velocities_) {
        for (const Vec3& v : {velocity.linear, velocity.angular}) {
            numbers.insert(numbers.end(), v.begin(), v.end());
        }
    }
    const std::vector<RateTerm>& terms = now_.solved.terms;
    const bool sameChoice = now_.solved.choice == loops_.choice();
    numbers.push_back(sameChoice ? static_cast<double>(terms.size()) : 0.0);
    for (std::size_t k = 0; sameChoice && k < terms.size(); ++k) {
        numbers.push_back(terms[k].factor);
    }
    loops_.save(numbers);
    memory_.save(numbers);
}

void ReducedEngine::restoreState(std::span<const double> numbers) {
    TreeState& state = now_.state;
    const std::size_t n = state.rates.size();
    const std::size_t first = 2 * n + 4 * state.balls.size();
    const std::size_t own = first + 9 * now_.momenta.size() + 6 * velocities_.size();
    if (numbers.size() < own + 1 ||
        numbers.size() < own + 1 + static_cast<std::size_t>(numbers[own])) {
        throw std::invalid_argument("the state belongs to another mechanism");
    }
    std::copy_n(numbers.begin(), n, state.coordinates.begin());
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(n), n, state.rates.begin());
    for (std::size_t i = 0; i < state.balls.size(); ++i) {
        const double* q = numbers.data() + 2 * n + 4 * i;
        state.balls[i].coeffs() = Eigen::Vector4d(q[0], q[1], q[2], q[3]);
    }
    const double* six = numbers.data() + first;
    for (Momentum& momentum : now_.momenta) {
        momentum = {Vec6(six), Vec3(six + 6)};
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
    loops_.resume(state, motion_);
    energy_.arrive(state.rates);
    SolvedTerms& solved = now_.solved;
    solved.terms = loops_.allTerms();
    solved.choice = factors.size() == solved.terms.size() ? loops_.choice() : -1;
    for (std::size_t k = 0; solved.choice >= 0 && k < factors.size(); ++k) {
        solved.terms[k].factor = factors[k];
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
        std::string what = Text::of("nothing in it can move");
        for (const std::string& loop : loops.rigidLoops()) {
            what += "; " + Text::of("{} holds its bodies", loop);
        }
        problems.push_back({Severity::Critical, Text::of("rover {}", mechanism.name), what + ".",
                            Text::of("Give a joint of the loop another freedom, or free a body.")});
    }
    return problems;
}

std::unique_ptr<Engine> makeReducedEngine(const mechanism::Mechanism& mechanism,
                                          const EngineSettings& settings) {
    return std::make_unique<ReducedEngine>(mechanism, settings);
}

}  // namespace simcore::dynamics
