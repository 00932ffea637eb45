// The joint graph in the real window: what it draws, and that selection goes both ways.
#include <QGraphicsItem>
#include <QGraphicsScene>
#include <QLabel>
#include <QToolButton>
#include <QWheelEvent>

#include <gmock/gmock.h>

#include "tests/support/studio.h"
#include "widgets/editors/parts_tree.h"
#include "widgets/panels/graph_panel.h"
#include "widgets/panels/mobility_panel.h"

using simcore::mobility::Model;
using testsupport::waitUntil;

namespace {

class GraphPanelTest : public testsupport::StudioTest {
  protected:
    GraphPanelTest() {
        press(Qt::Key_G, Qt::ControlModifier);
        EXPECT_TRUE(waitUntil([&] { return !view().scene()->items().isEmpty(); }));
    }

    widgets::GraphView& view() { return *find<widgets::GraphView>("jointGraph"); }

    /// Named items of the scene: bodies, joints and contacts.
    QList<QGraphicsItem*> named() {
        QList<QGraphicsItem*> items = view().scene()->items();
        items.removeIf([](QGraphicsItem* item) { return item->data(0).toString().isEmpty(); });
        return items;
    }

    QGraphicsItem* itemOf(const QString& name, bool joint) {
        for (QGraphicsItem* item : named()) {
            if (item->data(0) == name && item->data(1).toBool() == joint &&
                !item->data(2).toBool()) {
                return item;
            }
        }
        ADD_FAILURE() << name.toStdString();
        return nullptr;
    }

    const simcore::mechanism::Mechanism& mechanism() {
        return *window->document().derived().mechanism;
    }

    int couldGo() {
        const auto items = named();
        return static_cast<int>(std::count_if(items.begin(), items.end(), [](auto* item) {
            return item->data(0).isValid() && item->toolTip().contains("could go") &&
                   !item->toolTip().contains(" 0 of these could go");
        }));
    }
};

}  // namespace

TEST_F(GraphPanelTest, DrawsEveryBodyJointAndContact) {
    EXPECT_EQ(named().size(),
              static_cast<int>(mechanism().bodies.size() + mechanism().joints.size() +
                               mechanism().wheels.size()));
    EXPECT_THAT(itemOf("fork_a", true)->toolTip().toStdString(),
                testing::StartsWith("fork_a: 1 free, 5 held"));
    std::set<std::string> elements;
    for (const auto& constraint : window->document().derived().built.removable) {
        elements.insert(constraint.element);
    }
    EXPECT_EQ(couldGo(), static_cast<int>(elements.size()));
    // The whole is in view.
    EXPECT_TRUE(view()
                    .mapToScene(view().viewport()->rect())
                    .boundingRect()
                    .contains(view().scene()->itemsBoundingRect()));
}

TEST_F(GraphPanelTest, FollowsTheModelAndEdits) {
    window->mobility().setModel(Model::Relaxed);
    EXPECT_EQ(couldGo(), 0);
    window->mobility().setModel(Model::Built);
    auto next = window->document().project();
    next.rover.bodies.front().name = "hull";
    for (auto& joint : next.rover.joints) {
        for (std::string* body : {&joint.first, &joint.second}) {
            *body = *body == "chassis" ? "hull" : *body;
        }
    }
    window->document().edit("Rename", next);
    EXPECT_NE(itemOf("hull", false), nullptr);
}

TEST_F(GraphPanelTest, ClickSelectsEverywhereAndSelectionMarksTheGraph) {
    QGraphicsItem* fork = itemOf("fork_a", true);
    ASSERT_NE(fork, nullptr);
    fork->setSelected(true);
    EXPECT_EQ(window->scene().highlighted().joints,
              std::vector<int>{mechanism().findJoint("fork_a")});
    const auto* tree = window->findChild<widgets::PartsTree*>();
    EXPECT_EQ(tree->selected().kind, simcore::project::ElementKind::Joint);
    QGraphicsItem* chassis = itemOf(QString::fromStdString(mechanism().bodies.front().name), false);
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {},
                      view().mapFromScene(chassis->boundingRect().center()));
    EXPECT_EQ(window->scene().highlighted().bodies, std::vector<int>{0});
    EXPECT_FALSE(fork->isSelected());
    EXPECT_TRUE(chassis->isSelected());
    // The other way: a joint chosen in the mobility panel.
    const int joint = mechanism().findJoint("fork_c");
    emit window->mobility().jointChosen(joint);
    EXPECT_TRUE(itemOf("fork_c", true)->isSelected());
    EXPECT_FALSE(chassis->isSelected());
}

TEST_F(GraphPanelTest, WheelZoomsAndFitShowsAllAgain) {
    const double before = view().transform().m11();
    const QPointF middle = view().viewport()->rect().center();
    QWheelEvent event(middle, view().viewport()->mapToGlobal(middle), {}, QPoint(0, 480),
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(view().viewport(), &event);
    EXPECT_GT(view().transform().m11(), 1.5 * before);
    QTest::mouseClick(find<QToolButton>("graphFit"), Qt::LeftButton);
    EXPECT_NEAR(view().transform().m11(), before, 0.02 * before);
}

TEST_F(GraphPanelTest, BrokenRoverSaysSo) {
    auto next = window->document().project();
    next.rover.joints.front().first = "nowhere";
    window->document().edit("Break", next);
    EXPECT_TRUE(named().isEmpty());
    EXPECT_THAT(find<QLabel>("graphLegend")->text().toStdString(), testing::HasSubstr("No graph"));
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(named().isEmpty());
}

TEST_F(GraphPanelTest, EveryWidgetHasANameForReaders) {
    for (const char* name : {"jointGraph", "graphLegend", "graphFit", "graphDock"}) {
        EXPECT_FALSE(find<QWidget>(name)->accessibleName().isEmpty()) << name;
    }
}
