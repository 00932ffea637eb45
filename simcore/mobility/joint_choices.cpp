#include "simcore/mobility/joint_choices.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <Eigen/QR>

#include "simcore/base/text.h"
#include "simcore/mobility/constraint_jacobian.h"
#include "simcore/mobility/factorisation.h"
#include "simcore/project/element_names.h"

namespace simcore::mobility {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using mechanism::directionsOf;
using mechanism::Freedom;
using mechanism::FreedomKind;
using mechanism::orthogonalComplement;
using project::Side;
using project::Sides;

constexpr double kSameDirection = 1e-6;  // sine of the angle
// A reaction that small in all self-stress states is none: letting it go makes something move.
constexpr double kNoReaction = 1e-6;
// A body with more joints than this is no link: lines between its joints mean nothing.
constexpr int kJointsOfLink = 3;

/// A joint as it could be; directions as drawn, that is of the left copy of a mirrored joint.
struct Target {
    JointType type;
    std::vector<project::FreedomText> texts;
    std::vector<Freedom> freedoms;
    std::string name;
};

/// A joint of the project with what it is in the mechanism.
struct Place {
    const project::Joint* joint;
    std::vector<int> copies;  ///< mechanism joints; the first is as drawn
};

std::size_t asSize(int index) {
    return static_cast<std::size_t>(index);
}

std::vector<Side> sidesOf(bool mirror) {
    return mirror ? std::vector<Side>{Side::Left, Side::Right} : std::vector<Side>{Side::Center};
}

Place placeOf(const project::Joint& joint, const mechanism::Mechanism& mechanism) {
    Place place{&joint, {}};
    for (const Side side : sidesOf(joint.mirror)) {
        const int index = mechanism.findJoint(project::nameOnSide(joint.name, side));
        if (index >= 0) {  // else welded
            place.copies.push_back(index);
        }
    }
    return place;
}

/// Which copies may be changed, apart from others.
std::vector<Sides> waysToTakeSides(bool mirror, bool oneSided) {
    return mirror && oneSided ? std::vector<Sides>{Sides::Both, Sides::Left, Sides::Right}
                              : std::vector<Sides>{Sides::Both};
}

/// Those of a list that has the left copy and then the right one, or a single one.
template <class T>
std::vector<T> copiesOn(Sides sides, const std::vector<T>& copies) {
    if (sides == Sides::Both || copies.size() < 2) {
        return copies;
    }
    return {sides == Sides::Left ? copies.front() : copies.back()};
}

bool same(const Vec3& a, const Vec3& b) {
    return a.cross(b).norm() < kSameDirection;
}

/// "slide z", "turn 0.6 0 0.8"
project::FreedomText textOf(const Freedom& freedom) {
    const std::string kind = freedom.kind == FreedomKind::Turn ? "turn" : "slide";
    for (int k = 0; k < 3; ++k) {
        if (same(freedom.direction, Vec3::Unit(k))) {
            return fmt::format("{} {}", kind, "xyz"[k]);
        }
    }
    Index largest = 0;
    freedom.direction.cwiseAbs().maxCoeff(&largest);
    const double sign = freedom.direction[largest] < 0.0 ? -1.0 : 1.0;
    const auto number = [&](int k) {
        const double x = sign * freedom.direction[k];
        return std::abs(x) < 1e-6 ? 0.0 : x;
    };
    return fmt::format("{} {:.7g} {:.7g} {:.7g}", kind, number(0), number(1), number(2));
}

/// The same, or "slide axis".
project::FreedomText textOf(const Freedom& freedom, const Vec3& axisAsDrawn) {
    if (same(freedom.direction, axisAsDrawn)) {
        return freedom.kind == FreedomKind::Turn ? "turn axis" : "slide axis";
    }
    return textOf(freedom);
}

std::string nameOf(const std::vector<Freedom>& freedoms) {
    const auto turns = directionsOf(freedoms, FreedomKind::Turn);
    const auto slides = directionsOf(freedoms, FreedomKind::Slide);
    if (slides.empty() && turns.size() <= 3) {
        constexpr const char* kNames[] = {Text::mark("weld"), Text::mark("pin"),
                                          Text::mark("universal"), Text::mark("ball")};
        return Text::translated(kNames[turns.size()]);
    }
    if (turns.empty() && slides.size() == 1) {
        return Text::of("slider");
    }
    if (turns.size() == 1 && slides.size() == 1 && same(turns.front(), slides.front())) {
        return Text::of("cylindrical");
    }
    if (turns.size() == 3 && slides.size() == 1) {
        return Text::of("ball with slide");
    }
    return Text::of("{} turns, {} slides", turns.size(), slides.size());
}

/// Directions a designer would think of for a joint, `axis` not among them: rover axes, and in
/// every link that it joins the line to the next joint and the one across, all at right angles to
/// the axis.
std::vector<Vec3> sensibleDirections(const mechanism::Mechanism& mechanism,
                                     const mechanism::Joint& joint, const Vec3& axis) {
    std::vector<Vec3> directions = orthogonalComplement({axis});
    const auto add = [&](const Vec3& direction) {
        if (std::none_of(directions.begin(), directions.end(),
                         [&](const Vec3& other) { return same(direction, other); })) {
            directions.push_back(direction);
        }
    };
    for (const int link : {joint.first, joint.second}) {
        std::vector<Vec3> lines;
        int joints = 0;
        for (const mechanism::Joint& other : mechanism.joints) {
            if (other.first == link || other.second == link) {
                ++joints;
                const Vec3 way = other.point - joint.point;
                const Vec3 across = way - way.dot(axis) * axis;
                if (across.norm() > 1e-3 * way.norm() && across.norm() > 1e-6) {
                    lines.push_back(across.normalized());
                }
            }
        }
        for (const Vec3& line : lines) {
            if (joints <= kJointsOfLink) {
                add(line);
                add(axis.cross(line));
            }
        }
    }
    return directions;
}

/// What a joint with these freedoms could become, every type in every sensible direction.
std::vector<Target> targetsOf(const mechanism::Mechanism& mechanism, const Place& place,
                              const AdvisorOptions& options, bool turnsOnly) {
    const mechanism::Joint& joint = mechanism.joints[asSize(place.copies.front())];
    const auto turns = directionsOf(joint.built, FreedomKind::Turn);
    const auto slides = directionsOf(joint.built, FreedomKind::Slide);
    std::vector<Target> targets;
    const auto add = [&](JointType type, std::vector<Freedom> freedoms) {
        Target target{type, {}, std::move(freedoms), ""};
        const bool ball = directionsOf(target.freedoms, FreedomKind::Turn).size() == 3;
        for (const Freedom& freedom : target.freedoms) {
            const bool byAxis = !ball || freedom.kind == FreedomKind::Slide;
            target.texts.push_back(byAxis ? textOf(freedom, joint.axis) : textOf(freedom));
        }
        target.name = nameOf(target.freedoms);
        if (type == JointType::BallWithSlide) {
            target.name = Text::of("ball with {}", target.texts.back());
        }
        targets.push_back(std::move(target));
    };
    const auto ballAnd = [](std::vector<Freedom> more) {
        std::vector<Freedom> freedoms{{FreedomKind::Turn, Vec3::UnitX()},
                                      {FreedomKind::Turn, Vec3::UnitY()},
                                      {FreedomKind::Turn, Vec3::UnitZ()}};
        freedoms.insert(freedoms.end(), more.begin(), more.end());
        return freedoms;
    };
    if (options.cylindrical && turns.size() == 1 && slides.empty()) {
        add(JointType::Cylindrical,
            {{FreedomKind::Turn, turns.front()}, {FreedomKind::Slide, turns.front()}});
    }
    if (options.cylindrical && turns.empty() && slides.size() == 1) {
        add(JointType::Cylindrical,
            {{FreedomKind::Turn, slides.front()}, {FreedomKind::Slide, slides.front()}});
    }
    if (turnsOnly) {
        return targets;
    }
    const Vec3 axis = turns.size() == 1 ? turns.front() : joint.axis;
    const auto directions = sensibleDirections(mechanism, joint, axis);
    if (options.ball && turns.size() < 3 && slides.empty()) {
        add(JointType::Ball, ballAnd({}));
    }
    if (options.universal && turns.size() == 1 && slides.empty()) {
        for (const Vec3& direction : directions) {
            add(JointType::Universal,
                {{FreedomKind::Turn, turns.front()}, {FreedomKind::Turn, direction}});
        }
    }
    if (options.ballWithSlide && slides.empty()) {
        add(JointType::BallWithSlide, ballAnd({{FreedomKind::Slide, axis}}));
        for (const Vec3& direction : directions) {
            add(JointType::BallWithSlide, ballAnd({{FreedomKind::Slide, direction}}));
        }
    }
    if (options.ballWithSlide && slides.size() == 1 && turns.size() < 3) {
        add(JointType::BallWithSlide, ballAnd({{FreedomKind::Slide, slides.front()}}));
    }
    return targets;
}

/// Orthonormal directions of one kind that `wide` leaves free and `narrow` does not.
std::vector<Vec3> directionsBetween(const std::vector<Freedom>& narrow,
                                    const std::vector<Freedom>& wide, FreedomKind kind) {
    std::vector<Vec3> basis;
    std::vector<Vec3> more;
    const auto rest = [&](Vec3 v) {
        for (const Vec3& b : basis) {
            v -= v.dot(b) * b;
        }
        return v;
    };
    for (const Vec3& direction : directionsOf(narrow, kind)) {
        basis.push_back(rest(direction).normalized());
    }
    for (const Vec3& direction : directionsOf(wide, kind)) {
        const Vec3 v = rest(direction);
        if (v.norm() > kSameDirection) {
            basis.push_back(v.normalized());
            more.push_back(basis.back());
        }
    }
    return more;
}

Vec3 mirrored(const Vec3& v, FreedomKind kind) {
    return kind == FreedomKind::Turn ? Vec3(-v.x(), v.y(), -v.z()) : Vec3(v.x(), -v.y(), v.z());
}

/// The as-built mechanism's self-stress states, asked by direction.
class SelfStress {
  public:
    SelfStress(const mechanism::Mechanism& mechanism, const Stance& stance)
        : mechanism_(mechanism),
          stance_(stance),
          jacobian_(constraintJacobian(mechanism, Model::Built, stance)),
          states_(Factorisation(jacobian_.matrix).selfStress) {}

    /// A row per direction that changing these copies lets go.
    MatrixXd relievedBy(const Place& place, Sides sides,
                        const std::vector<Freedom>& freedoms) const {
        MatrixXd rows(0, states_.cols());
        const auto& built = mechanism_.joints[asSize(place.copies.front())].built;
        for (const int copy : copiesOn(sides, place.copies)) {
            const bool asDrawn = copy == place.copies.front();
            for (const FreedomKind kind : {FreedomKind::Turn, FreedomKind::Slide}) {
                for (const Vec3& drawn : directionsBetween(built, freedoms, kind)) {
                    append(rows, reaction(copy, kind, asDrawn ? drawn : mirrored(drawn, kind)));
                }
            }
        }
        return rows;
    }

    /// A row per wheel that holds sideways.
    MatrixXd relievedSideways(const std::vector<int>& wheels) const {
        MatrixXd rows(0, states_.cols());
        for (std::size_t i = 0; i < jacobian_.names.size(); ++i) {
            if (jacobian_.priorities[i] == Priority::ContactLateral &&
                std::count(wheels.begin(), wheels.end(), jacobian_.names[i].wheel) > 0) {
                append(rows, states_.row(static_cast<Index>(i)));
            }
        }
        return rows;
    }

  private:
    static void append(MatrixXd& rows, const Eigen::RowVectorXd& row) {
        rows.conservativeResize(rows.rows() + 1, Eigen::NoChange);
        rows.bottomRows<1>() = row;
    }

    /// Of a joint along a direction of its first body, as drawn.
    Eigen::RowVectorXd reaction(int joint, FreedomKind kind, const Vec3& direction) const {
        const Vec3 seen =
            stance_.bodies[asSize(mechanism_.joints[asSize(joint)].first)].rotation * direction;
        const Priority priority =
            kind == FreedomKind::Turn ? Priority::JointTurn : Priority::JointSlide;
        Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(states_.cols());
        for (std::size_t i = 0; i < jacobian_.names.size(); ++i) {
            if (jacobian_.names[i].joint == joint && jacobian_.priorities[i] == priority) {
                sum += seen.dot(jacobian_.names[i].direction) * states_.row(static_cast<Index>(i));
            }
        }
        return sum;
    }

    const mechanism::Mechanism& mechanism_;
    const Stance& stance_;
    ConstraintJacobian jacobian_;
    MatrixXd states_;
};

/// All rows depend on self-stress and on nothing else among them: letting go moves nothing new.
bool movesNothing(const MatrixXd& relieved) {
    if (relieved.rows() == 0 || relieved.rows() > relieved.cols()) {
        return false;
    }
    Eigen::ColPivHouseholderQR<MatrixXd> qr(relieved.transpose());
    return std::abs(qr.matrixQR()(relieved.rows() - 1, relieved.rows() - 1)) > kNoReaction;
}

/// Both relieve the same states; then one of the two joints will do.
bool relieveTheSame(const MatrixXd& a, const MatrixXd& b) {
    if (a.rows() != b.rows()) {
        return false;
    }
    MatrixXd both(2 * a.rows(), a.cols());
    both << a, b;
    Eigen::ColPivHouseholderQR<MatrixXd> qr;
    qr.setThreshold(kNoReaction);
    qr.compute(both.transpose());
    return qr.rank() == a.rows();
}

/// Adds a choice, unless another of its type relieves the same; of two, the one stays that does it
/// more strongly, as a slide normal to a bar does more than a slanting one.
void addUnlessServed(ChangeableElement& element, JointChange change, Choice choice) {
    for (std::size_t k = 0; k < element.choices.size(); ++k) {
        if (element.changes[k].type == change.type && element.changes[k].sides == change.sides &&
            relieveTheSame(element.choices[k].relieved, choice.relieved)) {
            if (choice.relieved.norm() > (1.0 + 1e-6) * element.choices[k].relieved.norm()) {
                element.changes[k] = std::move(change);
                element.choices[k] = std::move(choice);
            }
            return;
        }
    }
    element.changes.push_back(std::move(change));
    element.choices.push_back(std::move(choice));
}

bool turnsInGear(const mechanism::Mechanism& mechanism, int joint) {
    return std::any_of(mechanism.gears.begin(), mechanism.gears.end(), [&](const auto& gear) {
        return gear.firstJoint == joint || gear.secondJoint == joint;
    });
}

bool isAxle(const mechanism::Mechanism& mechanism, int joint) {
    return std::any_of(mechanism.wheels.begin(), mechanism.wheels.end(),
                       [&](const auto& wheel) { return wheel.axle == joint; });
}

int costOfChange(const JointChange& change) {
    return costOf(change.type) * static_cast<int>(change.copies.size()) +
           (change.sides == Sides::Both ? 0 : costOfOneSide(change.type));
}

JointChange changeOf(int index, const Place& place, const mechanism::Mechanism& mechanism,
                     Sides sides) {
    JointChange change;
    change.joint = index;
    change.element = place.joint->name;
    change.sides = sides;
    for (const int copy : copiesOn(sides, place.copies)) {
        change.copies.push_back(mechanism.joints[asSize(copy)].name);
    }
    change.from = nameOf(mechanism.joints[asSize(place.copies.front())].built);
    return change;
}

ChangeableElement changesOfJoint(int index, const Place& place,
                                 const mechanism::Mechanism& mechanism,
                                 const SelfStress& selfStress, const AdvisorOptions& options,
                                 bool oneSided) {
    ChangeableElement element;
    if (place.copies.empty() || (!options.axles && isAxle(mechanism, place.copies.front()))) {
        return element;
    }
    // The gear's shaft must stay in line with its axis.
    const bool turnsOnly = turnsInGear(mechanism, place.copies.front());
    for (const Target& target : targetsOf(mechanism, place, options, turnsOnly)) {
        for (const Sides sides : waysToTakeSides(place.joint->mirror, oneSided)) {
            Choice choice{0, selfStress.relievedBy(place, sides, target.freedoms)};
            if (!movesNothing(choice.relieved)) {
                continue;
            }
            JointChange change = changeOf(index, place, mechanism, sides);
            change.to = target.name;
            change.type = target.type;
            change.relaxed = target.texts;
            change.freed = static_cast<int>(choice.relieved.rows());
            change.cost = choice.cost = costOfChange(change);
            addUnlessServed(element, std::move(change), std::move(choice));
        }
    }
    return element;
}

ChangeableElement changesOfWheel(int index, const project::Wheel& wheel,
                                 const mechanism::Mechanism& mechanism,
                                 const SelfStress& selfStress, bool oneSided) {
    ChangeableElement element;
    for (const Sides sides : waysToTakeSides(wheel.mirror, oneSided)) {
        JointChange change;
        change.wheel = index;
        change.element = contactOf(wheel.name);
        std::vector<int> wheels;
        for (const Side side : copiesOn(sides, sidesOf(wheel.mirror))) {
            const std::string name = project::nameOnSide(wheel.name, side);
            wheels.push_back(mechanism.findWheel(name));
            change.copies.push_back(contactOf(name));
        }
        change.from = Text::of("contact");
        change.to = Text::of("contact free sideways");
        change.type = JointType::SidewaysContact;
        change.sides = sides;
        change.freed = static_cast<int>(wheels.size());
        change.cost = costOfChange(change);
        Choice choice{change.cost, selfStress.relievedSideways(wheels)};
        if (movesNothing(choice.relieved)) {
            addUnlessServed(element, std::move(change), std::move(choice));
        }
    }
    return element;
}

/// Free velocities of what does the work: chassis and wheels, or everything.
MatrixXd wantedMotions(const mechanism::Mechanism& mechanism, const ConstraintJacobian& jacobian) {
    const Factorisation factors(jacobian.matrix);
    if (mechanism.wheels.empty()) {
        return factors.motions;
    }
    std::vector<int> watched{mechanism.chassis};
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        watched.push_back(wheel.body);
    }
    MatrixXd seen(0, factors.motions.cols());
    for (const int body : watched) {
        const int column = jacobian.firstColumn[asSize(body)];
        if (column >= 0) {
            seen.conservativeResize(seen.rows() + 6, Eigen::NoChange);
            seen.bottomRows(6) = factors.motions.middleRows(column, 6);
        }
    }
    return seen;
}

Index rankOf(const MatrixXd& columns) {
    if (columns.size() == 0 || columns.norm() < 1e-9) {
        return 0;
    }
    Eigen::ColPivHouseholderQR<MatrixXd> qr;
    qr.setThreshold(1e-7);
    qr.compute(columns);
    return qr.rank();
}

/// A ball of the body that turns idly becomes a universal joint that holds this turn.
std::optional<JointChange> holdTurn(int index, const Place& place,
                                    const mechanism::Mechanism& mechanism,
                                    const IdleFreedom& idle) {
    if (place.copies.empty() || idle.turn.norm() < kNoReaction) {
        return std::nullopt;
    }
    const mechanism::Joint& joint = mechanism.joints[asSize(place.copies.front())];
    const int body = mechanism.findBody(idle.body);
    const bool touches = std::any_of(place.copies.begin(), place.copies.end(), [&](int copy) {
        const mechanism::Joint& one = mechanism.joints[asSize(copy)];
        return one.first == body || one.second == body;
    });
    if (!touches || directionsOf(joint.built, FreedomKind::Turn).size() != 3 ||
        directionsOf(joint.built, FreedomKind::Slide).size() != 0) {
        return std::nullopt;
    }
    JointChange change = changeOf(index, place, mechanism, Sides::Both);
    for (const Vec3& free : orthogonalComplement({idle.turn.normalized()})) {
        change.relaxed.push_back(textOf({FreedomKind::Turn, free}));
    }
    change.type = JointType::Universal;
    change.to = "universal";
    change.freed = -static_cast<int>(place.copies.size());
    change.cost = costOfChange(change);
    return change;
}

mechanism::Mechanism withTurnHeld(mechanism::Mechanism mechanism, const Place& place,
                                  const Vec3& held) {
    const auto across = orthogonalComplement({held});
    for (std::size_t copy = 0; copy < place.copies.size(); ++copy) {
        std::vector<Freedom>& freedoms = mechanism.joints[asSize(place.copies[copy])].built;
        freedoms.clear();
        for (const Vec3& free : across) {
            freedoms.push_back(
                {FreedomKind::Turn, copy == 0 ? free : mirrored(free, FreedomKind::Turn)});
        }
    }
    return mechanism;
}

}  // namespace

bool sameWantedMotions(const mechanism::Mechanism& mechanism, const ConstraintJacobian& one,
                       const ConstraintJacobian& other) {
    const MatrixXd a = wantedMotions(mechanism, one);
    const MatrixXd b = wantedMotions(mechanism, other);
    MatrixXd both(a.rows(), a.cols() + b.cols());
    both << a, b;
    const Index rank = rankOf(both);
    return rankOf(a) == rank && rankOf(b) == rank;
}

std::vector<ChangeableElement> findChanges(const project::Project& project,
                                           const mechanism::Mechanism& mechanism,
                                           const Stance& stance, const AdvisorOptions& options,
                                           bool oneSided) {
    const SelfStress selfStress(mechanism, stance);
    std::vector<ChangeableElement> elements;
    const auto keep = [&](ChangeableElement element) {
        if (!element.changes.empty()) {
            elements.push_back(std::move(element));
        }
    };
    const project::Rover& rover = project.rover;
    for (std::size_t i = 0; i < rover.joints.size(); ++i) {
        keep(changesOfJoint(static_cast<int>(i), placeOf(rover.joints[i], mechanism), mechanism,
                            selfStress, options, oneSided));
    }
    for (std::size_t i = 0; i < rover.wheels.size() && options.contacts; ++i) {
        keep(changesOfWheel(static_cast<int>(i), rover.wheels[i], mechanism, selfStress, oneSided));
    }
    return elements;
}

std::vector<JointChange> holdIdleFreedoms(const project::Project& project,
                                          const mechanism::Mechanism& mechanism) {
    const ConstraintJacobian built = constraintJacobian(mechanism, Model::Built);
    mechanism::Mechanism tried = mechanism;
    Report report = analyse(tried, Model::Built);
    std::vector<JointChange> held;
    /// One change that leaves less idle, if there is one.
    const auto improve = [&] {
        for (const IdleFreedom& idle : report.idle) {
            for (std::size_t i = 0; i < project.rover.joints.size(); ++i) {
                const Place place = placeOf(project.rover.joints[i], mechanism);
                const auto change = holdTurn(static_cast<int>(i), place, tried, idle);
                if (!change) {
                    continue;
                }
                mechanism::Mechanism next = withTurnHeld(tried, place, idle.turn.normalized());
                Report after = analyse(next, Model::Built);
                if (after.idle.size() < report.idle.size() && after.redundant == report.redundant &&
                    sameWantedMotions(mechanism, built, constraintJacobian(next, Model::Built))) {
                    held.push_back(*change);
                    tried = std::move(next);
                    report = std::move(after);
                    return true;
                }
            }
        }
        return false;
    };
    while (!report.idle.empty() && improve()) {
    }
    return held;
}

}  // namespace simcore::mobility
