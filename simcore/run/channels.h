#pragma once

#include <string>
#include <vector>

#include "simcore/mechanism/mechanism.h"
#include "simcore/run/snapshot.h"

namespace simcore::run {

/// What a channel is about.
enum class ChannelGroup { Time, Chassis, Wheel, Joint };

/// How a number could be known on a real rover.
enum class ChannelSource {
    Known,     ///< without a sensor: the clock, commands and motor currents
    Measured,  ///< by a sensor, with its errors: what the controller reads
    Oracle,    ///< by the simulation only: the truth
};

/// "time", "chassis", "wheel", "joint".
std::string toString(ChannelGroup group);
/// "known", "measured", "oracle".
std::string toString(ChannelSource source);

/// One recorded number: what CSV columns, plots and recordings share.
struct Channel {
    std::string quantity;  ///< "slip_abs", "torque_applied", ...
    std::string object;    ///< wheel or joint name, "chassis", or empty for time
    std::string label;     ///< for people: "Slip (absolute)"
    std::string symbol;    ///< as docs/notation.md writes it: "N", "τ"
    std::string unit;      ///< ASCII: "m", "N*m", "rad/s", "-"
    std::string meaning;   ///< one sentence
    ChannelGroup group = ChannelGroup::Time;
    ChannelSource source = ChannelSource::Known;

    /// The channel's id: `quantity_object`, or `time`.
    std::string id() const;
    /// CSV column head: `quantity_object [unit]`, or `time [s]`.
    std::string column() const;
};

/// All channels of a rover: time, chassis, every wheel in file order, every joint with an encoder.
std::vector<Channel> makeChannels(const mechanism::Mechanism& mechanism);

/// The values of all channels at one instant, in the order of makeChannels(). What the snapshot
/// does not have (no look of the sensors yet) is NaN.
void sampleChannels(const mechanism::Mechanism& mechanism, const Snapshot& snapshot,
                    std::vector<double>& row);

/// Position of a channel in makeChannels(), -1 when there is none.
int findChannel(const std::vector<Channel>& channels, const std::string& quantity,
                const std::string& object);

/// The channels as the table of docs/csv.md: WHEEL and JOINT stand for names.
std::string channelTable();

}  // namespace simcore::run
