#pragma once

class QString;
class QWidget;

namespace widgets {

/// Whether a file of this name may be written: there is none, or the user said yes. For names that
/// no file dialog has asked about.
bool mayReplace(QWidget* window, const QString& file);

}  // namespace widgets
