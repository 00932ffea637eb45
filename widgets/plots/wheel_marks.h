#pragma once

#include <QIcon>
#include <QPainterPath>
#include <QPixmap>
#include <QString>
#include <string>
#include <vector>

class QPainter;

/// What tells the wheels of a rover apart beside their colours, for whoever sees these alike and in
/// print without colour. The line's style is left to tell runs apart.
namespace widgets {

/// Sign on the curve of a wheel. Both wheels of a pair have the same shape.
struct WheelMark {
    int shape = 0;        ///< kinds of axles in the order of the wheels
    bool hollow = false;  ///< the right wheel of a pair
    bool operator==(const WheelMark&) const = default;
};

/// Marks of the wheels with these names: "rear_left" and "rear_right" are a pair, as
/// "bogie_left_front" and "bogie_right_front" are.
std::vector<WheelMark> wheelMarks(const std::vector<std::string>& names);

/// Outline around (0, 0), about `size` across [pixel].
QPainterPath markOutline(int shape, double size);

/// Colour of the wheel at this place: that of its ring in the 3-D view.
QColor wheelCurveColor(int wheel);

/// Width of a sample beside a name [pixel].
inline constexpr int kWheelSampleWidth = 22;

/// A piece of the wheel's curve: a line with its mark, from `place` (left end, middle) on. Hollow
/// marks are filled with `paper`.
void paintWheelSample(QPainter& painter, const QPointF& place, double width, int wheel,
                      const WheelMark& mark, const QColor& paper);

/// The sample as a picture.
QPixmap wheelSample(int wheel, const WheelMark& mark, const QColor& paper, int width);

/// The sample as an icon of a toggle; while it is off, only the mark, pale.
QIcon wheelIcon(int wheel, const WheelMark& mark, const QColor& paper);

}  // namespace widgets
