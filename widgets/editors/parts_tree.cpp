#include "widgets/editors/parts_tree.h"

#include <QContextMenuEvent>
#include <QDrag>
#include <QDropEvent>
#include <QHeaderView>
#include <QMenu>
#include <QMimeData>
#include <algorithm>
#include <set>

#include "simcore/project/names.h"
#include "simcore/project/units.h"
#include "widgets/document/parts_clipboard.h"
#include "widgets/editors/field_info.h"

namespace widgets {

using simcore::project::ElementKind;
using simcore::project::ElementRef;
using simcore::project::Project;
using simcore::project::Quantity;
using simcore::project::ShapeKind;

namespace {

constexpr int kKindRole = Qt::UserRole;
constexpr int kIndexRole = Qt::UserRole + 1;
constexpr int kShapeRole = Qt::UserRole + 2;

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

/// Groups that are open at first; bodies with their shapes are not.
bool opensAtFirst(const QTreeWidgetItem* item) {
    const auto kind = static_cast<ElementKind>(item->data(0, kKindRole).toInt());
    return kind == ElementKind::Wheel || kind == ElementKind::Scenario;
}

/// What its being open is remembered by: it outlives the item.
QString keyOf(const QTreeWidgetItem* item) {
    return item->parent() == nullptr ? QString::number(item->data(0, kKindRole).toInt())
                                     : "body " + item->text(0);
}

ElementRef elementOf(const QTreeWidgetItem* item) {
    if (item == nullptr || !item->data(0, kKindRole).isValid()) {
        return {};
    }
    return {static_cast<ElementKind>(item->data(0, kKindRole).toInt()),
            item->data(0, kIndexRole).toInt(), item->data(0, kShapeRole).toInt()};
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

QString kindTitle(ElementKind kind) {
    switch (kind) {
        case ElementKind::Parameter:
            return PartsTree::tr("Parameter");
        case ElementKind::Body:
            return PartsTree::tr("Body");
        case ElementKind::Joint:
            return PartsTree::tr("Joint");
        case ElementKind::Wheel:
            return PartsTree::tr("Wheel");
        case ElementKind::Spring:
            return PartsTree::tr("Spring");
        case ElementKind::Gear:
            return PartsTree::tr("Differential");
        case ElementKind::Payload:
            return PartsTree::tr("Payload");
        case ElementKind::Variant:
            return PartsTree::tr("Variant");
        case ElementKind::Scenario:
            break;
    }
    return PartsTree::tr("Scenario");
}

QString kindTitle(ShapeKind kind) {
    switch (kind) {
        case ShapeKind::Box:
            return PartsTree::tr("Box");
        case ShapeKind::Cylinder:
            return PartsTree::tr("Cylinder");
        case ShapeKind::Sphere:
            return PartsTree::tr("Sphere");
        case ShapeKind::Bar:
            break;
    }
    return PartsTree::tr("Bar");
}

QString labelOf(const Project& project, ElementRef element) {
    if (!element.isShape()) {
        return QString::fromStdString(nameOf(project, element));
    }
    //: Kind of a shape and its place among those of the body: "Box 2".
    return PartsTree::tr("%1 %2", "shape")
        .arg(kindTitle(shapeAt(project, element).kind))
        .arg(element.shape + 1);
}

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
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setDragDropMode(QAbstractItemView::InternalMove);
    setDropIndicatorShown(true);
    setObjectName("partsTree");
    setAccessibleName(tr("Parts of the project"));
    connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (!refreshing_ && item != nullptr) {
            emit elementSelected(elementOf(item));
        }
    });
    connect(this, &QTreeWidget::itemSelectionChanged, this, [this] {
        if (!refreshing_) {
            emit selectionMoved();
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

QString PartsTree::shown(const Quantity& quantity, const char* unit) const {
    const auto value = simcore::project::evaluate(quantity, document_->derived().parameters, "");
    return value ? QString::fromStdString(simcore::project::formatIn(*value, unit, 4)) + ' ' + unit
                 : QString("?");
}

QString PartsTree::shapeDetail(const simcore::project::Shape& shape) const {
    const auto number = [this](const Quantity& length) {
        return shown(length, "mm").remove(" mm");
    };
    static const QString kTimes = QString(QChar(0x00D7));
    switch (shape.kind) {
        case ShapeKind::Box:
            return number(shape.size[0]) + kTimes + number(shape.size[1]) + kTimes +
                   shown(shape.size[2], "mm");
        case ShapeKind::Bar:
            return number(shape.width) + kTimes + shown(shape.height, "mm");
        case ShapeKind::Cylinder:
        case ShapeKind::Sphere:
            break;
    }
    return tr("radius %1").arg(shown(shape.radius, "mm"));
}

QString PartsTree::detail(ElementRef element) const {
    const Project& project = document_->project();
    if (element.isShape()) {
        return shapeDetail(shapeAt(project, element));
    }
    const auto at = static_cast<std::size_t>(element.index);
    switch (element.kind) {
        case ElementKind::Parameter: {
            const simcore::project::Parameter& parameter = project.rover.parameters[at];
            const auto value = document_->derived().parameters.find(parameter.name);
            return value == document_->derived().parameters.end()
                       ? QString("?")
                       : QString::fromStdString(
                             simcore::project::formatIn(value->second, parameter.unit, 4) + ' ' +
                             parameter.unit);
        }
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
        wanted += static_cast<std::size_t>(countOf(project, kind));
    }
    for (const auto& body : project.rover.bodies) {
        wanted += body.shapes.size();
    }
    bool same = wanted == items_.size();
    for (const auto& [element, item] : items_) {
        same = same && element.index < countOf(project, element.kind) &&
               (!element.isShape() || element.shape < shapeCountOf(project, element.index));
    }
    if (!same) {
        rebuild();
    }
    for (const auto& [element, item] : items_) {
        const QString name = labelOf(project, element);
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
    applyFilter();
    refreshing_ = false;
    if (!same) {
        select(before);
    }
}

void PartsTree::rebuild() {
    const Project& project = document_->project();
    if (filter_.isEmpty()) {
        rememberExpanded();
    }
    clear();
    items_.clear();
    for (const ElementKind kind : simcore::project::allElementKinds()) {
        const int count = countOf(project, kind);
        if (count == 0) {
            continue;
        }
        auto* group = new QTreeWidgetItem(this, {groupTitle(kind), QString::number(count)});
        group->setData(0, kKindRole, static_cast<int>(kind));
        group->setData(0, kIndexRole, -1);
        group->setData(0, kShapeRole, -1);
        group->setFlags(Qt::ItemIsEnabled | Qt::ItemIsDropEnabled);
        group->setForeground(1, palette().brush(QPalette::PlaceholderText));
        for (int i = 0; i < count; ++i) {
            QTreeWidgetItem* item = addItem(group, {kind, i});
            const int shapes = kind == ElementKind::Body ? shapeCountOf(project, i) : 0;
            for (int k = 0; k < shapes; ++k) {
                addItem(item, {kind, i, k});
            }
        }
    }
    restoreExpanded();
}

QTreeWidgetItem* PartsTree::addItem(QTreeWidgetItem* parent, ElementRef element) {
    auto* item = new QTreeWidgetItem(parent);
    item->setData(0, kKindRole, static_cast<int>(element.kind));
    item->setData(0, kIndexRole, element.index);
    item->setData(0, kShapeRole, element.shape);
    item->setText(0, labelOf(document_->project(), element));
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled;
    if (!element.isShape()) {
        flags |= Qt::ItemIsEditable;  // shapes have no name
    }
    if (element.kind != ElementKind::Body || element.isShape()) {
        flags |= Qt::ItemNeverHasChildren;
    } else {
        flags |= Qt::ItemIsDropEnabled;
    }
    item->setFlags(flags);
    items_[element] = item;
    return item;
}

void PartsTree::rememberExpanded() {
    for (int i = 0; i < topLevelItemCount(); ++i) {
        const QTreeWidgetItem* group = topLevelItem(i);
        expanded_[keyOf(group)] = group->isExpanded();
        for (int k = 0; k < group->childCount(); ++k) {
            if (group->child(k)->childCount() > 0) {
                expanded_[keyOf(group->child(k))] = group->child(k)->isExpanded();
            }
        }
    }
}

void PartsTree::restoreExpanded() {
    for (int i = 0; i < topLevelItemCount(); ++i) {
        QTreeWidgetItem* group = topLevelItem(i);
        const auto known = expanded_.find(keyOf(group));
        group->setExpanded(known == expanded_.end() ? opensAtFirst(group) : known->second);
        for (int k = 0; k < group->childCount(); ++k) {
            const auto body = expanded_.find(keyOf(group->child(k)));
            group->child(k)->setExpanded(body != expanded_.end() && body->second);
        }
    }
}

void PartsTree::filter(const QString& text) {
    if (filter_.isEmpty() && !text.isEmpty()) {
        rememberExpanded();
    }
    const bool ends = text.isEmpty() && !filter_.isEmpty();
    filter_ = text;
    applyFilter();
    if (ends) {
        restoreExpanded();
        scrollToItem(currentItem());
    }
}

void PartsTree::applyFilter() {
    const auto matches = [this](const QTreeWidgetItem* item) {
        return item->text(0).contains(filter_, Qt::CaseInsensitive);
    };
    std::set<QTreeWidgetItem*> matching;
    for (const auto& [element, item] : items_) {
        // A body is found by the names of its shapes, too, and brings all of them by its own.
        bool shapes = false;
        for (int k = 0; k < item->childCount(); ++k) {
            shapes = shapes || matches(item->child(k));
        }
        const bool shown =
            shapes || matches(item) || (element.isShape() && matches(item->parent()));
        item->setHidden(!shown);
        if (shown) {
            matching.insert(item->parent());
        }
        if (!filter_.isEmpty() && item->childCount() > 0) {
            item->setExpanded(shapes);
        }
    }
    for (int i = 0; i < topLevelItemCount(); ++i) {
        QTreeWidgetItem* group = topLevelItem(i);
        group->setHidden(!matching.contains(group));
        if (!filter_.isEmpty()) {
            group->setExpanded(true);
        }
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
    emit selectionMoved();
}

void PartsTree::toggle(ElementRef element) {
    const auto found = items_.find(element);
    if (found == items_.end()) {
        return;
    }
    reveal(found->second);
    refreshing_ = true;
    setCurrentItem(found->second, 0, QItemSelectionModel::Toggle | QItemSelectionModel::Rows);
    scrollToItem(found->second);
    refreshing_ = false;
    emit selectionMoved();
}

void PartsTree::reveal(QTreeWidgetItem* item) {
    for (QTreeWidgetItem* above = item->parent(); above != nullptr; above = above->parent()) {
        above->setExpanded(true);
    }
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

std::vector<ElementRef> PartsTree::selection() const {
    std::vector<ElementRef> elements;
    for (const auto& [element, item] : items_) {
        if (item->isSelected() && !item->isHidden()) {
            elements.push_back(element);
        }
    }
    return elements;
}

QString PartsTree::titleOf(const std::vector<ElementRef>& elements) const {
    if (elements.size() > 1) {
        return tr("%1 parts").arg(elements.size());
    }
    const QString label = labelOf(document_->project(), elements.front());
    return elements.front().isShape()
               //: A shape of a body: "box 2 of chassis".
               ? tr("%1 of %2", "shape")
                     .arg(inSentence(label),
                          QString::fromStdString(nameOf(document_->project(), elements.front())))
               : label;
}

bool PartsTree::apply(const QString& text, const simcore::Result<Project>& next) {
    if (!next) {
        emit refused(QString::fromStdString(toString(next.problems().front())));
        return false;
    }
    document_->endMerging();
    document_->edit(text, *next);
    return true;
}

void PartsTree::selectThese(const std::vector<ElementRef>& elements) {
    if (elements.empty()) {
        return;
    }
    refreshing_ = true;
    clearSelection();
    for (const ElementRef element : elements) {
        if (const auto found = items_.find(element); found != items_.end()) {
            reveal(found->second);
            found->second->setSelected(true);
        }
    }
    if (const auto found = items_.find(elements.front()); found != items_.end()) {
        setCurrentItem(found->second, 0, QItemSelectionModel::Select | QItemSelectionModel::Rows);
        scrollToItem(found->second);
    }
    refreshing_ = false;
    emit selectionMoved();
}

void PartsTree::selectAppended(const Project& before, ElementRef current) {
    std::vector<ElementRef> fresh = appended(before, document_->project());
    if (current.index >= 0) {
        fresh = {current};
    }
    // What was looked for is found, or the new parts would be hidden.
    for (const ElementRef element : fresh) {
        if (const auto found = items_.find(element);
            found != items_.end() && found->second->isHidden()) {
            emit filterCleared();
            break;
        }
    }
    selectThese(fresh);
    if (!fresh.empty()) {
        emit elementSelected(fresh.front());
    }
}

void PartsTree::add(ElementKind kind) {
    const Project before = document_->project();
    if (apply(tr("Add %1").arg(inSentence(kindTitle(kind))), added(before, kind))) {
        // What came with it is not what was asked for.
        selectAppended(before, {kind, countOf(document_->project(), kind) - 1});
    }
}

int PartsTree::currentBody() const {
    const ElementRef current = selected();
    if (current.index < 0) {
        return -1;
    }
    const Project& project = document_->project();
    const auto at = static_cast<std::size_t>(current.index);
    const auto named = [&](const std::string& body) {
        return simcore::project::findElement(project, ElementKind::Body, body).index;
    };
    switch (current.kind) {
        case ElementKind::Body:
            return current.index;
        case ElementKind::Wheel:
            return named(project.rover.wheels[at].body);
        case ElementKind::Payload:
            return named(project.rover.payloads[at].body);
        default:
            return -1;
    }
}

void PartsTree::addShape(ShapeKind kind) {
    const Project before = document_->project();
    if (apply(tr("Add %1").arg(inSentence(kindTitle(kind))),
              withNewShape(before, currentBody(), kind))) {
        selectAppended(before);
    }
}

void PartsTree::deleteSelected() {
    const std::vector<ElementRef> elements = selection();
    if (!elements.empty()) {
        apply(tr("Delete %1").arg(titleOf(elements)), removed(document_->project(), elements));
    }
}

void PartsTree::duplicateSelected() {
    const std::vector<ElementRef> elements = selection();
    if (elements.empty()) {
        return;
    }
    const Project before = document_->project();
    const QString text = tr("Duplicate %1").arg(titleOf(elements));
    if (elements.size() > 1) {
        // Copies refer to each other as the originals do.
        if (apply(text, duplicated(before, elements))) {
            selectAppended(before);
        }
        return;
    }
    const ElementRef element = elements.front();
    if (apply(text, duplicated(before, element))) {
        ElementRef copy = element;
        (copy.isShape() ? copy.shape : copy.index)++;
        selectAppended(before, copy);
    }
}

void PartsTree::copySelected() {
    const std::vector<ElementRef> elements = selection();
    if (!elements.empty()) {
        clipboard::copyParts(document_->project(), elements);
        emit message(tr("Copied %1").arg(titleOf(elements)));
    }
}

void PartsTree::cutSelected() {
    const std::vector<ElementRef> elements = selection();
    if (elements.empty()) {
        return;
    }
    const Project before = document_->project();
    if (apply(tr("Cut %1").arg(titleOf(elements)), removed(before, elements))) {
        clipboard::copyParts(before, elements);
    }
}

void PartsTree::paste() {
    const Project before = document_->project();
    const auto next = clipboard::pasted(before, currentBody());
    if (!next) {
        apply({}, next);
        return;
    }
    const auto fresh = appended(before, *next);
    const QString what = fresh.size() != 1         ? tr("%1 parts").arg(fresh.size())
                         : fresh.front().isShape() ? inSentence(labelOf(*next, fresh.front()))
                                                   : labelOf(*next, fresh.front());
    if (apply(tr("Paste %1").arg(what), next)) {
        selectAppended(before);
    }
}

void PartsTree::mirrorSelected() {
    const std::vector<ElementRef> elements = selection();
    if (elements.empty()) {
        return;
    }
    const auto next = mirrored(document_->project(), elements, true);
    if (next && *next == document_->project()) {
        emit message(tr("It is mirrored already."));
        return;
    }
    apply(tr("Mirror %1").arg(titleOf(elements)), next);
}

void PartsTree::splitSelected() {
    const std::vector<ElementRef> elements = selection();
    if (!elements.empty()) {
        const ElementRef current = selected();
        if (apply(tr("Split %1").arg(titleOf(elements)), split(document_->project(), elements)) &&
            current.index >= 0) {
            select(current);
            emit elementSelected(current);
        }
    }
}

void PartsTree::moveTo(const std::vector<ElementRef>& elements, int place) {
    const bool chassisBefore = !document_->project().rover.bodies.empty();
    const std::string chassis =
        chassisBefore ? document_->project().rover.bodies.front().name : std::string();
    const QString text = tr("Move %1").arg(titleOf(elements));
    simcore::Result<Project> next = document_->project();
    std::vector<ElementRef> now;
    now.reserve(elements.size());
    int before = 0;
    int behind = 0;
    for (const ElementRef element : elements) {
        if (!next) {
            break;
        }
        // Those that came from before the place have made it one less each time.
        const bool fromBefore = element.index < place;
        const ElementRef from{element.kind, element.index - (fromBefore ? before : 0)};
        const int to = fromBefore ? place - 1 : place + behind;
        next = moved(*next, from, to);
        (fromBefore ? before : behind)++;
    }
    if (!apply(text, next)) {
        return;
    }
    for (int i = 0; i < static_cast<int>(elements.size()); ++i) {
        now.push_back({elements.front().kind, place - before + i});
    }
    selectThese(now);
    emit elementSelected(now.front());
    const auto& bodies = document_->project().rover.bodies;
    if (chassisBefore && bodies.front().name != chassis) {
        emit message(tr("The first body is the chassis: that is %1 now.")
                         .arg(QString::fromStdString(bodies.front().name)));
    }
}

void PartsTree::moveShapesTo(const std::vector<ElementRef>& shapes, int body, int place) {
    const QString text = tr("Move %1").arg(titleOf(shapes));
    if (!apply(text, withShapesMoved(document_->project(), shapes, body, place))) {
        return;
    }
    const auto before = std::count_if(shapes.begin(), shapes.end(), [&](ElementRef shape) {
        return shape.index == body && shape.shape < place;
    });
    std::vector<ElementRef> now;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        now.push_back(
            {ElementKind::Body, body, place - static_cast<int>(before) + static_cast<int>(i)});
    }
    selectThese(now);
    emit elementSelected(now.front());
}

void PartsTree::moveSelected(int by) {
    const ElementRef current = selected();
    std::vector<ElementRef> elements = selection();
    std::erase_if(elements, [&](ElementRef one) {
        return one.kind != current.kind || one.isShape() != current.isShape() ||
               (current.isShape() && one.index != current.index);
    });
    if (elements.empty()) {
        return;
    }
    if (current.isShape()) {
        const int place = by < 0 ? elements.front().shape - 1 : elements.back().shape + 2;
        if (place >= 0 && place <= shapeCountOf(document_->project(), current.index)) {
            moveShapesTo(elements, current.index, place);
        }
        return;
    }
    const int place = by < 0 ? elements.front().index - 1 : elements.back().index + 2;
    if (place >= 0 && place <= countOf(document_->project(), current.kind)) {
        moveTo(elements, place);
    }
}

ElementRef PartsTree::dropPlace(QDropEvent* event) const {
    const std::vector<ElementRef> elements = selection();
    const QTreeWidgetItem* target = itemAt(event->position().toPoint());
    if (elements.empty() || event->source() != this || target == nullptr) {
        return {};
    }
    const ElementRef over = elementOf(target);
    const bool shapes = elements.front().isShape();
    for (const ElementRef element : elements) {
        if (element.kind != over.kind || element.isShape() != shapes) {
            return {};
        }
    }
    const int below = event->position().y() > visualItemRect(target).center().y() ? 1 : 0;
    if (shapes) {
        return over.index < 0   ? ElementRef{}
               : over.isShape() ? ElementRef{over.kind, over.index, over.shape + below}
                                // The body itself: behind its last one.
                                : ElementRef{over.kind, over.index,
                                             shapeCountOf(document_->project(), over.index)};
    }
    if (over.index < 0) {
        return {over.kind, 0};  // the title of the group: to its beginning
    }
    return {over.kind, over.index + (over.isShape() ? 1 : below)};
}

void PartsTree::dragMoveEvent(QDragMoveEvent* event) {
    QTreeWidget::dragMoveEvent(event);  // scrolls, and shows where
    event->setDropAction(Qt::MoveAction);
    dropPlace(event).index < 0 ? event->ignore() : event->accept();
}

void PartsTree::startDrag(Qt::DropActions /*actions*/) {
    // Not the view's own: that takes the items away, but it is the project that moves its parts.
    auto* drag = new QDrag(this);
    drag->setMimeData(model()->mimeData(selectedIndexes()));
    drag->exec(Qt::MoveAction);
}

void PartsTree::dropEvent(QDropEvent* event) {
    const ElementRef place = dropPlace(event);
    if (place.index < 0) {
        event->ignore();
        return;
    }
    event->accept();
    if (place.isShape()) {
        moveShapesTo(selection(), place.index, place.shape);
    } else {
        moveTo(selection(), place.index);
    }
    setState(QAbstractItemView::NoState);
    viewport()->update();
}

void PartsTree::renameSelected() {
    if (selected().isShape()) {
        emit message(tr("A shape has no name."));
    } else if (selected().index >= 0) {
        setFocus();
        editItem(currentItem(), 0);
    }
}

void PartsTree::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    for (QAction* action : menuActions_) {
        if (action == nullptr) {
            menu.addSeparator();
        } else {
            menu.addAction(action);
        }
    }
    if (!menu.isEmpty()) {
        menu.exec(event->globalPos());
    }
}

}  // namespace widgets
