#include "widgets/editors/quantity_field.h"

#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QToolTip>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "simcore/project/edit.h"
#include "simcore/project/units.h"

namespace widgets {

using simcore::Problems;
using simcore::project::Quantity;

namespace {

QString withUnit(const std::string& number, const QString& unit) {
    const QString text = QString::fromStdString(number);
    return unit.isEmpty() || unit == "-" ? text : text + ' ' + unit;
}

/// One step: a hundredth of the value's decade, in its unit, so that 70 mm steps by 1 mm and
/// 0.4 kg by 0.01 kg.
double stepFor(double shown) {
    if (shown == 0.0) {
        return 1.0;
    }
    return std::pow(10.0, std::floor(std::log10(std::abs(shown)) + 1e-9) - 1.0);
}

}  // namespace

QuantityField::QuantityField(const Document* document, QString element, QString unit, Apply apply,
                             QWidget* parent)
    : QLineEdit(parent),
      document_(document),
      element_(std::move(element)),
      unit_(std::move(unit)),
      apply_(std::move(apply)) {
    setAccessibleName(element_);
    connect(this, &QLineEdit::editingFinished, this, &QuantityField::commit);
    connect(this, &QLineEdit::textEdited, this, [this] { refuse({}); });
}

void QuantityField::setQuantity(const Quantity& quantity) {
    const bool same = quantity == quantity_ && value_;
    quantity_ = quantity;
    const auto value =
        simcore::project::evaluate(quantity, document_->derived().parameters, "value");
    value_ = value ? std::optional(*value) : std::nullopt;
    // A text being typed is not taken away by an edit elsewhere.
    if (same && hasFocus() && isModified()) {
        return;
    }
    restore();
}

void QuantityField::setUnit(const QString& unit) {
    unit_ = unit;
    restore();
}

QString QuantityField::shownText() const {
    if (quantity_.isLiteral()) {
        return withUnit(simcore::project::formatIn(quantity_.literal(), unit_.toStdString()),
                        unit_);
    }
    return QString::fromStdString(quantity_.text());
}

void QuantityField::restore() {
    const QString shown = shownText();
    if (text() != shown) {
        setText(shown);
        setCursorPosition(0);
    }
    setModified(false);
    refuse({});
    update();
}

void QuantityField::commit() {
    if (!isModified() || text() == shownText()) {
        setModified(false);
        return;
    }
    auto quantity =
        simcore::project::quantityFromText(text().toStdString(), unit_.toStdString(),
                                           document_->derived().parameters, element_.toStdString());
    const Problems problems = quantity ? apply_(*quantity, {}) : quantity.problems();
    if (simcore::hasCritical(problems)) {
        refuse(QString::fromStdString(problems.front().reason + " " + problems.front().remedy));
        return;
    }
    setModified(false);
    if (quantity_ == *quantity) {
        restore();
    }
}

void QuantityField::step(int count) {
    if (!quantity_.isLiteral() || isModified()) {
        return;
    }
    const simcore::project::Unit* unit = simcore::project::findUnit(unit_.toStdString());
    const double factor = unit ? unit->factor : 1.0;
    const double shown = quantity_.literal() / factor;
    const double size = stepFor(shown);
    // Rounded to the step's own digits, so that 0.1 + 0.2 does not show.
    const double next = std::round((shown + count * size) / (size * 0.1)) * (size * 0.1);
    const std::string text = simcore::project::formatIn(next * factor, unit_.toStdString(), 9);
    const auto quantity =
        simcore::project::quantityFromText(text, unit_.toStdString(), {}, element_.toStdString());
    if (quantity) {
        const Problems problems = apply_(*quantity, "step " + element_);
        if (simcore::hasCritical(problems)) {
            refuse(QString::fromStdString(problems.front().reason));
        }
    }
}

void QuantityField::refuse(const QString& why) {
    if (why == refusal_) {
        return;
    }
    refusal_ = why;
    setToolTip(why);
    emit refused(why);
    update();
}

bool QuantityField::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && !isModified()) {
        // Nothing is being typed: Space drives, and undo is that of the project.
        auto* key = static_cast<QKeyEvent*>(event);
        const bool space = key->key() == Qt::Key_Space && key->modifiers() == Qt::NoModifier;
        if (space || key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    if (event->type() == QEvent::ToolTip && refusal_.isEmpty() && isCut()) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), text() + ' ' + shownValue(), this);
        return true;
    }
    return QLineEdit::event(event);
}

void QuantityField::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Escape:
            if (isModified() || !refusal_.isEmpty()) {
                restore();
                selectAll();
                return;
            }
            break;
        case Qt::Key_Up:
            step(event->modifiers() & Qt::ShiftModifier ? 10 : 1);
            return;
        case Qt::Key_Down:
            step(event->modifiers() & Qt::ShiftModifier ? -10 : -1);
            return;
        default:
            break;
    }
    QLineEdit::keyPressEvent(event);
}

void QuantityField::wheelEvent(QWheelEvent* event) {
    // Only the field being edited: scrolling a panel must not change numbers.
    if (!hasFocus() || event->angleDelta().y() == 0) {
        event->ignore();
        return;
    }
    step(event->angleDelta().y() > 0 ? 1 : -1);
    event->accept();
}

void QuantityField::focusInEvent(QFocusEvent* event) {
    QLineEdit::focusInEvent(event);
    if (event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason) {
        selectAll();
    }
    update();
}

void QuantityField::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    if (!isModified()) {
        setCursorPosition(0);
    }
    update();
}

QSize QuantityField::sizeHint() const {
    return {fontMetrics().horizontalAdvance("-0000.00 N*m*s/rad"), QLineEdit::sizeHint().height()};
}

QSize QuantityField::minimumSizeHint() const {
    return {fontMetrics().horizontalAdvance("-000.00 mm") + 12, QLineEdit::sizeHint().height()};
}

QString QuantityField::shownValue() const {
    return value_
               ? "= " + withUnit(simcore::project::formatIn(*value_, unit_.toStdString(), 5), unit_)
               : QString();
}

QRect QuantityField::contents() const {
    QStyleOptionFrame option;
    initStyleOption(&option);
    return style()
        ->subElementRect(QStyle::SE_LineEditContents, &option, this)
        .adjusted(2, 0, -4, 0);
}

/// Where the value stands behind an expression.
QRect QuantityField::valuePlace() const {
    QRect place = contents();
    place.setLeft(place.right() - fontMetrics().horizontalAdvance(shownValue()) - 8);
    return place;
}

bool QuantityField::isCut() const {
    const int room = quantity_.isLiteral() || !value_ ? contents().width()
                                                      : valuePlace().left() - contents().left();
    return fontMetrics().horizontalAdvance(text()) > room;
}

void QuantityField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    QPainter painter(this);
    if (!refusal_.isEmpty()) {
        painter.setPen(QPen(QColor(0xd5, 0x3e, 0x2a), 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
    if (quantity_.isLiteral() || !value_ || hasFocus()) {
        return;
    }
    const QRect place = valuePlace();
    QColor color = palette().text().color();
    if (isCut()) {
        // The expression is cut rather than its value.
        const QString more(QChar(0x2026));
        const int width = fontMetrics().horizontalAdvance(more) + 4;
        const QRect gap(place.left() - width, place.top(), width, place.height());
        painter.fillRect(gap.united(place).adjusted(0, 0, 8, 0), palette().base());
        painter.setPen(color);
        painter.drawText(gap, Qt::AlignLeft | Qt::AlignVCenter, more);
    }
    color.setAlphaF(0.6F);
    painter.setPen(color);
    painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter, shownValue());
}

}  // namespace widgets
