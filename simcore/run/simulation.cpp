#include "simcore/run/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "simcore/base/hash.h"
#include "simcore/base/text.h"
#include "simcore/contact/body_contacts.h"
#include "simcore/contact/wheel_contact.h"
#include "simcore/control/controller.h"
#include "simcore/control/steering.h"
#include "simcore/control/wheel_drive.h"
#include "simcore/dynamics/engine.h"
#include "simcore/run/wheel_observer.h"
#include "simcore/sensors/sensor_suite.h"

namespace simcore::run {
namespace {

// A rover that gains less than this distance in this time is stuck (assumed) [m], [s].
constexpr double kStuckDistance = 0.01;
constexpr double kStuckTime = 10.0;
// A body faster than this has blown up (assumed) [m/s].
constexpr double kFastest = 100.0;
// Below this rate rolling resistance fades, so that it does not push at rest [rad/s].
constexpr double kRollingRate = 0.05;

control::ControllerSettings controllerSettings(const ResolvedRun& run) {
    control::ControllerSettings settings;
    settings.kind = run.controller;
    settings.assumedFriction = run.assumedFriction;
    settings.period = run.controlPeriod;
    settings.steering = run.steering;
    settings.headingHold = run.headingHold;
    settings.proportional = run.proportional;
    settings.integral = run.integral;
    settings.derivative = run.derivative;
    return settings;
}

}  // namespace

struct Simulation::Impl {
    Impl(ResolvedRun settings, const dynamics::EngineMaker& makeEngine);

    void reset();
    void step();
    void control();
    void findContacts();
    void applyDrives();
    void applySteering();
    void updateSnapshot();

    double chassisPlace() const {
        return engine->poses()[static_cast<std::size_t>(run.mechanism.chassis)].position.x();
    }

    void measure();
    void measureBodies();
    void measureFrictionWork();
    void reportSlip();
    void checkEnd();
    std::string blownUpBody(double fastest) const;
    std::string whyStuck() const;
    control::DriveCommand driveCommand() const;
    double endTime() const;
    std::string hashText() const;

    double brakeTorque(const mechanism::Wheel& wheel) const;

    bool manual() const { return run.controller == project::ControllerKind::Manual; }

    ResolvedRun run;
    std::unique_ptr<dynamics::Engine> engine;
    contact::WheelContactFinder contactFinder;
    std::optional<contact::BodyContactFinder> bodyFinder;
    std::unique_ptr<control::Controller> controller;
    std::vector<control::WheelDrive> drives;
    std::vector<std::size_t> steered;  ///< the first wheel of each steering joint
    sensors::SensorSuite sensors;
    std::vector<int> encoders;
    WheelObserver observer;
    dynamics::LoopErrorMeter loopError;
    FrictionMeter friction;

    ManualCommand manualCommand;
    std::vector<control::WheelCommand> commands;
    std::vector<double> torques;
    std::vector<double> resistances;
    std::vector<Pose> before;
    std::vector<contact::Contact> contacts;
    std::vector<project::GroundValues> grounds;  ///< at each contact
    std::vector<double> frictions;               ///< of each contact
    std::vector<double> rollingLoads;            ///< c N of each wheel, of the last step [N]
    std::vector<dynamics::JointMotor> motors;
    std::vector<double> lastGood;  ///< the engine's state before the step
    long controlTicks = 0;

    StateHash hash;  ///< of the states that steps started from
    Snapshot now;
    bool snapshotIsOld = true;
    StopReason reason = StopReason::Running;
    std::string detail;
    std::vector<WheelReport> wheels;
    std::vector<double> loadSums;
    std::vector<BodyReport> bodies;  ///< all
    std::vector<Vec3> bodyForces;    ///< of the ground on each, of the last step [N]
    double energy = 0.0;
    double loopErrorMax = 0.0;
    double penetrationMax = 0.0;
    double wallTime = 0.0;
    double progressX = 0.0;
    double progressTime = 0.0;
};

Simulation::Impl::Impl(ResolvedRun settings, const dynamics::EngineMaker& makeEngine)
    : run(std::move(settings)),
      engine(makeEngine(run.mechanism, {run.step, dynamics::kGravity, run.joints})),
      contactFinder(run.mechanism, *run.terrain, 2, engine->contactMargin()),
      controller(control::makeController(run.mechanism, controllerSettings(run))),
      sensors(run.mechanism, run.sensors, run.seed),
      encoders(run.mechanism.encoderJoints()),
      observer(run.mechanism, run.step),
      loopError(run.mechanism, run.joints),
      friction(run.mechanism, *run.terrain) {
    if (run.bodyContacts) {
        bodyFinder.emplace(run.mechanism, *run.terrain, engine->contactMargin());
    }
    for (const mechanism::Wheel& wheel : run.mechanism.wheels) {
        drives.emplace_back(wheel, control::axleInertia(run.mechanism, wheel));
    }
    for (std::size_t i = 0; i < drives.size(); ++i) {
        const int joint = run.mechanism.wheels[i].steering;
        const bool isNew = std::none_of(steered.begin(), steered.end(), [&](std::size_t other) {
            return run.mechanism.wheels[other].steering == joint;
        });
        if (joint >= 0 && isNew) {
            steered.push_back(i);
        }
    }
    // More contacts than usual ground makes, so that a drive takes nothing more from the heap.
    constexpr std::size_t kContactRoom = 256;
    contacts.reserve(kContactRoom);
    grounds.reserve(kContactRoom);
    frictions.reserve(kContactRoom);
    reset();
}

void Simulation::Impl::reset() {
    const std::size_t count = run.mechanism.wheels.size();
    engine->reset();
    controller->reset();
    for (control::WheelDrive& drive : drives) {
        drive.reset();
    }
    observer.reset();
    friction.reset();
    manualCommand = {};
    sensors.reset();
    hash = {};
    commands.assign(count, {});
    torques.assign(count, 0.0);
    resistances.assign(count, 0.0);
    rollingLoads.assign(count, 0.0);
    controlTicks = 0;
    now = {};
    now.wheels.assign(count, {});
    now.measured = sensors::noReadings(run.mechanism);
    now.intent.wheels.assign(count, {});
    reason = StopReason::Running;
    detail.clear();
    wheels.assign(count, {});
    for (std::size_t i = 0; i < count; ++i) {
        wheels[i].name = run.mechanism.wheels[i].name;
    }
    loadSums.assign(count, 0.0);
    bodies.assign(run.mechanism.bodies.size(), {});
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        bodies[i].name = run.mechanism.bodies[i].name;
    }
    energy = loopErrorMax = penetrationMax = wallTime = progressX = progressTime = 0.0;
    now.distance = chassisPlace();
    snapshotIsOld = true;
}

control::DriveCommand Simulation::Impl::driveCommand() const {
    control::DriveCommand command;
    command.brake = now.time < run.settle - 0.5 * run.step;
    if (manual()) {
        command.speed = manualCommand.speed;
        command.turn = manualCommand.turn;
        return command;
    }
    const double share = run.ramp > 0.0 ? (now.time - run.settle) / run.ramp : 1.0;
    command.speed = run.speed * std::clamp(share, 0.0, 1.0);
    command.turn = run.turn * std::clamp(share, 0.0, 1.0);
    return command;
}

void Simulation::Impl::control() {
    // Zero-order hold at the controller's own period, whatever the engine's step.
    if (now.time < static_cast<double>(controlTicks) * run.controlPeriod - 0.5 * run.step) {
        return;
    }
    ++controlTicks;
    updateSnapshot();
    sensors.read(*engine, now, now.measured);
    controller->update(now.measured, driveCommand(), commands);
    now.intent = controller->intent();
}

void Simulation::Impl::applyDrives() {
    motors.clear();
    for (std::size_t i = 0; i < drives.size(); ++i) {
        const mechanism::Wheel& wheel = run.mechanism.wheels[i];
        const auto body = static_cast<std::size_t>(wheel.body);
        const Vec3 axis = engine->poses()[body].rotation * wheel.axis;
        const double absolute = axis.dot(engine->velocities()[body].angular);
        const double relative = dynamics::wheelRate(wheel, engine->poses(), engine->velocities());
        torques[i] = drives[i].torque(commands[i], relative, run.step);
        if (commands[i].mode == control::WheelMode::Lock) {
            motors.push_back({wheel.axle, 0.0, commands[i].torqueCap});
        }
        // Rolling resistance, moment = c N R against the absolute turn (paper, section 4), with the
        // load of the last step.
        resistances[i] = -rollingLoads[i] * wheel.radius * std::tanh(absolute / kRollingRate);
        now.wheels[i].torqueCommanded = drives[i].commanded();
        now.wheels[i].torqueApplied = torques[i];
        now.wheels[i].power = torques[i] * relative;
        const double work = std::max(0.0, now.wheels[i].power) * run.step;
        energy += work;
        wheels[i].energy += work;
        wheels[i].maxTorque = std::max(wheels[i].maxTorque, std::abs(torques[i]));
    }
    applySteering();
}

void Simulation::Impl::applySteering() {
    for (const std::size_t i : steered) {
        const mechanism::Wheel& wheel = run.mechanism.wheels[i];
        const double angle = jointAngle(
            run.mechanism.joints[static_cast<std::size_t>(wheel.steering)], engine->poses());
        motors.push_back({wheel.steering,
                          control::servoRate(commands[i].steering, angle, wheel.steeringSpeedLimit),
                          wheel.steeringTorqueLimit});
    }
}

void Simulation::Impl::findContacts() {
    contacts = contactFinder.find(before);
    if (bodyFinder) {
        const std::vector<contact::Contact>& found = bodyFinder->find(before);
        contacts.insert(contacts.end(), found.begin(), found.end());
    }
    grounds.clear();
    frictions.clear();
    for (const contact::Contact& contact : contacts) {
        grounds.push_back(project::groundAt(run, contact.point.x(), contact.point.y()));
        frictions.push_back(grounds.back().friction);
    }
}

void Simulation::Impl::step() {
    const auto start = std::chrono::steady_clock::now();
    control();
    applyDrives();
    before = engine->poses();
    findContacts();
    engine->writeState(lastGood);
    engine->step({torques, resistances, contacts, frictions, motors});
    // A body that is thrown because a loop cannot be closed is not the cause.
    std::string trouble = engine->trouble();
    const double fastest = trouble.empty() ? kFastest : std::numeric_limits<double>::infinity();
    if (std::string body = blownUpBody(fastest); !body.empty()) {
        engine->restoreState(lastGood);
        reason = StopReason::NonFinite;
        detail = Text::of("body {}", body);
    } else if (!trouble.empty()) {
        engine->restoreState(lastGood);
        reason = StopReason::SingularPose;
        detail = std::move(trouble);
    } else {
        hash.add(lastGood);
        ++now.step;
        now.time = static_cast<double>(now.step) * run.step;
        measure();
        now.distance = chassisPlace();
        snapshotIsOld = true;
        checkEnd();
    }
    wallTime += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// With which the lock of an axle turns its wheel [N m].
double Simulation::Impl::brakeTorque(const mechanism::Wheel& wheel) const {
    const auto axle = static_cast<std::size_t>(wheel.axle);
    const double sign = run.mechanism.joints[axle].second == wheel.body ? 1.0 : -1.0;
    const Vec3 axis = before[static_cast<std::size_t>(wheel.body)].rotation * wheel.axis;
    return sign * axis.dot(engine->jointReactions()[axle].torque);
}

/// Body whose pose or motion is no number, or that is faster than that [m/s]; empty when none is.
std::string Simulation::Impl::blownUpBody(double fastest) const {
    for (std::size_t i = 0; i < run.mechanism.bodies.size(); ++i) {
        const Pose& pose = engine->poses()[i];
        const dynamics::BodyVelocity& velocity = engine->velocities()[i];
        // No number in them, no number in their sum.
        const bool finite = std::isfinite(pose.position.sum() + pose.rotation.coeffs().sum() +
                                          velocity.linear.sum() + velocity.angular.sum());
        if (!finite || velocity.linear.squaredNorm() > fastest * fastest) {
            return run.mechanism.bodies[i].name;
        }
    }
    return {};
}

std::string Simulation::Impl::whyStuck() const {
    std::string why =
        Text::of("less than {:.0f} mm gained in {:.0f} s", 1e3 * kStuckDistance, kStuckTime);
    if (controller->intent().resting) {
        return Text::of("{}, though every wheel gave all that the ground takes; they rest", why);
    }
    const auto atTractionCap = [this](std::size_t i) {
        const double cap = commands[i].torqueCap;
        return cap < run.mechanism.wheels[i].torqueLimit && std::abs(torques[i]) > 0.99 * cap;
    };
    int capped = 0;
    int touching = 0;
    for (std::size_t i = 0; i < torques.size(); ++i) {
        touching += now.wheels[i].touching ? 1 : 0;
        capped += now.wheels[i].touching && atTractionCap(i) ? 1 : 0;
    }
    if (capped > 0 && capped == touching) {
        return Text::of("{}, every wheel at the traction cap of assumed friction {:.3g}", why,
                        run.assumedFriction);
    }
    return why;
}

void Simulation::Impl::measure() {
    const bool count = now.time > run.settle + run.ramp;
    observer.observe(*engine, before, contacts, count, now.wheels);
    rollingLoads.assign(wheels.size(), 0.0);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const contact::Contact& contact = contacts[i];
        if (contact.wheel < 0) {
            continue;
        }
        rollingLoads[static_cast<std::size_t>(contact.wheel)] +=
            grounds[i].rollingResistance *
            std::max(0.0, engine->contactForces()[i].dot(contact.normal));
    }
    measureBodies();
    if (count) {
        measureFrictionWork();
    }
    if (now.time > run.settle) {
        friction.observe(contacts, engine->contactForces(), frictions);
        loopErrorMax = std::max(loopErrorMax, loopError.measure(engine->poses()));
        for (const contact::Contact& contact : contacts) {
            penetrationMax = std::max(penetrationMax, contact.depth);
        }
    }
    for (std::size_t i = 0; i < wheels.size(); ++i) {
        WheelState& state = now.wheels[i];
        if (count) {
            wheels[i].airTime += state.touching ? 0.0 : run.step;
            loadSums[i] += state.normalForce * run.step;
        }
        state.frictionWork = wheels[i].frictionWork;
    }
    reportSlip();
}

void Simulation::Impl::reportSlip() {
    for (std::size_t i = 0; i < wheels.size(); ++i) {
        wheels[i].slipAbs = now.wheels[i].slipAbs;
        wheels[i].slipLoaded = now.wheels[i].slipLoaded;
        wheels[i].slipSigned = now.wheels[i].slipSigned;
        wheels[i].slipLateral = now.wheels[i].slipLateral;
    }
}

// Of the rates after the step, which are those that engines move bodies with in it.
void Simulation::Impl::measureFrictionWork() {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const contact::Contact& contact = contacts[i];
        const auto body = static_cast<std::size_t>(bodyOf(contact, run.mechanism));
        const dynamics::BodyVelocity& rates = engine->velocities()[body];
        const Vec3 arm = contact.point - before[body] * run.mechanism.bodies[body].com;
        const double work = run.step * frictionPower(contact, engine->contactForces()[i],
                                                     rates.linear + rates.angular.cross(arm));
        (contact.wheel >= 0 ? wheels[static_cast<std::size_t>(contact.wheel)].frictionWork
                            : bodies[body].frictionWork) += work;
    }
}

void Simulation::Impl::measureBodies() {
    bodyForces.assign(bodies.size(), Vec3::Zero());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (contacts[i].wheel < 0) {
            bodyForces[static_cast<std::size_t>(contacts[i].body)] += engine->contactForces()[i];
        }
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const double force = bodyForces[i].norm();
        bodies[i].contactTime += force > 0.0 ? run.step : 0.0;
        bodies[i].maxForce = std::max(bodies[i].maxForce, force);
    }
}

/// Of what nothing in a step asks for: most steps are looked at by nobody.
void Simulation::Impl::updateSnapshot() {
    if (!snapshotIsOld) {
        return;
    }
    snapshotIsOld = false;
    for (std::size_t i = 0; i < now.wheels.size(); ++i) {
        if (commands[i].mode == control::WheelMode::Lock && !engine->jointReactions().empty()) {
            now.wheels[i].torqueApplied = brakeTorque(run.mechanism.wheels[i]);
        }
    }
    const auto chassis = static_cast<std::size_t>(run.mechanism.chassis);
    now.bodies = engine->poses();
    now.centerOfMass = run.mechanism.centerOfMass(now.bodies);
    const Pose& pose = now.bodies[chassis];
    const dynamics::BodyVelocity& velocity = engine->velocities()[chassis];
    const Vec3 arm = -(pose.rotation * run.mechanism.bodies[chassis].com);
    now.angularRate = pose.rotation.conjugate() * velocity.angular;
    now.joints.clear();
    for (const int index : encoders) {
        const mechanism::Joint& joint = run.mechanism.joints[static_cast<std::size_t>(index)];
        now.joints.push_back({jointAngle(joint, engine->poses()),
                              dynamics::jointRate(joint, engine->poses(), engine->velocities())});
    }
    now.speed = (pose.rotation * Vec3::UnitX()).dot(velocity.linear + velocity.angular.cross(arm));
}

double Simulation::Impl::endTime() const {
    if (run.duration > 0.0) {
        return run.duration;
    }
    // 60 % more than the drive takes without slip.
    return run.settle + run.ramp + 1.0 + 1.6 * run.distance / std::max(std::abs(run.speed), 1e-3);
}

std::string Simulation::Impl::hashText() const {
    StateHash all = hash;
    all.add(engine->saveState());
    return fmt::format("{:016x}", all.value());
}

void Simulation::Impl::checkEnd() {
    const double travelled = (run.speed < 0.0 && !manual() ? -1.0 : 1.0) * now.distance;
    if (travelled >= run.distance) {
        reason = StopReason::Completed;
    } else if (now.time > endTime() - 0.5 * run.step && !(manual() && run.duration <= 0.0)) {
        reason = StopReason::TimeUp;
    } else if (travelled > progressX + kStuckDistance || manual() || run.speed == 0.0 ||
               run.turn != 0.0) {
        progressX = travelled;
        progressTime = now.time;
    } else if (now.time - std::max(progressTime, run.settle + run.ramp) > kStuckTime) {
        reason = StopReason::Stuck;
        detail = whyStuck();
    }
    if (reason != StopReason::Running) {
        observer.closeWindow(now.wheels);
        reportSlip();
    }
}

Simulation::Simulation(ResolvedRun run) {
    const dynamics::EngineMaker makeEngine = run.engine == project::EngineKind::Reduced
                                                 ? dynamics::makeReducedEngine
                                                 : dynamics::makeOdeEngine;
    impl_ = std::make_unique<Impl>(std::move(run), makeEngine);
}

Simulation::Simulation(ResolvedRun run, const dynamics::EngineMaker& makeEngine)
    : impl_(std::make_unique<Impl>(std::move(run), makeEngine)) {}

Simulation::~Simulation() = default;

void Simulation::reset() {
    impl_->reset();
}

void Simulation::step() {
    if (!finished()) {
        impl_->step();
    }
}

bool Simulation::finished() const {
    return impl_->reason != StopReason::Running;
}

void Simulation::setManualCommand(const ManualCommand& command) {
    impl_->manualCommand = command;
}

const ResolvedRun& Simulation::settings() const {
    return impl_->run;
}

const Snapshot& Simulation::snapshot() const {
    impl_->updateSnapshot();
    return impl_->now;
}

RunReport Simulation::report() const {
    const Impl& s = *impl_;
    RunReport report;
    report.engine = s.engine->name();
    report.scenario = s.run.scenario;
    report.step = s.run.step;
    report.steps = s.now.step;
    report.simTime = s.now.time;
    report.wallTime = s.wallTime;
    report.rtf = s.wallTime > 0.0 ? s.now.time / s.wallTime : 0.0;
    report.completed = s.reason == StopReason::Completed ||
                       (s.reason == StopReason::TimeUp && s.run.duration > 0.0);
    report.stopReason = s.reason;
    report.stopDetail = s.detail;
    report.distance = s.now.distance;
    report.wheels = s.wheels;
    const double counted = s.now.time - s.run.settle - s.run.ramp;
    for (std::size_t i = 0; i < report.wheels.size(); ++i) {
        report.slipAbs += report.wheels[i].slipAbs;
        report.slipLoaded += report.wheels[i].slipLoaded;
        report.slipSigned += report.wheels[i].slipSigned;
        report.frictionWork += report.wheels[i].frictionWork;
        report.wheels[i].meanNormalForce = counted > 0.0 ? s.loadSums[i] / counted : 0.0;
    }
    std::copy_if(s.bodies.begin(), s.bodies.end(), std::back_inserter(report.bodies),
                 [](const BodyReport& body) { return body.contactTime > 0.0; });
    for (const BodyReport& body : report.bodies) {
        report.frictionWork += body.frictionWork;
    }
    report.energy = s.energy;
    report.stateHash = s.hashText();
    report.frictionViolationPercent = s.friction.violationPercent();
    report.frictionWorstPercent = s.friction.worstPercent();
    report.loopErrorMax = s.loopErrorMax;
    report.penetrationMax = s.penetrationMax;
    const dynamics::EngineCounters& counters = s.engine->counters();
    if (counters.steps > 0) {
        report.solvesPerStep =
            static_cast<double>(counters.passes) / static_cast<double>(counters.steps);
    }
    report.solverMessages = counters.solverMessages;
    report.fallbacks = counters.fallbacks;
    report.contactResidualMax = counters.worstResidual;
    report.dividedSteps = counters.dividedSteps;
    report.jointChoices = counters.choices;
    report.pivotRatioMin = counters.leastPivotRatio;
    report.warnings = counters.warnings;
    return report;
}

}  // namespace simcore::run
