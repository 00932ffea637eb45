#include "widgets/window/text_size.h"

#include <QApplication>
#include <QFont>
#include <algorithm>
#include <cstdlib>
#include <iterator>

namespace widgets {
namespace {

/// Place of the size nearest to `percent`.
int placeOf(int percent) {
    const auto* nearest = std::min_element(
        std::begin(kTextSizes), std::end(kTextSizes),
        [percent](int a, int b) { return std::abs(a - percent) < std::abs(b - percent); });
    return static_cast<int>(nearest - std::begin(kTextSizes));
}

/// The system's font, as it was before the first change.
QFont systemFont(QApplication& application) {
    constexpr const char* kProperty = "systemFont";
    if (!application.property(kProperty).isValid()) {
        application.setProperty(kProperty, QApplication::font());
    }
    return application.property(kProperty).value<QFont>();
}

}  // namespace

int steppedTextSize(int percent, int steps) {
    const int last = static_cast<int>(std::size(kTextSizes)) - 1;
    return kTextSizes[std::clamp(placeOf(percent) + steps, 0, last)];
}

int applyTextSize(QApplication& application, int percent) {
    const int size = steppedTextSize(percent, 0);
    QFont font = systemFont(application);
    font.setPointSizeF(font.pointSizeF() * size / 100.0);
    if (font != QApplication::font()) {
        QApplication::setFont(font);
        QApplication::setFont(font, "QTipLabel");  // does not follow by itself
        // Widgets that the style sheet has a rule for would keep the font that they have.
        application.setStyleSheet(application.styleSheet());
    }
    return size;
}

}  // namespace widgets
