#include "widgets/session/run_library.h"

#include <algorithm>
#include <utility>

#include "widgets/session/run_titles.h"

namespace widgets {

int RunLibrary::find(int id) const {
    const auto found =
        std::find_if(runs_.begin(), runs_.end(), [id](const HeldRun& run) { return run.id == id; });
    return found == runs_.end() ? -1 : static_cast<int>(std::distance(runs_.begin(), found));
}

int RunLibrary::freeStyle() const {
    for (int style = 1; style < kStyles; ++style) {
        if (std::none_of(runs_.begin(), runs_.end(),
                         [style](const HeldRun& run) { return run.style == style; })) {
            return style;
        }
    }
    return kStyles;
}

int RunLibrary::keep(const RunSession& shown, const simcore::project::Project& project) {
    if (!shown.hasRun()) {
        return 0;
    }
    auto copy = std::make_unique<RunSession>();
    copy->show(shown.freeze());
    return hold(std::move(copy), shown.isStale() ? std::nullopt : std::optional(project));
}

int RunLibrary::hold(std::unique_ptr<RunSession> session,
                     std::optional<simcore::project::Project> project) {
    if (isFull()) {
        remove(runs_.front().id);
    }
    HeldRun run;
    run.id = ++lastId_;
    run.style = freeStyle();
    run.name = runTitle(session->settings());
    run.stale = !project.has_value();
    run.project = std::move(project);
    run.session = std::move(session);
    connect(run.session.get(), &RunSession::dataAppended, this, &RunLibrary::dataChanged);
    connect(run.session.get(), &RunSession::dataReplaced, this, &RunLibrary::dataChanged);
    runs_.push_back(std::move(run));
    emit changed();
    return lastId_;
}

int RunLibrary::hold(RecordedRun recorded, const simcore::project::Project& project) {
    simcore::project::Project own = recorded.project;
    auto session = std::make_unique<RunSession>();
    session->show(std::move(recorded));
    const int id = hold(std::move(session), std::move(own));
    setProject(project);
    return id;
}

void RunLibrary::remove(int id) {
    const int index = find(id);
    if (index < 0) {
        return;
    }
    // Gone from the list before it dies: its signals must find it nowhere.
    const HeldRun gone = std::move(runs_[static_cast<std::size_t>(index)]);
    runs_.erase(runs_.begin() + index);
    if (ghost_ == id) {
        ghost_ = 0;
    }
    emit changed();
}

void RunLibrary::clear() {
    if (runs_.empty()) {
        return;
    }
    const std::vector<HeldRun> gone = std::exchange(runs_, {});
    ghost_ = 0;
    emit changed();
}

void RunLibrary::setCurves(int id, bool on) {
    const int index = find(id);
    if (index >= 0 && runs_[static_cast<std::size_t>(index)].curves != on) {
        runs_[static_cast<std::size_t>(index)].curves = on;
        emit changed();
    }
}

void RunLibrary::setGhost(int id) {
    const int ghost = find(id) >= 0 ? id : 0;
    if (ghost_ != ghost) {
        ghost_ = ghost;
        emit changed();
    }
}

const RunSession* RunLibrary::ghostRun() const {
    const int index = find(ghost_);
    return index < 0 ? nullptr : runs_[static_cast<std::size_t>(index)].session.get();
}

void RunLibrary::setProject(const simcore::project::Project& project) {
    bool any = false;
    for (HeldRun& run : runs_) {
        const bool stale = !run.project || *run.project != project;
        any = any || stale != run.stale;
        run.stale = stale;
    }
    if (any) {
        emit changed();
    }
}

}  // namespace widgets
