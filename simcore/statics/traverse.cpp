#include "simcore/statics/traverse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include "simcore/base/text.h"

namespace simcore::statics {
namespace {

/// An event is known to be between two poses this far apart [m of way].
constexpr double kLocated = 1e-7;
/// A wheel whose foremost foothold turns more than this in one step drops, or is caught [rad].
constexpr double kJump = 0.35;
/// The shortest step, in radii of a wheel.
constexpr double kShortest = 1e-4;
/// The rover is stuck when its wheels roll this much without it [radii], or so many samples.
constexpr double kRollsInVain = 6.0;
/// So many samples on so little way [radii]: wheels that meet and leave by turns.
constexpr std::size_t kBlock = 40;
constexpr double kBlockWay = 0.05;
constexpr std::size_t kSamplesInVain = 200;
constexpr double kGetsOn = 1e-3;  ///< that counts as going on, in radii

/// No ground has this friction: in some poses next to singular ones forces are found that are
/// none.
constexpr double kNoGround = 5.0;

bool isHeld(const TraverseSample& sample) {
    return sample.study.feasible && sample.study.frictionRequired < kNoGround;
}

/// The footholds of one wheel.
struct Stand {
    int count = 0;
    double foremost = 0.0;  ///< angle [rad]
    bool onEdge = false;    ///< one of them
};

std::vector<Stand> standsOf(const StandingPose& pose, std::size_t wheels) {
    std::vector<Stand> stands(wheels);
    for (const Foothold& foothold : pose.footholds) {
        Stand& stand = stands[static_cast<std::size_t>(foothold.contact.wheel)];
        ++stand.count;
        stand.foremost = foothold.angle;
        stand.onEdge = stand.onEdge || foothold.onEdge;
    }
    return stands;
}

class Creep {
  public:
    Creep(PoseSolver& solver, const TraverseRequest& request,
          const std::function<bool(const TraverseSample&)>& watch)
        : solver_(solver),
          request_(request),
          watch_(watch),
          sign_(request.backwards ? -1.0 : 1.0),
          ahead_(std::cos(request.from.heading), std::sin(request.from.heading), 0.0),
          radius_(leastRadius(solver.mechanism())),
          longest_(request.step * radius_),
          step_(0.5 * longest_) {}

    Traverse follow() {
        result_.radius = radius_;
        pose_ = solver_.settle(request_.from);
        if (pose_.standing != Standing::Stands) {
            end(TraverseEnd::NoPose, pose_.standing);
            return std::move(result_);
        }
        farthest_ = distanceOf(pose_);
        bool goesOn = take({});
        while (goesOn && distanceOf(pose_) < request_.distance) {
            goesOn = getsOn() && advance();
        }
        return std::move(result_);
    }

  private:
    /// @return false
    bool end(TraverseEnd end, Standing why = Standing::Stands) {
        result_.end = end;
        result_.why = why;
        return false;
    }

    /// Adds a sample at the present pose; false when who watches has seen enough.
    bool take(std::vector<std::string> events) {
        TraverseSample sample;
        sample.way = way_;
        sample.distance = distanceOf(pose_);
        sample.pose = pose_;
        sample.climbs =
            !result_.samples.empty() && pose_.potential > result_.samples.back().pose.potential;
        if (request_.study) {
            sample.study =
                studyPose(solver_.model(), pose_, request_.contacts, request_.backwards, false);
        }
        sample.events = std::move(events);
        result_.samples.push_back(std::move(sample));
        return !watch_ || watch_(result_.samples.back()) || end(TraverseEnd::Stopped);
    }

    /// Whether the rover goes on when its wheels do.
    bool getsOn() {
        if (way_ - wayAtFarthest_ > kRollsInVain * radius_ ||
            result_.samples.size() > samplesAtFarthest_ + kSamplesInVain) {
            return end(TraverseEnd::Stuck);
        }
        return true;
    }

    /// Goes one step on, or tries again with a shorter one next time. False at the end of the way.
    bool advance() {
        StandingPose next = solver_.roll(pose_, step_, request_.backwards);
        if (meetsAndLeavesByTurns()) {
            next = beyond(pose_);
            if (next.standing != Standing::Stands) {
                return end(TraverseEnd::NoPose, next.standing);
            }
        }
        if (!same(pose_, next)) {
            return passEvent(std::move(next));
        }
        const double moved = movedMost(pose_, next);
        if (moved > longest_ && step_ > kShortest * radius_) {
            step_ *= std::max(0.3, 0.8 * longest_ / moved);
            return true;
        }
        const double way = way_ + step_;
        if (moved < 0.6 * longest_) {
            step_ = std::min(1.5 * step_, longest_);
        }
        return arrive(std::move(next), way, {});
    }

    /// Many samples on little way.
    bool meetsAndLeavesByTurns() {
        if (result_.samples.size() < blockFirst_ + kBlock) {
            return false;
        }
        const bool inVain = way_ - blockWay_ < kBlockWay * radius_;
        blockFirst_ = result_.samples.size();
        blockWay_ = way_;
        return inVain;
    }

    /// Locates the event between the present pose and `next`, one step on, with a sample just
    /// before it and one just after.
    bool passEvent(StandingPose next) {
        double before = 0.0;
        double after = step_;
        StandingPose last = pose_;
        while (after - before > kLocated) {
            const double middle = 0.5 * (before + after);
            StandingPose tried = solver_.roll(pose_, middle, request_.backwards);
            const bool isBefore = same(pose_, tried);
            (isBefore ? before : after) = middle;
            (isBefore ? last : next) = std::move(tried);
        }
        if (next.standing != Standing::Stands) {
            const Standing why = next.standing;
            next = beyond(last);
            if (next.standing != Standing::Stands) {
                return end(TraverseEnd::NoPose, why);
            }
        }
        std::vector<std::string> events = eventsOf(last, next);
        const double start = way_;
        if (before > 0.0) {
            pose_ = std::move(last);
            way_ = start + before;
            if (!take({})) {
                return false;
            }
        }
        return arrive(std::move(next), start + after, std::move(events));
    }

    bool arrive(StandingPose pose, double way, std::vector<std::string> events) {
        pose_ = std::move(pose);
        way_ = way;
        if (distanceOf(pose_) > farthest_ + kGetsOn * radius_) {
            farthest_ = distanceOf(pose_);
            wayAtFarthest_ = way_;
            samplesAtFarthest_ = result_.samples.size();
        }
        return take(std::move(events));
    }

    double distanceOf(const StandingPose& pose) const {
        const Pose& chassis = pose.bodies[static_cast<std::size_t>(solver_.mechanism().chassis)];
        return sign_ * ahead_.dot(chassis.position - Vec3(request_.from.x, request_.from.y, 0.0));
    }

    /// Where the wheels cannot roll on together: the rover a little further on.
    StandingPose beyond(const StandingPose& pose) {
        StandingPose next;
        for (const double little : {0.05, 0.2, 0.6}) {  // radii
            const double distance = distanceOf(pose) + little * radius_;
            const Vec3 at = Vec3(request_.from.x, request_.from.y, 0.0) + sign_ * distance * ahead_;
            next = solver_.settleFrom(pose.state, {at.x(), at.y(), request_.from.heading});
            if (next.standing == Standing::Stands) {
                break;
            }
        }
        return next;
    }

    /// Whether the same wheels touch with as many places, on edges or not, no body and no stop
    /// besides.
    bool same(const StandingPose& a, const StandingPose& b) const {
        if (b.standing != Standing::Stands || a.bodiesTouching != b.bodiesTouching ||
            a.jointsAtStop != b.jointsAtStop) {
            return false;
        }
        const std::size_t wheels = solver_.mechanism().wheels.size();
        const std::vector<Stand> from = standsOf(a, wheels);
        const std::vector<Stand> to = standsOf(b, wheels);
        for (std::size_t i = 0; i < wheels; ++i) {
            if (from[i].count != to[i].count || from[i].onEdge != to[i].onEdge ||
                std::abs(from[i].foremost - to[i].foremost) > kJump) {
                return false;
            }
        }
        return true;
    }

    double movedMost(const StandingPose& a, const StandingPose& b) const {
        double most = 0.0;
        for (const mechanism::Wheel& wheel : solver_.mechanism().wheels) {
            const auto body = static_cast<std::size_t>(wheel.body);
            most = std::max(most,
                            (b.bodies[body] * wheel.center - a.bodies[body] * wheel.center).norm());
        }
        return most;
    }

    std::vector<std::string> eventsOf(const StandingPose& a, const StandingPose& b) const {
        const mechanism::Mechanism& mechanism = solver_.mechanism();
        std::vector<std::string> events;
        const std::vector<Stand> from = standsOf(a, mechanism.wheels.size());
        const std::vector<Stand> to = standsOf(b, mechanism.wheels.size());
        for (std::size_t i = 0; i < from.size(); ++i) {
            const std::string& name = mechanism.wheels[i].name;
            if (from[i].count == 0 && to[i].count > 0) {
                events.push_back(Text::of("{} lands", name));
            } else if (from[i].count > 0 && to[i].count == 0) {
                events.push_back(Text::of("{} lifts", name));
            } else if (from[i].count < to[i].count) {
                events.push_back(Text::of("{} meets", name));
            } else if (from[i].count > to[i].count) {
                events.push_back(Text::of("{} leaves", name));
            } else if (std::abs(from[i].foremost - to[i].foremost) > kJump) {
                events.push_back(Text::of("{} drops", name));
            }
            if (from[i].onEdge != to[i].onEdge) {
                events.push_back(to[i].onEdge ? Text::of("{} reaches edge", name)
                                              : Text::of("{} leaves edge", name));
            }
        }
        const auto compare = [&](const std::vector<int>& was, const std::vector<int>& is,
                                 const auto& begins, const auto& ends) {
            for (const int index : is) {
                if (std::find(was.begin(), was.end(), index) == was.end()) {
                    events.push_back(begins(static_cast<std::size_t>(index)));
                }
            }
            for (const int index : was) {
                if (std::find(is.begin(), is.end(), index) == is.end()) {
                    events.push_back(ends(static_cast<std::size_t>(index)));
                }
            }
        };
        compare(
            a.bodiesTouching, b.bodiesTouching,
            [&](std::size_t i) { return Text::of("{} touches", mechanism.bodies[i].name); },
            [&](std::size_t i) { return Text::of("{} is free", mechanism.bodies[i].name); });
        compare(
            a.jointsAtStop, b.jointsAtStop,
            [&](std::size_t i) {
                return Text::of("{} reaches its stop", mechanism.joints[i].name);
            },
            [&](std::size_t i) {
                return Text::of("{} leaves its stop", mechanism.joints[i].name);
            });
        return events;
    }

    PoseSolver& solver_;
    const TraverseRequest& request_;
    const std::function<bool(const TraverseSample&)>& watch_;
    const double sign_;
    const Vec3 ahead_;
    const double radius_;
    const double longest_;  ///< that a wheel moves between two samples [m]
    Traverse result_;
    StandingPose pose_;  ///< the present one
    double way_ = 0.0;   ///< up to it [m]
    double step_;        ///< that is tried next [m]
    double farthest_ = 0.0;
    double wayAtFarthest_ = 0.0;
    std::size_t samplesAtFarthest_ = 0;
    std::size_t blockFirst_ = 0;  ///< sample from which meetsAndLeavesByTurns() counts
    double blockWay_ = 0.0;
};

}  // namespace

std::string toString(TraverseEnd end) {
    switch (end) {
        case TraverseEnd::Arrived:
            return "arrived";
        case TraverseEnd::NoPose:
            return "no-pose";
        case TraverseEnd::Stuck:
            return "stuck";
        case TraverseEnd::Stopped:
            break;
    }
    return "stopped";
}

Traverse traverse(PoseSolver& solver, const TraverseRequest& request,
                  const std::function<bool(const TraverseSample&)>& watch) {
    return Creep(solver, request, watch).follow();
}

std::size_t Traverse::hardest() const {
    std::size_t most = 0;
    double friction = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples[i].climbs && isHeld(samples[i]) &&
            samples[i].study.frictionRequired > friction) {
            most = i;
            friction = samples[i].study.frictionRequired;
        }
    }
    return most;
}

double Traverse::frictionRequired() const {
    constexpr double kUnheld = 0.1;  // radii
    double unheld = 0.0;
    bool passable = end == TraverseEnd::Arrived && !samples.empty();
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const bool held = !samples[i].climbs || isHeld(samples[i]);
        unheld = held ? 0.0 : unheld + samples[i].way - samples[i - 1].way;
        passable = passable && unheld < kUnheld * radius;
    }
    if (!passable) {
        return std::numeric_limits<double>::infinity();
    }
    const TraverseSample& most = samples[hardest()];
    return most.climbs && isHeld(most) ? most.study.frictionRequired : 0.0;
}

}  // namespace simcore::statics
