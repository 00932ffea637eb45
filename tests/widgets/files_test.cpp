// Files in the real window: save, open, recent, close prompts, autosave and recovery.
#include <QDir>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include "tests/support/dialogs.h"
#include "tests/support/studio.h"

using testsupport::answerNextBox;
using testsupport::bytesOf;
using testsupport::chooseFile;
using testsupport::projectFile;
using testsupport::waitUntil;

namespace {

QStringList autosavedCopies() {
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                      "/autosave");
    return folder.entryList({"*.rover"});
}

class FilesTest : public testsupport::StudioTest {};

}  // namespace

TEST_F(FilesTest, SaveWritesTheFileAndClearsTheMark) {
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.rover");
    type(parameter("wheel_radius"), "80");
    ASSERT_TRUE(window->document().saveAs(file).empty());
    EXPECT_FALSE(window->isWindowModified());
    type(parameter("wheel_radius"), "90");
    EXPECT_TRUE(window->isWindowModified());
    press(Qt::Key_S, Qt::ControlModifier);
    EXPECT_FALSE(window->isWindowModified());
    ASSERT_TRUE(window->files().openFile(file));
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.09);
    EXPECT_THAT(window->files().recentFiles(), testing::Contains(file));
    EXPECT_THAT(window->windowTitle().toStdString(), testing::HasSubstr("mine.rover"));
}

// The ending is added after the dialog, which asked about another name.
TEST_F(FilesTest, SaveAsReplacesNoFileUnasked) {
    const QTemporaryDir folder;
    const QString file = folder.filePath("solero.rover");
    std::ofstream(file.toStdString()) << "precious";
    QString said;
    answerNextBox(QMessageBox::No, &said);
    chooseFile(folder.filePath("solero"));
    EXPECT_FALSE(window->files().saveAs());
    EXPECT_THAT(said.toStdString(), testing::HasSubstr("solero.rover"));
    EXPECT_EQ(bytesOf(file), "precious");
    EXPECT_EQ(window->document().file(), projectFile("solero"));
    answerNextBox(QMessageBox::Yes);
    chooseFile(folder.filePath("solero"));
    EXPECT_TRUE(window->files().saveAs());
    EXPECT_THAT(bytesOf(file), testing::HasSubstr("SOLERO"));
    EXPECT_EQ(window->document().file(), file);
}

TEST_F(FilesTest, OpenAsksForAFileAndThenAboutUnsavedChanges) {
    type(parameter("wheel_radius"), "80");
    chooseFile(projectFile("shrimp"));
    answerNextBox(QMessageBox::Cancel);
    press(Qt::Key_O, Qt::ControlModifier);
    EXPECT_EQ(window->document().project().rover.name, "SOLERO");
    chooseFile(projectFile("shrimp"));
    answerNextBox(QMessageBox::Discard);
    press(Qt::Key_O, Qt::ControlModifier);
    EXPECT_EQ(window->document().project().rover.name, "Shrimp");
}

TEST_F(FilesTest, ClosingAsksAndCancelKeepsEverything) {
    type(parameter("wheel_radius"), "80");
    answerNextBox(QMessageBox::Cancel);
    window->close();
    EXPECT_TRUE(window->isVisible());
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.08);
    answerNextBox(QMessageBox::Discard);
    window->close();
    EXPECT_FALSE(window->isVisible());
}

TEST_F(FilesTest, ClosingWithoutChangesDoesNotAsk) {
    window->close();
    EXPECT_FALSE(window->isVisible());
}

TEST_F(FilesTest, OpeningAnotherFileAsksFirst) {
    type(parameter("wheel_radius"), "80");
    answerNextBox(QMessageBox::Cancel);
    EXPECT_FALSE(window->files().openFile(projectFile("shrimp")));
    EXPECT_EQ(window->document().project().rover.name, "SOLERO");
    answerNextBox(QMessageBox::Discard);
    EXPECT_TRUE(window->files().openFile(projectFile("shrimp")));
    EXPECT_EQ(window->document().project().rover.name, "Shrimp");
}

TEST_F(FilesTest, UnreadableFileIsExplainedAndTheProjectStays) {
    QString said;
    answerNextBox(QMessageBox::Ok, &said);
    EXPECT_FALSE(window->files().openFile("/nonexistent.rover"));
    EXPECT_THAT(said.toStdString(), testing::HasSubstr("/nonexistent.rover"));
    EXPECT_EQ(window->document().project().rover.name, "SOLERO");
}

TEST_F(FilesTest, ExamplesOpenAsCopies) {
    ASSERT_GE(window->files().exampleFiles().size(), 4);
    window->files().openExample(projectFile("rocker_bogie"));
    EXPECT_TRUE(window->document().file().isEmpty());
    EXPECT_EQ(window->document().derived().built.gruebler, -3);
}

TEST_F(FilesTest, NewProjectShowsItsChassisWithoutProblems) {
    press(Qt::Key_N, Qt::ControlModifier);
    EXPECT_EQ(window->document().project().rover.bodies.size(), 1U);
    EXPECT_FALSE(hasCritical(window->document().derived().problems));
}

TEST_F(FilesTest, RunAutosavesUnsavedWorkAndItIsOfferedAfterACrash) {
    type(parameter("wheel_radius"), "80");
    EXPECT_TRUE(autosavedCopies().isEmpty());
    ASSERT_TRUE(window->playPause());
    window->session().pause();
    ASSERT_EQ(autosavedCopies().size(), 1);
    // As after a crash: the copy belongs to a process that is no more.
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                      "/autosave");
    const QString copy = autosavedCopies().front();
    QFile::rename(folder.filePath(copy), folder.filePath("999999999.rover"));
    QFile::rename(folder.filePath(copy + ".origin"), folder.filePath("999999999.rover.origin"));
    window->document().undoStack().setClean();
    ASSERT_TRUE(window->document().open(projectFile("shrimp")).empty());
    answerNextBox(QMessageBox::Yes);
    window->files().offerRecovery();
    EXPECT_EQ(window->document().project().rover.name, "SOLERO");
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.08);
    EXPECT_TRUE(window->document().isModified());
    EXPECT_EQ(window->document().file(), projectFile("solero"));
}
