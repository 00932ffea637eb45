// Editing in the real window: fields, sliders, properties, mobility and mass panels.
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTabWidget>
#include <QTreeWidget>

#include <gmock/gmock.h>

#include "tests/support/studio.h"
#include "widgets/editors/parts_tree.h"
#include "widgets/editors/property_panel.h"
#include "widgets/panels/mass_panel.h"
#include "widgets/panels/mobility_panel.h"
#include "widgets/panels/problems_panel.h"

using simcore::project::ElementKind;
using testsupport::waitUntil;
using widgets::QuantityField;

namespace {

class EditingTest : public testsupport::StudioTest {
  protected:
    /// Text of a cell of the mobility table: rows as in the panel, column 0 built, 1 relaxed.
    QString mobilityCell(int row, int model) {
        QString text = find<QLabel>(QString("mobility:%1:%2").arg(row).arg(model))->text();
        return text.remove("<b>").remove("</b>");
    }

    QTreeWidgetItem* treeItem(const QString& name) {
        const auto items = find<QWidget>("roverDock")
                               ->findChild<widgets::PartsTree*>()
                               ->findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
        EXPECT_EQ(items.size(), 1) << name.toStdString();
        return items.isEmpty() ? nullptr : items.front();
    }

    void clickInTree(const QString& name) {
        auto* tree = window->findChild<widgets::PartsTree*>();
        QTreeWidgetItem* item = treeItem(name);
        ASSERT_NE(item, nullptr);
        tree->scrollToItem(item);
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {},
                          tree->visualItemRect(item).center());
    }
};

}  // namespace

TEST_F(EditingTest, TypedMillimetresBecomeMetres) {
    type(parameter("wheel_radius"), "80");
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.08);
    EXPECT_EQ(parameter("wheel_radius")->text(), "80 mm");
    EXPECT_TRUE(window->isWindowModified());
}

TEST_F(EditingTest, OtherUnitsAndExpressionsAreTaken) {
    type(parameter("wheel_radius"), "8.5 cm");
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.085);
    type(parameter("wheel_width"), "wheel_radius/2");
    EXPECT_DOUBLE_EQ(parameterValue("wheel_width"), 0.0425);
    EXPECT_EQ(parameter("wheel_width")->text(), "wheel_radius/2");
    EXPECT_FALSE(find<QSlider>("slider:wheel_width")->isEnabled());
    type(parameter("wheel_radius"), "100 mm");
    EXPECT_DOUBLE_EQ(parameterValue("wheel_width"), 0.05);
}

TEST_F(EditingTest, RefusedTextStaysWithItsReasonAndEscapeBringsTheOldBack) {
    QuantityField* field = parameter("wheel_radius");
    for (const QString& bad : {QString("7 kg"), QString("5 m"), QString("7 +"), QString("nothing"),
                               QString("wheel_radius + 1 mm")}) {
        type(field, bad);
        EXPECT_EQ(field->text(), bad);
        EXPECT_FALSE(field->refusal().isEmpty()) << bad.toStdString();
        EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.07) << bad.toStdString();
        EXPECT_FALSE(window->document().isModified());
        QTest::keyClick(field, Qt::Key_Escape);
        EXPECT_EQ(field->text(), "70 mm");
        EXPECT_TRUE(field->refusal().isEmpty());
    }
}

TEST_F(EditingTest, UndoAndRedoByKeysRestoreTheNumber) {
    type(parameter("wheel_radius"), "80");
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.07);
    EXPECT_EQ(parameter("wheel_radius")->text(), "70 mm");
    EXPECT_FALSE(window->isWindowModified());
    press(Qt::Key_Y, Qt::ControlModifier);
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.08);
    press(Qt::Key_Z, Qt::ControlModifier);
    press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.08);
}

TEST_F(EditingTest, ArrowKeysStepANumberAndMergeIntoOneUndoStep) {
    QuantityField* field = parameter("wheel_radius");
    QTest::mouseClick(field, Qt::LeftButton);
    for (int i = 0; i < 3; ++i) {
        QTest::keyClick(field, Qt::Key_Up);
    }
    EXPECT_NEAR(parameterValue("wheel_radius"), 0.073, 1e-12);
    EXPECT_EQ(window->document().undoStack().count(), 1);
    QTest::keyClick(field, Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_NEAR(parameterValue("wheel_radius"), 0.063, 1e-12);
}

TEST_F(EditingTest, SliderDragIsOneUndoStepAndRefreshesTheScene) {
    auto* slider = find<QSlider>("slider:wheel_radius");
    const double reach = window->scene().focusRadius();
    const QPoint start(slider->width() / 5, slider->height() / 2);
    QTest::mousePress(slider, Qt::LeftButton, {}, start);
    for (int i = 1; i <= 10; ++i) {
        QTest::mouseMove(slider, start + QPoint(4 * i, 0));
    }
    QTest::mouseRelease(slider, Qt::LeftButton, {}, start + QPoint(40, 0));
    EXPECT_GT(parameterValue("wheel_radius"), 0.08);
    EXPECT_NE(window->scene().focusRadius(), reach);
    // A press beside the handle pages once before the drag; never more than two steps.
    EXPECT_LE(window->document().undoStack().count(), 2);
    while (window->document().undoStack().canUndo()) {
        press(Qt::Key_Z, Qt::ControlModifier);
    }
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.07);
}

// The fork alone is a planar four-bar: -2 by Grübler, 1 in truth, 3 redundant; relaxed exact.
TEST_F(EditingTest, MobilityPanelCountsTheSelectionAlone) {
    const QString minus(QChar(0x2212));
    auto* tree = window->findChild<widgets::PartsTree*>();
    const auto click = [&](const QString& name, Qt::KeyboardModifiers keys) {
        for (QTreeWidgetItem* item : tree->findItems(name, Qt::MatchExactly | Qt::MatchRecursive)) {
            if (item->parent() != nullptr && item->parent()->text(0) == "Bodies") {
                item->parent()->setExpanded(true);
                tree->scrollToItem(item);
                QTest::mouseClick(tree->viewport(), Qt::LeftButton, keys,
                                  tree->visualItemRect(item).center());
            }
        }
    };
    auto* scope = find<QComboBox>("mobilityScope");
    QTest::keyClick(scope, Qt::Key_Down);
    ASSERT_EQ(scope->currentText(), "Selection");
    // Nothing is selected yet.
    EXPECT_EQ(mobilityCell(0, 0), QString(QChar(0x2013)));
    EXPECT_EQ(find<QLabel>("headline")->text(), "Nothing to count");

    click("chassis", {});
    for (const char* body : {"fork_upper", "fork_lower", "fork_arm"}) {
        click(body, Qt::ControlModifier);
    }
    ASSERT_EQ(tree->selection().size(), 4U);
    const QStringList built{minus + "2", "3, 4", "20", "17", "+1", "3"};
    const QStringList relaxed{"+1", "3, 4", "17", "17", "+1", "0"};
    for (int row = 0; row < 6; ++row) {
        EXPECT_EQ(mobilityCell(row, 0).toStdString(), built[row].toStdString()) << row;
        EXPECT_EQ(mobilityCell(row, 1).toStdString(), relaxed[row].toStdString()) << row;
    }
    EXPECT_EQ(find<QLabel>("headline")->text(), "Hyperstatic: 3 redundant constraints");

    // One loop; choosing it marks its four joints.
    auto* kind = find<QComboBox>("mobilityKind");
    auto* list = find<QTreeWidget>("removableList");
    QStringList marked;
    QObject::connect(&window->mobility(), &widgets::MobilityPanel::marked, list,
                     [&](const QStringList& joints) { marked = joints; });
    QTest::keyClick(kind, Qt::Key_Down);
    ASSERT_EQ(list->topLevelItemCount(), 1);
    EXPECT_EQ(list->topLevelItem(0)->text(1), "3 redundant");
    EXPECT_TRUE(list->topLevelItem(0)->child(0)->text(0).contains("rank 17"));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->topLevelItem(0)).center());
    EXPECT_EQ(marked.size(), 4);

    // What cannot be known: of every pin the loads give the two forces in the plane.
    QTest::keyClick(kind, Qt::Key_Down);
    EXPECT_TRUE(marked.empty());
    ASSERT_EQ(list->topLevelItemCount(), 4);
    EXPECT_TRUE(list->topLevelItem(0)->text(0).endsWith(": 2 of 5 known"));
    EXPECT_TRUE(find<QLabel>("mobilityListTitle")->text().startsWith("Of 20 components"));
    double parts = 0.0;
    for (int i = 0; i < 4; ++i) {
        parts += list->topLevelItem(i)->data(1, Qt::UserRole + 2).toDouble();
    }
    EXPECT_NEAR(parts, 1.0, 1e-9);

    // An edit that takes a part away, and undo.
    click("fork_arm", {});
    EXPECT_EQ(find<QLabel>("headline")->text(), "Nothing to count");
    QTest::keyClick(scope, Qt::Key_Up);
    EXPECT_EQ(mobilityCell(0, 0).toStdString(), (minus + "20").toStdString());
}

// A click with Ctrl in the 3-D view collects parts.
TEST_F(EditingTest, PicksWithControlAreCollected) {
    if (window->viewport() == nullptr) {
        GTEST_SKIP() << "no OpenGL";
    }
    auto* tree = window->findChild<widgets::PartsTree*>();
    const auto& mechanism = *window->document().derived().mechanism;
    QTest::keyClick(find<QComboBox>("mobilityScope"), Qt::Key_Down);
    emit window->viewport()->bodyPicked(mechanism.findBody("chassis"));
    emit window->viewport()->bodyPicked(mechanism.findBody("fork_upper"), true);
    EXPECT_EQ(tree->selection().size(), 2U);
    EXPECT_EQ(mobilityCell(1, 0), "1, 1");
    emit window->viewport()->bodyPicked(-1, true);
    EXPECT_EQ(tree->selection().size(), 2U);
    emit window->viewport()->bodyPicked(mechanism.findBody("fork_upper"), true);
    EXPECT_EQ(tree->selection().size(), 1U);
    emit window->viewport()->jointPicked(mechanism.findJoint("bogie_left_upper_pivot"));
    EXPECT_EQ(mobilityCell(4, 0), "+2");  // mirrored: both pins are in the chassis
}

TEST_F(EditingTest, MobilityPanelShowsThePublishedCountsOfBothModels) {
    const QString minus(QChar(0x2212));
    const QStringList built{minus + "20", "18, 28", "128", "107", "+1", "21"};
    const QStringList relaxed{"+1", "18, 28", "107", "107", "+1", "0"};
    for (int row = 0; row < built.size(); ++row) {
        EXPECT_EQ(mobilityCell(row, 0).toStdString(), built[row].toStdString()) << row;
        EXPECT_EQ(mobilityCell(row, 1).toStdString(), relaxed[row].toStdString()) << row;
    }
    EXPECT_EQ(find<QLabel>("headline")->text(), "Hyperstatic: 21 redundant constraints");
    QTest::mouseClick(find<QPushButton>("modelRelaxed"), Qt::LeftButton);
    EXPECT_EQ(find<QLabel>("headline")->text(), "Statically determinate");
}

TEST_F(EditingTest, FreeingAJointChangesTheCountAtOnce) {
    clickInTree("Joints");
    QTest::keyClick(window->findChild<widgets::PartsTree*>(), Qt::Key_Right);
    treeItem("fork_b")->parent()->setExpanded(true);
    clickInTree("fork_b");
    auto* panel = window->findChild<widgets::PropertyPanel*>();
    ASSERT_EQ(panel->element().kind, ElementKind::Joint);
    QLineEdit* free = nullptr;
    for (QLineEdit* line : panel->findChildren<QLineEdit*>()) {
        free = line->text() == "turn axis" ? line : free;
    }
    ASSERT_NE(free, nullptr);
    type(free, "turn x, turn y, turn z");
    EXPECT_EQ(mobilityCell(0, 0).toStdString(), (QChar(0x2212) + QString("18")).toStdString());
    EXPECT_EQ(mobilityCell(2, 0).toStdString(), "126");
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(mobilityCell(2, 0).toStdString(), "128");
}

TEST_F(EditingTest, ChoosingARemovableConstraintSelectsItsJoint) {
    auto* list = find<QTreeWidget>("removableList");
    QTreeWidgetItem* item = nullptr;
    for (int i = 0; i < list->topLevelItemCount(); ++i) {
        if (list->topLevelItem(i)->text(0) == "bogie_right_lower_front") {
            item = list->topLevelItem(i);
        }
    }
    ASSERT_NE(item, nullptr);
    list->scrollToItem(item);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(item).center());
    auto* panel = window->findChild<widgets::PropertyPanel*>();
    EXPECT_EQ(panel->element().kind, ElementKind::Joint);
    EXPECT_EQ(nameOf(window->document().project(), panel->element()), "bogie_{side}_lower_front");
    // It is marked in the 3D view, also after an edit has drawn the rover anew.
    const auto marked = [this] {
        const std::vector<int>& joints = window->scene().highlighted().joints;
        return joints.size() != 1 ? std::string()
                                  : window->document()
                                        .derived()
                                        .mechanism->joints.at(static_cast<std::size_t>(joints[0]))
                                        .name;
    };
    EXPECT_EQ(marked(), "bogie_right_lower_front");
    find<QTabWidget>("editors")->setCurrentIndex(0);
    type(parameter("wheel_radius"), "80");
    EXPECT_EQ(parameterValue("wheel_radius"), 0.08);
    EXPECT_EQ(marked(), "bogie_right_lower_front");
}

TEST_F(EditingTest, CentreOfMassIsMovedByEditingIt) {
    QTest::mouseClick(find<QWidget>("massDock"), Qt::LeftButton);
    find<QWidget>("massDock")->raise();
    const simcore::Vec3 before = window->document().derived().mechanism->centerOfMass();
    const double mass = window->document().derived().mechanism->mass();
    type(find<QuantityField>("com:2"), "250");
    type(find<QuantityField>("com:0"), "3 cm");
    const auto& mechanism = *window->document().derived().mechanism;
    EXPECT_NEAR(mechanism.centerOfMass().z(), 0.25, 1e-9);
    EXPECT_NEAR(mechanism.centerOfMass().x(), 0.03, 1e-9);
    EXPECT_NEAR(mechanism.centerOfMass().y(), before.y(), 1e-12);
    EXPECT_NEAR(mechanism.mass(), mass, 1e-12);
    EXPECT_EQ(find<QuantityField>("com:2")->text(), "250 mm");
}

TEST_F(EditingTest, PropertyEditChangesTheElementAndReferencesFollowARename) {
    clickInTree("Bodies");
    treeItem("fork_arm")->parent()->setExpanded(true);
    clickInTree("fork_arm");
    auto* panel = window->findChild<widgets::PropertyPanel*>();
    type(panel->findChild<QLineEdit*>("property:name"), "front_fork");
    EXPECT_FALSE(hasCritical(window->document().derived().problems));
    EXPECT_GE(window->document().derived().mechanism->findBody("front_fork"), 0);
    type(panel->findChild<QuantityField*>("property:mass"), "0.9 kg");
    const auto& mechanism = *window->document().derived().mechanism;
    const auto& body = mechanism.bodies[static_cast<std::size_t>(mechanism.findBody("front_fork"))];
    EXPECT_NEAR(body.mass, 0.9, 1e-12);
}

TEST_F(EditingTest, BrokenReferenceIsListedAndLeadsToTheElement) {
    clickInTree("Joints");
    treeItem("fork_a")->parent()->setExpanded(true);
    clickInTree("fork_a");
    auto* panel = window->findChild<widgets::PropertyPanel*>();
    auto* second = panel->findChildren<QComboBox*>().at(1);
    second->setCurrentIndex(0);  // (none)
    emit second->activated(0);
    auto* problems = window->findChild<widgets::ProblemsPanel*>();
    EXPECT_GE(problems->count(), 1);
    // Nothing in the window is lost meanwhile; undo repairs it.
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(problems->count(), 0);
    EXPECT_TRUE(window->document().derived().mechanism.has_value());
}

TEST_F(EditingTest, DeletingAUsedPartIsRefusedAndAFreeOneIsUndoable) {
    clickInTree("Bodies");
    treeItem("fork_arm")->parent()->setExpanded(true);
    clickInTree("fork_arm");
    const auto bodies = window->document().project().rover.bodies.size();
    press(Qt::Key_Delete);
    EXPECT_EQ(window->document().project().rover.bodies.size(), bodies);
    clickInTree("Payloads");
    treeItem("spring_upper_end")->parent()->setExpanded(true);
    clickInTree("spring_upper_end");
    const double mass = window->document().derived().mechanism->mass();
    press(Qt::Key_Delete);
    EXPECT_NEAR(window->document().derived().mechanism->mass(), mass - 0.035, 1e-9);
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_NEAR(window->document().derived().mechanism->mass(), mass, 1e-12);
}

TEST_F(EditingTest, FilterHidesOtherParameters) {
    QLineEdit* filter = nullptr;
    for (QLineEdit* line : window->findChildren<QLineEdit*>()) {
        filter = line->placeholderText() == "Filter parameters" ? line : filter;
    }
    ASSERT_NE(filter, nullptr);
    QTest::mouseClick(filter, Qt::LeftButton);
    QTest::keyClicks(filter, "fork");
    EXPECT_FALSE(parameter("wheel_radius")->isVisible());
    EXPECT_TRUE(parameter("fork_preload")->isVisible());
}

TEST_F(EditingTest, EveryEditorHasAnAccessibleName) {
    for (QWidget* widget : window->findChildren<QWidget*>()) {
        const bool editor = qobject_cast<QLineEdit*>(widget) || qobject_cast<QComboBox*>(widget) ||
                            qobject_cast<QAbstractSlider*>(widget) ||
                            qobject_cast<QAbstractItemView*>(widget);
        // Parts inside other editors (a combo box's list, scroll bars) speak through them.
        const QString type = widget->metaObject()->className();
        const bool inner = qobject_cast<QComboBox*>(widget->parentWidget()) ||
                           qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) ||
                           type == "QScrollBar" || type == "QHeaderView" ||
                           type.startsWith("QComboBoxPrivate") || type == "QComboBoxListView";
        if (editor && !inner) {
            EXPECT_FALSE(widget->accessibleName().isEmpty())
                << type.toStdString() << " " << widget->objectName().toStdString();
        }
    }
}
