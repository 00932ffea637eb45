#include "widgets/session/recording_store.h"

#include <algorithm>
#include <iterator>

namespace widgets {
namespace {

template <class T>
void moveBehind(std::vector<T>& from, std::vector<T>& to) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
    from.clear();
}

/// Drops every second entry; the first stays.
template <class T>
void halve(std::vector<T>& list) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < list.size(); i += 2) {
        list[kept++] = std::move(list[i]);
    }
    list.resize(kept);
}

}  // namespace

RecordingStore::RecordingStore(std::size_t rowLimit, std::size_t frameLimit)
    : rowLimit_(rowLimit),
      frameLimit_(frameLimit) {}

void RecordingStore::start(const simcore::mechanism::Mechanism& mechanism) {
    clearData();
    recording_.channels = simcore::run::makeChannels(mechanism);
}

void RecordingStore::clearData() {
    recording_.rows.clear();
    recording_.frames.clear();
}

RecordingStore::Change RecordingStore::drain(simcore::run::RunWorker& worker) {
    worker.drain(newRows_, newFrames_);
    if (newRows_.empty() && newFrames_.empty()) {
        return Change::None;
    }
    moveBehind(newRows_, recording_.rows);
    moveBehind(newFrames_, recording_.frames);
    Change change = Change::Appended;
    while (recording_.rows.size() > rowLimit_) {
        halve(recording_.rows);
        change = Change::Thinned;
    }
    while (recording_.frames.size() > frameLimit_) {
        halve(recording_.frames);
    }
    return change;
}

int RecordingStore::indexNear(double time) const {
    const auto& frames = recording_.frames;
    if (frames.empty()) {
        return -1;
    }
    const auto after = std::lower_bound(frames.begin(), frames.end(), time,
                                        [](const auto& f, double t) { return f->time < t; });
    if (after == frames.end()) {
        return static_cast<int>(frames.size()) - 1;
    }
    if (after == frames.begin()) {
        return 0;
    }
    const bool previous = time - (*std::prev(after))->time <= (*after)->time - time;
    return static_cast<int>(std::distance(frames.begin(), previous ? std::prev(after) : after));
}

std::shared_ptr<const simcore::run::Snapshot> RecordingStore::frameNear(double time) const {
    const int index = indexNear(time);
    return index < 0 ? nullptr : recording_.frames[static_cast<std::size_t>(index)];
}

}  // namespace widgets
