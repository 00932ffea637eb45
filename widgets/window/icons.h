#pragma once

#include <QIcon>

class QPalette;

namespace widgets {

enum class Icon { New, Open, Save, Undo, Redo, Back, Forward };

/// A line drawing in the palette's text colour, so that it suits light and dark windows.
QIcon lineIcon(Icon icon, const QPalette& palette);

}  // namespace widgets
