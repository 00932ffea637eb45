#include "widgets/session/timeline_slider.h"

#include <QMouseEvent>
#include <QStyle>
#include <QStyleOptionSlider>

namespace widgets {

TimelineSlider::TimelineSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
    setRange(0, 0);
    setSingleStep(20);
    setPageStep(1000);
    // Keys and wheel; the mouse is handled below.
    connect(this, &QAbstractSlider::actionTriggered, this, [this](int action) {
        if (action != SliderMove && action != SliderNoAction) {
            emit timeChosen(1e-3 * sliderPosition());
        }
    });
}

void TimelineSlider::chooseAt(double x) {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const int handle = style()->pixelMetric(QStyle::PM_SliderLength, &option, this);
    const int value =
        QStyle::sliderValueFromPosition(minimum(), maximum(), static_cast<int>(x - 0.5 * handle),
                                        width() - handle, option.upsideDown);
    setValue(value);
    emit timeChosen(1e-3 * value);
}

void TimelineSlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    setSliderDown(true);
    chooseAt(event->position().x());
}

void TimelineSlider::mouseMoveEvent(QMouseEvent* event) {
    if (isSliderDown()) {
        chooseAt(event->position().x());
    }
}

void TimelineSlider::mouseReleaseEvent(QMouseEvent*) {
    setSliderDown(false);
}

}  // namespace widgets
