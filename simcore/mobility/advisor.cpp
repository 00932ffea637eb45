#include "simcore/mobility/advisor.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "simcore/base/text.h"
#include "simcore/mobility/exact_sets.h"
#include "simcore/mobility/joint_choices.h"
#include "simcore/mobility/moved_pose.h"
#include "simcore/project/resolve.h"

namespace simcore::mobility {
namespace {

constexpr std::size_t kTypes = 5;
/// How many of each type of joint an exact set has.
using MakeUp = std::array<int, kTypes>;

/// Sets of one cost and make-up that wait to be confirmed; the rest have a smaller margin.
constexpr std::size_t kWaiting = 64;

class Clock {
  public:
    Clock(double seconds, const std::stop_token& stop)
        : stop_(stop),
          end_(std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds)) {}

    bool cancelled() const { return stop_.stop_requested(); }

    bool timeUp() const { return std::chrono::steady_clock::now() >= end_; }

    bool over() const { return cancelled() || timeUp(); }

  private:
    const std::stop_token& stop_;
    std::chrono::time_point<std::chrono::steady_clock, std::chrono::duration<double>> end_;
};

/// Where exactness is looked for: the drawn pose or, where that is special, one nearby.
struct SearchedPose {
    Stance stance;
    Report report;
    bool moved = false;
    bool onlyYields = false;  ///< a free motion does not go on
};

SearchedPose searchedPose(const mechanism::Mechanism& mechanism) {
    SearchedPose pose{drawnStance(mechanism), analyse(mechanism, Model::Built), false, false};
    const MovedPose moved = movedPose(mechanism, Model::Built, pose.stance);
    pose.onlyYields = moved.moving < static_cast<int>(moved.motions.size());
    if (moved.rank > pose.report.rank) {
        for (const FreeMotion& motion : moved.motions) {
            if (motion.continuation == Continuation::Infinitesimal) {
                continue;
            }
            Report there = analyse(mechanism, Model::Built, motion.reached);
            if (there.rank == moved.rank) {
                return {motion.reached, std::move(there), true, pose.onlyYields};
            }
        }
    }
    return pose;
}

/// The project with the changes as what it is built with.
project::Project builtWith(project::Project project, const std::vector<JointChange>& changes) {
    for (const JointChange& change : changes) {
        project.rover.joints[static_cast<std::size_t>(change.joint)].free = change.relaxed;
    }
    return project;
}

MakeUp makeUpOf(const std::vector<ChangeableElement>& elements, const ExactSet& set) {
    MakeUp makeUp{};
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (set.choice[i] >= 0) {
            const JointChange& change =
                elements[i].changes[static_cast<std::size_t>(set.choice[i])];
            makeUp[static_cast<std::size_t>(change.type)] += static_cast<int>(change.copies.size());
        }
    }
    return makeUp;
}

/// "2 balls".
std::string countOf(JointType type, int count) {
    if (count == 1) {
        return fmt::format("1 {}", toString(type));
    }
    switch (type) {
        case JointType::SidewaysContact:
            return Text::of("{} contacts free sideways", count);
        case JointType::Ball:
            return Text::of("{} balls", count);
        case JointType::Cylindrical:
            return Text::of("{} cylindrical", count);
        case JointType::Universal:
            return Text::of("{} universal", count);
        case JointType::BallWithSlide:
            return Text::of("{} balls with slide", count);
    }
    return {};
}

std::string summaryOf(const std::vector<JointChange>& changes) {
    std::map<JointType, int> counts;
    for (const JointChange& change : changes) {
        counts[change.type] += static_cast<int>(change.copies.size());
    }
    std::vector<std::string> parts;
    parts.reserve(counts.size());
    for (const auto& [type, count] : counts) {
        parts.push_back(countOf(type, count));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

class Advisor {
  public:
    Advisor(const project::Project& project, const AdvisorOptions& options,
            const std::stop_token& stop)
        : project_(project),
          options_(options),
          clock_(options.seconds, stop) {}

    Result<Advice> run() {
        const auto built = project::resolve(project_);
        if (!built) {
            return built.problems();
        }
        built_ = *built;
        advice_.fileRelaxed = analyse(built_, Model::Relaxed);
        const std::vector<JointChange> held = holdIdleFreedoms(project_, built_);
        const project::Project base = builtWith(project_, held);
        const auto resolved = project::resolve(base);
        if (!resolved) {
            return resolved.problems();
        }
        base_ = *resolved;
        pose_ = searchedPose(base_);
        const Report asBuilt = pose_.moved ? analyse(built_, Model::Built, pose_.stance)
                                           : analyse(built_, Model::Built);
        advice_.built = asBuilt;
        advice_.searchedMovedPose = pose_.moved;
        advice_.alreadyExact = asBuilt.redundant == 0 && asBuilt.idle.empty();
        addNotes();
        if (!advice_.alreadyExact) {
            search(base, held);
        }
        finish();
        return Result<Advice>(std::move(advice_), built.problems());
    }

  private:
    void addNotes() {
        const Report& file = advice_.fileRelaxed;
        if (!advice_.alreadyExact && file.redundant == 0 && file.idle.empty() &&
            file.mobility == pose_.report.mobility) {
            advice_.notes.push_back(Text::of("The relaxed model that the file has is exact."));
        }
        if (pose_.moved) {
            advice_.notes.push_back(Text::of(
                "The drawn pose is special: after a small real motion more constraints hold. The "
                "search was made there, and in the drawn pose itself constraints stay redundant."));
        }
        if (pose_.onlyYields) {
            advice_.notes.push_back(Text::of(
                "As built, a free motion of the drawn pose does not go on: it only yields. What "
                "follows keeps that motion, too."));
        }
        if (!pose_.report.idle.empty()) {
            advice_.notes.push_back(
                Text::of("An idle freedom cannot be held by a universal joint in place "
                         "of a ball; it has to go first."));
        }
    }

    void search(const project::Project& base, const std::vector<JointChange>& held) {
        searchAmong(findChanges(base, base_, pose_.stance, options_, false), held);
        if (advice_.proposals.empty() && advice_.end == AdviceEnd::Complete && hasMirrored()) {
            searchAmong(findChanges(base, base_, pose_.stance, options_, true), held);
            advice_.oneSided = true;
            if (!advice_.proposals.empty()) {
                advice_.notes.push_back(
                    Text::of("No set that changes both sides alike is exact, so each of "
                             "these changes something on one side only."));
            }
        }
    }

    bool hasMirrored() const {
        const project::Rover& rover = project_.rover;
        const auto mirrored = [](const auto& element) { return element.mirror; };
        return std::any_of(rover.joints.begin(), rover.joints.end(), mirrored) ||
               std::any_of(rover.wheels.begin(), rover.wheels.end(), mirrored);
    }

    /// Adds proposals, cheapest first, until there are enough, there are no more, or it is over.
    void searchAmong(const std::vector<ChangeableElement>& elements,
                     const std::vector<JointChange>& held) {
        std::vector<std::vector<Choice>> choices;
        choices.reserve(elements.size());
        for (const ChangeableElement& element : elements) {
            choices.push_back(element.choices);
        }
        ExactSetSearch sets(std::move(choices), pose_.report.redundant);
        for (const int cost : sets.costs()) {
            if (full()) {
                return;
            }
            std::map<MakeUp, std::vector<ExactSet>> found;
            const bool whole = sets.visit(
                cost, [&] { return clock_.over(); },
                [&](const ExactSet& set) { keepBest(found[makeUpOf(elements, set)], set); });
            confirmAll(elements, held, found);
            if (!whole || (clock_.over() && !full())) {
                advice_.end = clock_.cancelled() ? AdviceEnd::Cancelled : AdviceEnd::TimeUp;
                return;
            }
        }
    }

    bool full() const { return static_cast<int>(advice_.proposals.size()) >= options_.proposals; }

    /// Of two sets of one cost: fewer elements changed, then the larger margin.
    static bool better(const ExactSet& a, const ExactSet& b) {
        const auto changed = [](const ExactSet& set) {
            return std::count_if(set.choice.begin(), set.choice.end(),
                                 [](int choice) { return choice >= 0; });
        };
        // Round-off must not decide between sets that are mirror images of each other.
        const auto margin = [](const ExactSet& set) { return std::round(1e6 * set.margin); };
        return std::pair(changed(a), -margin(a)) < std::pair(changed(b), -margin(b));
    }

    static void keepBest(std::vector<ExactSet>& sets, const ExactSet& set) {
        sets.insert(std::upper_bound(sets.begin(), sets.end(), set, better), set);
        if (sets.size() > kWaiting) {
            sets.pop_back();
        }
    }

    void confirmAll(const std::vector<ChangeableElement>& elements,
                    const std::vector<JointChange>& held,
                    const std::map<MakeUp, std::vector<ExactSet>>& found) {
        std::vector<const ExactSet*> order;
        for (const auto& [makeUp, sets] : found) {
            for (const ExactSet& set : sets) {
                order.push_back(&set);
            }
        }
        std::stable_sort(order.begin(), order.end(),
                         [](const ExactSet* a, const ExactSet* b) { return better(*a, *b); });
        std::map<MakeUp, int> taken;
        for (const ExactSet* set : order) {
            const MakeUp makeUp = makeUpOf(elements, *set);
            if (full() || clock_.cancelled() || taken[makeUp] >= options_.alike) {
                continue;
            }
            if (auto proposal = confirmed(elements, held, *set)) {
                advice_.proposals.push_back(std::move(*proposal));
                ++taken[makeUp];
            }
        }
    }

    std::optional<Proposal> confirmed(const std::vector<ChangeableElement>& elements,
                                      const std::vector<JointChange>& held,
                                      const ExactSet& set) const {
        Proposal proposal;
        proposal.changes = held;
        for (std::size_t i = 0; i < elements.size(); ++i) {
            if (set.choice[i] >= 0) {
                proposal.changes.push_back(
                    elements[i].changes[static_cast<std::size_t>(set.choice[i])]);
            }
        }
        std::stable_sort(proposal.changes.begin(), proposal.changes.end(),
                         [](const JointChange& a, const JointChange& b) {
                             return std::pair(a.wheel, a.joint) < std::pair(b.wheel, b.joint);
                         });
        for (const JointChange& change : proposal.changes) {
            proposal.changed += static_cast<int>(change.copies.size());
            proposal.cost += change.cost;
        }
        proposal.margin = set.margin;
        auto report = confirm(proposal);
        if (!report) {
            return std::nullopt;
        }
        proposal.report = std::move(*report);
        return proposal;
    }

    /// The second route: the relaxed model as the project would have it, through the analysis.
    std::optional<Report> confirm(const Proposal& proposal) const {
        const auto changed = withRelaxation(project_, proposal);
        const auto mechanism = changed ? project::resolve(*changed) : Result(built_);
        if (!changed || !mechanism) {
            return std::nullopt;
        }
        Report report = analyse(*mechanism, Model::Relaxed, pose_.stance);
        if (report.redundant != 0 || report.mobility != pose_.report.mobility ||
            report.idle.size() > pose_.report.idle.size() ||
            !sameWantedMotions(built_, constraintJacobian(built_, Model::Built, pose_.stance),
                               constraintJacobian(*mechanism, Model::Relaxed, pose_.stance))) {
            return std::nullopt;
        }
        const MovedPose moved = movedPose(*mechanism, Model::Relaxed, pose_.stance);
        if (moved.redundant != 0 || moved.mobility != report.mobility) {
            return std::nullopt;
        }
        return report;
    }

    void finish() {
        const int least = advice_.proposals.empty() ? 0 : advice_.proposals.front().cost;
        for (Proposal& proposal : advice_.proposals) {
            const std::string summary = summaryOf(proposal.changes);
            proposal.why =
                proposal.cost == least
                    ? Text::of("{} joints change: {}; {} points, the least", proposal.changed,
                               summary, proposal.cost)
                    : Text::of("{} joints change: {}; {} points, {} more than the least",
                               proposal.changed, summary, proposal.cost, proposal.cost - least);
        }
    }

    const project::Project& project_;
    const AdvisorOptions& options_;
    Clock clock_;
    mechanism::Mechanism built_;
    mechanism::Mechanism base_;  ///< as built but for idle freedoms that are held
    SearchedPose pose_;          ///< of base_
    Advice advice_;
};

}  // namespace

int costOf(JointType type) {
    switch (type) {
        case JointType::SidewaysContact:
            return 1;
        case JointType::Ball:
        case JointType::Cylindrical:
            return 2;
        case JointType::Universal:
            return 3;
        case JointType::BallWithSlide:
            return 5;
    }
    return 0;
}

int costOfOneSide(JointType type) {
    return type == JointType::SidewaysContact ? 1 : 3;
}

std::string toString(JointType type) {
    switch (type) {
        case JointType::SidewaysContact:
            return Text::of("contact free sideways");
        case JointType::Ball:
            return Text::of("ball");
        case JointType::Cylindrical:
            return Text::of("cylindrical");
        case JointType::Universal:
            return Text::of("universal");
        case JointType::BallWithSlide:
            return Text::of("ball with slide");
    }
    return "";
}

Result<Advice> advise(const project::Project& project, const AdvisorOptions& options,
                      const std::stop_token& stop) {
    if (options.proposals < 1 || options.alike < 1 || !(options.seconds >= 0.0)) {
        throw std::invalid_argument("the Advisor needs at least one proposal, and a time limit");
    }
    return Advisor(project, options, stop).run();
}

Result<project::Project> withRelaxation(const project::Project& project, const Proposal& proposal) {
    project::Project changed = project;
    for (project::Joint& joint : changed.rover.joints) {
        joint.relaxed.clear();
        joint.relaxedSides = project::Sides::Both;
    }
    for (project::Wheel& wheel : changed.rover.wheels) {
        wheel.relaxedLateral = false;
        wheel.relaxedSides = project::Sides::Both;
    }
    Problems problems;
    const auto missing = [&](const std::string& element) {
        problems.push_back({Severity::Critical, element,
                            Text::of("the proposal changes it, but the project has it no longer."),
                            Text::of("Ask for advice again.")});
    };
    for (const JointChange& change : proposal.changes) {
        if (change.wheel >= 0) {
            const auto index = static_cast<std::size_t>(change.wheel);
            if (index >= changed.rover.wheels.size() ||
                contactOf(changed.rover.wheels[index].name) != change.element) {
                missing(change.element);
                continue;
            }
            changed.rover.wheels[index].relaxedLateral = true;
            changed.rover.wheels[index].relaxedSides = change.sides;
        } else {
            const auto index = static_cast<std::size_t>(change.joint);
            if (index >= changed.rover.joints.size() ||
                changed.rover.joints[index].name != change.element) {
                missing(Text::of("joint {}", change.element));
                continue;
            }
            changed.rover.joints[index].relaxed = change.relaxed;
            changed.rover.joints[index].relaxedSides = change.sides;
        }
    }
    if (!problems.empty()) {
        return problems;
    }
    return changed;
}

std::string describe(const Advice& advice) {
    if (advice.alreadyExact) {
        return Text::of(
            "Exact as built: nothing is redundant and nothing idle. No joint needs to change.");
    }
    const int redundant = advice.built.redundant;
    const std::string constraints = redundant == 1
                                        ? Text::of("1 constraint is redundant")
                                        : Text::of("{} constraints are redundant", redundant);
    const std::size_t idle = advice.built.idle.size();
    std::string text = idle == 0 ? Text::of("As built, {}.", constraints)
                       : idle == 1
                           ? Text::of("As built, {} and 1 freedom is idle.", constraints)
                           : Text::of("As built, {} and {} freedoms are idle.", constraints, idle);
    const auto add = [&](const std::string& sentence) { text += " " + sentence; };
    const std::size_t count = advice.proposals.size();
    if (count == 0) {
        add(advice.end == AdviceEnd::Complete
                ? Text::of(
                      "No set of permitted joints makes it exact and leaves its motion as it is.")
                : Text::of("None was found until then."));
    } else {
        add(count == 1
                ? Text::of(
                      "Found one set of joints that makes it exact and leaves its motion as it is.")
                : Text::of(
                      "Found {} sets of joints that make it exact and leave its motion as it is.",
                      count));
    }
    switch (advice.end) {
        case AdviceEnd::Complete:
            if (count > 0) {
                add(Text::of("None that was left out costs less than the last one."));
            }
            break;
        case AdviceEnd::TimeUp:
            add(Text::of("The search was cut short by its time limit."));
            break;
        case AdviceEnd::Cancelled:
            add(Text::of("The search was cancelled."));
            break;
    }
    return text;
}

}  // namespace simcore::mobility
