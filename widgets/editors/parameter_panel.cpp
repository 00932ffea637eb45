#include "widgets/editors/parameter_panel.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QSlider>
#include <QStyle>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "simcore/project/units.h"
#include "widgets/editors/quantity_field.h"

namespace widgets {

using simcore::Problems;
using simcore::project::Parameter;
using simcore::project::Project;
using simcore::project::Quantity;

namespace {

constexpr int kSliderSteps = 1000;

/// Dragging lands on values a person would type: a thousandth of the range, rounded to 1, 2 or 5.
double niceStep(double range) {
    const double raw = range / kSliderSteps;
    const double decade = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        if (factor * decade >= raw * (1.0 - 1e-9)) {
            return factor * decade;
        }
    }
    return 10.0 * decade;
}

/// Lets the wheel scroll the panel, not the number under the pointer.
class PanelSlider : public QSlider {
  public:
    using QSlider::QSlider;

  protected:
    void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

QString tooltipOf(const Parameter& parameter) {
    const auto limit = [&](double value) {
        return QString::fromStdString(simcore::project::formatIn(value, parameter.unit));
    };
    QString text = "<b>" + QString::fromStdString(parameter.name).toHtmlEscaped() + "</b>";
    if (!parameter.meaning.empty()) {
        text += "<br>" + QString::fromStdString(parameter.meaning).toHtmlEscaped();
    }
    if (parameter.minimum && parameter.maximum) {
        text += "<br>" + ParameterPanel::tr("Range: %1 to %2 %3")
                             .arg(limit(*parameter.minimum), limit(*parameter.maximum),
                                  QString::fromStdString(parameter.unit));
    }
    if (!parameter.source.empty()) {
        text += "<br>" + ParameterPanel::tr("Source: %1")
                             .arg(QString::fromStdString(parameter.source).toHtmlEscaped());
    }
    return text;
}

}  // namespace

ParameterPanel::ParameterPanel(Document* document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      filter_(new QLineEdit(this)),
      scroll_(new QScrollArea(this)),
      message_(new QLabel(this)),
      none_(new QLabel(tr("This rover has no parameters."), this)) {
    filter_->setObjectName("parameterFilter");
    filter_->setPlaceholderText(tr("Filter parameters"));
    filter_->setAccessibleName(tr("Filter parameters"));
    filter_->setClearButtonEnabled(true);
    scroll_->setObjectName("parameterList");
    scroll_->setAccessibleName(tr("Parameters"));
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setAccessibleName(tr("Parameters"));
    message_->setWordWrap(true);
    message_->setObjectName("errorMessage");
    message_->hide();
    none_->setAlignment(Qt::AlignCenter);
    none_->setEnabled(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 0, 6);
    layout->addWidget(filter_);
    layout->addWidget(message_);
    layout->addWidget(none_);
    layout->addWidget(scroll_, 1);
    connect(filter_, &QLineEdit::textChanged, this, &ParameterPanel::filter);
    connect(document_, &Document::changed, this, &ParameterPanel::refresh);
    rebuild();
}

/// Sliders are to be seen whole, unless somebody's names are very long.
void ParameterPanel::fitWidth() {
    constexpr int kMostLines = 30;
    const int wanted = scroll_->widget()->minimumSizeHint().width() +
                       style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    scroll_->setMinimumWidth(std::min(wanted, kMostLines * fontMetrics().height()));
}

void ParameterPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange && scroll_ != nullptr && scroll_->widget() != nullptr) {
        // The fields have the new font after this.
        QMetaObject::invokeMethod(this, &ParameterPanel::fitWidth, Qt::QueuedConnection);
    }
}

void ParameterPanel::rebuild() {
    rows_.clear();
    auto* content = new QWidget;
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(0, 2, 8, 2);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(1, 3);
    grid->setColumnStretch(2, 2);
    const auto& parameters = document_->project().rover.parameters;
    for (int i = 0; i < static_cast<int>(parameters.size()); ++i) {
        const Parameter& parameter = parameters[static_cast<std::size_t>(i)];
        const QString name = QString::fromStdString(parameter.name);
        auto* label = new QLabel(name);
        auto* field = new QuantityField(
            document_, "parameter " + name, QString::fromStdString(parameter.unit),
            [this, i](const Quantity& value, const QString& key) { return apply(i, value, key); });
        field->setObjectName("parameter:" + name);
        auto* slider = new PanelSlider(Qt::Horizontal);
        slider->setAccessibleName(tr("Slider of %1").arg(name));
        slider->setObjectName("slider:" + name);
        slider->setRange(0, kSliderSteps);
        slider->setMinimumWidth(44);
        slider->setFocusPolicy(Qt::TabFocus);
        label->setBuddy(field);
        grid->addWidget(label, i, 0);
        grid->addWidget(field, i, 1);
        grid->addWidget(slider, i, 2);
        connect(slider, &QSlider::valueChanged, this, [this, i](int at) { slide(i, at); });
        connect(slider, &QSlider::sliderPressed, document_, &Document::endMerging);
        connect(slider, &QSlider::sliderReleased, document_, &Document::endMerging);
        connect(field, &QuantityField::refused, this, [this, name](const QString& why) {
            message_->setText(why.isEmpty() ? QString() : name + ": " + why);
            message_->setVisible(!why.isEmpty());
        });
        rows_.push_back({name, label, field, slider});
    }
    grid->setRowStretch(static_cast<int>(parameters.size()), 1);
    scroll_->setWidget(content);
    fitWidth();
    message_->hide();
    filter(filter_->text());
    refresh();
}

void ParameterPanel::refresh() {
    const auto& parameters = document_->project().rover.parameters;
    bool same = parameters.size() == rows_.size();
    for (std::size_t i = 0; same && i < rows_.size(); ++i) {
        same = rows_[i].name == QString::fromStdString(parameters[i].name);
    }
    if (!same) {
        rebuild();
        return;
    }
    none_->setVisible(rows_.empty());
    scroll_->setVisible(!rows_.empty());
    refreshing_ = true;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Parameter& parameter = parameters[i];
        Row& row = rows_[i];
        row.label->setToolTip(tooltipOf(parameter));
        row.field->setUnit(QString::fromStdString(parameter.unit));
        row.field->setQuantity(parameter.value);
        const bool slides = parameter.minimum && parameter.maximum &&
                            *parameter.maximum > *parameter.minimum && parameter.value.isLiteral();
        row.slider->setEnabled(slides);
        if (slides && !row.slider->isSliderDown()) {
            const double share = (parameter.value.literal() - *parameter.minimum) /
                                 (*parameter.maximum - *parameter.minimum);
            row.slider->setValue(static_cast<int>(std::lround(share * kSliderSteps)));
        }
    }
    refreshing_ = false;
}

void ParameterPanel::filter(const QString& text) {
    for (Row& row : rows_) {
        const bool shown = row.name.contains(text, Qt::CaseInsensitive);
        row.label->setVisible(shown);
        row.field->setVisible(shown);
        row.slider->setVisible(shown);
    }
}

Problems ParameterPanel::apply(int index, const Quantity& value, const QString& mergeKey) {
    Project next = document_->project();
    Parameter& parameter = next.rover.parameters.at(static_cast<std::size_t>(index));
    parameter.value = value;
    const auto checked = simcore::project::evaluateParameters(next.rover);
    if (!checked) {
        return checked.problems();
    }
    const QString name = QString::fromStdString(parameter.name);
    document_->edit(tr("Change %1").arg(name), std::move(next), mergeKey);
    return {};
}

void ParameterPanel::slide(int index, int position) {
    if (refreshing_) {
        return;
    }
    const Parameter& parameter =
        document_->project().rover.parameters.at(static_cast<std::size_t>(index));
    if (!parameter.minimum || !parameter.maximum) {
        return;
    }
    const simcore::project::Unit* unit = simcore::project::findUnit(parameter.unit);
    const double factor = unit ? unit->factor : 1.0;
    const double range = *parameter.maximum - *parameter.minimum;
    const double step = niceStep(range / factor);
    const double raw = (*parameter.minimum + range * position / kSliderSteps) / factor;
    // Multiples of the step, with as few digits as a person would write.
    const std::string text = simcore::project::formatIn(std::round(raw / step) * step, "", 9);
    const double value =
        std::clamp(std::stod(text) * factor, *parameter.minimum, *parameter.maximum);
    const Problems problems =
        apply(index, value, "slide " + QString::fromStdString(parameter.name));
    if (simcore::hasCritical(problems)) {
        message_->setText(QString::fromStdString(problems.front().reason));
        message_->show();
    }
}

void ParameterPanel::focusParameter(const QString& name) {
    for (const Row& row : rows_) {
        if (row.name == name) {
            filter_->clear();
            scroll_->ensureWidgetVisible(row.field);
            row.field->setFocus(Qt::TabFocusReason);
        }
    }
}

}  // namespace widgets
