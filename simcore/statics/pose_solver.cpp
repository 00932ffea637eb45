#include "simcore/statics/pose_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "simcore/dynamics/engine.h"
#include "simcore/mobility/stance.h"

namespace simcore::statics {
namespace {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

constexpr int kMaxIterations = 300;
/// Of a roll, which begins next to where it ends.
constexpr int kMaxRollIterations = 60;
/// A pose is found when no wheel moves further in one more step [m].
constexpr double kStill = 1e-9;
/// What the contact finder tells apart where triangles meet: a pose may go on to change by this
/// [m].
constexpr double kResolved = 3e-6;
constexpr int kEnoughSteps = 10;
/// Nearer than this is touching [m].
constexpr double kTouching = 5e-6;
/// A fall in the time of a step moves the rover by this share of a wheel's radius. Steps that go
/// well make it ever longer.
constexpr double kFall = 0.25;
constexpr double kLongestStep = 0.25;  ///< of a wheel, in radii
/// Of the mean square of the frequencies: what the steps that go well leave of the metric.
constexpr double kLeastMetric = 1e-5;
/// A rover is lowered without the curvature of its energy, which only hanging parts need.
constexpr int kStraightSteps = 4;
/// The metric is renewed when a wheel has moved by this, in radii.
constexpr double kSameMetric = 0.1;
/// Deeper under the plane of the others than this there is a hole, in radii (assumed).
constexpr double kHole = 2.0;
constexpr double kWithoutWheels = 0.1;  ///< instead of a radius [m] (assumed)
constexpr double kUpright = 0.25;       ///< cosine of the chassis' tilt, beyond it has tipped over
/// Rows of what holds the rover: along its course, across it, its heading.
constexpr Eigen::Index kHeld = 3;
/// Share of the largest pivot below which a row depends on the others.
constexpr double kDependent = 1e-6;
constexpr double kPress = 0.3;  ///< in weights (assumed: less than what wheels carry)
/// Depths that differ by less are alike [m]: more than what counts as touching.
constexpr double kAlike = 2e-5;
constexpr double kSameFace = 0.999;  ///< cosine between normals of one face, or on one edge
/// Contacts of one wheel whose normals are this alike are one foothold (cosine of 20 deg).
constexpr double kOnePlace = 0.94;
/// Where the ground turns by less, it counts as one face (cosine): as far as footholds are told
/// apart.
const double kEdge = std::cos(20.0 * std::numbers::pi / 180.0);

double lowestOf(const terrain::Terrain& terrain) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3& vertex : terrain.mesh().vertices) {
        lowest = std::min(lowest, vertex.z());
    }
    return lowest;
}

Vec3 leftOf(double heading) {
    return {-std::sin(heading), std::cos(heading), 0.0};
}

}  // namespace

double leastRadius(const mechanism::Mechanism& mechanism) {
    double radius = std::numeric_limits<double>::infinity();
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        radius = std::min(radius, wheel.radius);
    }
    return radius;
}

std::string toString(Standing standing) {
    switch (standing) {
        case Standing::Stands:
            return "stands";
        case Standing::NoGround:
            return "no-ground";
        case Standing::Tips:
            return "tips";
        case Standing::LoopOpens:
            return "loop-opens";
        case Standing::NotConverged:
            break;
    }
    return "not-converged";
}

PoseSolver::PoseSolver(StaticModel& model, const terrain::Terrain& terrain, int slices)
    : model_(model),
      terrain_(terrain),
      lowest_(lowestOf(terrain)),
      reach_(0.5 *
             (model.mechanism().wheels.empty() ? kWithoutWheels : leastRadius(model.mechanism()))),
      wheels_(model.mechanism(), terrain, slices, reach_),
      bodies_(model.mechanism(), terrain, reach_) {}

/// How the chassis is turned when it is even with the ground under its wheels.
Eigen::Quaterniond PoseSolver::evenWith(const Place& place) const {
    Eigen::Quaterniond heading(Eigen::AngleAxisd(place.heading, Vec3::UnitZ()));
    const Vec3 at(place.x, place.y, 0.0);
    // Plane a + b x + c y through the heights under the wheels, in the directions of the heading.
    std::vector<Vec3> heights;
    for (const mechanism::Wheel& wheel : model_.mechanism().wheels) {
        const Vec3 under = at + heading * wheel.center;
        const double height = terrain_.heightAt(under.x(), under.y());
        if (std::isfinite(height)) {
            heights.emplace_back(wheel.center.x(), wheel.center.y(), height);
        }
    }
    if (heights.empty()) {
        return heading;
    }
    VectorXd plane;
    while (true) {
        MatrixXd rows(heights.size(), 3);
        VectorXd right(heights.size());
        for (std::size_t i = 0; i < heights.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            rows.row(row) << 1.0, heights[i].x(), heights[i].y();
            right[row] = heights[i].z();
        }
        plane = rows.completeOrthogonalDecomposition().solve(right);
        // A hole under a wheel has no say: the wheel will hang.
        Eigen::Index deepest = 0;
        const double depth = (rows * plane - right).maxCoeff(&deepest);
        if (heights.size() <= 3 || depth < kHole * 2.0 * reach_) {
            break;
        }
        heights.erase(heights.begin() + deepest);
    }
    const Vec3 normal = heading * Vec3(-plane[1], -plane[2], 1.0).normalized();
    return Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), normal) * heading;
}

/// As drawn, even with the ground, above all of it that its parts are over.
dynamics::TreeState PoseSolver::above(const Place& place) {
    const mechanism::Mechanism& mechanism = model_.mechanism();
    dynamics::TreeState state = model_.reset();
    const Eigen::Quaterniond turn = evenWith(place);
    Vec3 at(place.x, place.y, 0.0);
    double raise = -std::numeric_limits<double>::infinity();
    const auto keepAbove = [&](const Vec3& point, double radius) {
        const Vec3 where = at + turn * point;
        const Vec3 round(radius, radius, 0.0);
        const double highest = terrain_.highest(where - round, where + round);
        if (std::isfinite(highest)) {
            raise = std::max(raise, highest + radius - where.z());
        }
    };
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        keepAbove(wheel.center, wheel.radius);
    }
    for (const mechanism::Body& body : mechanism.bodies) {
        keepAbove(body.com, reach_);
    }
    at.z() = std::isfinite(raise) ? raise : 0.0;
    for (const dynamics::TreeBody& root : model_.tree().bodies()) {
        if (root.joint >= 0) {
            continue;
        }
        // Three slides, then a ball about the body's centre of mass.
        const Vec3 center = mechanism.bodies[static_cast<std::size_t>(root.body)].com;
        const Vec3 by = at + turn * center - center;
        for (std::size_t k = 0; k < 3; ++k) {
            state.coordinates[static_cast<std::size_t>(root.elements[k].rate)] =
                by[static_cast<Eigen::Index>(k)];
        }
        state.balls[static_cast<std::size_t>(root.elements[3].ball)] = turn;
    }
    return state;
}

StandingPose PoseSolver::settle(const Place& place) {
    Held held;
    held.place = place;
    return solve(above(place), held);
}

StandingPose PoseSolver::settleFrom(const dynamics::TreeState& state, const Place& place) {
    Held held;
    held.place = place;
    return solve(state, held);
}

StandingPose PoseSolver::roll(const StandingPose& from, double way, bool backwards) {
    Held held;
    held.what = Held::What::Way;
    held.way = way;
    const Pose& chassis = from.bodies[static_cast<std::size_t>(mechanism().chassis)];
    held.place = {chassis.position.x(), chassis.position.y(), yaw(chassis)};
    held.along = rollingAlong(from, backwards);
    if (held.along.empty()) {
        StandingPose hangs = from;
        hangs.standing = Standing::NoGround;
        return hangs;
    }
    held.course = courseFrom(from, held.along, backwards);
    StandingPose result = solve(from.state, held);
    result.course.resize(mechanism().wheels.size());
    for (std::size_t i = 0; i < result.course.size(); ++i) {
        const mechanism::Wheel& wheel = mechanism().wheels[i];
        const auto body = static_cast<std::size_t>(wheel.body);
        result.course[i] = result.bodies[body] * wheel.center - from.bodies[body] * wheel.center;
    }
    return result;
}

/// The directions in which the wheels' centres move on when they roll along these contacts, their
/// mean length 1.
std::vector<Vec3> PoseSolver::courseFrom(const StandingPose& from,
                                         const std::vector<Contact>& along, bool backwards) {
    const mechanism::Mechanism& mechanism = model_.mechanism();
    dynamics::TreeState state = from.state;
    model_.place(state);
    const std::vector<Pose>& poses = model_.poses();
    const Eigen::Index n = model_.motions();
    const auto rowOf = [&](const Contact& contact, const Vec3& direction) {
        return model_.workOf(mechanism.wheels[static_cast<std::size_t>(contact.wheel)].body,
                             direction, contact.point);
    };
    const auto centerRow = [&](std::size_t i, const Vec3& direction) {
        const mechanism::Wheel& wheel = mechanism.wheels[i];
        return model_.workOf(wheel.body, direction,
                             poses[static_cast<std::size_t>(wheel.body)] * wheel.center);
    };
    MatrixXd metric = inertia();
    // Contacts hold far more firmly than inertia; where they contradict each other, as best they
    // can.
    constexpr double kFirmly = 1e6;
    RowVectorXd on = RowVectorXd::Zero(n);
    for (const Contact& contact : along) {
        const RowVectorXd row = rowOf(contact, contact.normal);
        metric += kFirmly * mechanism.mass() * row.transpose() * row;
        const auto i = static_cast<std::size_t>(contact.wheel);
        on += centerRow(i, (backwards ? -1.0 : 1.0) * contact.forward);
    }
    const double moved =
        from.course.empty()
            ? 0.0
            : std::accumulate(from.course.begin(), from.course.end(), 0.0,
                              [](double sum, const Vec3& v) { return sum + v.norm(); });
    if (moved > kStill) {
        on.setZero();
        for (std::size_t i = 0; i < from.course.size(); ++i) {
            on += centerRow(i, from.course[i] / moved);
        }
    }
    const Pose& chassis = poses[static_cast<std::size_t>(mechanism.chassis)];
    MatrixXd rows(3, n);
    rows.row(0) = on;
    rows.row(1) = model_.workOf(mechanism.chassis, leftOf(yaw(chassis)), chassis.position);
    rows.row(2) = headingRow(chassis);
    const VectorXd motion = minimise({metric, VectorXd::Zero(n), rows, VectorXd::Unit(3, 0), 3}).x;
    // What a wheel leaves opens; so a wheel at a wall goes up it, even if that moves the rover
    // back.
    double opening = 0.0;
    for (const Foothold& foothold : from.footholds) {
        const Contact& contact = foothold.contact;
        const bool kept = std::any_of(along.begin(), along.end(), [&](const Contact& of) {
            return of.wheel == contact.wheel && of.point == contact.point;
        });
        opening += kept ? 0.0 : rowOf(contact, contact.normal).dot(motion);
    }
    std::vector<Vec3> course;
    double length = 0.0;
    for (std::size_t i = 0; i < mechanism.wheels.size(); ++i) {
        Vec3 direction;
        for (int k = 0; k < 3; ++k) {
            direction[k] = centerRow(i, Vec3::Unit(k)).dot(motion);
        }
        length += direction.norm() / static_cast<double>(mechanism.wheels.size());
        course.push_back(direction);
    }
    for (Vec3& direction : course) {
        direction *= (opening < 0.0 ? -1.0 : 1.0) / length;
    }
    return course;
}

std::vector<Contact> rollingAlong(const StandingPose& pose, bool backwards) {
    std::vector<Contact> contacts;
    for (std::size_t i = 0; i < pose.footholds.size(); ++i) {
        const int wheel = pose.footholds[i].contact.wheel;
        const bool first = i == 0 || pose.footholds[i - 1].contact.wheel != wheel;
        const bool last =
            i + 1 == pose.footholds.size() || pose.footholds[i + 1].contact.wheel != wheel;
        if (backwards ? first : last) {
            contacts.push_back(pose.footholds[i].contact);
        }
    }
    return contacts;
}

/// Of the motions, with a little more for those that nothing heavy takes part in.
MatrixXd PoseSolver::inertia() {
    MatrixXd inertia = model_.inertia();
    inertia.diagonal().array() += 1e-9 * inertia.diagonal().maxCoeff();
    return inertia;
}

/// How the heading turns with the chassis.
RowVectorXd PoseSolver::headingRow(const Pose& chassis) const {
    const Vec3 forward = chassis.rotation * Vec3::UnitX();
    const double level = forward.head<2>().squaredNorm();
    return model_.workOfMoment(model_.mechanism().chassis,
                               (Vec3::UnitZ() - forward.z() * forward) / level);
}

/// The program of one step at the pose placed last.
void PoseSolver::assemble(const Held& held) {
    const mechanism::Mechanism& mechanism = model_.mechanism();
    const std::vector<Pose>& poses = model_.poses();
    contacts_ = wheels_.find(poses);
    const std::vector<contact::Contact>& ofBodies = bodies_.find(poses);
    contacts_.insert(contacts_.end(), ofBodies.begin(), ofBodies.end());
    stops_.clear();
    for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
        if (mechanism.joints[j].stops) {
            stops_.emplace_back(static_cast<int>(j), 1.0);
            stops_.emplace_back(static_cast<int>(j), -1.0);
        }
    }
    const Eigen::Index n = model_.motions();
    const auto rows = kHeld + static_cast<Eigen::Index>(contacts_.size() + stops_.size());
    program_.right = model_.loads(dynamics::kGravity);
    program_.rows.resize(rows, n);
    program_.bounds.resize(rows);
    program_.equations = kHeld;

    const int c = mechanism.chassis;
    const Pose& chassis = poses[static_cast<std::size_t>(c)];
    const Vec3 ahead(std::cos(held.place.heading), std::sin(held.place.heading), 0.0);
    const Vec3 left = leftOf(held.place.heading);
    const Vec3 away = Vec3(held.place.x, held.place.y, 0.0) - chassis.position;
    if (held.what == Held::What::Position) {
        program_.rows.row(0) = model_.workOf(c, ahead, chassis.position);
        program_.bounds[0] = ahead.dot(away);
    } else {
        RowVectorXd way = RowVectorXd::Zero(n);
        double square = 0.0;
        for (std::size_t i = 0; i < held.course.size(); ++i) {
            const mechanism::Wheel& wheel = mechanism.wheels[i];
            way += model_.workOf(wheel.body, held.course[i],
                                 poses[static_cast<std::size_t>(wheel.body)] * wheel.center);
            square += held.course[i].squaredNorm();
        }
        program_.rows.row(0) = way / square;
        program_.bounds[0] = held.way;
    }
    program_.rows.row(1) = model_.workOf(c, left, chassis.position);
    program_.bounds[1] = left.dot(away);
    program_.rows.row(2) = headingRow(chassis);
    program_.bounds[2] = std::remainder(held.place.heading - yaw(chassis), 2.0 * std::numbers::pi);

    Eigen::Index row = kHeld;
    for (const contact::Contact& contact : contacts_) {
        program_.rows.row(row) =
            model_.workOf(contact::bodyOf(contact, mechanism), contact.normal, contact.point);
        program_.bounds[row++] = contact.depth;
    }
    for (const auto& [joint, sign] : stops_) {
        const mechanism::Joint& at = mechanism.joints[static_cast<std::size_t>(joint)];
        const double angle = mechanism::jointAngle(at, poses);
        program_.rows.row(row) = sign * model_.workAboutJoint(at);
        program_.bounds[row++] = sign > 0.0 ? at.stops->first - angle : angle - at.stops->second;
    }
    if (held.what == Held::What::Way) {
        keepRolling(held.along);
    }
}

/// Wheels that roll stay on the ground: what each rolls along becomes an equation. Which wheel
/// could not be held there is for the forces to say. Where the wheels are more than the joints can
/// set down, as four on a rigid frame, they are pressed on the ground instead.
void PoseSolver::keepRolling(const std::vector<Contact>& along) {
    std::vector<Eigen::Index> kept;
    for (const Contact& of : along) {
        // The nearest place of the wheel; of those that it touches alike, the one it rolls along.
        Eigen::Index row = -1;
        double best = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            const bool same = contacts_[i].normal.dot(of.normal) > kSameFace;
            const double score = contacts_[i].depth + (same ? kAlike : 0.0);
            if (contacts_[i].wheel == of.wheel && score > best) {
                row = kHeld + static_cast<Eigen::Index>(i);
                best = score;
            }
        }
        if (row >= 0) {
            kept.push_back(row);
        }
    }
    const auto count = static_cast<Eigen::Index>(kept.size());
    MatrixXd rows(kHeld + count, program_.rows.cols());
    VectorXd bounds(kHeld + count);
    rows.topRows(kHeld) = program_.rows.topRows(kHeld);
    bounds.head(kHeld) = program_.bounds.head(kHeld);
    for (Eigen::Index i = 0; i < count; ++i) {
        rows.row(kHeld + i) = program_.rows.row(kept[static_cast<std::size_t>(i)]);
        bounds[kHeld + i] = program_.bounds[kept[static_cast<std::size_t>(i)]];
    }
    Eigen::ColPivHouseholderQR<MatrixXd> qr(rows.transpose());
    qr.setThreshold(kDependent);
    if (qr.rank() < rows.rows()) {
        const double force = kPress * model_.mechanism().mass() * dynamics::kGravity;
        program_.right -= force * rows.bottomRows(count).colwise().sum().transpose();
        return;
    }
    MatrixXd all(program_.rows.rows() + count, program_.rows.cols());
    all << rows, program_.rows.bottomRows(program_.rows.rows() - kHeld);
    VectorXd allBounds(all.rows());
    allBounds << bounds, program_.bounds.tail(program_.bounds.size() - kHeld);
    program_.rows = std::move(all);
    program_.bounds = std::move(allBounds);
    program_.equations = static_cast<int>(kHeld + count);
}

/// The curvature of the energy by differences of the loads, at the pose of `state`.
void PoseSolver::bend(const dynamics::TreeState& state) {
    const Eigen::Index n = model_.motions();
    constexpr double kSmall = 1e-5;
    bent_.resize(n, n);
    std::vector<dynamics::TreeState> moved;
    for (Eigen::Index k = 0; k < n; ++k) {
        for (const double sign : {1.0, -1.0}) {
            moved.push_back(state);
            model_.move(moved.back(), sign * kSmall * VectorXd::Unit(n, k));
        }
    }
    for (Eigen::Index k = 0; k < n; ++k) {
        VectorXd loads[2];
        for (std::size_t side : {0U, 1U}) {
            model_.place(moved[2 * static_cast<std::size_t>(k) + side]);
            loads[side] = model_.loads(dynamics::kGravity);
        }
        bent_.col(k) = (loads[1] - loads[0]) / (2.0 * kSmall);
    }
    bent_ = (0.5 * (bent_ + bent_.transpose())).eval();
    dynamics::TreeState back = state;
    model_.place(back);
}

/// The curvature with all that is concave taken as convex.
MatrixXd PoseSolver::convexPart() const {
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(bent_, metric_);
    const MatrixXd shapes = metric_ * modes.eigenvectors();
    return shapes * modes.eigenvalues().cwiseAbs().asDiagonal() * shapes.transpose();
}

StandingPose PoseSolver::solve(dynamics::TreeState state, Held held) {
    const mechanism::Mechanism& mechanism = model_.mechanism();
    const double radius = 2.0 * reach_;
    StandingPose result;
    double stiffness = dynamics::kGravity / (kFall * radius);  // [1/s^2]
    const double start = stiffness;
    const double least = kLeastMetric * stiffness;
    double lastMove = std::numeric_limits<double>::infinity();
    double promised = 0.0;  // that the energy falls by in the last step [J]
    double lastPotential = 0.0;
    double movedSince = 0.0;  // that the metric was renewed
    int metricChoice = -1;
    VectorXd guess;
    const int most = held.what == Held::What::Way ? kMaxRollIterations : kMaxIterations;
    for (int iteration = 0; iteration < most; ++iteration) {
        result.iterations = iteration + 1;
        if (!model_.place(state)) {
            result.standing = Standing::LoopOpens;
            break;
        }
        const Pose& chassis = model_.poses()[static_cast<std::size_t>(mechanism.chassis)];
        if ((chassis.rotation * Vec3::UnitZ()).z() < kUpright) {
            result.standing = Standing::Tips;
            break;
        }
        assemble(held);
        if (contacts_.empty() && chassis.position.z() < lowest_ - 1.0) {
            result.standing = Standing::NoGround;
            break;
        }
        if (model_.choice() != metricChoice || movedSince > kSameMetric * radius) {
            metric_ = inertia();
            metricChoice = model_.choice();
            movedSince = 0.0;
        }
        program_.hessian = stiffness * metric_;
        if (iteration >= kStraightSteps) {
            bend(state);
            program_.hessian += bent_;
            if (Eigen::LLT<MatrixXd>(program_.hessian).info() != Eigen::Success) {
                program_.hessian = stiffness * metric_ + convexPart();
            }
        }
        Optimum optimum = minimise(program_, guess);
        VectorXd& amounts = optimum.x;
        guess = std::move(optimum.multipliers);
        double move = 0.0;
        for (const mechanism::Wheel& wheel : mechanism.wheels) {
            const Vec3 center = model_.poses()[static_cast<std::size_t>(wheel.body)] * wheel.center;
            const Vec3 by = model_.velocityOf(wheel.body, center, amounts);
            move = std::max(move, by.cwiseAbs().maxCoeff());
        }
        // What is on its way down goes on, however long the way.
        const double potential = model_.potential(dynamics::kGravity);
        const bool falls = held.what == Held::What::Position && promised > 0.0 &&
                           lastPotential - potential > 0.5 * promised;
        lastPotential = potential;
        const double longest = kLongestStep * radius;
        const double share = move > longest ? longest / move : 1.0;
        amounts *= share;
        promised = program_.right.dot(amounts);
        if (held.what == Held::What::Way) {
            held.way -= program_.rows.row(0).dot(amounts);
        }
        if (share == 1.0 && stiffness <= start &&
            move < (iteration < kEnoughSteps ? kStill : kResolved)) {
            result.standing = Standing::Stands;
            break;
        }
        if (move < 0.5 * lastMove || move < kResolved) {
            // Wheels that are pressed would sink into ground that is held less firmly than they.
            if (held.what == Held::What::Position || iteration >= kStraightSteps) {
                stiffness = std::max(least, 0.2 * stiffness);
            }
        } else if (falls) {
            stiffness = share < 1.0 ? stiffness : std::max(least, 0.5 * stiffness);
        } else if (move > lastMove) {
            stiffness *= 2.0;
        }
        lastMove = move;
        movedSince += share * move;
        model_.move(state, amounts);
    }
    result.state = std::move(state);
    describe(result);
    return result;
}

/// What touches at the pose placed last.
void PoseSolver::describe(StandingPose& result) const {
    const mechanism::Mechanism& mechanism = model_.mechanism();
    result.bodies = model_.poses();
    result.clearance = reach_;
    result.potential = model_.potential(dynamics::kGravity);
    std::vector<int> merged;  // contacts in each foothold
    for (const contact::Contact& contact : contacts_) {
        if (contact.wheel < 0) {
            result.clearance = std::min(result.clearance, -contact.depth);
            if (contact.depth > -kTouching &&
                std::find(result.bodiesTouching.begin(), result.bodiesTouching.end(),
                          contact.body) == result.bodiesTouching.end()) {
                result.bodiesTouching.push_back(contact.body);
            }
            continue;
        }
        if (contact.depth < -kTouching || contact.slice == contact::kSide) {
            continue;
        }
        const bool onEdge = contact.turnCosine < kEdge;
        const auto same = std::find_if(
            result.footholds.begin(), result.footholds.end(), [&](const Foothold& there) {
                return there.contact.wheel == contact.wheel &&
                       there.contact.normal.dot(contact.normal) > kOnePlace;
            });
        if (same == result.footholds.end()) {
            result.footholds.push_back(
                {{contact.wheel, contact.point, contact.normal, contact.forward}, 0.0, onEdge});
            merged.push_back(1);
        } else {
            same->onEdge = same->onEdge && onEdge;
            const double n = ++merged[static_cast<std::size_t>(same - result.footholds.begin())];
            same->contact.point += (contact.point - same->contact.point) / n;
            same->contact.normal =
                (same->contact.normal + (contact.normal - same->contact.normal) / n).normalized();
        }
    }
    for (Foothold& foothold : result.footholds) {
        const mechanism::Wheel& wheel =
            mechanism.wheels[static_cast<std::size_t>(foothold.contact.wheel)];
        const Pose& X_WB = result.bodies[static_cast<std::size_t>(wheel.body)];
        foothold.contact.forward = mobility::rollingDirection(wheel, X_WB, foothold.contact.normal);
        foothold.angle =
            mobility::contactAngle(foothold.contact.normal, X_WB.rotation * wheel.axis);
    }
    std::sort(result.footholds.begin(), result.footholds.end(),
              [](const Foothold& a, const Foothold& b) {
                  return std::pair(a.contact.wheel, a.angle) < std::pair(b.contact.wheel, b.angle);
              });
    Eigen::Index row = program_.bounds.size() - static_cast<Eigen::Index>(stops_.size());
    for (const auto& [joint, sign] : stops_) {
        if (program_.bounds[row++] > -1e-7) {
            result.jointsAtStop.push_back(joint);
        }
    }
}

}  // namespace simcore::statics
