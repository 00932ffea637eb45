// The statics panel in the real window: numbers as simcore's, slider, keys, edits and the picture.
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QTreeWidget>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "simcore/run/simulation.h"
#include "simcore/statics/traverse.h"
#include "tests/support/studio.h"
#include "widgets/panels/statics_text.h"
#include "widgets/panels/wheel_table.h"
#include "widgets/session/run_bar.h"
#include "widgets/session/statics_session.h"

using simcore::statics::PoseSolver;
using simcore::statics::StaticModel;
using simcore::statics::Study;
using simcore::statics::Traverse;
using simcore::statics::TraverseSample;
using testsupport::waitUntil;
using widgets::WheelTable;

namespace {

class StaticsPanelTest : public testsupport::StudioTest {
  protected:
    StaticsPanelTest() {
        window->runBar().setScenario("step");
        press(Qt::Key_T, Qt::ControlModifier);
        EXPECT_TRUE(waitForWay());
    }

    widgets::StaticsSession& statics() { return window->statics(); }

    bool waitForWay() {
        QTest::qWait(150);  // what edits ask for is put together first
        return waitUntil([&] { return !statics().isWorking(); });
    }

    const std::vector<TraverseSample>& samples() { return statics().way()->traverse.samples; }

    QSlider* slider() { return find<QSlider>("staticsPlace"); }

    std::string text(const QString& label) { return find<QLabel>(label)->text().toStdString(); }

    QString cell(int wheel, WheelTable::Column column) {
        return find<QTreeWidget>("staticsWheels")->topLevelItem(wheel)->text(column);
    }

    /// Where the front wheel climbs a wall.
    int sampleAtWall() {
        for (std::size_t i = 0; i < samples().size(); ++i) {
            for (const auto& wheel : samples()[i].study.wheels) {
                if (wheel.contactAngle > 1.5) {
                    return static_cast<int>(i);
                }
            }
        }
        return -1;
    }

    simcore::Result<simcore::run::ResolvedRun> prepared() {
        return simcore::run::prepareRun(window->document().project(), window->runBar().request());
    }

    /// Of the whole way, without a window.
    double requiredByWay() {
        const auto run = prepared();
        StaticModel model(run->mechanism, run->joints);
        PoseSolver solver(model, *run->terrain);
        simcore::statics::TraverseRequest request;
        request.distance = run->distance;
        return simcore::statics::traverse(solver, request).frictionRequired();
    }

    double distanceFromShown() {
        double most = 0.0;
        const auto& bodies = statics().shown()->pose.bodies;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const auto drawn = window->scene().bodyPose(static_cast<int>(i)).position;
            most = std::max(most, (drawn - bodies[i].position).norm());
        }
        return most;
    }

    void breakTerrain() {
        auto next = window->document().project();
        for (auto& scenario : next.scenarios) {
            scenario.terrain.kind = simcore::project::TerrainKind::Stairs;
            scenario.terrain.height = -1.0;
        }
        window->document().edit("Break", next);
    }
};

std::string frictionText(double friction) {
    return QString("μ* %1").arg(friction, 0, 'f', 2).toStdString();
}

}  // namespace

TEST_F(StaticsPanelTest, WallAsksForTheFrictionThatSimcoreSays) {
    const int wall = sampleAtWall();
    ASSERT_GE(wall, 0);
    slider()->setValue(wall);
    const auto run = prepared();
    ASSERT_TRUE(run.ok());
    StaticModel model(run->mechanism, run->joints);
    const Study study =
        studyPose(model, samples()[static_cast<std::size_t>(wall)].pose, std::nullopt);
    ASSERT_TRUE(study.feasible);
    EXPECT_GT(study.frictionRequired, 0.2);
    EXPECT_EQ(text("staticsFriction"), frictionText(study.frictionRequired));
    for (int i = 0; i < static_cast<int>(study.wheels.size()); ++i) {
        const auto& wheel = study.wheels[static_cast<std::size_t>(i)];
        EXPECT_EQ(cell(i, WheelTable::Wheel).toStdString(), wheel.name);
        EXPECT_EQ(cell(i, WheelTable::Load), QString("%1 N").arg(wheel.normal, 0, 'f', 1));
        EXPECT_EQ(cell(i, WheelTable::Angle),
                  QString("%1°").arg(wheel.contactAngle * 180.0 / std::numbers::pi, 0, 'f', 0));
    }
}

TEST_F(StaticsPanelTest, BeginsAtTheHardestPlaceOfTheWholeWay) {
    const double required = requiredByWay();
    ASSERT_TRUE(std::isfinite(required));
    EXPECT_EQ(text("staticsFriction"), frictionText(required));
    EXPECT_THAT(text("staticsWhole"), testing::HasSubstr(frictionText(required)));
    slider()->setValue(0);
    EXPECT_NE(text("staticsFriction"), frictionText(required));
    QTest::mouseClick(find<QToolButton>("staticsHardest"), Qt::LeftButton);
    EXPECT_EQ(text("staticsFriction"), frictionText(required));
}

TEST_F(StaticsPanelTest, VerdictComparesWithTheFrictionOfTheRunBar) {
    EXPECT_THAT(text("staticsVerdict"), testing::StartsWith("Enough:\nthe ground gives 0.70"));
    auto* friction = find<QWidget>("friction");
    QTest::keyClick(friction, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(friction, "0.1");
    QTest::keyClick(friction, Qt::Key_Return);
    EXPECT_TRUE(waitUntil([&] {
        return QString::fromStdString(text("staticsVerdict"))
            .startsWith("Not enough:\nthe ground gives 0.10");
    })) << text("staticsVerdict");
}

TEST_F(StaticsPanelTest, SliderMovesLoadsAndPicture) {
    slider()->setValue(0);
    const QString before = cell(0, WheelTable::Load);
    EXPECT_LT(distanceFromShown(), 1e-9);
    slider()->setValue(sampleAtWall());
    EXPECT_NE(cell(0, WheelTable::Load), before);
    EXPECT_LT(distanceFromShown(), 1e-9);
    EXPECT_GT(window->scene().bodyPose(0).position.norm(), 0.05);
}

TEST_F(StaticsPanelTest, LeavingThePanelGivesTheDrawnPoseBack) {
    ASSERT_LT(distanceFromShown(), 1e-9);
    press(Qt::Key_M, Qt::ControlModifier);
    EXPECT_TRUE(waitUntil([&] { return !statics().isActive(); }));
    EXPECT_LT(window->scene().bodyPose(0).position.norm(), 1e-12);
    press(Qt::Key_T, Qt::ControlModifier);
    EXPECT_TRUE(waitUntil([&] { return statics().isActive(); }));
    EXPECT_LT(distanceFromShown(), 1e-9);
}

TEST_F(StaticsPanelTest, PlayingRunIsOnShowAndDesignModeShowsThePoseAgain) {
    press(Qt::Key_Space);
    ASSERT_TRUE(waitUntil([&] { return window->session().endTime() > 0.1; }));
    press(Qt::Key_Space);
    const auto& run = window->session().shown()->bodies.front().position;
    EXPECT_LT((window->scene().bodyPose(0).position - run).norm(), 1e-9);
    press(Qt::Key_B, Qt::ControlModifier);
    EXPECT_LT(distanceFromShown(), 1e-9);
}

TEST_F(StaticsPanelTest, KeysDriveTheRover) {
    QTest::mouseClick(slider(), Qt::LeftButton, {}, QPoint(2, slider()->height() / 2));
    slider()->setFocus();
    QTest::keyClick(slider(), Qt::Key_Home);
    EXPECT_EQ(statics().place(), 0);
    QTest::keyClick(slider(), Qt::Key_Right);
    QTest::keyClick(slider(), Qt::Key_Right);
    EXPECT_EQ(statics().place(), 2);
    EXPECT_THAT(text("staticsWhere"),
                testing::HasSubstr(QString::number(samples()[2].way, 'f', 3).toStdString()));
    QTest::keyClick(slider(), Qt::Key_Left);
    EXPECT_EQ(statics().place(), 1);
    QTest::keyClick(slider(), Qt::Key_End);
    EXPECT_EQ(statics().place(), static_cast<int>(samples().size()) - 1);
    EXPECT_FALSE(window->session().hasRun());
}

TEST_F(StaticsPanelTest, ClickInThePlotGoesThere) {
    auto* plot = find<QWidget>("staticsPlot");
    // The axes follow at the next drawing.
    plot->repaint();
    auto* canvas = plot->findChild<QWidget*>();
    QTest::mouseClick(canvas, Qt::LeftButton, {},
                      QPoint(canvas->width() / 2, canvas->height() / 3));
    EXPECT_NEAR(statics().shown()->way, 0.5 * samples().back().way, 0.2 * samples().back().way);
}

TEST_F(StaticsPanelTest, EditsAndUndoRefresh) {
    const std::string before = text("staticsFriction");
    type(parameter("wheel_radius"), "55");
    ASSERT_TRUE(waitForWay());
    EXPECT_NE(text("staticsFriction"), before);
    EXPECT_EQ(text("staticsFriction"), frictionText(requiredByWay()));
    EXPECT_LT(distanceFromShown(), 1e-9);
    press(Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(waitForWay());
    EXPECT_EQ(text("staticsFriction"), before);
}

TEST_F(StaticsPanelTest, LatestOfManyEditsWins) {
    for (const char* radius : {"60", "65", "75", "80", "57"}) {
        type(parameter("wheel_radius"), radius);
        QTest::qWait(70);
    }
    ASSERT_TRUE(waitForWay());
    EXPECT_DOUBLE_EQ(statics().current()->run->mechanism.wheels.front().radius, 0.057);
    EXPECT_EQ(text("staticsFriction"), frictionText(requiredByWay()));
}

// A long way takes seconds: what is known of it is shown meanwhile, and an edit ends it.
TEST_F(StaticsPanelTest, LongStudyIsShownAsItGoesAndGivesWayToTheNext) {
    auto next = window->document().project();
    for (auto& scenario : next.scenarios) {
        scenario.run.distance = 150.0;
    }
    window->document().edit("Lengthen", next);
    const auto partOfTheWay = [&] {
        return statics().isWorking() && statics().way() == statics().current() &&
               statics().way()->stage == widgets::StaticsFindings::Stage::Part;
    };
    ASSERT_TRUE(waitUntil(partOfTheWay));
    slider()->setValue(3);
    EXPECT_EQ(statics().place(), 3);
    EXPECT_LT(distanceFromShown(), 1e-9);
    EXPECT_THAT(text("staticsWhole"), testing::HasSubstr("Working"));
    press(Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(waitForWay());
    EXPECT_EQ(statics().way()->stage, widgets::StaticsFindings::Stage::Whole);
    EXPECT_EQ(statics().place(), 3);
}

TEST_F(StaticsPanelTest, PlaceStaysWhereTheSliderWasThroughAnEdit) {
    slider()->setValue(static_cast<int>(samples().size()) / 3);
    const double way = statics().shown()->way;
    type(parameter("chassis_mass"), "9");
    ASSERT_TRUE(waitForWay());
    EXPECT_NEAR(statics().shown()->way, way, 0.01);
}

TEST_F(StaticsPanelTest, BrokenScenarioSaysWhyAndUndoMendsIt) {
    breakTerrain();
    ASSERT_TRUE(waitForWay());
    auto* why = find<QLabel>("staticsUnavailable");
    EXPECT_TRUE(why->isVisible());
    EXPECT_FALSE(find<QSlider>("staticsPlace")->isVisible());
    EXPECT_THAT(why->text().toStdString(), testing::HasSubstr("cannot be studied"));
    press(Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(waitForWay());
    EXPECT_FALSE(why->isVisible());
    EXPECT_TRUE(slider()->isVisible());
}

TEST(StaticsTextTest, SaysWhichWheelsLimit) {
    Study study;
    study.feasible = true;
    study.frictionRequired = 0.4;
    for (const double ratio : {0.4, 0.1, 0.4, 0.2, 0.0}) {
        study.wheels.push_back({});
        study.wheels.back().name = "w" + std::to_string(study.wheels.size());
        study.wheels.back().ratio = ratio;
    }
    study.wheels.back().touches = false;
    EXPECT_EQ(widgets::limitSentence(study).toStdString(), "w1, w3 limit.");
    study.wheels[1].ratio = 0.4;
    EXPECT_EQ(widgets::limitSentence(study).toStdString(),
              "All wheels that touch limit alike but w4.");
    study.wheels[3].ratio = 0.4;
    EXPECT_EQ(widgets::limitSentence(study).toStdString(), "All wheels that touch limit alike.");
    study.feasible = false;
    EXPECT_TRUE(limitingWheels(study).empty());
}

TEST(StaticsTextTest, GroupsFlagsIntoSentences) {
    const QStringList sentences = widgets::flagSentences(
        {"search", "hanging rear", "torque-limit a", "torque-limit b", "no-torques-hold-it"});
    EXPECT_EQ(sentences, QStringList({"No torques hold the rover here.", "Hangs in the air: rear.",
                                      "At the torque limit: a, b."}));
}

TEST_F(StaticsPanelTest, EveryWidgetHasANameForReaders) {
    for (const char* name : {"staticsFriction", "staticsVerdict", "staticsPlace", "staticsWhere",
                             "staticsHardest", "staticsWheels", "staticsPlot", "staticsTipOver",
                             "staticsNotes", "staticsWhole", "staticsUnavailable"}) {
        EXPECT_FALSE(find<QWidget>(name)->accessibleName().isEmpty()) << name;
    }
}
