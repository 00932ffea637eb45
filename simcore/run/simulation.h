#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simcore/base/result.h"
#include "simcore/dynamics/engine.h"
#include "simcore/mechanism/mechanism.h"
#include "simcore/project/project_files.h"
#include "simcore/project/resolve.h"
#include "simcore/run/channels.h"
#include "simcore/run/snapshot.h"
#include "simcore/terrain/terrain.h"

/// Driving a rover over terrain: engine, contacts, controller and measures put together.
namespace simcore::run {

/// What is asked for on top of the scenario. Empty fields keep the scenario's.
struct RunRequest {
    std::string scenario;
    project::ProjectFiles files;  ///< where those of the terrain are
    std::optional<project::EngineKind> engine;
    std::optional<project::ControllerKind> controller;
    std::optional<double> friction;
    std::optional<double> duration;
    std::optional<double> distance;
    std::optional<double> terrainHeight;
    std::optional<double> step;
    std::optional<int> seed;
    std::optional<bool> relaxedJoints;
    std::vector<project::Assignment> assignments;
    bool operator==(const RunRequest&) const = default;
};

/// Commands of a person driving.
struct ManualCommand {
    double speed = 0.0;  ///< [m/s], + forward
    double turn = 0.0;   ///< yaw rate [rad/s], + left
    bool operator==(const ManualCommand&) const = default;
};

/// All that a run needs, evaluated [SI].
struct ResolvedRun : project::ScenarioValues {
    mechanism::Mechanism mechanism;
    std::shared_ptr<const terrain::Terrain> terrain;
    project::EngineKind engine = project::EngineKind::Ode;
    project::ControllerKind controller = project::ControllerKind::Speed;
    mechanism::Model joints = mechanism::Model::Built;
    project::SteeringMode steering = project::SteeringMode::Auto;
    bool headingHold = false;
    bool bodyContacts = true;  ///< chassis, forks and links touch the ground, too
    int seed = 1;
    std::string scenario;
};

/// The ground of a scenario; it reaches beyond the way the rover is to drive, ahead of the start or
/// (negative speed) behind it. Reads the terrain's files.
Result<terrain::Terrain> makeScenarioTerrain(const project::Scenario& scenario,
                                             const project::ParameterValues& parameters,
                                             const project::ProjectFiles& files = {});

/// project::validate(), and what would keep a scenario from running: its terrain, the engine. Makes
/// no terrain and reads no files, only looks for them, so that an editor can ask after every edit.
Problems checkProject(const project::Project& project, const project::ProjectFiles& files = {});

/// The scenario of that name; the problem lists those there are.
Result<const project::Scenario*> findScenario(const project::Project& project,
                                              const std::string& name);

/// A run's settings and mechanism without its ground, so without any of its files: for what only
/// tells of a run.
Result<ResolvedRun> evaluateRun(const project::Project& project, const RunRequest& request);

/// The project with what was asked for written into it: its scenario alone asks for the same run.
/// Parameters are set in the scenario's variant when it has one. Problem: no such scenario.
Result<project::Project> asRequested(const project::Project& project, const RunRequest& request);

/// Resolves everything a run needs; all problems, none of them left for the engine to abort on.
Result<ResolvedRun> prepareRun(const project::Project& project, const RunRequest& request);

enum class StopReason { Running, Completed, TimeUp, Stuck, NonFinite, SingularPose, Stopped };
std::string toString(StopReason reason);

struct WheelReport {
    std::string name;
    double slipAbs = 0.0, slipLoaded = 0.0, slipSigned = 0.0, slipLateral = 0.0;  ///< [m]
    double frictionWork = 0.0;                                                    ///< [J]
    double meanNormalForce = 0.0, maxTorque = 0.0;                                ///< [N], [N m]
    double energy = 0.0;   ///< drive work, positive part [J]
    double airTime = 0.0;  ///< [s]
};

/// A body that is no wheel and touched the ground.
struct BodyReport {
    std::string name;
    double contactTime = 0.0;   ///< with a contact force [s]
    double maxForce = 0.0;      ///< largest sum of its contact forces [N]
    double frictionWork = 0.0;  ///< [J]
};

/// What a run came to. docs/csv.md and docs/run-report.md define every number.
struct RunReport {
    std::string engine;
    std::string scenario;
    double step = 0.0;
    long steps = 0;
    double simTime = 0.0, wallTime = 0.0, rtf = 0.0;
    bool completed = false;
    StopReason stopReason = StopReason::Running;
    std::string stopDetail;  ///< e.g. the body that went non-finite
    double distance = 0.0;
    double slipAbs = 0.0, slipLoaded = 0.0, slipSigned = 0.0;
    double frictionWork = 0.0;  ///< at the contacts of wheels and other bodies [J]
    std::vector<WheelReport> wheels;
    std::vector<BodyReport> bodies;  ///< those that touched the ground, mechanism order
    double energy = 0.0;
    std::string stateHash;  ///< 16 hex digits
    double frictionViolationPercent = 0.0;
    double frictionWorstPercent = 0.0;  ///< farthest outside the friction cone
    double loopErrorMax = 0.0;          ///< [m]
    double penetrationMax = 0.0;        ///< [m]
    // dynamics::EngineCounters says what these are.
    double solvesPerStep = 0.0;
    long solverMessages = 0;
    long fallbacks = 0;
    double contactResidualMax = 0.0;  ///< [N]
    long dividedSteps = 0;
    long jointChoices = 0;
    double pivotRatioMin = 1.0;
    std::vector<std::string> warnings;
};

/// One run, stepped by its owner. Not thread safe: one thread makes, steps and destroys it.
class Simulation {
  public:
    /// On the engine that the run asks for.
    explicit Simulation(ResolvedRun run);
    /// On any engine behind the port.
    Simulation(ResolvedRun run, const dynamics::EngineMaker& makeEngine);
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    /// Back to the start: the same run again, bit for bit.
    void reset();
    /// Advances by one engine step. Does nothing once finished.
    void step();
    bool finished() const;
    void setManualCommand(const ManualCommand& command);

    const ResolvedRun& settings() const;
    /// The present instant.
    const Snapshot& snapshot() const;
    /// The report so far; wallTime counts time spent in step().
    RunReport report() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Channel values sampled at a fixed period, with frames for playback.
struct Recording {
    std::vector<Channel> channels;
    std::vector<std::vector<double>> rows;  ///< each as long as channels
    std::vector<std::shared_ptr<const Snapshot>> frames;
};

}  // namespace simcore::run
