// Parts of a rover in the real window: adding, several at once, clipboard, mirroring, order,
// search, history; and new rovers from templates.
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QTabWidget>
#include <QToolButton>
#include <QToolTip>
#include <QTreeWidget>
#include <QUndoView>

#include <gmock/gmock.h>

#include "render/scene.h"
#include "simcore/io/project_file.h"
#include "tests/support/dialogs.h"
#include "tests/support/studio.h"
#include "widgets/editors/parts_tree.h"
#include "widgets/editors/property_panel.h"
#include "widgets/window/new_rover_dialog.h"

using simcore::project::ElementKind;
using simcore::project::ElementRef;
using testsupport::onNext;
using testsupport::waitUntil;
using widgets::PartsTree;
using widgets::QuantityField;

namespace {

class PartsTest : public testsupport::StudioTest {
  protected:
    PartsTest() : tree(window->findChild<PartsTree*>()) {
        EXPECT_TRUE(window->document().open(testsupport::projectFile("rocker_bogie")).empty());
        first = text();
    }

    const simcore::project::Project& project() { return window->document().project(); }

    /// What the file would hold, to the byte.
    std::string text() { return simcore::io::formatProject(project()); }

    QTreeWidgetItem* item(const QString& kind, const QString& name) {
        for (int i = 0; i < tree->topLevelItemCount(); ++i) {
            QTreeWidgetItem* group = tree->topLevelItem(i);
            for (int k = 0; group->text(0) == kind && k < group->childCount(); ++k) {
                if (group->child(k)->text(0) == name) {
                    return group->child(k);
                }
            }
        }
        ADD_FAILURE() << "there is no " << name.toStdString();
        return nullptr;
    }

    void click(const QString& kind, const QString& name, Qt::KeyboardModifiers keys = {}) {
        QTreeWidgetItem* found = item(kind, name);
        ASSERT_NE(found, nullptr);
        found->parent()->setExpanded(true);
        tree->scrollToItem(found);
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, keys,
                          tree->visualItemRect(found).center());
    }

    void selectRearWheel() {
        click("Bodies", "{side}_rear_wheel");
        click("Joints", "{side}_rear_axle", Qt::ControlModifier);
        click("Wheels", "{side}_rear", Qt::ControlModifier);
        ASSERT_EQ(tree->selection().size(), 3U);
    }

    /// Clicks on an entry of a menu as soon as it is on the screen.
    static void clickIn(QMenu* menu, const QString& entry) {
        for (int waited = 0; !menu->isVisible() && waited < 100; ++waited) {
            QTest::qWait(20);
        }
        for (QAction* action : menu->actions()) {
            if (action->text() == entry) {
                QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
                return;
            }
        }
        ADD_FAILURE() << "there is no " << entry.toStdString();
        menu->close();
    }

    /// Chooses from the menu of a button with real clicks; from its submenu when one is named.
    static void chooseFrom(QWidget* button, QMenu* menu, const QString& entry,
                           const QString& submenu = {}) {
        QTimer::singleShot(0, button, [menu, entry, submenu] {
            QMenu* inner = menu;
            if (!submenu.isEmpty()) {
                clickIn(menu, submenu);
                for (QAction* action : menu->actions()) {
                    inner = action->text() == submenu ? action->menu() : inner;
                }
            }
            clickIn(inner, entry);
        });
        QTest::mouseClick(button, Qt::LeftButton);
        EXPECT_TRUE(waitUntil([menu] { return !menu->isVisible(); }));
    }

    void addByMenu(const QString& kind) {
        auto* button = find<QToolButton>("addPart");
        chooseFrom(button, button->menu(), kind);
    }

    void addShapeByMenu(const QString& kind) {
        auto* button = find<QToolButton>("addPart");
        chooseFrom(button, button->menu(), kind, "Shape");
    }

    /// Opens the body by key, then clicks on one of its shapes.
    void clickShape(const QString& body, int shape) {
        click("Bodies", body);
        QTest::keyClick(tree, Qt::Key_Right);
        QTreeWidgetItem* found = item("Bodies", body);
        ASSERT_TRUE(found->isExpanded());
        tree->scrollToItem(found->child(shape));
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {},
                          tree->visualItemRect(found->child(shape)).center());
    }

    /// Drags an item onto the upper half of another one.
    void drag(QTreeWidgetItem* from, QTreeWidgetItem* to) {
        QWidget* view = tree->viewport();
        const QPoint start = tree->visualItemRect(from).center();
        const QRect row = tree->visualItemRect(to);
        const QPoint end(row.center().x(), row.top() + 2);
        // The drag has an event loop of its own.
        QTimer::singleShot(200, view, [view, end] {
            QTest::mouseMove(view, end + QPoint(3, 0));
            QTest::qWait(100);
            QTest::mouseMove(view, end);
            QTest::qWait(100);
            QTest::mouseRelease(view, Qt::LeftButton, {}, end);
        });
        QTest::mousePress(view, Qt::LeftButton, {}, start);
        QTest::mouseMove(view, start + QPoint(4, 4));
        QTest::mouseMove(view, start + QPoint(20, 4));
        QTest::qWait(500);
    }

    QString undoText() { return window->document().undoStack().undoText(); }

    void undoAll() {
        while (window->document().undoStack().canUndo()) {
            press(Qt::Key_Z, Qt::ControlModifier);
        }
        EXPECT_EQ(text(), first);
    }

    PartsTree* tree;
    std::string first;
};

}  // namespace

TEST_F(PartsTest, EveryKindIsAddedByTheMenuSelectedAndUndone) {
    const std::vector<std::pair<QString, ElementKind>> kinds{
        {"Parameter", ElementKind::Parameter}, {"Body", ElementKind::Body},
        {"Joint", ElementKind::Joint},         {"Wheel", ElementKind::Wheel},
        {"Spring", ElementKind::Spring},       {"Differential", ElementKind::Gear},
        {"Payload", ElementKind::Payload},     {"Variant", ElementKind::Variant},
        {"Scenario", ElementKind::Scenario}};
    ASSERT_EQ(kinds.size(), simcore::project::allElementKinds().size());
    for (const auto& [title, kind] : kinds) {
        const int before = countOf(project(), kind);
        addByMenu(title);
        ASSERT_EQ(countOf(project(), kind), before + 1) << title.toStdString();
        EXPECT_EQ(undoText(), "Add " + title.toLower());
        EXPECT_EQ(tree->selected(), (ElementRef{kind, before})) << title.toStdString();
        EXPECT_EQ(window->findChild<widgets::PropertyPanel*>()->element(), tree->selected());
        EXPECT_FALSE(hasCritical(window->document().derived().problems))
            << title.toStdString() << ": " << toString(window->document().derived().problems);
    }
    EXPECT_EQ(window->document().undoStack().count(), static_cast<int>(kinds.size()));
    undoAll();
}

TEST_F(PartsTest, SeveralAreDeletedAtOnceOrNoneOfThem) {
    click("Bodies", "{side}_rear_wheel");
    click("Joints", "{side}_rear_axle", Qt::ControlModifier);
    press(Qt::Key_Delete);
    EXPECT_EQ(text(), first);  // the wheel still needs them
    selectRearWheel();
    press(Qt::Key_Delete);
    EXPECT_EQ(window->document().derived().mechanism->wheels.size(), 4U);
    EXPECT_EQ(undoText(), "Delete 3 parts");
    undoAll();
}

TEST_F(PartsTest, CopiedPartsArePastedBesideTheirOriginalsAndSelected) {
    selectRearWheel();
    press(Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(text(), first);
    press(Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(undoText(), "Paste 3 parts");
    EXPECT_EQ(project().rover.wheels.back().body, "{side}_rear_wheel_2");
    EXPECT_EQ(window->document().derived().mechanism->wheels.size(), 8U);
    const auto selected = tree->selection();
    ASSERT_EQ(selected.size(), 3U);
    EXPECT_EQ(nameOf(project(), selected.front()), "{side}_rear_wheel_2");
    undoAll();
}

TEST_F(PartsTest, CutPartsGoIntoAnotherProjectWithTheParametersTheyNeed) {
    click("Bodies", "chassis");
    press(Qt::Key_C, Qt::ControlModifier);
    window->document().createNew();
    press(Qt::Key_V, Qt::ControlModifier);
    ASSERT_EQ(project().rover.bodies.size(), 2U);
    EXPECT_EQ(project().rover.bodies.back().name, "chassis_2");
    EXPECT_TRUE(window->document().derived().parameters.contains("rocker_pivot_z"));
    EXPECT_TRUE(window->document().derived().parameters.contains("chassis_mass"));
}

TEST_F(PartsTest, ForeignClipboardIsRefusedInTheStatusBar) {
    QApplication::clipboard()->setText("nothing of a rover");
    press(Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(text(), first);
    EXPECT_EQ(window->document().undoStack().count(), 0);
}

TEST_F(PartsTest, TextFieldsKeepTheirOwnCopyAndPaste) {
    click("Bodies", "chassis");
    QApplication::clipboard()->setText("77 mm");
    QuantityField* field = parameter("wheel_radius");
    window->findChild<QTabWidget*>("editors")->setCurrentIndex(0);
    QTest::mouseClick(field, Qt::LeftButton);
    field->selectAll();
    QTest::keyClick(field, Qt::Key_V, Qt::ControlModifier);
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.077);
}

TEST_F(PartsTest, SplitPairIsTheSameMechanismAndMirroringBringsItBack) {
    const auto before = window->document().derived().built;
    click("Bodies", "rocker");
    press(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(undoText(), "Split rocker");
    EXPECT_NE(item("Bodies", "rocker_right"), nullptr);
    const auto& after = window->document().derived().built;
    EXPECT_EQ(after.gruebler, before.gruebler);
    EXPECT_EQ(after.rank, before.rank);
    EXPECT_EQ(after.redundant, before.redundant);
    click("Bodies", "rocker_left");
    press(Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(undoText(), "Mirror rocker_left");
    EXPECT_EQ(text(), first);
    undoAll();
}

TEST_F(PartsTest, PartsMoveInTheirListByKeysAndTheChassisStaysFirst) {
    click("Scenarios", "step");
    const auto scenario = [this](std::size_t at) { return project().scenarios[at].name; };
    ASSERT_EQ(scenario(1), "step");
    press(Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(scenario(0), "step");
    EXPECT_EQ(tree->selected(), (ElementRef{ElementKind::Scenario, 0}));
    press(Qt::Key_Up, Qt::AltModifier);  // at the top already
    EXPECT_EQ(window->document().undoStack().count(), 1);
    press(Qt::Key_Down, Qt::AltModifier);
    EXPECT_EQ(text(), first);
    // The body behind the chassis is mirrored.
    click("Bodies", "rocker");
    press(Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(text(), first);
}

TEST_F(PartsTest, DraggingMovesAPartWithinItsKindOnly) {
    click("Scenarios", "flat");
    ASSERT_EQ(project().scenarios.back().name, "flat");
    drag(item("Scenarios", "flat"), item("Scenarios", "step"));
    EXPECT_EQ(project().scenarios[1].name, "flat");
    EXPECT_EQ(project().scenarios[2].name, "step");
    EXPECT_EQ(undoText(), "Move flat");
    press(Qt::Key_Z, Qt::ControlModifier);
    click("Scenarios", "flat");
    drag(item("Scenarios", "flat"), item("Wheels", "{side}_rear"));
    EXPECT_EQ(text(), first);
}

TEST_F(PartsTest, SearchShowsMatchingPartsOnly) {
    press(Qt::Key_F, Qt::ControlModifier);
    auto* search = find<QLineEdit>("searchParts");
    EXPECT_EQ(QApplication::focusWidget(), search);
    QTest::keyClicks(search, "REAR");
    EXPECT_FALSE(item("Wheels", "{side}_rear")->isHidden());
    EXPECT_TRUE(item("Wheels", "{side}_rear")->parent()->isExpanded());
    EXPECT_TRUE(item("Wheels", "{side}_front")->isHidden());
    EXPECT_TRUE(item("Bodies", "chassis")->isHidden());
    // What is added while searching is not hidden.
    addByMenu("Payload");
    EXPECT_TRUE(search->text().isEmpty());
    EXPECT_FALSE(item("Payloads", "payload")->isHidden());
}

TEST_F(PartsTest, HistoryNamesTheStepsAndGoesBackToAny) {
    type(parameter("wheel_radius"), "80");
    addByMenu("Payload");
    press(Qt::Key_H, Qt::ControlModifier);
    auto* steps = find<QDockWidget>("historyDock")->findChild<QUndoView*>();
    ASSERT_NE(steps, nullptr);
    EXPECT_TRUE(waitUntil([steps] { return steps->isVisible(); }));
    ASSERT_EQ(steps->model()->rowCount(), 3);
    EXPECT_EQ(steps->model()->index(1, 0).data().toString(), "Change wheel_radius");
    EXPECT_EQ(steps->model()->index(2, 0).data().toString(), "Add payload");
    QTest::mouseClick(steps->viewport(), Qt::LeftButton, {},
                      steps->visualRect(steps->model()->index(0, 0)).center());
    EXPECT_EQ(text(), first);
}

TEST_F(PartsTest, WizardMakesARockerBogieWithTheExpectedMobility) {
    onNext<widgets::NewRoverDialog>([](widgets::NewRoverDialog* dialog) {
        auto* list = dialog->findChild<QListWidget*>("topology");
        for (int i = 0; i < list->count(); ++i) {
            EXPECT_FALSE(list->item(i)->icon().isNull());
            if (list->item(i)->data(Qt::UserRole) == "rocker_bogie_gear") {
                list->scrollToItem(list->item(i));
                QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                                  list->visualItemRect(list->item(i)).center());
            }
        }
        auto* wheelbase = dialog->findChild<QuantityField*>("dimension:wheelbase");
        auto* create = dialog->findChild<QPushButton*>("create");
        auto* problem = dialog->findChild<QLabel*>("problem");
        ASSERT_NE(wheelbase, nullptr);
        EXPECT_TRUE(waitUntil([wheelbase] { return wheelbase->isVisible(); }));
        EXPECT_TRUE(create->isEnabled());
        // Outside its range: refused in its place.
        type(wheelbase, "9 m");
        EXPECT_FALSE(wheelbase->refusal().isEmpty());
        EXPECT_THAT(problem->text().toStdString(), testing::HasSubstr("4000 mm"));
        QTest::keyClick(wheelbase, Qt::Key_Escape);
        // Within it, but the wheels would meet: nothing to create.
        type(wheelbase, "250");
        EXPECT_TRUE(wheelbase->refusal().isEmpty());
        EXPECT_FALSE(create->isEnabled());
        EXPECT_THAT(problem->text().toStdString(), testing::HasSubstr("Room between the wheels"));
        type(wheelbase, "80 cm");
        EXPECT_TRUE(create->isEnabled());
        EXPECT_TRUE(problem->text().isEmpty());
        EXPECT_THAT(dialog->findChild<QLabel*>("summary")->text().toStdString(),
                    testing::HasSubstr("Mobility 1"));
        QTest::mouseClick(create, Qt::LeftButton);
    });
    press(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(project().rover.name, "Rocker-bogie");
    EXPECT_TRUE(window->document().file().isEmpty());
    EXPECT_DOUBLE_EQ(parameterValue("wheelbase"), 0.8);
    const QStringList expected{QChar(0x2212) + QString("3"), "11, 17", "69", "65", "+1", "4"};
    for (int row = 0; row < expected.size(); ++row) {
        QString cell = find<QLabel>(QString("mobility:%1:0").arg(row))->text();
        EXPECT_EQ(cell.remove("<b>").remove("</b>").toStdString(), expected[row].toStdString())
            << row;
    }
}

TEST_F(PartsTest, WizardCanBeLeftWithoutAChange) {
    onNext<widgets::NewRoverDialog>([](widgets::NewRoverDialog* dialog) {
        EXPECT_FALSE(dialog->findChild<QListWidget*>("topology")->accessibleName().isEmpty());
        for (QLineEdit* line : dialog->findChildren<QLineEdit*>()) {
            EXPECT_FALSE(line->accessibleName().isEmpty());
        }
        QTest::keyClick(dialog, Qt::Key_Escape);
    });
    press(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(text(), first);
}

TEST_F(PartsTest, ShapesAreBelowTheirBodyAndHavePropertiesOfTheirOwn) {
    QTreeWidgetItem* bogie = item("Bodies", "bogie");
    ASSERT_NE(bogie, nullptr);
    ASSERT_EQ(bogie->childCount(), shapeCountOf(project(), 2));
    EXPECT_EQ(bogie->child(0)->text(0), "Bar 1");
    EXPECT_FALSE(bogie->isExpanded());
    auto* panel = window->findChild<widgets::PropertyPanel*>();
    clickShape("bogie", 0);
    EXPECT_EQ(tree->selected(), (ElementRef{ElementKind::Body, 2, 0}));
    EXPECT_EQ(panel->element(), tree->selected());
    // It is marked in the 3-D view on both sides, and not the rest of its body.
    const auto& mechanism = *window->document().derived().mechanism;
    const std::vector<int> both{mechanism.findBody("bogie_left"),
                                mechanism.findBody("bogie_right")};
    EXPECT_EQ(window->scene().highlighted().bodies, both);
    EXPECT_EQ(window->scene().highlighted().shape, 0);
    click("Bodies", "bogie");
    EXPECT_EQ(window->scene().highlighted().bodies, both);
    EXPECT_EQ(window->scene().highlighted().shape, -1);
    clickShape("bogie", 0);
    auto* width = panel->findChild<QuantityField*>("property:width");
    ASSERT_NE(width, nullptr);
    EXPECT_EQ(panel->findChild<QuantityField*>("property:radius"), nullptr);
    type(width, "33");
    EXPECT_DOUBLE_EQ(project().rover.bodies[2].shapes[0].width.literal(), 0.033);
    EXPECT_EQ(undoText(), "Change Width");
    EXPECT_TRUE(bogie->child(0)->text(1).startsWith(QString("33") + QChar(0x00D7)));
    // Another kind has other fields, and its label follows.
    auto* kind = panel->findChild<QComboBox*>("property:kind");
    ASSERT_NE(kind, nullptr);
    kind->setCurrentText("cylinder");
    emit kind->activated(kind->currentIndex());
    EXPECT_NE(panel->findChild<QuantityField*>("property:radius"), nullptr);
    EXPECT_EQ(bogie->child(0)->text(0), "Cylinder 1");
    undoAll();
}

TEST_F(PartsTest, ShapesOfEveryKindAreAddedByTheMenuSelectedAndUndone) {
    const int before = shapeCountOf(project(), 2);
    addShapeByMenu("Box");  // to no body
    EXPECT_EQ(text(), first);
    click("Bodies", "bogie");
    int count = before;
    for (const QString kind : {"Box", "Cylinder", "Sphere", "Bar"}) {
        addShapeByMenu(kind);
        ASSERT_EQ(shapeCountOf(project(), 2), ++count) << kind.toStdString();
        EXPECT_EQ(undoText(), "Add " + kind.toLower());
        EXPECT_EQ(tree->selected(), (ElementRef{ElementKind::Body, 2, count - 1}));
        EXPECT_EQ(window->findChild<widgets::PropertyPanel*>()->element(), tree->selected());
        EXPECT_TRUE(item("Bodies", "bogie")->isExpanded());
        EXPECT_FALSE(hasCritical(window->document().derived().problems))
            << toString(window->document().derived().problems);
    }
    EXPECT_EQ(window->document().undoStack().count(), 4);
    undoAll();
}

// An expression longer than its field is told by the tooltip, with its value.
TEST_F(PartsTest, LongExpressionsAreToldByTheTooltip) {
    window->resize(1280, 800);
    click("Bodies", "bogie");
    addShapeByMenu("Cylinder");
    const auto tip = [](QuantityField* field) {
        QToolTip::hideText();
        EXPECT_TRUE(waitUntil([] { return !QToolTip::isVisible(); }));
        QHelpEvent ask(QEvent::ToolTip, field->rect().center(),
                       field->mapToGlobal(field->rect().center()));
        QApplication::sendEvent(field, &ask);
        return QToolTip::text();
    };
    int cut = 0;
    for (auto* field :
         window->findChild<widgets::PropertyPanel*>()->findChildren<QuantityField*>()) {
        if (field->text().contains('(')) {
            ++cut;
            EXPECT_TRUE(tip(field).startsWith(field->text() + " = ")) << tip(field).toStdString();
        } else if (field->quantity().isLiteral()) {
            EXPECT_EQ(tip(field), QString()) << field->text().toStdString();
        }
    }
    EXPECT_GT(cut, 0);
    QToolTip::hideText();
    undoAll();
}

TEST_F(PartsTest, ShapesAreDuplicatedMovedCopiedAndDeletedByKeys) {
    const int before = shapeCountOf(project(), 2);
    const auto shape = [this](int at) { return shapeAt(project(), {ElementKind::Body, 2, at}); };
    clickShape("bogie", 0);
    press(Qt::Key_D, Qt::ControlModifier);
    EXPECT_EQ(undoText(), "Duplicate bar 1 of bogie");
    EXPECT_EQ(shapeCountOf(project(), 2), before + 1);
    EXPECT_EQ(shape(1), shape(0));
    EXPECT_EQ(tree->selected(), (ElementRef{ElementKind::Body, 2, 1}));
    auto* width =
        window->findChild<widgets::PropertyPanel*>()->findChild<QuantityField*>("property:width");
    type(width, "7");
    press(Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(undoText(), "Move bar 2 of bogie");
    EXPECT_DOUBLE_EQ(shape(0).width.literal(), 0.007);
    EXPECT_EQ(tree->selected(), (ElementRef{ElementKind::Body, 2, 0}));
    press(Qt::Key_C, Qt::ControlModifier);
    press(Qt::Key_Delete);
    EXPECT_EQ(undoText(), "Delete bar 1 of bogie");
    EXPECT_EQ(shapeCountOf(project(), 2), before);
    // Into another body.
    const int chassis = shapeCountOf(project(), 0);
    click("Bodies", "chassis");
    press(Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(shapeCountOf(project(), 0), chassis + 1);
    EXPECT_DOUBLE_EQ(project().rover.bodies[0].shapes.back().width.literal(), 0.007);
    EXPECT_EQ(tree->selected(), (ElementRef{ElementKind::Body, 0, chassis}));
    EXPECT_EQ(window->document().undoStack().count(), 5);
    // Neither renamed nor mirrored.
    const std::string now = text();
    press(Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
    window->actions().at("rename")->trigger();
    EXPECT_EQ(text(), now);
    undoAll();
}

TEST_F(PartsTest, DraggingMovesAShapeIntoAnotherBody) {
    const simcore::project::Shape bar = shapeAt(project(), {ElementKind::Body, 2, 0});
    const int chassis = shapeCountOf(project(), 0);
    clickShape("bogie", 0);
    drag(item("Bodies", "bogie")->child(0), item("Bodies", "chassis"));
    EXPECT_EQ(shapeCountOf(project(), 0), chassis + 1);
    EXPECT_EQ(project().rover.bodies[0].shapes.back(), bar);
    EXPECT_EQ(undoText(), "Move bar 1 of bogie");
    EXPECT_EQ(tree->selected(), (ElementRef{ElementKind::Body, 0, chassis}));
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(text(), first);
    // Nowhere else.
    clickShape("bogie", 0);
    drag(item("Bodies", "bogie")->child(0), item("Wheels", "{side}_rear"));
    EXPECT_EQ(text(), first);
}

TEST_F(PartsTest, SearchFindsShapesAndOpensTheirBody) {
    auto* search = find<QLineEdit>("searchParts");
    QTest::keyClicks(search, "bar 1");
    EXPECT_TRUE(item("Bodies", "bogie")->isExpanded());
    EXPECT_FALSE(item("Bodies", "bogie")->child(0)->isHidden());
    EXPECT_TRUE(item("Joints", "rocker_pivot")->isHidden());
    search->clear();
    EXPECT_FALSE(item("Bodies", "bogie")->isExpanded());
    QTest::keyClicks(search, "bogie");
    EXPECT_FALSE(item("Bodies", "bogie")->isExpanded());
    EXPECT_FALSE(item("Bodies", "bogie")->child(0)->isHidden());
}

TEST_F(PartsTest, PropertiesOfABodyLeadToItsShapesAndAddOnes) {
    click("Bodies", "bogie");
    auto* panel = window->findChild<widgets::PropertyPanel*>();
    auto* add = panel->findChild<QPushButton*>("add:shapes");
    ASSERT_NE(add, nullptr);
    panel->ensureWidgetVisible(add);
    const int before = shapeCountOf(project(), 2);
    chooseFrom(add, add->menu(), "Sphere");
    EXPECT_EQ(shapeCountOf(project(), 2), before + 1);
    click("Bodies", "bogie");
    auto* bar = panel->findChild<QPushButton*>("shape:0");
    ASSERT_NE(bar, nullptr);
    panel->ensureWidgetVisible(bar);
    QTest::mouseClick(bar, Qt::LeftButton);
    EXPECT_EQ(tree->selected(), (ElementRef{ElementKind::Body, 2, 0}));
    EXPECT_EQ(panel->element(), tree->selected());
    undoAll();
}

TEST_F(PartsTest, VariantsAreEditedInTheProperties) {
    auto* panel = window->findChild<widgets::PropertyPanel*>();
    addByMenu("Variant");
    auto* set = panel->findChild<QComboBox*>("add:set");
    ASSERT_NE(set, nullptr);
    const int at = set->findText("wheel_radius");
    ASSERT_GT(at, 0);
    EXPECT_EQ(set->findText("arm_y"), -1);  // derived: it cannot be set
    set->setCurrentIndex(at);
    emit set->activated(at);
    ASSERT_EQ(project().variants.size(), 1U);
    ASSERT_EQ(project().variants[0].set.size(), 1U);
    EXPECT_EQ(project().variants[0].set[0].parameter, "wheel_radius");
    undoAll();
}

TEST_F(PartsTest, MirrorBoxIsRefusedWhileTheRightOneIsUsed) {
    click("Joints", "rocker_pivot");
    auto* mirror =
        window->findChild<widgets::PropertyPanel*>()->findChild<QCheckBox*>("property:mirror");
    ASSERT_NE(mirror, nullptr);
    ASSERT_TRUE(mirror->isChecked());
    mirror->click();  // the differential needs rocker_pivot_right
    EXPECT_TRUE(mirror->isChecked());
    EXPECT_EQ(text(), first);
}
