#include "tests/support/fake_run.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace test_support {
namespace {

using namespace simcore;
using namespace simcore::run;

constexpr std::array kWheels{
    "front", "bogie_left_front", "bogie_left_rear", "bogie_right_front", "bogie_right_rear",
    "rear"};
constexpr std::array kWheelX{0.34, 0.10, -0.14, 0.10, -0.14, -0.36};

class FakeStepper final : public Stepper {
  public:
    FakeStepper(const ResolvedRun& run, std::function<void(long)> beforeStep)
        : run_(run),
          beforeStep_(std::move(beforeStep)) {
        reset();
    }

    void reset() override {
        snapshot_ = Snapshot{};
        snapshot_.bodies.resize(1);
        snapshot_.wheels.resize(kWheels.size());
        snapshot_.measured.wheels.resize(kWheels.size());
        snapshot_.intent.wheels.resize(kWheels.size());
        chaos_ = 0.1 + 0.01 * run_.seed;
        hash_ = 14695981039346656037ULL;
        fill();
    }

    void step() override {
        if (finished()) {
            return;
        }
        if (beforeStep_) {
            beforeStep_(snapshot_.step + 1);
        }
        ++snapshot_.step;
        snapshot_.time = static_cast<double>(snapshot_.step) * run_.step;
        chaos_ = 3.99 * chaos_ * (1.0 - chaos_);
        fill();
        hash_ = (hash_ ^ std::bit_cast<std::uint64_t>(chaos_)) * 1099511628211ULL;
        hash_ = (hash_ ^ std::bit_cast<std::uint64_t>(snapshot_.speed)) * 1099511628211ULL;
    }

    bool finished() const override { return snapshot_.time >= run_.duration - 0.5 * run_.step; }

    void setManualCommand(const ManualCommand& command) override { manual_ = command; }

    const Snapshot& snapshot() const override { return snapshot_; }

    RunReport report() const override {
        RunReport report;
        report.engine = "fake";
        report.scenario = run_.scenario;
        report.step = run_.step;
        report.steps = snapshot_.step;
        report.simTime = snapshot_.time;
        report.completed = finished();
        report.stopReason = finished() ? StopReason::Completed : StopReason::Running;
        report.distance = snapshot_.distance;
        for (std::size_t i = 0; i < kWheels.size(); ++i) {
            report.wheels.push_back({.name = kWheels[i], .slipAbs = snapshot_.wheels[i].slipAbs});
            report.slipAbs += snapshot_.wheels[i].slipAbs;
        }
        std::array<char, 17> text{};
        std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash_));
        report.stateHash = text.data();
        return report;
    }

  private:
    void fill() {
        const bool driven = run_.controller == project::ControllerKind::Manual;
        snapshot_.speed = driven ? manual_.speed : run_.speed;
        snapshot_.distance += snapshot_.speed * run_.step;
        snapshot_.bodies[0].position = Vec3(snapshot_.distance, 0.0, 0.0);
        snapshot_.centerOfMass = snapshot_.bodies[0].position + Vec3(0.0, 0.0, 0.2);
        snapshot_.intent.commonTorque = 0.1 * chaos_;
        snapshot_.intent.requiredFriction = 0.3;
        snapshot_.intent.frictionCap = 0.5;
        for (std::size_t i = 0; i < kWheels.size(); ++i) {
            WheelState& wheel = snapshot_.wheels[i];
            snapshot_.intent.wheels[i] = {0.2, 20.0, snapshot_.speed / 0.07};
            const double x = snapshot_.distance + kWheelX[i] - 1.0;
            const double bump = std::exp(-x * x / 0.02);
            const double noise = chaos_ - 0.5;
            wheel.touching = true;
            wheel.contactAngle = -1.2 * x / 0.14 * bump;
            wheel.normalForce = 20.0 + 9.0 * bump + 1.5 * noise;
            wheel.torqueCommanded = 0.25 + 1.1 * bump + 0.04 * noise;
            wheel.torqueApplied = std::min(wheel.torqueCommanded, 1.0);
            wheel.tractionForce = wheel.torqueApplied / 0.07;
            wheel.rate = snapshot_.speed / 0.07 * (1.0 + 0.4 * bump);
            wheel.centerSpeed = snapshot_.speed * (1.0 - 0.1 * bump);
            wheel.slipRatio = 0.3 * bump + 0.01 * noise;
            wheel.slipAbs +=
                (0.004 + 0.03 * bump) * run_.step * (1.0 + 0.1 * static_cast<double>(i));
            snapshot_.measured.wheels[i] = {wheel.rate, wheel.normalForce, wheel.contactAngle};
            wheel.slipSigned -= 0.02 * bump * run_.step;
        }
    }

    ResolvedRun run_;
    std::function<void(long)> beforeStep_;
    Snapshot snapshot_;
    ManualCommand manual_;
    double chaos_ = 0.1;
    std::uint64_t hash_ = 0;
};

}  // namespace

ResolvedRun fakeRun(double duration) {
    ResolvedRun run;
    run.scenario = "bump";
    run.duration = duration;
    run.mechanism.name = "fake";
    run.mechanism.bodies.resize(1);
    for (const char* name : kWheels) {
        run.mechanism.wheels.emplace_back().name = name;
    }
    return run;
}

StepperFactory fakeStepper(std::function<void(long)> beforeStep) {
    return [beforeStep = std::move(beforeStep)](const ResolvedRun& run) {
        return std::make_unique<FakeStepper>(run, beforeStep);
    };
}

}  // namespace test_support
