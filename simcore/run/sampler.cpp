#include "simcore/run/sampler.h"

#include <cmath>
#include <iterator>

#include "simcore/run/channels.h"
#include "simcore/run/run_worker.h"

namespace simcore::run {
namespace {

/// Which period an instant lies in; an instant that round-off leaves just before a boundary counts
/// as on it.
long periodIndex(double time, double period) {
    return static_cast<long>(std::floor(time / period + 1e-6));
}

template <class T>
void append(std::vector<T>& from, std::vector<T>& to) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
    from.clear();
}

}  // namespace

void Sampler::start(const Snapshot& snapshot) {
    rows_.clear();
    frames_.clear();
    takeRow(snapshot);
    takeFrame(snapshot);
}

void Sampler::take(const Snapshot& snapshot) {
    if (periodIndex(snapshot.time, kRowPeriod) > rowIndex_) {
        takeRow(snapshot);
    }
    if (periodIndex(snapshot.time, kFramePeriod) > frameIndex_) {
        takeFrame(snapshot);
    }
}

void Sampler::finish(const Snapshot& snapshot) {
    if (snapshot.time > rowTime_) {
        takeRow(snapshot);
    }
    if (snapshot.time > frameTime_) {
        takeFrame(snapshot);
    }
}

void Sampler::takeRow(const Snapshot& snapshot) {
    rowIndex_ = periodIndex(snapshot.time, kRowPeriod);
    rowTime_ = snapshot.time;
    sampleChannels(mechanism_, snapshot, rows_.emplace_back());
}

void Sampler::takeFrame(const Snapshot& snapshot) {
    frameIndex_ = periodIndex(snapshot.time, kFramePeriod);
    frameTime_ = snapshot.time;
    frames_.push_back(std::make_shared<const Snapshot>(snapshot));
}

void Sampler::moveTo(std::vector<std::vector<double>>& rows,
                     std::vector<std::shared_ptr<const Snapshot>>& frames) {
    append(rows_, rows);
    append(frames_, frames);
}

}  // namespace simcore::run
