#include "widgets/session/recording_store.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace widgets {
namespace {

/// Drops every second entry; the first stays.
template <class T>
void halve(std::vector<T>& list) {
    // The first is not moved onto itself, which would empty it.
    std::size_t kept = 1;
    for (std::size_t i = 2; i < list.size(); i += 2) {
        list[kept++] = std::move(list[i]);
    }
    list.resize(kept);
}

}  // namespace

RecordingStore::RecordingStore(std::size_t rowLimit, std::size_t frameLimit) {
    rowSieve_.limit = rowLimit;
    frameSieve_.limit = frameLimit;
}

void RecordingStore::start(std::vector<simcore::run::Channel> channels) {
    clearData();
    recording_.channels = std::move(channels);
}

void RecordingStore::clearData() {
    recording_.rows.clear();
    recording_.frames.clear();
    for (Sieve* sieve : {&rowSieve_, &frameSieve_}) {
        sieve->stride = 1;
        sieve->seen = 0;
    }
}

template <class T>
RecordingStore::Change RecordingStore::take(std::vector<T>& from, std::vector<T>& to,
                                            Sieve& sieve) {
    Change change = Change::None;
    for (T& entry : from) {
        if (sieve.seen++ % sieve.stride != 0) {
            continue;
        }
        to.push_back(std::move(entry));
        change = std::max(change, Change::Appended);
        if (to.size() > sieve.limit) {
            halve(to);
            sieve.stride *= 2;
            change = Change::Thinned;
        }
    }
    from.clear();
    return change;
}

RecordingStore::Change RecordingStore::drain(simcore::run::RunWorker& worker) {
    worker.drain(newRows_, newFrames_);
    return append(newRows_, newFrames_);
}

RecordingStore::Change RecordingStore::append(
    std::vector<std::vector<double>>& rows,
    std::vector<std::shared_ptr<const simcore::run::Snapshot>>& frames) {
    const Change change = take(rows, recording_.rows, rowSieve_);
    const bool moreFrames = take(frames, recording_.frames, frameSieve_) != Change::None;
    return change == Change::None && moreFrames ? Change::Appended : change;
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
