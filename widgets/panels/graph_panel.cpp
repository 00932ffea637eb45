#include "widgets/panels/graph_panel.h"

#include <QGraphicsPathItem>
#include <QGraphicsScene>
#include <QGraphicsSceneMouseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <map>

#include "simcore/mobility/joint_graph.h"

namespace widgets {

using simcore::mobility::GraphEdge;
using simcore::mobility::GraphPoint;
using simcore::mobility::JointGraph;
using simcore::mobility::Model;
using simcore::mobility::Report;

namespace {

constexpr double kColumn = 124.0;
constexpr double kLayer = 96.0;
constexpr QSizeF kNode(108.0, 38.0);
constexpr double kBadge = 11.0;
constexpr double kMostZoom = 4.0;
constexpr int kNameRole = 0;
constexpr int kIsJointRole = 1;
constexpr int kIsContactRole = 2;
/// Of what could go; stands out on light and dark.
const QColor kRemovable(0xd9, 0x86, 0x1a);

QPointF inPicture(const GraphPoint& point) {
    return {kColumn * point.x(), kLayer * point.y()};
}

/// A scene keeps the palette that it was made with; the window's theme may have changed since.
QPalette paletteOf(const QStyleOptionGraphicsItem* option, const QWidget* widget) {
    return widget != nullptr ? widget->palette() : option->palette;
}

/// A joint or a contact; wide enough to be hit.
class EdgeItem : public QGraphicsPathItem {
  public:
    EdgeItem(const QPainterPath& path, bool removable)
        : QGraphicsPathItem(path),
          removable_(removable) {
        setFlag(ItemIsSelectable);
    }

    QColor color(const QPalette& palette) const {
        return isSelected() ? palette.color(QPalette::Highlight)
               : removable_ ? kRemovable
                            : palette.color(QPalette::Disabled, QPalette::Text);
    }

    QPainterPath shape() const override {
        QPainterPathStroker stroker;
        stroker.setWidth(10.0);
        return stroker.createStroke(path());
    }

    QRectF boundingRect() const override {
        // With the number, which is drawn anew when the edge is.
        const double margin = kBadge + 3.0;
        return path().boundingRect().adjusted(-margin, -margin, margin, margin);
    }

    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option,
               QWidget* widget) override {
        painter->setPen(QPen(color(paletteOf(option, widget)), isSelected() ? 3.5 : 1.8));
        painter->drawPath(path());
    }

  private:
    bool removable_;
};

/// The number of freedoms on an edge, above all edges; a click on it means the edge.
class BadgeItem : public QGraphicsItem {
  public:
    /// @param place  along the edge, 0 to 1
    BadgeItem(EdgeItem* edge, double place, int freedoms) : edge_(edge), freedoms_(freedoms) {
        setPos(edge->path().pointAtPercent(place));
        setZValue(1.0);
        setToolTip(edge->toolTip());
    }

    QRectF boundingRect() const override {
        return {-kBadge - 2.0, -kBadge - 2.0, 2.0 * kBadge + 4.0, 2.0 * kBadge + 4.0};
    }

    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option,
               QWidget* widget) override {
        const QPalette palette = paletteOf(option, widget);
        const bool chosen = edge_->isSelected();
        painter->setPen(QPen(edge_->color(palette), 1.8));
        painter->setBrush(palette.color(chosen ? QPalette::Highlight : QPalette::Base));
        painter->drawEllipse(QPointF(), kBadge, kBadge);
        painter->setPen(palette.color(chosen ? QPalette::HighlightedText : QPalette::Text));
        painter->drawText(boundingRect(), Qt::AlignCenter, QString::number(freedoms_));
    }

  protected:
    void mousePressEvent(QGraphicsSceneMouseEvent* event) override {
        scene()->clearSelection();
        edge_->setSelected(true);
        event->accept();
    }

  private:
    EdgeItem* edge_;
    int freedoms_;
};

/// A body, or the ground.
class NodeItem : public QGraphicsItem {
  public:
    NodeItem(const QPointF& center, const QSizeF& size, QString text, bool round)
        : place_(center - QPointF(0.5 * size.width(), 0.5 * size.height()), size),
          text_(std::move(text)),
          round_(round) {
        setZValue(2.0);
    }

    QRectF boundingRect() const override { return place_.adjusted(-3, -3, 3, 3); }

    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option,
               QWidget* widget) override {
        const QPalette palette = paletteOf(option, widget);
        painter->setPen(QPen(palette.color(isSelected() ? QPalette::Highlight : QPalette::Mid),
                             isSelected() ? 2.5 : 1.2));
        painter->setBrush(palette.color(isSelected() ? QPalette::Highlight : QPalette::Button));
        const double radius = round_ ? 0.5 * place_.height() : 5.0;
        painter->drawRoundedRect(place_, radius, radius);
        painter->setPen(
            palette.color(isSelected() ? QPalette::HighlightedText : QPalette::ButtonText));
        // Names may break after an underscore.
        QString text = text_;
        text.replace('_', QString("_") + QChar(0x200b));
        painter->drawText(place_.adjusted(3, 1, -3, -1), Qt::AlignCenter | Qt::TextWordWrap, text);
    }

  private:
    QRectF place_;
    QString text_;
    bool round_;
};

/// Upright at every layer; along a layer it passes below what stands there.
QPainterPath curve(const GraphEdge& edge, double aside) {
    QPainterPath path(inPicture(edge.path.front()));
    for (std::size_t i = 1; i < edge.path.size(); ++i) {
        const QPointF from = inPicture(edge.path[i - 1]);
        const QPointF to = inPicture(edge.path[i]);
        const QPointF shift(aside, 0.0);
        if (from.y() == to.y()) {
            path.quadTo(0.5 * (from + to) + QPointF(0.0, 0.9 * kLayer + aside), to);
        } else {
            const double y = 0.5 * (from.y() + to.y());
            path.cubicTo(QPointF(from.x(), y) + shift, QPointF(to.x(), y) + shift, to);
        }
    }
    return path;
}

/// Where along a path its number stands clear of the others', which it joins.
double freePlace(const QPainterPath& path, std::vector<QPointF>& taken) {
    for (const double place : {0.5, 0.36, 0.64, 0.28, 0.72}) {
        const QPointF at = path.pointAtPercent(place);
        const bool clear = std::all_of(taken.begin(), taken.end(), [&](const QPointF& other) {
            return std::hypot(other.x() - at.x(), other.y() - at.y()) > 2.2 * kBadge;
        });
        if (clear) {
            taken.push_back(at);
            return place;
        }
    }
    return 0.5;
}

}  // namespace

GraphView::GraphView(QWidget* parent) : QGraphicsView(parent) {
    setScene(new QGraphicsScene(this));
    setObjectName("jointGraph");
    setAccessibleName(tr("Joint graph"));
    setRenderHint(QPainter::Antialiasing);
    setFrameShape(QFrame::NoFrame);
    setDragMode(ScrollHandDrag);
    setTransformationAnchor(AnchorUnderMouse);
}

void GraphView::fit() {
    fitted_ = true;
    const QRectF all = scene()->itemsBoundingRect().adjusted(-12, -12, 12, 12);
    setSceneRect(all);
    fitInView(all, Qt::KeepAspectRatio);
    if (transform().m11() > 1.25) {  // a small graph needs no huge letters
        setTransform(QTransform::fromScale(1.25, 1.25));
    }
}

void GraphView::wheelEvent(QWheelEvent* event) {
    const double factor = std::pow(1.0015, event->angleDelta().y());
    const double next = transform().m11() * factor;
    if (next < kMostZoom && next > 1.0 / kMostZoom) {
        fitted_ = false;
        scale(factor, factor);
    }
    event->accept();
}

void GraphView::resizeEvent(QResizeEvent* event) {
    QGraphicsView::resizeEvent(event);
    if (fitted_) {
        fit();
    }
}

GraphPanel::GraphPanel(Document* document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      view_(new GraphView),
      legend_(new QLabel) {
    setAccessibleName(tr("Joint graph"));
    legend_->setObjectName("graphLegend");
    legend_->setAccessibleName(tr("What the graph shows"));
    legend_->setWordWrap(true);
    auto* fit = new QToolButton;
    fit->setObjectName("graphFit");
    fit->setText(tr("Fit"));
    fit->setAccessibleName(tr("Fit the graph"));
    fit->setToolTip(tr("Show the whole graph; the mouse wheel zooms"));
    auto* row = new QHBoxLayout;
    row->addWidget(legend_, 1);
    row->addWidget(fit);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 8);
    layout->setSpacing(6);
    layout->addLayout(row);
    layout->addWidget(view_, 1);
    connect(fit, &QToolButton::clicked, view_, &GraphView::fit);
    connect(view_->scene(), &QGraphicsScene::selectionChanged, this, &GraphPanel::choose);
    connect(document_, &Document::changed, this, &GraphPanel::draw);
}

void GraphPanel::setModel(Model model) {
    model_ = model;
    draw();
}

void GraphPanel::setActive(bool active) {
    active_ = active;
    if (active_ && outdated_) {
        draw();
    }
}

void GraphPanel::select(const QString& joint, const QString& body) {
    joint_ = joint;
    body_ = body;
    showSelection();
}

void GraphPanel::draw() {
    outdated_ = !active_;
    if (!active_) {
        return;
    }
    refreshing_ = true;
    view_->scene()->clear();
    const bool available = document_->derived().mechanism.has_value();
    legend_->setText(
        available
            ? tr("%1: joints and wheel contacts with the number of their freedoms. "
                 "<span style='color:%2'>●</span> Holds what others hold already.")
                  .arg(model_ == Model::Built ? tr("As built") : tr("Relaxed"), kRemovable.name())
            : tr("No graph: the project has problems. They are listed under Problems."));
    if (available) {
        drawEdges();
        drawGears();
        drawBodies();
        view_->fit();
    }
    refreshing_ = false;
    showSelection();
}

void GraphPanel::drawEdges() {
    const auto& mechanism = *document_->derived().mechanism;
    const Report& report =
        model_ == Model::Built ? document_->derived().built : document_->derived().relaxed;
    std::map<std::pair<int, int>, int> removable;  // by joint and wheel
    for (const auto& constraint : report.removable) {
        ++removable[{constraint.joint, constraint.wheel}];
    }
    std::map<std::pair<int, int>, int> between;  // edges drawn, by bodies
    std::vector<QPointF> taken;                  // by numbers
    const JointGraph graph = simcore::mobility::jointGraph(mechanism);
    for (const GraphEdge& edge : graph.edges) {
        QString name;
        int freedoms = 0;
        double aside = 0.0;
        if (edge.joint >= 0) {
            const auto& joint = mechanism.joints[static_cast<std::size_t>(edge.joint)];
            name = QString::fromStdString(joint.name);
            freedoms = static_cast<int>(freedomsOf(joint, model_).size());
            const auto ends = std::minmax(joint.first, joint.second);
            const int earlier = between[{ends.first, ends.second}]++;
            const int steps = (earlier + 1) / 2;  // to either side in turn
            aside = (earlier % 2 == 0 ? 30.0 : -30.0) * steps;
        } else {
            const auto& wheel = mechanism.wheels[static_cast<std::size_t>(edge.wheel)];
            name = QString::fromStdString(wheel.name);
            freedoms = model_ == Model::Relaxed && wheel.relaxedLateral ? 4 : 3;
        }
        const int count = removable[{edge.joint, edge.wheel}];
        const QPainterPath path = curve(edge, aside);
        auto* item = new EdgeItem(path, count > 0);
        item->setData(kNameRole, name);
        item->setData(kIsJointRole, edge.joint >= 0);
        item->setData(kIsContactRole, edge.joint < 0);
        item->setToolTip((edge.joint >= 0
                              ? tr("%1: %2 free, %3 held, %4 of these could go")
                              : tr("contact %1: %2 free, %3 held, %4 of these could go"))
                             .arg(name)
                             .arg(freedoms)
                             .arg(6 - freedoms)
                             .arg(count));
        view_->scene()->addItem(item);
        view_->scene()->addItem(new BadgeItem(item, freePlace(path, taken), freedoms));
    }
}

void GraphPanel::drawGears() {
    const auto& mechanism = *document_->derived().mechanism;
    const JointGraph graph = simcore::mobility::jointGraph(mechanism);
    for (const auto& gear : mechanism.gears) {
        const auto middle = [&](int joint) {
            return curve(graph.edges[static_cast<std::size_t>(joint)], 0.0).pointAtPercent(0.5);
        };
        QPainterPath path(middle(gear.firstJoint));
        path.lineTo(middle(gear.secondJoint));
        auto* item = view_->scene()->addPath(path, QPen(kRemovable, 1.5, Qt::DashLine));
        item->setZValue(-1.0);
        item->setToolTip(tr("gear %1").arg(QString::fromStdString(gear.name)));
    }
}

void GraphPanel::drawBodies() {
    const auto& mechanism = *document_->derived().mechanism;
    const JointGraph graph = simcore::mobility::jointGraph(mechanism);
    std::vector<bool> rolls(mechanism.bodies.size(), false);
    double half = 0.5;
    for (const auto& wheel : mechanism.wheels) {
        const auto body = static_cast<std::size_t>(wheel.body);
        rolls[body] = true;
        half = std::max(half, std::abs(graph.bodies[body].x()) + 0.5);
    }
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        const QString name = QString::fromStdString(mechanism.bodies[b].name);
        auto* item = new NodeItem(inPicture(graph.bodies[b]), kNode, name, rolls[b]);
        item->setFlag(QGraphicsItem::ItemIsSelectable);
        item->setData(kNameRole, name);
        item->setData(kIsJointRole, false);
        item->setToolTip(name);
        view_->scene()->addItem(item);
    }
    if (graph.hasGround) {
        view_->scene()->addItem(new NodeItem(inPicture(graph.ground),
                                             QSizeF(2.0 * half * kColumn, 0.6 * kNode.height()),
                                             tr("ground"), false));
    }
}

void GraphPanel::showSelection() {
    if (!active_) {
        return;
    }
    refreshing_ = true;
    for (QGraphicsItem* item : view_->scene()->items()) {
        const QString name = item->data(kNameRole).toString();
        const bool joint = item->data(kIsJointRole).toBool();
        const bool contact = item->data(kIsContactRole).toBool();
        item->setSelected(!name.isEmpty() && !contact && name == (joint ? joint_ : body_));
    }
    refreshing_ = false;
}

void GraphPanel::choose() {
    const auto chosen = view_->scene()->selectedItems();
    if (refreshing_ || chosen.size() != 1) {
        return;
    }
    const QString name = chosen.front()->data(kNameRole).toString();
    if (chosen.front()->data(kIsJointRole).toBool()) {
        emit jointChosen(name);
    } else if (chosen.front()->data(kIsContactRole).toBool()) {
        const auto& mechanism = *document_->derived().mechanism;
        const int wheel = mechanism.findWheel(name.toStdString());
        const auto body = static_cast<std::size_t>(
            mechanism.wheels[static_cast<std::size_t>(std::max(wheel, 0))].body);
        emit bodyChosen(QString::fromStdString(mechanism.bodies[body].name));
    } else {
        emit bodyChosen(name);
    }
}

}  // namespace widgets
