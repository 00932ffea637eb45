#include "simcore/run/drive_script.h"

#include <cmath>
#include <locale>
#include <sstream>

#include "simcore/base/text.h"

namespace simcore::run {
namespace {

/// Beyond these no rover drives; typing errors [m/s], [rad/s].
constexpr double kFastest = 10.0;

}  // namespace

Result<DriveScript> parseDriveScript(std::string_view text) {
    DriveScript script;
    std::istringstream entries{std::string(text)};
    std::string entry;
    while (std::getline(entries, entry, ';')) {
        std::istringstream words(entry);
        words.imbue(std::locale::classic());
        ScriptedCommand next;
        char comma = 0;
        char second = 0;
        const auto complain = [&](std::string reason) {
            return Problem{
                Severity::Critical, Text::of("drive entry {}", script.size() + 1),
                std::move(reason),
                Text::of("Write TIME,SPEED,TURN in s, m/s and rad/s, with ; between entries.")};
        };
        if (!(words >> next.time >> comma >> next.command.speed >> second >> next.command.turn) ||
            comma != ',' || second != ',' || !(words >> std::ws).eof()) {
            return complain(Text::of("'{}' is not understood.", entry));
        }
        if (!(next.time >= 0.0) || (!script.empty() && !(next.time > script.back().time))) {
            return complain(Text::of("its time {:.6g} is not after the one before.", next.time));
        }
        if (!(std::abs(next.command.speed) <= kFastest &&
              std::abs(next.command.turn) <= kFastest)) {
            return complain(Text::of("speed {:.6g} or turn {:.6g} is above {:.0f}.",
                                     next.command.speed, next.command.turn, kFastest));
        }
        script.push_back(next);
    }
    if (script.empty()) {
        return Problem{
            Severity::Critical, Text::of("drive"), Text::of("it has no entries."),
            Text::of("Write TIME,SPEED,TURN in s, m/s and rad/s, with ; between entries.")};
    }
    return script;
}

ManualCommand commandAt(const DriveScript& script, double time) {
    ManualCommand command;
    for (const ScriptedCommand& entry : script) {
        if (entry.time > time) {
            break;
        }
        command = entry.command;
    }
    return command;
}

}  // namespace simcore::run
