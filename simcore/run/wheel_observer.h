#pragma once

#include <span>
#include <vector>

#include "simcore/dynamics/engine.h"
#include "simcore/run/simulation.h"

/// Contact, slip and torque of every wheel, as defined in docs/run-report.md.
namespace simcore::run {

/// Length of the windows in which slip is summed before its absolute value is taken [s].
inline constexpr double kSlipWindow = 0.02;

/// A wheel or patch that carries less does not count as loaded: 2 % (assumed) of the mean wheel
/// load [N].
double leastLoad(const mechanism::Mechanism& mechanism);

/// What a contact's friction takes from a body that slides over the ground [W].
/// @param force     of the ground on the body [N], world
/// @param velocity  of the body's point that touches [m/s], world
double frictionPower(const contact::Contact& contact, const Vec3& force, const Vec3& velocity);

/// Rolling frame of a wheel at its contact: held while the wheel is in the air.
struct RollingFrame {
    Vec3 normal = Vec3::UnitZ();   ///< force-weighted mean, world
    double effectiveRadius = 0.0;  ///< wheel centre to contact point [m]
    double angle = 0.0;            ///< contact angle [rad]
};

/// Watches one run from step to step.
class WheelObserver {
  public:
    WheelObserver(const mechanism::Mechanism& mechanism, double step);

    void reset();
    /// After a step: `before` are the poses the step started from.
    void observe(const dynamics::Engine& engine, const std::vector<Pose>& before,
                 std::span<const contact::Contact> contacts, bool countSlip,
                 std::vector<WheelState>& states);
    /// Ends the running window, e.g. at the end of a run.
    void closeWindow(std::vector<WheelState>& states);

  private:
    struct Window {
        double slip = 0.0;
        double loaded = 0.0;  ///< of it, while the wheel carried load
        double lateral = 0.0;
    };

    void observeContact(std::size_t wheel, const Pose& pose,
                        std::span<const contact::Contact> contacts, std::span<const Vec3> forces,
                        WheelState& state);
    void observeMotion(std::size_t wheel, const Pose& before, const Pose& after,
                       const dynamics::BodyVelocity& velocity, bool countSlip, WheelState& state);

    const mechanism::Mechanism& mechanism_;
    double step_;
    double leastLoad_;
    double windowTime_ = 0.0;
    std::vector<RollingFrame> frames_;
    std::vector<Window> windows_;
};

/// Share of loaded contact patches outside their friction cone (docs/run-report.md).
class FrictionMeter {
  public:
    FrictionMeter(const mechanism::Mechanism& mechanism, const terrain::Terrain& terrain);
    void reset();
    /// Forces and friction coefficients of each contact.
    void observe(std::span<const contact::Contact> contacts, std::span<const Vec3> forces,
                 std::span<const double> frictions);
    double violationPercent() const;
    /// How far the worst patch was outside its cone, after a slack of 0.2 N.
    double worstPercent() const;

  private:
    struct Count {
        long patches = 0;
        long outside = 0;
        double worst = 0.0;  ///< largest (|T| - slack) / (mu N) - 1
    };

    bool onObstacle(std::span<const contact::Contact> contacts) const;

    double leastLoad_;
    std::pair<double, double> obstacles_;
    bool started_ = false;
    Count certain_;  ///< up to the last obstacle contact so far
    Count pending_;  ///< since then
    std::vector<bool> used_;
};

}  // namespace simcore::run
