#include "simcore/run/run_worker.h"

namespace simcore::run {
namespace {

class SimulationStepper final : public Stepper {
  public:
    explicit SimulationStepper(const ResolvedRun& run) : simulation_(run) {}

    void reset() override { simulation_.reset(); }

    void step() override { simulation_.step(); }

    bool finished() const override { return simulation_.finished(); }

    void setManualCommand(const ManualCommand& command) override {
        simulation_.setManualCommand(command);
    }

    const Snapshot& snapshot() const override { return simulation_.snapshot(); }

    RunReport report() const override { return simulation_.report(); }

  private:
    Simulation simulation_;
};

}  // namespace

RunWorker::RunWorker(ResolvedRun run, std::unique_ptr<RunSink> sink)
    : RunWorker(
          std::move(run),
          [](const ResolvedRun& r) { return std::make_unique<SimulationStepper>(r); },
          std::move(sink)) {}

}  // namespace simcore::run
