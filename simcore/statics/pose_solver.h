#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "simcore/contact/body_contacts.h"
#include "simcore/contact/wheel_contact.h"
#include "simcore/statics/quadratic_program.h"
#include "simcore/statics/static_model.h"
#include "simcore/terrain/terrain.h"

namespace simcore::statics {

/// Where a rover is put: its chassis' origin, seen from above.
struct Place {
    double x = 0.0, y = 0.0;  ///< world [m]
    double heading = 0.0;     ///< of the chassis' forward axis, + left [rad]
};

/// What became of a rover that was put down.
enum class Standing {
    Stands,
    NoGround,      ///< there is none under it, or it falls past it
    Tips,          ///< it turns over
    LoopOpens,     ///< its joints cannot follow
    NotConverged,  ///< it comes to no rest
};

/// A wheel's place on the ground.
struct Foothold {
    Contact contact;
    /// In the wheel's plane, from up to the normal, positive: what it touches is ahead [rad].
    double angle = 0.0;
    /// It is on an edge of the ground, about which the wheel turns, and on no face. Ground that
    /// turns by less than 20 deg, as finely cut ground does everywhere, counts as one face.
    bool onEdge = false;
};

/// A rover that stands on a terrain.
struct StandingPose {
    Standing standing = Standing::NotConverged;
    dynamics::TreeState state;
    std::vector<Pose> bodies;         ///< X_WB
    std::vector<Foothold> footholds;  ///< by wheel, then from behind to ahead; a wheel at floor
                                      ///< and wall has two, one that hangs none
    std::vector<int> bodiesTouching;  ///< that are no wheels
    std::vector<int> jointsAtStop;
    double potential = 0.0;    ///< of weight and springs [J]
    double clearance = 0.0;    ///< least distance of a body that is no wheel from the ground [m]
    std::vector<Vec3> course;  ///< by which each wheel's centre came here when it rolled [m]
    int iterations = 0;
};

/// Of every wheel that touches the foremost foothold (the rearmost when it rolls backwards), which
/// it rolls along. Where a wheel stands against something and on the floor, the floor lets go.
std::vector<Contact> rollingAlong(const StandingPose& pose, bool backwards = false);

/// Finds how a rover stands: the least energy of weight and springs among all poses in which
/// nothing is under ground and no joint beyond its stops. Wheels slide without friction meanwhile,
/// and the chassis is held where it was put. Where every wheel touches, geometry alone decides;
/// energy decides where one hangs.
///
/// Newton's iteration: one quadratic program a step, with the ground as it is met there.
class PoseSolver {
  public:
    /// @param slices  discs a wheel, as a run has
    PoseSolver(StaticModel& model, const terrain::Terrain& terrain, int slices = 2);

    /// Lowers the rover onto the ground from above, its joints as drawn at first.
    StandingPose settle(const Place& place);

    /// From a state near the place.
    StandingPose settleFrom(const dynamics::TreeState& state, const Place& place);

    /// Rolls on from a pose that stands: heading and course are held, the wheels' centres move by
    /// `way` on average [m], each wheel along the foremost place that it touches (the rearmost when
    /// it rolls backwards). So a wheel climbs a wall while the chassis hardly moves. Goes on in the
    /// sense in which it came: by arc length, not by the chassis.
    StandingPose roll(const StandingPose& from, double way, bool backwards = false);

    const mechanism::Mechanism& mechanism() const { return model_.mechanism(); }

    StaticModel& model() { return model_; }

  private:
    /// What is held while the rest comes to rest: rows . change = amounts left.
    struct Held {
        enum class What { Position, Way } what = What::Position;
        Place place;
        double way = 0.0;  ///< left to go
        std::vector<Contact> along;
        std::vector<Vec3> course;  ///< of the wheels' centres, mean length 1
    };

    StandingPose solve(dynamics::TreeState state, Held held);
    void assemble(const Held& held);
    std::vector<Vec3> courseFrom(const StandingPose& from, const std::vector<Contact>& along,
                                 bool backwards);
    Eigen::MatrixXd inertia();
    Eigen::RowVectorXd headingRow(const Pose& chassis) const;
    void keepRolling(const std::vector<Contact>& along);
    void bend(const dynamics::TreeState& state);
    Eigen::MatrixXd convexPart() const;
    void describe(StandingPose& result) const;
    Eigen::Quaterniond evenWith(const Place& place) const;
    dynamics::TreeState above(const Place& place);

    StaticModel& model_;
    const terrain::Terrain& terrain_;
    double lowest_;  ///< of the ground [m]
    double reach_;   ///< how far ahead the ground is looked at [m]
    contact::WheelContactFinder wheels_;
    contact::BodyContactFinder bodies_;
    std::vector<contact::Contact> contacts_;     ///< rows after the held ones
    std::vector<std::pair<int, double>> stops_;  ///< joint and sign, rows after the contacts
    QuadraticProgram program_;
    Eigen::MatrixXd metric_;
    Eigen::MatrixXd bent_;  ///< curvature of the energy
};

/// Of the wheels [m]; infinite without any.
double leastRadius(const mechanism::Mechanism& mechanism);

std::string toString(Standing standing);

}  // namespace simcore::statics
