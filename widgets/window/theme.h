#pragma once

#include <QString>

class QApplication;

namespace widgets {

enum class Theme { Light, Dark };

/// Colours and style of the whole program.
void applyTheme(QApplication& application, Theme theme);

}  // namespace widgets
