#pragma once

#include <string>
#include <vector>

#include "simcore/mechanism/mechanism.h"
#include "simcore/run/snapshot.h"

namespace simcore::run {

/// One recorded number: what CSV columns, plots and tables share.
struct Channel {
    std::string quantity;  ///< "slip_abs", "torque_applied", ...
    std::string object;    ///< wheel name, "chassis", or empty for time
    std::string label;     ///< for people: "Slip (absolute)"
    std::string unit;      ///< ASCII: "m", "N*m", "rad/s", "-"
    std::string meaning;   ///< one sentence
    /// CSV column head: `quantity_object [unit]`, or `time [s]`.
    std::string column() const;
};

/// All channels of a rover: time, chassis, then every wheel in file order.
std::vector<Channel> makeChannels(const mechanism::Mechanism& mechanism);

/// The values of all channels at one instant, in the order of makeChannels(). `chassis` is
/// Mechanism::chassis.
void sampleChannels(const Snapshot& snapshot, std::vector<double>& row, int chassis = 0);

/// Position of a channel in makeChannels(), -1 when there is none.
int findChannel(const std::vector<Channel>& channels, const std::string& quantity,
                const std::string& object);

}  // namespace simcore::run
