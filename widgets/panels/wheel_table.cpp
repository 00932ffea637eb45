#include "widgets/panels/wheel_table.h"

#include <QEvent>
#include <QHeaderView>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "widgets/panels/statics_text.h"
#include "widgets/plots/wheel_marks.h"

namespace widgets {

using simcore::statics::Study;
using simcore::statics::WheelStudy;

namespace {

/// Torques far below it have no bar, however small all are [N m].
constexpr double kLeastScale = 0.05;
constexpr int kSignWidth = 14;               ///< sign of a wheel [pixel]
constexpr int kBarRole = Qt::UserRole;       ///< part of the bar that is filled, 0 to 1
constexpr int kMarkRole = Qt::UserRole + 1;  ///< place of a mark on the bar, 0 to 1
constexpr int kColorRole = Qt::UserRole + 2;

/// A bar along the lower edge of the cell, under its number.
class BarDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        const QVariant part = index.data(kBarRole);
        if (!part.isValid()) {
            return;
        }
        QRectF bar = QRectF(option.rect).adjusted(8, 0, -4, -1);
        bar.setTop(bar.bottom() - 3.0);
        const double width = bar.width();
        const QColor text = option.palette.color(QPalette::Text);
        QColor empty = text;
        empty.setAlphaF(0.14F);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(Qt::NoPen);
        painter->setBrush(empty);
        painter->drawRoundedRect(bar, 1.5, 1.5);
        painter->setBrush(index.data(kColorRole).value<QColor>());
        bar.setWidth(width * std::clamp(part.toDouble(), 0.0, 1.0));
        painter->drawRoundedRect(bar, 1.5, 1.5);
        if (const QVariant mark = index.data(kMarkRole); mark.isValid()) {
            painter->fillRect(QRectF(bar.left() + mark.toDouble() * width - 1.0, bar.top() - 1.5,
                                     2.0, bar.height() + 2.5),
                              text);
        }
        painter->restore();
    }

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const QSize size = QStyledItemDelegate::sizeHint(option, index);
        return {size.width(), std::max(size.height(), option.fontMetrics.height() + 6)};
    }
};

/// Of the ground under a wheel.
double frictionUnder(const simcore::run::ResolvedRun& run,
                     const std::vector<simcore::statics::Contact>& contacts, int wheel) {
    for (const simcore::statics::Contact& contact : contacts) {
        if (contact.wheel == wheel) {
            return groundAt(run, contact.point.x(), contact.point.y()).friction;
        }
    }
    return run.friction;
}

}  // namespace

WheelTable::WheelTable(QWidget* parent) : QTreeWidget(parent) {
    setObjectName("staticsWheels");
    setAccessibleName(tr("Wheels: contact angle, load, friction used and torques"));
    setColumnCount(kColumns);
    setHeaderLabels({tr("Wheel"), tr("Angle"), tr("Load"), tr("Friction"), tr("Torque")});
    headerItem()->setToolTip(Angle, tr("Contact angle: 90° is a wall ahead"));
    headerItem()->setToolTip(Load, tr("Normal force with the best torques [N]"));
    headerItem()->setToolTip(
        Friction, tr("Tangential over normal force, as a part of the friction of the ground"));
    headerItem()->setToolTip(
        Torque, tr("The torques that ask for the least friction [N·m]; the mark on the bar is the "
                   "torque when all wheels have the same"));
    setIconSize({kSignWidth, kSignWidth});
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setFrameShape(QFrame::NoFrame);
    setSelectionMode(QAbstractItemView::NoSelection);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTextElideMode(Qt::ElideLeft);  // names begin alike
    setItemDelegate(new BarDelegate(this));
    header()->setStretchLastSection(false);
    header()->setSectionsMovable(false);
    header()->setMinimumSectionSize(30);
    header()->setSectionResizeMode(Wheel, QHeaderView::Stretch);
    for (int column = Angle; column < kColumns; ++column) {
        headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        header()->setSectionResizeMode(column, QHeaderView::Fixed);
    }
    fitColumns();
}

void WheelTable::fitColumns() {
    const auto widen = [this](Column column, const QString& widest) {
        const QString head = headerItem()->text(column);
        setColumnWidth(column, 12 + std::max(fontMetrics().horizontalAdvance(widest),
                                             fontMetrics().horizontalAdvance(head)));
    };
    widen(Angle, "−90°");
    widen(Load, "00.0 N");
    widen(Friction, ">999 %");
    widen(Torque, "−00.00");
}

void WheelTable::changeEvent(QEvent* event) {
    QTreeWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        fitColumns();
        setRows(topLevelItemCount());
    }
}

void WheelTable::setRows(int count) {
    while (topLevelItemCount() > count) {
        delete takeTopLevelItem(count);
    }
    while (topLevelItemCount() < count) {
        auto* item = new QTreeWidgetItem(this);
        const int wheel = topLevelItemCount() - 1;
        for (int column = Angle; column < kColumns; ++column) {
            item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
            item->setData(column, kColorRole, wheelCurveColor(wheel));
        }
    }
    setFixedHeight(header()->sizeHint().height() + count * sizeHintForRow(0) + 2);
}

void WheelTable::show(const simcore::run::ResolvedRun& run,
                      const simcore::statics::TraverseSample& sample, bool backwards) {
    const Study& study = sample.study;
    setRows(static_cast<int>(study.wheels.size()));
    showSigns(study);
    const auto contacts = rollingAlong(sample.pose, backwards);
    for (int i = 0; i < topLevelItemCount(); ++i) {
        const WheelStudy& wheel = study.wheels[static_cast<std::size_t>(i)];
        const double used = wheel.ratio / frictionUnder(run, contacts, i);
        showWheel(topLevelItem(i), study, wheel, used);
        showBars(topLevelItem(i), study, wheel, used);
    }
}

void WheelTable::showSigns(const Study& study) {
    std::vector<std::string> names;
    for (const WheelStudy& wheel : study.wheels) {
        names.push_back(wheel.name);
    }
    const std::vector<WheelMark> marks = wheelMarks(names);
    for (int i = 0; i < topLevelItemCount(); ++i) {
        topLevelItem(i)->setIcon(Wheel, wheelSample(i, marks.at(static_cast<std::size_t>(i)),
                                                    palette().color(QPalette::Base), kSignWidth));
    }
}

void WheelTable::showWheel(QTreeWidgetItem* item, const Study& study, const WheelStudy& wheel,
                           double used) {
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    const bool held = wheel.touches && study.feasible;
    const auto put = [&](Column column, bool known, const QString& text) {
        item->setText(column, known ? text : QString(QChar(0x2013)));
    };
    const QString name = QString::fromStdString(wheel.name);
    item->setText(Wheel, name);
    item->setToolTip(Wheel, name);
    put(Angle, wheel.touches, numberText(wheel.contactAngle * kDegrees, 0) + "°");
    put(Load, held, numberText(wheel.normal, wheel.normal < 100.0 ? 1 : 0) + " N");
    put(Friction, held && std::isfinite(used),
        used < 9.995 ? numberText(100.0 * used, 0) + " %" : QString(">999 %"));
    put(Torque, held, numberText(wheel.torque, 2));
    item->setToolTip(
        Torque,
        study.equalTorque
            ? tr("%1 N·m when all wheels have the same").arg(numberText(*study.equalTorque, 2))
            : tr("No equal torque holds the rover here"));
    QFont font = item->font(Friction);
    font.setBold(held && used > 1.0);
    item->setFont(Friction, font);
}

void WheelTable::showBars(QTreeWidgetItem* item, const Study& study, const WheelStudy& wheel,
                          double used) {
    double heaviest = 0.0;
    double strongest = std::max(kLeastScale, study.equalTorque.value_or(0.0));
    for (const WheelStudy& one : study.wheels) {
        heaviest = std::max(heaviest, one.normal);
        strongest = std::max(strongest, std::abs(one.torque));
    }
    const bool held = wheel.touches && study.feasible;
    const auto part = [&](double value, double most) {
        return held && most > 0.0 ? value / most : 0.0;
    };
    item->setData(Load, kBarRole, part(wheel.normal, heaviest));
    item->setData(Friction, kBarRole, std::isfinite(used) ? part(used, 1.0) : 0.0);
    item->setData(Torque, kBarRole, part(std::abs(wheel.torque), strongest));
    item->setData(
        Torque, kMarkRole,
        wheel.touches && study.equalTorque ? QVariant(*study.equalTorque / strongest) : QVariant());
}

}  // namespace widgets
