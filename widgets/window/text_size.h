#pragma once

class QApplication;

namespace widgets {

/// Text sizes that can be chosen [% of the system's], in rising order: 80 to 200.
inline constexpr int kTextSizes[] = {80, 90, 100, 110, 125, 150, 175, 200};

/// The next larger (`steps` > 0) or smaller size than `percent`, at most as many steps as there
/// are.
int steppedTextSize(int percent, int steps);

/// Gives all widgets text of this part of the system's size [%]. What is no size that can be chosen
/// becomes the nearest one.
/// @returns the size that it is now.
int applyTextSize(QApplication& application, int percent);

}  // namespace widgets
