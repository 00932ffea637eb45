#include "simcore/statics/pose_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "simcore/dynamics/engine.h"
#include "simcore/mobility/stance.h"

namespace simcore::statics {
namespace {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

constexpr int kMaxIterations = 300;
/// A pose is found when no wheel moves further in one more step [m].
constexpr double kStill = 1e-10;
/// What the contact finder tells apart where triangles meet: a pose may go on to change by this [m].
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
constexpr double kUpright = 0.25;  ///< cosine of the chassis' tilt, beyond it has tipped over
/// Contacts of one wheel whose normals are this alike are one foothold (cosine of 20 deg).
constexpr double kOnePlace = 0.94;

double smallestRadius(const mechanism::Mechanism& mechanism) {
    double radius = std::numeric_limits<double>::infinity();
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        radius = std::min(radius, wheel.radius);
    }
    return mechanism.wheels.empty() ? 0.1 : radius;
}

double headingOf(const Pose& chassis) {
    const Vec3 forward = chassis.rotation * Vec3::UnitX();
    return std::atan2(forward.y(), forward.x());
}

}  // namespace

double contactAngle(const Vec3& normal, const Vec3& axis) {
    const Vec3 forward = axis.cross(Vec3::UnitZ()).normalized();
    const Vec3 up = forward.cross(axis);
    return std::atan2(-normal.dot(forward), normal.dot(up));
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
      reach_(0.5 * smallestRadius(model.mechanism())),
      wheels_(model.mechanism(), terrain, slices, reach_),
      bodies_(model.mechanism(), terrain, reach_) {}

/// How the chassis is turned when it is even with the ground under its wheels.
Eigen::Quaterniond PoseSolver::evenWith(const Place& place) const {
    const Eigen::Quaterniond heading(Eigen::AngleAxisd(place.heading, Vec3::UnitZ()));
    const Vec3 at(place.x, place.y, 0.0);
    // Plane a + b x + c y through the heights under the wheels, in the directions of the heading.
    MatrixXd rows(0, 3);
    VectorXd heights(0);
    for (const mechanism::Wheel& wheel : model_.mechanism().wheels) {
        const Vec3 under = at + heading * wheel.center;
        const double height = terrain_.heightAt(under.x(), under.y());
        if (std::isfinite(height)) {
            rows.conservativeResize(rows.rows() + 1, 3);
            rows.row(rows.rows() - 1) << 1.0, wheel.center.x(), wheel.center.y();
            heights.conservativeResize(rows.rows());
            heights[rows.rows() - 1] = height;
        }
    }
    if (rows.rows() == 0) {
        return heading;
    }
    const VectorXd plane = rows.completeOrthogonalDecomposition().solve(heights);
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

StandingPose PoseSolver::roll(const StandingPose& from, double way) {
    Held held;
    held.what = Held::What::Way;
    held.way = way;
    const Pose& chassis = from.bodies[static_cast<std::size_t>(mechanism().chassis)];
    held.place = {chassis.position.x(), chassis.position.y(), headingOf(chassis)};
    for (std::size_t i = 0; i < from.footholds.size(); ++i) {
        const Contact& contact = from.footholds[i].contact;
        const bool first = i == 0 || from.footholds[i - 1].contact.wheel != contact.wheel;
        const bool last = i + 1 == from.footholds.size() ||
                          from.footholds[i + 1].contact.wheel != contact.wheel;
        if (way >= 0.0 ? last : first) {
            held.along.push_back(contact);
        }
    }
    if (held.along.empty()) {
        StandingPose hangs = from;
        hangs.standing = Standing::NoGround;
        return hangs;
    }
    return solve(from.state, held);
}

/// The program of one step at the pose placed last; its metric comes last.
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
    const auto rows = static_cast<Eigen::Index>(3 + contacts_.size() + stops_.size());
    program_.right = model_.loads(dynamics::kGravity);
    program_.rows.resize(rows, n);
    program_.bounds.resize(rows);
    program_.equations = 3;

    const int c = mechanism.chassis;
    const Pose& chassis = poses[static_cast<std::size_t>(c)];
    const Vec3 forward = chassis.rotation * Vec3::UnitX();
    const Vec3 ahead(std::cos(held.place.heading), std::sin(held.place.heading), 0.0);
    const Vec3 left = Vec3::UnitZ().cross(ahead);
    const Vec3 away = Vec3(held.place.x, held.place.y, 0.0) - chassis.position;
    if (held.what == Held::What::Position) {
        program_.rows.row(0) = model_.workOf(c, ahead, chassis.position);
        program_.bounds[0] = ahead.dot(away);
    } else {
        RowVectorXd way = RowVectorXd::Zero(n);
        for (const Contact& along : held.along) {
            const mechanism::Wheel& wheel =
                mechanism.wheels[static_cast<std::size_t>(along.wheel)];
            way += model_.workOf(wheel.body, along.forward,
                                 poses[static_cast<std::size_t>(wheel.body)] * wheel.center);
        }
        program_.rows.row(0) = way / static_cast<double>(held.along.size());
        program_.bounds[0] = held.way;
    }
    program_.rows.row(1) = model_.workOf(c, left, chassis.position);
    program_.bounds[1] = left.dot(away);
    // How the forward axis, seen from above, turns with the chassis.
    const double level = forward.head<2>().squaredNorm();
    program_.rows.row(2) =
        model_.workOfMoment(c, (Vec3::UnitZ() - forward.z() * forward) / level);
    program_.bounds[2] = std::remainder(held.place.heading - headingOf(chassis), 2.0 * M_PI);

    Eigen::Index row = 3;
    for (const contact::Contact& contact : contacts_) {
        program_.rows.row(row) =
            model_.workOf(contact::bodyOf(contact, mechanism), contact.normal, contact.point);
        program_.bounds[row++] = contact.depth;
    }
    if (held.what == Held::What::Way) {
        press(held.along);
    }
    for (const auto& [joint, sign] : stops_) {
        const mechanism::Joint& at = mechanism.joints[static_cast<std::size_t>(joint)];
        const double angle = mechanism::jointAngle(at, poses);
        program_.rows.row(row) = sign * model_.workAboutJoint(at);
        program_.bounds[row++] = sign > 0.0 ? at.stops->first - angle : angle - at.stops->second;
    }
    metric_ = model_.inertia();
    metric_.diagonal().array() += 1e-9 * metric_.diagonal().maxCoeff();
}

/// Wheels that roll stay on the ground: each is pressed against what it rolls along. Which wheel
/// could not be held there is for the forces to say.
void PoseSolver::press(const std::vector<Contact>& along) {
    constexpr double kPress = 3.0;  // weights
    const double force = kPress * model_.mechanism().mass() * dynamics::kGravity;
    for (const Contact& of : along) {
        std::vector<Eigen::Index> rows;
        double likest = 0.0;
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            const double like = contacts_[i].normal.dot(of.normal);
            if (contacts_[i].wheel != of.wheel || like < likest - 1e-3) {
                continue;
            }
            if (like > likest + 1e-3) {
                rows.clear();
                likest = like;
            }
            rows.push_back(3 + static_cast<Eigen::Index>(i));
        }
        for (const Eigen::Index row : rows) {
            program_.right -=
                force / static_cast<double>(rows.size()) * program_.rows.row(row).transpose();
        }
    }
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
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3& vertex : terrain_.mesh().vertices) {
        lowest = std::min(lowest, vertex.z());
    }
    StandingPose result;
    double stiffness = dynamics::kGravity / (kFall * radius);  // [1/s^2]
    const double start = stiffness;
    const double least = kLeastMetric * stiffness;
    double lastMove = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
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
        if (contacts_.empty() && chassis.position.z() < lowest - 1.0) {
            result.standing = Standing::NoGround;
            break;
        }
        program_.hessian = stiffness * metric_;
        if (iteration >= kStraightSteps) {
            bend(state);
            program_.hessian += bent_;
            if (Eigen::LLT<MatrixXd>(program_.hessian).info() != Eigen::Success) {
                program_.hessian = stiffness * metric_ + convexPart();
            }
        }
        VectorXd amounts = minimise(program_).x;
        double move = 0.0;
        for (const mechanism::Wheel& wheel : mechanism.wheels) {
            const Vec3 center = model_.poses()[static_cast<std::size_t>(wheel.body)] * wheel.center;
            for (int k = 0; k < 3; ++k) {
                move = std::max(
                    move, std::abs(model_.workOf(wheel.body, Vec3::Unit(k), center).dot(amounts)));
            }
        }
        const double longest = kLongestStep * radius;
        const double share = move > longest ? longest / move : 1.0;
        amounts *= share;
        if (held.what == Held::What::Way) {
            held.way -= program_.rows.row(0).dot(amounts);
        }
        if (share == 1.0 && stiffness <= start && move < (iteration < kEnoughSteps ? kStill : kResolved)) {
            result.standing = Standing::Stands;
            break;
        }
        if (move < 0.5 * lastMove || move < kResolved) {
            // Wheels that are pressed would sink into ground that is held less firmly than they.
            if (held.what == Held::What::Position || iteration >= kStraightSteps) {
                stiffness = std::max(least, 0.2 * stiffness);
            }
        } else if (move > lastMove) {
            stiffness *= 2.0;
        }
        lastMove = move;
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
    std::map<std::pair<int, int>, int> counts;
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
        const mechanism::Wheel& wheel = mechanism.wheels[static_cast<std::size_t>(contact.wheel)];
        const Pose& X_WB = result.bodies[static_cast<std::size_t>(wheel.body)];
        const auto same = std::find_if(
            result.footholds.begin(), result.footholds.end(), [&](const Foothold& there) {
                return there.contact.wheel == contact.wheel &&
                       there.contact.normal.dot(contact.normal) > kOnePlace;
            });
        if (same == result.footholds.end()) {
            result.footholds.push_back({{contact.wheel, contact.point, contact.normal,
                                         contact.forward},
                                        0.0});
            counts[{contact.wheel, static_cast<int>(result.footholds.size())}] = 1;
        } else {
            const int index = static_cast<int>(same - result.footholds.begin()) + 1;
            const double n = ++counts[{contact.wheel, index}];
            same->contact.point += (contact.point - same->contact.point) / n;
            same->contact.normal =
                (same->contact.normal + (contact.normal - same->contact.normal) / n).normalized();
        }
        (void)X_WB;
    }
    for (Foothold& foothold : result.footholds) {
        const mechanism::Wheel& wheel =
            mechanism.wheels[static_cast<std::size_t>(foothold.contact.wheel)];
        const Pose& X_WB = result.bodies[static_cast<std::size_t>(wheel.body)];
        foothold.contact.forward =
            mobility::rollingDirection(wheel, X_WB, foothold.contact.normal);
        foothold.angle = contactAngle(foothold.contact.normal, X_WB.rotation * wheel.axis);
    }
    std::sort(result.footholds.begin(), result.footholds.end(),
              [](const Foothold& a, const Foothold& b) {
                  return std::pair(a.contact.wheel, a.angle) < std::pair(b.contact.wheel, b.angle);
              });
    Eigen::Index row = 3 + static_cast<Eigen::Index>(contacts_.size());
    for (const auto& [joint, sign] : stops_) {
        if (program_.bounds[row++] > -1e-7) {
            result.jointsAtStop.push_back(joint);
        }
    }
}

}  // namespace simcore::statics
