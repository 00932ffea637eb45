#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "simcore/contact/wheel_contact.h"
#include "simcore/run/simulation.h"
#include "tests/bench/peers/mjcf.h"

namespace peers {

/// What a peer did in its last step, in our terms.
struct Reading {
    std::vector<simcore::Pose> poses;  ///< X_WB after the step, mechanism order
    /// Where the wheels touched at the start of the step, and the ground's force on the wheel [N].
    std::vector<simcore::contact::Contact> contacts;
    std::vector<Vec3> forces;
};

/// Another engine with the rover on its ground, at the drawn pose and at rest.
class Peer {
  public:
    virtual ~Peer() = default;

    virtual std::string name() const = 0;

    /// Advances by one step with every wheel's servo at its speed [rad/s]: all that is timed.
    virtual void step(std::span<const double> wheelSpeeds) = 0;

    virtual void read(Reading& reading) = 0;

    /// Whether the engine itself says that the motion is broken.
    virtual bool failed() const = 0;
};

/// All that a peer is made of. Outlives the peer.
struct PeerWorld {
    const simcore::run::ResolvedRun& run;
    PeerTree tree;
    HeightGrid ground;
    WheelShape wheel = WheelShape::Ellipsoid;
};

/// A fresh peer at the start of the run. Throws std::runtime_error when the engine refuses the
/// model.
using PeerMaker = std::function<std::unique_ptr<Peer>(const PeerWorld&)>;

/// Empty functions where the program was built without the engine.
PeerMaker mujocoMaker();
PeerMaker bulletMaker();

}  // namespace peers
