#include "simcore/statics/traverse.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
    Creep(PoseSolver& solver, const TraverseRequest& request)
        : solver_(solver),
          request_(request),
          sign_(request.backwards ? -1.0 : 1.0),
          ahead_(std::cos(request.from.heading), std::sin(request.from.heading), 0.0),
          radius_(leastRadius(solver.mechanism())) {}

    Traverse follow(const std::function<bool(const TraverseSample&)>& watch) {
        Traverse result;
        result.radius = radius_;
        StandingPose pose = solver_.settle(request_.from);
        if (pose.standing != Standing::Stands) {
            result.end = TraverseEnd::NoPose;
            result.why = pose.standing;
            return result;
        }
        double way = 0.0;
        double farthest = distanceOf(pose);
        double wayAtFarthest = 0.0;
        std::size_t samplesAtFarthest = 0;
        const auto take = [&](std::vector<std::string> events) {
            TraverseSample sample;
            sample.way = way;
            sample.distance = distanceOf(pose);
            sample.pose = pose;
            sample.climbs =
                !result.samples.empty() && pose.potential > result.samples.back().pose.potential;
            if (request_.study) {
                sample.study =
                    studyPose(solver_.model(), pose, request_.contacts, request_.backwards, false);
            }
            sample.events = std::move(events);
            result.samples.push_back(std::move(sample));
            return !watch || watch(result.samples.back());
        };
        if (!take({})) {
            result.end = TraverseEnd::Stopped;
            return result;
        }
        double step = 0.5 * request_.step * radius_;
        std::size_t blockFirst = 0;
        double blockWay = 0.0;
        while (distanceOf(pose) < request_.distance) {
            if (way - wayAtFarthest > kRollsInVain * radius_ ||
                result.samples.size() > samplesAtFarthest + kSamplesInVain) {
                result.end = TraverseEnd::Stuck;
                return result;
            }
            StandingPose next = solver_.roll(pose, step, request_.backwards);
            if (result.samples.size() >= blockFirst + kBlock) {
                if (way - blockWay < kBlockWay * radius_) {
                    next = beyond(pose);
                    if (next.standing != Standing::Stands) {
                        result.end = TraverseEnd::NoPose;
                        result.why = next.standing;
                        return result;
                    }
                }
                blockFirst = result.samples.size();
                blockWay = way;
            }
            const bool event = !same(pose, next);
            const double moved = event ? 0.0 : movedMost(pose, next);
            if (!event && moved > request_.step * radius_ && step > kShortest * radius_) {
                step *= std::max(0.3, 0.8 * request_.step * radius_ / moved);
                continue;
            }
            std::vector<std::string> events;
            if (event) {
                double before = 0.0;
                double after = step;
                StandingPose last = pose;
                while (after - before > kLocated) {
                    const double middle = 0.5 * (before + after);
                    StandingPose tried = solver_.roll(pose, middle, request_.backwards);
                    (same(pose, tried) ? before : after) = middle;
                    (before == middle ? last : next) = std::move(tried);
                }
                if (next.standing != Standing::Stands) {
                    const Standing why = next.standing;
                    next = beyond(last);
                    if (next.standing != Standing::Stands) {
                        result.end = TraverseEnd::NoPose;
                        result.why = why;
                        return result;
                    }
                }
                events = eventsOf(last, next);
                const double start = way;
                if (before > 0.0) {
                    pose = std::move(last);
                    way = start + before;
                    if (!take({})) {
                        result.end = TraverseEnd::Stopped;
                        return result;
                    }
                }
                way = start + after;
                pose = std::move(next);
            } else {
                way += step;
                pose = std::move(next);
                if (moved < 0.6 * request_.step * radius_) {
                    step = std::min(1.5 * step, request_.step * radius_);
                }
            }
            if (distanceOf(pose) > farthest + kGetsOn * radius_) {
                farthest = distanceOf(pose);
                wayAtFarthest = way;
                samplesAtFarthest = result.samples.size();
            }
            if (!take(std::move(events))) {
                result.end = TraverseEnd::Stopped;
                return result;
            }
        }
        return result;
    }

  private:
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
                events.push_back(name + " lands");
            } else if (from[i].count > 0 && to[i].count == 0) {
                events.push_back(name + " lifts");
            } else if (from[i].count < to[i].count) {
                events.push_back(name + " meets");
            } else if (from[i].count > to[i].count) {
                events.push_back(name + " leaves");
            } else if (std::abs(from[i].foremost - to[i].foremost) > kJump) {
                events.push_back(name + " drops");
            }
            if (from[i].onEdge != to[i].onEdge) {
                events.push_back(name + (to[i].onEdge ? " reaches edge" : " leaves edge"));
            }
        }
        const auto compare = [&](const std::vector<int>& was, const std::vector<int>& is,
                                 const auto& nameOf, const char* begins, const char* ends) {
            for (const int index : is) {
                if (std::find(was.begin(), was.end(), index) == was.end()) {
                    events.push_back(nameOf(index) + begins);
                }
            }
            for (const int index : was) {
                if (std::find(is.begin(), is.end(), index) == is.end()) {
                    events.push_back(nameOf(index) + ends);
                }
            }
        };
        compare(
            a.bodiesTouching, b.bodiesTouching,
            [&](int i) { return mechanism.bodies[static_cast<std::size_t>(i)].name; }, " touches",
            " is free");
        compare(
            a.jointsAtStop, b.jointsAtStop,
            [&](int i) { return mechanism.joints[static_cast<std::size_t>(i)].name; },
            " reaches its stop", " leaves its stop");
        return events;
    }

    PoseSolver& solver_;
    const TraverseRequest& request_;
    double sign_;
    Vec3 ahead_;
    double radius_;
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
    return Creep(solver, request).follow(watch);
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
