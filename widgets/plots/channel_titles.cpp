#include "widgets/plots/channel_titles.h"

#include <QCoreApplication>
#include <array>

namespace widgets {

namespace {

/// The names that simcore has for the channels of plots, for the translators' tools to find.
[[maybe_unused]] constexpr std::array kTitles{
    QT_TRANSLATE_NOOP("channels", "Position x"),
    QT_TRANSLATE_NOOP("channels", "Position y"),
    QT_TRANSLATE_NOOP("channels", "Position z"),
    QT_TRANSLATE_NOOP("channels", "Roll"),
    QT_TRANSLATE_NOOP("channels", "Pitch"),
    QT_TRANSLATE_NOOP("channels", "Yaw"),
    QT_TRANSLATE_NOOP("channels", "Speed"),
    QT_TRANSLATE_NOOP("channels", "Distance"),
    QT_TRANSLATE_NOOP("channels", "Angular rate x"),
    QT_TRANSLATE_NOOP("channels", "Angular rate y"),
    QT_TRANSLATE_NOOP("channels", "Angular rate z"),
    QT_TRANSLATE_NOOP("channels", "Centre of mass x"),
    QT_TRANSLATE_NOOP("channels", "Centre of mass y"),
    QT_TRANSLATE_NOOP("channels", "Centre of mass z"),
    QT_TRANSLATE_NOOP("channels", "Speed (measured)"),
    QT_TRANSLATE_NOOP("channels", "Roll (measured)"),
    QT_TRANSLATE_NOOP("channels", "Pitch (measured)"),
    QT_TRANSLATE_NOOP("channels", "Angular rate x (measured)"),
    QT_TRANSLATE_NOOP("channels", "Angular rate y (measured)"),
    QT_TRANSLATE_NOOP("channels", "Angular rate z (measured)"),
    QT_TRANSLATE_NOOP("channels", "Acceleration x (measured)"),
    QT_TRANSLATE_NOOP("channels", "Acceleration y (measured)"),
    QT_TRANSLATE_NOOP("channels", "Acceleration z (measured)"),
    QT_TRANSLATE_NOOP("channels", "Torque of the speed loop"),
    QT_TRANSLATE_NOOP("channels", "Required friction (planned)"),
    QT_TRANSLATE_NOOP("channels", "Friction trusted"),
    QT_TRANSLATE_NOOP("channels", "Slip (absolute)"),
    QT_TRANSLATE_NOOP("channels", "Slip (loaded)"),
    QT_TRANSLATE_NOOP("channels", "Slip (signed)"),
    QT_TRANSLATE_NOOP("channels", "Slip ratio"),
    QT_TRANSLATE_NOOP("channels", "Slip (lateral)"),
    QT_TRANSLATE_NOOP("channels", "Friction work"),
    QT_TRANSLATE_NOOP("channels", "Torque (commanded)"),
    QT_TRANSLATE_NOOP("channels", "Torque (applied)"),
    QT_TRANSLATE_NOOP("channels", "Power"),
    QT_TRANSLATE_NOOP("channels", "Normal force"),
    QT_TRANSLATE_NOOP("channels", "Traction force"),
    QT_TRANSLATE_NOOP("channels", "Lateral force"),
    QT_TRANSLATE_NOOP("channels", "Contact force x"),
    QT_TRANSLATE_NOOP("channels", "Contact force y"),
    QT_TRANSLATE_NOOP("channels", "Contact force z"),
    QT_TRANSLATE_NOOP("channels", "Contact angle"),
    QT_TRANSLATE_NOOP("channels", "Penetration"),
    QT_TRANSLATE_NOOP("channels", "Wheel rate"),
    QT_TRANSLATE_NOOP("channels", "Wheel speed"),
    QT_TRANSLATE_NOOP("channels", "Wheel rate (measured)"),
    QT_TRANSLATE_NOOP("channels", "Normal force (measured)"),
    QT_TRANSLATE_NOOP("channels", "Contact angle (measured)"),
    QT_TRANSLATE_NOOP("channels", "Torque (planned)"),
    QT_TRANSLATE_NOOP("channels", "Normal force (planned)"),
    QT_TRANSLATE_NOOP("channels", "Wheel rate (planned)"),
};

}  // namespace

QString channelTitle(const std::string& label) {
    return QCoreApplication::translate("channels", label.c_str());
}

}  // namespace widgets
