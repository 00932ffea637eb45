#pragma once

#include "simcore/dynamics/engine.h"

namespace testsupport {

/// An engine that a test poses by hand, for what only looks at an engine.
class PosedEngine final : public simcore::dynamics::Engine {
  public:
    explicit PosedEngine(std::size_t bodies) : bodyPoses(bodies), bodyVelocities(bodies) {}

    std::string name() const override { return "posed"; }

    void reset() override {}

    void step(const simcore::dynamics::StepInput& /*input*/) override {}

    const std::vector<simcore::Pose>& poses() const override { return bodyPoses; }

    const std::vector<simcore::dynamics::BodyVelocity>& velocities() const override {
        return bodyVelocities;
    }

    const std::vector<simcore::Vec3>& contactForces() const override { return forces; }

    const std::vector<simcore::dynamics::JointReaction>& jointReactions() const override {
        return reactions;
    }

    void writeState(std::vector<double>& numbers) const override { numbers.clear(); }

    void restoreState(std::span<const double> /*state*/) override {}

    const simcore::dynamics::EngineCounters& counters() const override { return counters_; }

    std::vector<simcore::Pose> bodyPoses;
    std::vector<simcore::dynamics::BodyVelocity> bodyVelocities;
    std::vector<simcore::Vec3> forces;
    std::vector<simcore::dynamics::JointReaction> reactions;

  private:
    simcore::dynamics::EngineCounters counters_;
};

}  // namespace testsupport
