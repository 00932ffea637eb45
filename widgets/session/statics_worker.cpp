#include "widgets/session/statics_worker.h"

#include <chrono>
#include <exception>
#include <utility>

#include "simcore/base/text.h"

namespace widgets {

using simcore::statics::Place;
using simcore::statics::PoseSolver;
using simcore::statics::Standing;
using simcore::statics::StandingPose;
using simcore::statics::StaticModel;
using simcore::statics::TraverseEnd;
using simcore::statics::TraverseRequest;
using simcore::statics::TraverseSample;

namespace {

using Clock = std::chrono::steady_clock;

/// The way so far is published after this time, then ever more rarely: it is copied whole.
constexpr Clock::duration kFirstPart = std::chrono::milliseconds(500);

/// Near the earlier pose where the rover still has as many coordinates, else from above.
StandingPose standNear(PoseSolver& solver, const std::optional<TraverseSample>& near) {
    if (!near) {
        return solver.settle({});
    }
    const auto chassis = static_cast<std::size_t>(solver.mechanism().chassis);
    const simcore::dynamics::TreeState drawn = solver.model().reset();
    const simcore::dynamics::TreeState& earlier = near->pose.state;
    if (chassis >= near->pose.bodies.size()) {
        return solver.settle({});
    }
    const simcore::Vec3& at = near->pose.bodies[chassis].position;
    const Place place{at.x(), at.y(), 0.0};
    StandingPose pose;
    if (earlier.coordinates.size() == drawn.coordinates.size() &&
        earlier.balls.size() == drawn.balls.size()) {
        pose = solver.settleFrom(earlier, place);
    }
    return pose.standing == Standing::Stands ? pose : solver.settle(place);
}

/// Nothing where the rover does not stand.
std::optional<TraverseSample> lookNear(PoseSolver& solver,
                                       const std::optional<TraverseSample>& near, bool backwards) {
    TraverseSample sample;
    sample.pose = standNear(solver, near);
    if (sample.pose.standing != Standing::Stands) {
        return std::nullopt;
    }
    if (near) {
        sample.way = near->way;
        sample.distance = near->distance;
        sample.climbs = near->climbs;
    }
    sample.study = studyPose(solver.model(), sample.pose, std::nullopt, backwards, false);
    return sample;
}

}  // namespace

StaticsWorker::StaticsWorker(Publish publish)
    : publish_(std::move(publish)),
      thread_([this] { loop(); }) {}

StaticsWorker::~StaticsWorker() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        givenUp_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void StaticsWorker::start(StaticsTask task) {
    {
        const std::lock_guard lock(mutex_);
        next_ = std::move(task);
        givenUp_ = true;
    }
    wake_.notify_one();
}

void StaticsWorker::cancel() {
    const std::lock_guard lock(mutex_);
    next_.reset();
    givenUp_ = true;
}

void StaticsWorker::loop() {
    while (true) {
        StaticsTask task;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return ending_ || next_; });
            if (ending_) {
                return;
            }
            task = std::move(*next_);
            next_.reset();
            givenUp_ = false;
        }
        try {
            study(task);
        } catch (const std::exception& error) {
            auto failed = std::make_shared<StaticsFindings>();
            failed->number = task.number;
            failed->problems.push_back(
                {simcore::Severity::Critical,
                 simcore::Text::of("scenario {}", task.request.scenario), error.what(),
                 simcore::Text::of("Check the rover's masses, joints and wheels.")});
            publish_(std::move(failed));
        }
    }
}

void StaticsWorker::study(const StaticsTask& task) {
    StaticsFindings findings;
    findings.number = task.number;
    auto run = simcore::run::prepareRun(task.project, task.request);
    findings.problems = run.problems();
    if (!run) {
        publish_(std::make_shared<StaticsFindings>(std::move(findings)));
        return;
    }
    findings.run = std::make_shared<const simcore::run::ResolvedRun>(std::move(run).value());
    StaticModel model(findings.run->mechanism, findings.run->joints);
    PoseSolver solver(model, *findings.run->terrain);
    if (givenUp_) {
        return;
    }
    if (auto first = lookNear(solver, task.near, findings.rollsBack())) {
        auto look = std::make_shared<StaticsFindings>(findings);
        look->traverse.samples.push_back(std::move(*first));
        publish_(std::move(look));
    }
    follow(solver, std::move(findings));
}

void StaticsWorker::follow(PoseSolver& solver, StaticsFindings findings) {
    TraverseRequest request;
    request.distance = findings.run->distance;
    request.backwards = findings.rollsBack();
    StaticsFindings part = findings;
    part.stage = StaticsFindings::Stage::Part;
    part.traverse.end = TraverseEnd::Stopped;
    const Clock::time_point start = Clock::now();
    Clock::duration due = kFirstPart;
    findings.traverse = traverse(solver, request, [&](const TraverseSample& sample) {
        part.traverse.samples.push_back(sample);
        if (Clock::now() - start >= due && !givenUp_) {
            publish_(std::make_shared<StaticsFindings>(part));
            due += due / 2;
        }
        return !givenUp_;
    });
    findings.stage = StaticsFindings::Stage::Whole;
    if (!givenUp_) {
        publish_(std::make_shared<StaticsFindings>(std::move(findings)));
    }
}

}  // namespace widgets
