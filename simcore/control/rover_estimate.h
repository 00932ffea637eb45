#pragma once

#include <vector>

#include "simcore/control/sensors.h"
#include "simcore/statics/static_model.h"

namespace simcore::control {

/// What the sensors say of pose and contacts: angles and loads of tactile wheels, smoothed.
class RoverEstimate {
  public:
    /// @param period  between updates [s]
    RoverEstimate(const mechanism::Mechanism& mechanism, double period);

    void reset();
    void update(const Sensors& sensors);

    /// Of the wheels that bear load; poses are the chassis' at the world's origin, heading along x.
    const std::vector<statics::Contact>& contacts() const { return contacts_; }

    statics::StaticModel& model() { return model_; }

    /// [N], one a wheel.
    const std::vector<double>& loads() const { return loads_; }

    /// Of all wheels, now [N].
    double meanLoad() const { return meanLoad_; }

    /// Whether a wheel bears load now: one that hangs is not to be driven by torque.
    bool bears(std::size_t wheel) const { return bears_[wheel]; }

  private:
    /// A rate of the tree that an encoder measures.
    struct Measured {
        std::size_t encoder = 0;
        std::size_t rate = 0;
        double sign = 1.0;
    };

    statics::StaticModel model_;
    dynamics::TreeState drawn_;
    std::vector<Measured> measured_;
    int chassisBall_ = -1;
    double smoothing_;
    bool started_ = false;
    std::vector<double> angles_;
    std::vector<double> loads_;
    std::vector<bool> bears_;
    double meanLoad_ = 0.0;
    std::vector<statics::Contact> contacts_;
};

}  // namespace simcore::control
