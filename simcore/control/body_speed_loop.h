#pragma once

#include <algorithm>

#include "simcore/control/controller.h"

namespace simcore::control {

/// PID on the body's speed; its torque Mc is to be shared among the wheels as N_i / N_mean (Lamon
/// et al. 2004, eq. 4).
class BodySpeedLoop {
  public:
    /// Gains of 0 are derived: n Mc / R accelerates the mass m, and both poles at -w0 ask for
    /// Kp = 2 w0 R m / n and Ki = w0^2 R m / n.
    BodySpeedLoop(const mechanism::Mechanism& mechanism, const ControllerSettings& settings)
        : period_(settings.period),
          proportional_(settings.proportional),
          integralGain_(settings.integral),
          derivative_(settings.derivative) {
        // Quick against a rover of 0.1 m/s, slow against a period of 10 ms [rad/s] (assumed).
        constexpr double kFrequency = 6.0;
        const auto n = static_cast<double>(std::max<std::size_t>(1, mechanism.wheels.size()));
        const double radius = mechanism.wheels.empty() ? 0.1 : mechanism.wheels.front().radius;
        const double unit = radius * mechanism.mass() / n;
        proportional_ = proportional_ > 0.0 ? proportional_ : 2.0 * kFrequency * unit;
        integralGain_ = integralGain_ > 0.0 ? integralGain_ : kFrequency * kFrequency * unit;
        for (const mechanism::Wheel& wheel : mechanism.wheels) {
            limit_ = std::max(limit_, wheel.torqueLimit);
        }
    }

    void reset() {
        integral_ = 0.0;
        started_ = false;
    }

    /// Mc [N m].
    /// @param held  the wheels cannot give more: the integral waits
    double torque(double speed, double wanted, bool held = false) {
        const double error = wanted - speed;
        const double change = started_ ? -(speed - last_) / period_ : 0.0;
        last_ = speed;
        started_ = true;
        // Anti-windup: the integral alone never asks for more than the motors have.
        if (!held || error * integral_ < 0.0) {
            integral_ = std::clamp(integral_ + integralGain_ * error * period_, -limit_, limit_);
        }
        return proportional_ * error + integral_ + derivative_ * change;
    }

  private:
    double period_;
    double proportional_;
    double integralGain_;
    double derivative_;
    double limit_ = 0.0;
    double integral_ = 0.0;
    double last_ = 0.0;
    bool started_ = false;
};

}  // namespace simcore::control
