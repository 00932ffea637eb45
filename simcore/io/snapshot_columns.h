#pragma once

#include <string>
#include <vector>

#include "simcore/run/snapshot.h"

namespace simcore::io {

/// How many of everything a run's snapshots have.
struct SnapshotSize {
    std::size_t bodies = 0, wheels = 0, joints = 0;
    bool operator==(const SnapshotSize&) const = default;
};

/// Names of the numbers of a snapshot, e.g. "body/3/z", "wheel/0/power", in a fixed order.
std::vector<std::string> snapshotColumns(const SnapshotSize& size);

/// The numbers of a snapshot in the order of snapshotColumns().
std::vector<double> toNumbers(const run::Snapshot& snapshot);

/// The snapshot again; `positions` says where in `numbers` each of snapshotColumns() is, -1 where
/// it is not (a file of another version): such a number stays at its default.
run::Snapshot snapshotFromNumbers(const SnapshotSize& size, const std::vector<int>& positions,
                                  const std::vector<double>& numbers);

}  // namespace simcore::io
