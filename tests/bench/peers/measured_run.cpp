#include "tests/bench/peers/measured_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "simcore/run/wheel_observer.h"
#include "tests/support/posed_engine.h"

namespace peers {
namespace {

using simcore::Pose;
using simcore::run::ResolvedRun;

double threadTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Adds to a run what a call takes.
template <class Work>
void timed(MeasuredRun& run, Work&& work) {
    using Clock = std::chrono::steady_clock;
    const double cpu = threadTime();
    const auto start = Clock::now();
    work();
    const auto end = Clock::now();
    run.cpuTime += threadTime() - cpu;
    run.wallTime += std::chrono::duration<double>(end - start).count();
}

/// Commanded speed of the rover [m/s], as our own runs have it.
double commandedSpeed(const ResolvedRun& run, double time) {
    const double share = run.ramp > 0.0 ? (time - run.settle) / run.ramp : 1.0;
    return time < run.settle - 0.5 * run.step ? 0.0 : run.speed * std::clamp(share, 0.0, 1.0);
}

double endTime(const ResolvedRun& run) {
    return run.duration > 0.0
               ? run.duration
               : run.settle + run.ramp + 1.0 + 1.6 * run.distance / std::abs(run.speed);
}

bool finite(const std::vector<Pose>& poses) {
    return std::all_of(poses.begin(), poses.end(), [](const Pose& pose) {
        return pose.position.allFinite() && pose.rotation.coeffs().allFinite();
    });
}

/// Our measures of what a peer does.
class Meter {
  public:
    explicit Meter(const ResolvedRun& run)
        : run_(run),
          observer_(run.mechanism, run.step),
          engine_(run.mechanism.bodies.size()),
          wheels_(run.mechanism.wheels.size()) {
        engine_.bodyPoses.resize(run.mechanism.bodies.size());
        // Slip is a matter of poses; of velocities the observer only makes rates, unused here.
        engine_.bodyVelocities.resize(run.mechanism.bodies.size());
    }

    void observe(const Reading& reading, MeasuredRun& measured) {
        const std::vector<Pose> before = engine_.bodyPoses;
        engine_.bodyPoses = reading.poses;
        engine_.forces = reading.forces;
        observer_.observe(engine_, before, reading.contacts,
                          measured.simTime > run_.settle + run_.ramp, wheels_);
        if (measured.simTime > run_.settle) {
            measured.loopError =
                std::max(measured.loopError,
                         simcore::dynamics::loopError(run_.mechanism, reading.poses, run_.joints));
            for (const auto& contact : reading.contacts) {
                measured.penetration = std::max(measured.penetration, contact.depth);
            }
        }
        measured.distance =
            reading.poses[static_cast<std::size_t>(run_.mechanism.chassis)].position.x();
    }

    double slipAbs() {
        observer_.closeWindow(wheels_);
        double sum = 0.0;
        for (const auto& wheel : wheels_) {
            sum += wheel.slipAbs;
        }
        return sum;
    }

  private:
    const ResolvedRun& run_;
    simcore::run::WheelObserver observer_;
    testsupport::PosedEngine engine_;
    std::vector<simcore::run::WheelState> wheels_;
};

}  // namespace

MeasuredRun runOurs(const ResolvedRun& run, simcore::project::EngineKind engine) {
    ResolvedRun own = run;
    own.engine = engine;
    simcore::run::Simulation simulation(std::move(own));
    MeasuredRun measured;
    while (!simulation.finished()) {
        timed(measured, [&] { simulation.step(); });
    }
    const simcore::run::RunReport report = simulation.report();
    measured.steps = report.steps;
    measured.simTime = report.simTime;
    measured.penetration = report.penetrationMax;
    measured.loopError = report.loopErrorMax;
    measured.slipAbs = report.slipAbs;
    measured.distance = report.distance;
    measured.completed = report.stopReason == simcore::run::StopReason::Completed;
    return measured;
}

MeasuredRun runPeer(Peer& peer, const ResolvedRun& run) {
    Meter meter(run);
    MeasuredRun measured;
    Reading reading;
    std::vector<double> speeds(run.mechanism.wheels.size());
    while (measured.simTime < endTime(run) - 0.5 * run.step && !measured.completed) {
        for (std::size_t i = 0; i < speeds.size(); ++i) {
            speeds[i] = commandedSpeed(run, measured.simTime) / run.mechanism.wheels[i].radius;
        }
        timed(measured, [&] { peer.step(speeds); });
        ++measured.steps;
        measured.simTime = static_cast<double>(measured.steps) * run.step;
        peer.read(reading);
        if (peer.failed() || !finite(reading.poses)) {
            break;
        }
        meter.observe(reading, measured);
        measured.completed = measured.distance >= run.distance;
    }
    measured.slipAbs = meter.slipAbs();
    return measured;
}

}  // namespace peers
