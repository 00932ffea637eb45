#include "widgets/panels/mobility_list.h"

#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "simcore/mobility/loops.h"
#include "simcore/mobility/reactions.h"
#include "simcore/mobility/selection.h"
#include "widgets/panels/mobility_text.h"

namespace widgets {

using simcore::mobility::ConstraintName;
using simcore::mobility::ReactionDeterminacy;
using simcore::mobility::wheelOfContact;

namespace {

constexpr int kJointRole = Qt::UserRole;  // names; one of these two, or of a loop the lists
constexpr int kWheelRole = Qt::UserRole + 1;
constexpr int kShareRole = Qt::UserRole + 2;
constexpr int kLoopJointsRole = Qt::UserRole + 3;
constexpr int kLoopBodiesRole = Qt::UserRole + 4;

QString directionText(const simcore::Vec3& d) {
    static constexpr std::array kAxes{"x", "y", "z"};
    for (Eigen::Index i = 0; i < 3; ++i) {
        if (std::abs(d[i]) > 0.9999) {
            return kAxes.at(static_cast<std::size_t>(i));
        }
    }
    return QString("(%1, %2, %3)")
        .arg(d.x(), 0, 'f', 2)
        .arg(d.y(), 0, 'f', 2)
        .arg(d.z(), 0, 'f', 2);
}

QString constraintText(const ConstraintName& constraint) {
    const QString direction = directionText(constraint.direction);
    if (constraint.kind == "turn") {
        return MobilityList::tr("holds the turn about %1").arg(direction);
    }
    if (constraint.kind == "gear") {
        return MobilityList::tr("couples two joints");
    }
    return MobilityList::tr("holds the slide along %1").arg(direction);
}

/// Draws a share from 0 to 1 as a bar with its percentage.
class ShareDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        const QVariant share = index.data(kShareRole);
        if (!share.isValid()) {
            return;
        }
        const QRectF place = QRectF(option.rect).adjusted(4, 6, -38, -6);
        const bool selected = option.state.testFlag(QStyle::State_Selected);
        QColor color =
            option.palette.color(selected ? QPalette::HighlightedText : QPalette::Highlight);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(Qt::NoPen);
        color.setAlphaF(0.25F);
        painter->setBrush(color);
        painter->drawRoundedRect(place, 2, 2);
        color.setAlphaF(1.0F);
        painter->setBrush(color);
        QRectF filled = place;
        filled.setWidth(place.width() * std::clamp(share.toDouble(), 0.0, 1.0));
        painter->drawRoundedRect(filled, 2, 2);
        painter->setPen(
            option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
        painter->drawText(QRectF(option.rect).adjusted(0, 0, -4, 0),
                          Qt::AlignRight | Qt::AlignVCenter,
                          QString("%1 %").arg(100.0 * share.toDouble(), 0, 'f', 0));
        painter->restore();
    }
};

/// What is not known where the constraint holds something.
QString unknownText(const ConstraintName& constraint) {
    const QString direction = directionText(constraint.direction);
    if (constraint.kind == "turn") {
        return MobilityList::tr("torque about %1: not only from the loads").arg(direction);
    }
    if (constraint.kind == "gear") {
        return MobilityList::tr("torque of the gear: not only from the loads");
    }
    return MobilityList::tr("force along %1: not only from the loads").arg(direction);
}

}  // namespace

MobilityList::MobilityList(QWidget* parent)
    : QWidget(parent),
      kind_(new QComboBox(this)),
      title_(new QLabel(this)),
      list_(new QTreeWidget(this)) {
    kind_->addItem(tr("Constraints that could go"));
    kind_->addItem(tr("Loops, one at a time"));
    kind_->addItem(tr("Reactions and self-stress"));
    kind_->setObjectName("mobilityKind");
    kind_->setAccessibleName(tr("What lies behind the counts"));
    title_->setObjectName("mobilityListTitle");
    title_->setWordWrap(true);
    title_->setAccessibleName(kind_->currentText());
    title_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    list_->setColumnCount(2);
    list_->setHeaderHidden(true);
    list_->setUniformRowHeights(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setObjectName("removableList");
    list_->setMinimumHeight(4 * fontMetrics().height());
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(1, QHeaderView::Fixed);
    fitShares();
    list_->setItemDelegateForColumn(1, new ShareDelegate(list_));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(kind_);
    layout->addWidget(title_);
    layout->addWidget(list_, 1);
    connect(kind_, &QComboBox::currentIndexChanged, this, [this] {
        unmark();
        fill();
    });
    connect(list_, &QTreeWidget::currentItemChanged, this, &MobilityList::choose);
}

/// The bar of a share and its number.
void MobilityList::fitShares() {
    list_->setColumnWidth(1, 66 + fontMetrics().horizontalAdvance("100 %"));
}

void MobilityList::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) {
        fitShares();
    }
    QWidget::changeEvent(event);
}

void MobilityList::show(const simcore::mechanism::Mechanism& mechanism,
                        const simcore::mobility::Stance& stance,
                        const simcore::mobility::Report& report) {
    mechanism_ = mechanism;
    stance_ = stance;
    report_ = report;
    fill();
}

void MobilityList::choose(QTreeWidgetItem* item) {
    if (refreshing_ || item == nullptr) {
        return;
    }
    // A joint of a loop is looked at within its loop.
    const QTreeWidgetItem* loop = item;
    if (!loop->data(0, kLoopJointsRole).isValid() && loop->parent() != nullptr) {
        loop = loop->parent();
    }
    if (loop->data(0, kLoopJointsRole).isValid()) {
        marks_ = true;
        emit marked(loop->data(0, kLoopJointsRole).toStringList(),
                    loop->data(0, kLoopBodiesRole).toStringList());
    }
    if (const QVariant joint = item->data(0, kJointRole); joint.isValid()) {
        emit jointChosen(joint.toString());
    } else if (const QVariant wheel = item->data(0, kWheelRole); wheel.isValid()) {
        emit wheelChosen(wheel.toString());
    }
}

void MobilityList::unmark() {
    if (marks_) {
        marks_ = false;
        emit marked({}, {});
    }
}

QTreeWidgetItem* MobilityList::elementItem(const std::string& element) const {
    auto* item = new QTreeWidgetItem({elementText(element)});
    item->setToolTip(0, item->text(0));
    if (const std::string wheel = wheelOfContact(element); !wheel.empty()) {
        item->setData(0, kWheelRole, QString::fromStdString(wheel));
    } else {
        item->setData(0, kJointRole, QString::fromStdString(element));
    }
    return item;
}

QList<QTreeWidgetItem*> MobilityList::constraintItems() {
    title_->setText(report_.redundant == 0 ? tr("No constraint repeats what others hold.")
                                           : tr("<b>%1 removable</b>, %2 of them together")
                                                 .arg(report_.removable.size())
                                                 .arg(report_.redundant));
    title_->setToolTip(
        tr("Removing any one of these gives no new motion. The bar is the "
           "constraint's share in the self-stress: 100 % is wholly redundant."));
    QList<QTreeWidgetItem*> groups;
    std::map<std::string, QTreeWidgetItem*> byElement;
    for (const ConstraintName& constraint : report_.removable) {
        QTreeWidgetItem*& group = byElement[constraint.element];
        if (group == nullptr) {
            group = elementItem(constraint.element);
            groups << group;
        }
        auto* item = new QTreeWidgetItem(group, {constraintText(constraint)});
        item->setData(0, kJointRole, group->data(0, kJointRole));
        item->setData(0, kWheelRole, group->data(0, kWheelRole));
        item->setData(1, kShareRole, constraint.share);
    }
    for (QTreeWidgetItem* group : groups) {
        double largest = 0.0;
        for (int i = 0; i < group->childCount(); ++i) {
            largest = std::max(largest, group->child(i)->data(1, kShareRole).toDouble());
        }
        group->setData(1, kShareRole, largest);
    }
    return groups;
}

QList<QTreeWidgetItem*> MobilityList::loopItems() {
    const auto loops = findLoops(mechanism_, report_.model, stance_);
    title_->setText(loops.empty() ? tr("No joints form a loop.")
                    : loops.size() == 1
                        ? tr("<b>1 loop</b>, counted alone with one body held")
                        : tr("<b>%1 loops</b>, each counted alone with one of its bodies "
                             "held")
                              .arg(loops.size()));
    title_->setToolTip(
        tr("The shortest independent loops. The ground is one body, a wheel's contact a joint to "
           "it. What is redundant in the whole may be more than in the loops."));
    QList<QTreeWidgetItem*> items;
    for (const simcore::mobility::Loop& loop : loops) {
        QStringList joints, names, bodies;
        auto* item = new QTreeWidgetItem;
        for (const std::string& element : loop.joints) {
            item->addChild(elementItem(element));
            joints << QString::fromStdString(element);
            names << elementText(element);
            if (const std::string wheel = wheelOfContact(element); !wheel.empty()) {
                const auto at = static_cast<std::size_t>(std::max(0, mechanism_.findWheel(wheel)));
                const auto body = static_cast<std::size_t>(mechanism_.wheels.at(at).body);
                bodies << QString::fromStdString(mechanism_.bodies.at(body).name);
            }
        }
        for (const std::string& body : loop.bodies) {
            bodies << QString::fromStdString(body);
        }
        bodies.removeDuplicates();
        item->setData(0, kLoopJointsRole, joints);
        item->setData(0, kLoopBodiesRole, bodies);
        const QString counts = tr("Grübler %1, rank %2, mobility %3, redundant %4")
                                   .arg(signedNumber(loop.gruebler))
                                   .arg(loop.rank)
                                   .arg(loop.mobility)
                                   .arg(loop.redundant);
        item->setText(0, (loop.gear ? tr("Gear %1: %2") : tr("Loop %1: %2"))
                             .arg(items.size() + 1)
                             .arg(names.join(", ")));
        item->setText(1,
                      loop.redundant == 0 ? tr("exact") : tr("%1 redundant").arg(loop.redundant));
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        item->setToolTip(0, counts + "\n" + names.join(", ") + "\n" + bodies.join(", "));
        item->setToolTip(1, counts);
        auto* line = new QTreeWidgetItem({counts});
        line->setToolTip(0, counts);
        item->insertChild(0, line);
        items << item;
    }
    return items;
}

QList<QTreeWidgetItem*> MobilityList::reactionItems() {
    const auto reactions = determinedReactions(mechanism_, report_.model, stance_);
    title_->setText(reactionsVerdict(reactions));
    title_->setToolTip(
        tr("Known: components of the reaction that every equilibrium has in common. The bar is the "
           "part of the self-stress that is in the joint, 100 % over all joints."));
    std::map<std::string, double> parts;
    for (const auto& share : simcore::mobility::shareByElement(report_)) {
        parts[share.element] = share.part;
    }
    QList<QTreeWidgetItem*> items;
    for (const ReactionDeterminacy& reaction : reactions) {
        QTreeWidgetItem* item = elementItem(reaction.element);
        item->setText(0, tr("%1: %2 of %3 known")
                             .arg(item->text(0))
                             .arg(reaction.determined.size())
                             .arg(reaction.components));
        item->setToolTip(0, item->text(0));
        item->setData(1, kShareRole, parts[reaction.element]);
        for (const ConstraintName& constraint : reaction.undetermined) {
            auto* line = new QTreeWidgetItem(item, {unknownText(constraint)});
            line->setToolTip(0, line->text(0));
            line->setData(0, kJointRole, item->data(0, kJointRole));
            line->setData(0, kWheelRole, item->data(0, kWheelRole));
        }
        items << item;
    }
    std::stable_sort(items.begin(), items.end(), [](QTreeWidgetItem* a, QTreeWidgetItem* b) {
        return a->data(1, kShareRole).toDouble() > b->data(1, kShareRole).toDouble() + 1e-9;
    });
    return items;
}

void MobilityList::fill() {
    refreshing_ = true;
    const QString chosen =
        list_->currentItem() ? list_->currentItem()->data(0, kJointRole).toString() : QString();
    std::map<QString, bool> expanded;
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        expanded[list_->topLevelItem(i)->text(0)] = list_->topLevelItem(i)->isExpanded();
    }
    list_->clear();
    const int kind = kind_->currentIndex();
    const QList<QTreeWidgetItem*> items = kind == Loops       ? loopItems()
                                          : kind == Reactions ? reactionItems()
                                                              : constraintItems();
    list_->setAccessibleName(kind_->currentText());
    title_->setAccessibleName(kind_->currentText());
    list_->addTopLevelItems(items);
    for (QTreeWidgetItem* item : items) {
        item->setExpanded(expanded[item->text(0)]);
        if (kind == Loops) {
            item->child(0)->setFirstColumnSpanned(true);
        }
    }
    refreshing_ = false;
    if (!chosen.isEmpty()) {
        selectElement(chosen);
    }
}

void MobilityList::selectElement(const QString& name) {
    if (kind_->currentIndex() == Loops) {
        return;  // a joint is in several
    }
    refreshing_ = true;
    QTreeWidgetItem* found = nullptr;
    for (int i = 0; i < list_->topLevelItemCount() && !name.isEmpty(); ++i) {
        if (list_->topLevelItem(i)->data(0, kJointRole).toString() == name) {
            found = list_->topLevelItem(i);
        }
    }
    list_->setCurrentItem(found);
    if (found != nullptr) {
        list_->scrollToItem(found);
    }
    refreshing_ = false;
}

}  // namespace widgets
