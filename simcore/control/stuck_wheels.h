#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace simcore::control {

/// Wheels of a rover that stands though it is to drive: which of them may be given more, which
/// spin, and when nothing more is to be had. From what the rover measures alone; see
/// docs/controllers.md.
class StuckWheels {
  public:
    enum class Stage {
        Drives,
        Tries,  ///< stalled: wheels that stand get more, wheels that spin creep
        Rests,  ///< all that the ground gives was not enough: wheels are brought to rest
    };

    /// The friction that wheels are trusted with at most, when the rover is stalled (assumed).
    static constexpr double kMostFriction = 0.9;

    /// A wheel at one look.
    struct Wheel {
        bool bears = false;    ///< carries load
        bool atCap = false;    ///< is asked for all that its friction cap leaves it
        bool atLimit = false;  ///< is asked for all that its motor has
        double rate = 0.0;     ///< measured [rad/s]
        double rolling = 0.0;  ///< at which nothing slips if the rover drives as asked [rad/s]
    };

    /// @param period  between looks [s]
    StuckWheels(std::size_t wheels, double period);

    void reset();

    /// @param asked  speed [m/s]
    /// @param speed  measured [m/s]
    void update(double asked, double speed, std::span<const Wheel> wheels);

    Stage stage() const { return stage_; }

    /// The friction to trust a wheel with: `assumed`, more where it is stuck below it, less where
    /// it is being brought to rest [-]. `assumed` 0 stands for no cap, which is 0 again but for a
    /// wheel at rest.
    double friction(std::size_t wheel, double assumed) const;

    /// Rate at which a wheel may turn when the rover is stalled: a little ahead of the ground
    /// [rad/s], >= 0.
    double creep(std::size_t wheel) const { return creep_[wheel]; }

  private:
    void attempt(double asked, std::span<const Wheel> wheels);

    double period_;
    Stage stage_ = Stage::Drives;
    bool forward_ = true;
    double speed_ = 0.0;                ///< measured, smoothed [m/s]
    double stalled_ = 0.0;              ///< for how long [s]
    double spun_ = 0.0;                 ///< for how long all have given what they can [s]
    double advance_ = 0.0;              ///< of the rover meanwhile [m]
    std::vector<bool> slips_;           ///< one a wheel, as all below
    std::vector<double> creep_;         ///< [rad/s]
    std::vector<double> raised_;        ///< trusted above what is assumed [-]
    std::vector<double> restingBelow_;  ///< trusted at most [-]
};

}  // namespace simcore::control
