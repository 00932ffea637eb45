#pragma once

#include <QIcon>

class QPalette;

namespace widgets {

enum class RunIcon { Play, Pause, Step, Reset };

/// A transport symbol drawn in the palette's text colour, so that it suits light and dark windows.
QIcon runIcon(RunIcon icon, const QPalette& palette);

}  // namespace widgets
