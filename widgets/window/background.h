#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace widgets {

/// Asked with the part that is done [0 to 1] while work goes on, on the work's thread; false: stop.
using GoOn = std::function<bool(double)>;

/// Does `work` in a thread of its own and returns when it has returned. Meanwhile the window is
/// alive but takes no input; after a moment a dialog shows `what` is going on, how far it is, and
/// stops it when asked to. What `work` throws comes out here.
void workInBackground(QWidget* window, const QString& what,
                      const std::function<void(const GoOn&)>& work);

}  // namespace widgets
