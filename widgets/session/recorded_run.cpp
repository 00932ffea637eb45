#include "widgets/session/recorded_run.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "simcore/base/text.h"
#include "simcore/io/project_file.h"
#include "simcore/io/replay.h"

namespace widgets {

using simcore::Problem;
using simcore::Problems;
using simcore::Severity;
using simcore::io::RecordingReader;

namespace {

/// Channels to those of this version: one to come may have more of them, not any number.
constexpr std::size_t kMostChannels = 4;

/// Everything about the run but its numbers.
Problems readRun(RecordingReader& reader, RecordedRun& run) {
    const auto& header = reader.header();
    const auto project =
        simcore::io::parseProject(header.projectText, simcore::Text::of("the recorded project"));
    if (!project) {
        return project.problems();
    }
    auto requested = simcore::run::asRequested(*project, header.request);
    if (!requested) {
        return requested.problems();
    }
    run.project = std::move(requested).value();
    run.request = header.request;
    Problems problems;
    auto prepared = simcore::io::prepareRecorded(reader);
    if (!prepared) {
        // The run can be looked at without its ground.
        const Problems& all = prepared.problems();
        const auto why = std::find_if(all.begin(), all.end(), [](const Problem& problem) {
            return problem.severity == Severity::Critical;
        });
        problems.push_back({Severity::Warning, run.file.string(),
                            simcore::Text::of("the ground cannot be shown: {}", why->reason),
                            why->remedy});
        prepared = simcore::run::evaluateRun(*project, header.request);
        if (!prepared) {
            return prepared.problems();
        }
    }
    auto files = reader.readFiles();
    run.request.files = files ? std::move(files).value() : simcore::project::ProjectFiles();
    run.settings = std::move(prepared).value();
    const auto& mechanism = run.settings.mechanism;
    if (header.size.bodies != mechanism.bodies.size() ||
        header.size.wheels != mechanism.wheels.size() ||
        header.size.joints != mechanism.encoderJoints().size() ||
        header.channels.size() > kMostChannels * simcore::run::makeChannels(mechanism).size()) {
        return {{Severity::Critical, run.file.string(),
                 simcore::Text::of("its numbers are of another rover than its project."),
                 simcore::Text::of(
                     "Open it with the RoverStudio version that wrote it, or take another copy.")}};
    }
    run.origin = {project->rover.name, header.projectFile, header.variant, header.parameters,
                  header.request.assignments};
    run.report = reader.report();
    run.complete = reader.complete();
    return problems;
}

/// Feeds the store in the order of time.
class NumbersReader {
  public:
    NumbersReader(RecordingReader& reader, RecordedRun& run,
                  const std::function<bool(double)>& goOn)
        : reader_(reader),
          run_(run),
          goOn_(goOn) {}

    /// The problem that ended it, if any. Stops where `goOn` says so.
    Problems readAll() {
        const std::size_t blocks = reader_.rowBlockCount();
        for (std::size_t block = 0; block < blocks; ++block) {
            part_ = static_cast<double>(block) / static_cast<double>(blocks);
            if (!mayGoOn()) {
                return {};
            }
            auto read = reader_.rowBlock(block);
            if (!read) {
                return read.problems();
            }
            rows_ = std::move(read).value();
            for (const auto& row : rows_) {
                if (!follows(row.front(), rowTime_)) {
                    return disorder();
                }
            }
            if (Problems problems = readFrames(rowTime_); !problems.empty()) {
                return problems;
            }
        }
        // An interrupted recording may have frames whose rows are lost.
        return readFrames(std::numeric_limits<double>::infinity());
    }

    bool stopped() const { return stopped_; }

  private:
    bool mayGoOn() {
        stopped_ = stopped_ || (goOn_ && !goOn_(part_));
        return !stopped_;
    }

    /// The frames up to about this time; then the store takes rows and frames.
    Problems readFrames(double until) {
        for (; frame_ < reader_.frameCount() && frameTime_ < until; ++frame_) {
            auto snapshot = reader_.frame(frame_);
            if (!snapshot) {
                return snapshot.problems();
            }
            if (!follows(snapshot->time, frameTime_)) {
                return disorder();
            }
            run_.last = std::make_shared<const simcore::run::Snapshot>(std::move(snapshot).value());
            frames_.push_back(run_.last);
            if (frames_.size() >= kFramesAtOnce) {
                run_.store.append(rows_, frames_);
                if (!mayGoOn()) {
                    return {};
                }
            }
        }
        run_.store.append(rows_, frames_);
        return {};
    }

    /// Whether this time may come after `before`, which it then becomes.
    static bool follows(double time, double& before) {
        const bool good = std::isfinite(time) && time >= before;
        before = time;
        return good;
    }

    Problems disorder() const {
        return {{Severity::Critical, run_.file.string(),
                 simcore::Text::of("its times are out of order."),
                 simcore::Text::of("Take another copy of the file if there is one.")}};
    }

    static constexpr std::size_t kFramesAtOnce = 1000;

    RecordingReader& reader_;
    RecordedRun& run_;
    const std::function<bool(double)>& goOn_;
    double part_ = 0.0;
    bool stopped_ = false;
    std::vector<std::vector<double>> rows_;
    std::vector<std::shared_ptr<const simcore::run::Snapshot>> frames_;
    double rowTime_ = 0.0, frameTime_ = 0.0;
    std::size_t frame_ = 0;
};

using Loaded = simcore::Result<std::shared_ptr<RecordedRun>>;

Loaded load(const std::filesystem::path& file, const std::function<bool(double)>& goOn,
            RecordingStore store) {
    auto opened = RecordingReader::open(file, [&goOn] { return !goOn || goOn(0.0); });
    if (!opened) {
        return opened.problems();
    }
    if (*opened == nullptr) {
        return std::shared_ptr<RecordedRun>();
    }
    RecordingReader& reader = **opened;
    auto run = std::make_shared<RecordedRun>();
    run->file = file;
    run->store = std::move(store);
    Problems problems = opened.problems();
    appendNew(problems, readRun(reader, *run));
    if (hasCritical(problems)) {
        return problems;
    }
    run->store.start(reader.header().channels);
    NumbersReader numbers(reader, *run, goOn);
    Problems ended = numbers.readAll();
    if (numbers.stopped()) {
        return std::shared_ptr<RecordedRun>();
    }
    if (!run->last) {
        ended.push_back({Severity::Critical, file.string(),
                         simcore::Text::of("there is nothing of its run in it."),
                         simcore::Text::of("Take another copy of the file if there is one.")});
        appendNew(problems, ended);
        return problems;
    }
    for (Problem& problem : ended) {
        // What came before is whole.
        problem.severity = Severity::Warning;
        run->complete = false;
    }
    appendNew(problems, ended);
    return Loaded(std::move(run), std::move(problems));
}

}  // namespace

simcore::Result<std::shared_ptr<RecordedRun>> loadRecording(const std::filesystem::path& file,
                                                            const std::function<bool(double)>& goOn,
                                                            RecordingStore store) {
    try {
        return load(file, goOn, std::move(store));
    } catch (const std::exception& error) {
        return Problem{Severity::Critical, file.string(),
                       simcore::Text::of("it cannot be read ({}).", error.what()),
                       simcore::Text::of("Close other programs if there is no memory left.")};
    }
}

}  // namespace widgets
