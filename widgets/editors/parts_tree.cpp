#include "widgets/editors/parts_tree.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMenu>

#include "simcore/project/names.h"
#include "simcore/project/units.h"

namespace widgets {

using simcore::project::ElementKind;
using simcore::project::ElementRef;
using simcore::project::Project;
using simcore::project::Quantity;

namespace {

constexpr int kKindRole = Qt::UserRole;
constexpr int kIndexRole = Qt::UserRole + 1;

QString groupTitle(ElementKind kind) {
    switch (kind) {
        case ElementKind::Parameter:
            return PartsTree::tr("Parameters");
        case ElementKind::Body:
            return PartsTree::tr("Bodies");
        case ElementKind::Joint:
            return PartsTree::tr("Joints");
        case ElementKind::Wheel:
            return PartsTree::tr("Wheels");
        case ElementKind::Spring:
            return PartsTree::tr("Springs");
        case ElementKind::Gear:
            return PartsTree::tr("Differentials");
        case ElementKind::Payload:
            return PartsTree::tr("Payloads");
        case ElementKind::Variant:
            return PartsTree::tr("Variants");
        case ElementKind::Scenario:
            break;
    }
    return PartsTree::tr("Scenarios");
}

ElementRef elementOf(const QTreeWidgetItem* item) {
    if (item == nullptr || !item->data(0, kKindRole).isValid()) {
        return {};
    }
    return {static_cast<ElementKind>(item->data(0, kKindRole).toInt()),
            item->data(0, kIndexRole).toInt()};
}

/// "pin", "ball", "welded", else the number of freedoms.
QString freedomsText(const simcore::project::Joint& joint) {
    if (joint.locked || joint.free.empty()) {
        return PartsTree::tr("locked");
    }
    if (joint.free.size() == 1) {
        return joint.free[0].starts_with("turn") ? PartsTree::tr("pin") : PartsTree::tr("slider");
    }
    return PartsTree::tr("%1 freedoms").arg(joint.free.size());
}

}  // namespace

PartsTree::PartsTree(Document* document, QWidget* parent)
    : QTreeWidget(parent),
      document_(document) {
    setColumnCount(2);
    setHeaderLabels({tr("Part"), tr("Detail")});
    header()->setSectionResizeMode(0, QHeaderView::Stretch);
    header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    header()->setStretchLastSection(false);
    setHeaderHidden(true);
    setUniformRowHeights(true);
    setFrameShape(QFrame::NoFrame);
    setEditTriggers(QAbstractItemView::EditKeyPressed);
    setAccessibleName(tr("Parts of the project"));
    connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (!refreshing_ && item != nullptr) {
            emit elementSelected(elementOf(item));
        }
    });
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
        if (!refreshing_) {
            rename(item);
        }
    });
    connect(document_, &Document::changed, this, &PartsTree::refresh);
    refresh();
}

QString PartsTree::detail(ElementRef element) const {
    const Project& project = document_->project();
    const auto at = static_cast<std::size_t>(element.index);
    const auto shown = [&](const Quantity& quantity, const char* unit) {
        const auto value =
            simcore::project::evaluate(quantity, document_->derived().parameters, "");
        return value ? QString::fromStdString(simcore::project::formatIn(*value, unit, 4)) + ' ' +
                           unit
                     : QString("?");
    };
    switch (element.kind) {
        case ElementKind::Parameter:
            return shown(project.rover.parameters[at].value,
                         project.rover.parameters[at].unit.c_str());
        case ElementKind::Body:
            return shown(project.rover.bodies[at].mass, "kg");
        case ElementKind::Joint:
            return freedomsText(project.rover.joints[at]);
        case ElementKind::Wheel:
            return tr("radius %1").arg(shown(project.rover.wheels[at].radius, "mm"));
        case ElementKind::Payload:
            return shown(project.rover.payloads[at].mass, "kg");
        case ElementKind::Scenario:
            return QString::fromStdString(nameOf(project.scenarios[at].terrain.kind));
        default:
            return {};
    }
}

void PartsTree::refresh() {
    refreshing_ = true;
    const Project& project = document_->project();
    const ElementRef before = selected();
    std::size_t wanted = 0;
    for (const ElementKind kind : simcore::project::allElementKinds()) {
        wanted +=
            kind == ElementKind::Parameter ? 0 : static_cast<std::size_t>(countOf(project, kind));
    }
    bool same = wanted == items_.size();
    for (const auto& [element, item] : items_) {
        same = same && element.index < countOf(project, element.kind);
    }
    if (!same) {
        std::map<int, bool> expanded;
        for (int i = 0; i < topLevelItemCount(); ++i) {
            expanded[topLevelItem(i)->data(0, kKindRole).toInt()] = topLevelItem(i)->isExpanded();
        }
        clear();
        items_.clear();
        for (const ElementKind kind : simcore::project::allElementKinds()) {
            const int count = countOf(project, kind);
            // Parameters have a panel of their own.
            if (count == 0 || kind == ElementKind::Parameter) {
                continue;
            }
            auto* group = new QTreeWidgetItem(this, {groupTitle(kind), QString::number(count)});
            group->setData(0, kKindRole, static_cast<int>(kind));
            group->setData(0, kIndexRole, -1);
            group->setFlags(Qt::ItemIsEnabled);
            group->setForeground(1, palette().brush(QPalette::PlaceholderText));
            for (int i = 0; i < count; ++i) {
                auto* item = new QTreeWidgetItem(group);
                item->setData(0, kKindRole, static_cast<int>(kind));
                item->setData(0, kIndexRole, i);
                item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable);
                items_[{kind, i}] = item;
            }
            const auto known = expanded.find(static_cast<int>(kind));
            group->setExpanded(known == expanded.end()
                                   ? kind == ElementKind::Wheel || kind == ElementKind::Scenario
                                   : known->second);
        }
    }
    for (const auto& [element, item] : items_) {
        const QString name = QString::fromStdString(nameOf(project, element));
        if (item->text(0) != name) {
            item->setText(0, name);
            item->setToolTip(0, name);
        }
        const QString info = detail(element);
        if (item->text(1) != info) {
            item->setText(1, info);
        }
        item->setForeground(1, palette().brush(QPalette::PlaceholderText));
    }
    refreshing_ = false;
    if (!same) {
        select(before);
    }
}

void PartsTree::select(ElementRef element) {
    const auto found = items_.find(element);
    refreshing_ = true;
    setCurrentItem(found == items_.end() ? nullptr : found->second);
    if (found != items_.end()) {
        scrollToItem(found->second);
    }
    refreshing_ = false;
}

ElementRef PartsTree::selected() const {
    return elementOf(currentItem());
}

void PartsTree::rename(QTreeWidgetItem* item) {
    const ElementRef element = elementOf(item);
    if (element.index < 0) {
        return;
    }
    const auto next = simcore::project::renamed(document_->project(), element,
                                                item->text(0).trimmed().toStdString());
    if (next) {
        document_->edit(tr("Rename to %1").arg(item->text(0).trimmed()), *next);
    } else {
        emit refused(QString::fromStdString(toString(next.problems().front())));
    }
    refresh();
}

void PartsTree::deleteSelected() {
    const ElementRef element = selected();
    if (element.index < 0) {
        return;
    }
    const QString name = QString::fromStdString(nameOf(document_->project(), element));
    const auto next = simcore::project::removed(document_->project(), element);
    if (next) {
        document_->edit(tr("Delete %1").arg(name), *next);
    } else {
        emit refused(QString::fromStdString(toString(next.problems().front())));
    }
}

void PartsTree::duplicateSelected() {
    const ElementRef element = selected();
    if (element.index < 0) {
        return;
    }
    const QString name = QString::fromStdString(nameOf(document_->project(), element));
    const auto next = simcore::project::duplicated(document_->project(), element);
    if (next) {
        document_->edit(tr("Duplicate %1").arg(name), *next);
        select({element.kind, element.index + 1});
        emit elementSelected({element.kind, element.index + 1});
    }
}

void PartsTree::contextMenuEvent(QContextMenuEvent* event) {
    if (selected().index < 0) {
        return;
    }
    QMenu menu(this);
    connect(menu.addAction(tr("&Rename")), &QAction::triggered, this,
            [this] { editItem(currentItem(), 0); });
    connect(menu.addAction(tr("D&uplicate")), &QAction::triggered, this,
            &PartsTree::duplicateSelected);
    connect(menu.addAction(tr("&Delete")), &QAction::triggered, this, &PartsTree::deleteSelected);
    menu.exec(event->globalPos());
}

}  // namespace widgets
