// The document: undo, merging of edits, the modified flag, files.
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/io/project_file.h"
#include "simcore/run/simulation.h"
#include "tests/support/random_edits.h"
#include "widgets/document/document.h"

using simcore::project::Project;
using widgets::Document;

namespace {

QString solero() {
    return QString(ROVER_SOURCE_DIR) + "/assets/projects/solero.rover";
}

Project withRadius(const Document& document, double radius) {
    Project next = document.project();
    next.rover.parameters.at(0).value = radius;
    return next;
}

double radiusOf(const Document& document) {
    return document.project().rover.parameters.at(0).value.literal();
}

class DocumentTest : public testing::Test {
  protected:
    DocumentTest() { EXPECT_TRUE(document.open(solero()).empty()); }

    Document document;
};

}  // namespace

TEST_F(DocumentTest, EditIsUndoneAndRedoneAsAWhole) {
    const Project before = document.project();
    document.edit("Change", withRadius(document, 0.08));
    EXPECT_DOUBLE_EQ(radiusOf(document), 0.08);
    EXPECT_TRUE(document.isModified());
    document.undoStack().undo();
    EXPECT_TRUE(document.project() == before);
    EXPECT_FALSE(document.isModified());
    document.undoStack().redo();
    EXPECT_DOUBLE_EQ(radiusOf(document), 0.08);
}

TEST_F(DocumentTest, DerivedValuesFollowEveryEdit) {
    const double before = document.derived().mechanism->wheels.at(0).radius;
    document.edit("Change", withRadius(document, 0.09));
    EXPECT_DOUBLE_EQ(document.derived().mechanism->wheels.at(0).radius, 0.09);
    document.undoStack().undo();
    EXPECT_DOUBLE_EQ(document.derived().mechanism->wheels.at(0).radius, before);
}

TEST_F(DocumentTest, EqualProjectIsNoEdit) {
    QSignalSpy changed(&document, &Document::changed);
    document.edit("Nothing", document.project());
    EXPECT_EQ(changed.count(), 0);
    EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(DocumentTest, DragIsOneStepUntilMergingEnds) {
    const double before = radiusOf(document);
    for (const double radius : {0.071, 0.072, 0.073}) {
        document.edit("Drag", withRadius(document, radius), "slide wheel_radius");
    }
    EXPECT_EQ(document.undoStack().count(), 1);
    document.endMerging();
    document.edit("Drag", withRadius(document, 0.08), "slide wheel_radius");
    EXPECT_EQ(document.undoStack().count(), 2);
    document.undoStack().undo();
    EXPECT_DOUBLE_EQ(radiusOf(document), 0.073);
    document.undoStack().undo();
    EXPECT_DOUBLE_EQ(radiusOf(document), before);
}

TEST_F(DocumentTest, ProblemsAreReportedAndTheMechanismIsWithheld) {
    Project broken = document.project();
    broken.rover.joints.at(0).first = "nobody";
    document.edit("Break", broken);
    EXPECT_FALSE(document.derived().mechanism.has_value());
    EXPECT_TRUE(hasCritical(document.derived().problems));
    document.undoStack().undo();
    EXPECT_TRUE(document.derived().mechanism.has_value());
}

TEST_F(DocumentTest, SavedFileReadsBackEqualAndIsClean) {
    const QTemporaryDir folder;
    document.edit("Change", withRadius(document, 0.0812));
    const QString file = folder.filePath("mine.rover");
    EXPECT_TRUE(document.saveAs(file).empty());
    EXPECT_FALSE(document.isModified());
    EXPECT_EQ(document.displayName(), "mine.rover");
    Document other;
    ASSERT_TRUE(other.open(file).empty());
    EXPECT_TRUE(other.project() == document.project());
}

TEST_F(DocumentTest, FailedSaveKeepsFileNameAndModifiedFlag) {
    document.edit("Change", withRadius(document, 0.08));
    const auto problems = document.saveAs("/nonexistent/folder/x.rover");
    ASSERT_FALSE(problems.empty());
    EXPECT_THAT(problems.front().element, testing::HasSubstr("/nonexistent/folder/x.rover"));
    EXPECT_EQ(document.file(), solero());
    EXPECT_TRUE(document.isModified());
}

TEST_F(DocumentTest, FailedOpenKeepsTheProject) {
    const QTemporaryDir folder;
    QFile bad(folder.filePath("bad.rover"));
    ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
    bad.write("{\"format\": ");
    bad.close();
    const Project before = document.project();
    EXPECT_FALSE(document.open(bad.fileName()).empty());
    EXPECT_TRUE(document.project() == before);
    EXPECT_EQ(document.file(), solero());
}

TEST_F(DocumentTest, ExampleOpensWithoutAFile) {
    ASSERT_TRUE(document.openCopy(solero()).empty());
    EXPECT_TRUE(document.file().isEmpty());
    EXPECT_EQ(document.displayName(), "Untitled");
    EXPECT_FALSE(document.isModified());
}

TEST_F(DocumentTest, NewProjectIsValidAndFloats) {
    document.createNew();
    EXPECT_FALSE(hasCritical(document.derived().problems)) << toString(document.derived().problems);
    EXPECT_EQ(document.derived().built.mobility, 6);
}

// ROVER_RANDOM_EDITS is the number of steps.
TEST_F(DocumentTest, RandomEditsUndoneAllGiveTheSameBytes) {
    const int steps = testsupport::stepsFrom("ROVER_RANDOM_EDITS", 300);
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.rover");
    const std::string before = simcore::io::formatProject(document.project());
    testsupport::RandomEdits edits(11);
    for (int step = 0; step < steps && !HasFailure(); ++step) {
        SCOPED_TRACE("step " + std::to_string(step));
        switch (edits.below(10)) {
            case 0:
                for (int i = edits.below(4); i >= 0; --i) {
                    document.undoStack().undo();
                }
                break;
            case 1:
                document.undoStack().redo();
                break;
            case 2: {
                ASSERT_TRUE(document.saveAs(file).empty());
                EXPECT_FALSE(document.isModified());
                Document other;
                ASSERT_TRUE(other.open(file).empty());
                EXPECT_TRUE(other.project() == document.project());
                break;
            }
            case 3:
                if (step % 5 == 0 && !document.project().scenarios.empty()) {
                    simcore::run::RunRequest request;
                    request.scenario = document.project().scenarios.front().name;
                    const auto run = simcore::run::prepareRun(document.project(), request);
                    EXPECT_TRUE(run || hasCritical(run.problems()));
                }
                break;
            default:
                if (auto next = edits.edit(document.project())) {
                    document.edit("Edit", std::move(*next));
                }
        }
    }
    const int count = document.undoStack().count();
    EXPECT_GT(count, steps / 20);
    document.undoStack().setIndex(0);
    EXPECT_EQ(simcore::io::formatProject(document.project()), before);
    document.undoStack().setIndex(count);
    document.undoStack().setIndex(0);
    EXPECT_EQ(simcore::io::formatProject(document.project()), before);
}
