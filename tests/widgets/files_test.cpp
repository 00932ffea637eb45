// Files in the real window: save, open, recent, close prompts, autosave and recovery.
#include <QDir>
#include <QListWidget>
#include <QPushButton>
#include <QStandardPaths>
#include <QSysInfo>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include "tests/support/dialogs.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/studio.h"
#include "widgets/panels/problems_panel.h"
#include "widgets/window/recovery_dialog.h"

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

QString autosaveFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/autosave";
}

/// What a program that was killed leaves, whose lock is stale.
void leaveBehind(const QString& name, const QString& original, const std::string& project) {
    ASSERT_TRUE(QDir().mkpath(autosaveFolder()));
    const std::string copy = (autosaveFolder() + "/" + name + ".rover").toStdString();
    std::ofstream(copy) << project;
    std::ofstream(copy + ".origin") << "digest\n" << original.toStdString();
    std::ofstream(copy + ".lock") << "999999999\nRoverStudioTest\n"
                                  << QSysInfo::machineHostName().toStdString() << "\n";
}

/// Answers the next dialog about recovery.
void answerRecovery(const QString& button, int row = 0, QStringList* rows = nullptr) {
    testsupport::onNext<widgets::RecoveryDialog>(
        [button, row, rows](widgets::RecoveryDialog* dialog) {
            auto* list = dialog->findChild<QListWidget*>("recoverable");
            for (int i = 0; rows != nullptr && i < list->count(); ++i) {
                *rows << list->item(i)->text();
            }
            list->setCurrentRow(row);
            QTest::mouseClick(dialog->findChild<QPushButton*>(button), Qt::LeftButton);
        });
}

class FilesTest : public testsupport::StudioTest {
  protected:
    /// SOLERO under a name of its own.
    QString ownFile() {
        const QString file = folder.filePath("mine.rover");
        EXPECT_TRUE(window->document().saveAs(file).empty());
        return file;
    }

    QMessageBox* changeBox() { return window->findChild<QMessageBox*>("changedOnDisk"); }

    const QTemporaryDir folder;
};

}  // namespace

TEST_F(FilesTest, SaveWritesTheFileAndClearsTheMark) {
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

TEST_F(FilesTest, RunAutosavesUnsavedWorkAtOnceAndSavingRemovesTheCopy) {
    ownFile();
    type(parameter("wheel_radius"), "80");
    ASSERT_TRUE(window->playPause());
    window->session().pause();
    EXPECT_EQ(autosavedCopies().size(), 1);
    EXPECT_TRUE(window->files().save());
    EXPECT_TRUE(autosavedCopies().isEmpty());
    EXPECT_TRUE(QDir(autosaveFolder()).entryList(QDir::Files).isEmpty());
}

TEST_F(FilesTest, EditIsAutosavedByItselfAndNotOfferedWhileItsProgramRuns) {
    type(parameter("wheel_radius"), "80");
    ASSERT_TRUE(waitUntil([] { return autosavedCopies().size() == 1; }, 5000));
    EXPECT_TRUE(widgets::findLeftovers().empty());
    window->document().undoStack().undo();
    EXPECT_TRUE(autosavedCopies().isEmpty()) << "nothing is unsaved any more";
}

TEST_F(FilesTest, WorkOfAProgramThatIsGoneIsRestoredWithNameAndMark) {
    const QString file = ownFile();
    const std::string project = bytesOf(projectFile("shrimp"));
    leaveBehind("a", file, project);
    answerRecovery("restore");
    window->files().offerRecovery();
    EXPECT_EQ(window->document().project().rover.name, "Shrimp");
    EXPECT_TRUE(window->document().isModified());
    EXPECT_EQ(window->document().file(), file);
    // The new session has it now.
    EXPECT_EQ(autosavedCopies().size(), 1);
    EXPECT_TRUE(widgets::findLeftovers().empty());
}

TEST_F(FilesTest, SeveralAreListedAndWhatIsNotChosenStays) {
    leaveBehind("a", "/somewhere/first.rover", bytesOf(projectFile("shrimp")));
    leaveBehind("b", {}, bytesOf(projectFile("rocker_bogie")));
    QStringList rows;
    answerRecovery("later", 0, &rows);
    window->files().offerRecovery();
    ASSERT_EQ(rows.size(), 2);
    EXPECT_THAT(rows.join("; ").toStdString(), testing::HasSubstr("first.rover"));
    EXPECT_THAT(rows.join("; ").toStdString(), testing::HasSubstr("never saved"));
    const int untitled = rows.front().contains("never saved") ? 0 : 1;
    answerRecovery("restore", untitled);
    window->files().offerRecovery();
    EXPECT_TRUE(window->document().file().isEmpty());
    EXPECT_TRUE(window->document().isModified());
    {
        const auto left = widgets::findLeftovers();  // nobody else finds them meanwhile
        ASSERT_EQ(left.size(), 1U);
        EXPECT_EQ(left.front().original, "/somewhere/first.rover");
    }
    // Fetched without a new start, once what is there now may go.
    answerRecovery("restore");
    testsupport::answerNextBox(QMessageBox::Discard);
    window->actions().at("recover")->trigger();
    EXPECT_EQ(window->document().file(), "/somewhere/first.rover");
    EXPECT_TRUE(widgets::findLeftovers().empty());
    QString said;
    testsupport::answerNextBox(QMessageBox::Ok, &said);
    window->actions().at("recover")->trigger();
    EXPECT_THAT(said.toStdString(), testing::HasSubstr("No other session"));
}

TEST_F(FilesTest, FailedAutosaveIsToldUntilItWorks) {
    auto* problems = window->findChild<widgets::ProblemsPanel*>();
    const int before = problems->count();
    int told = 0;
    QObject::connect(&window->files(), &widgets::FileCommands::message, [&] { ++told; });
    {
        const testsupport::FileSizeLimit full(1000);
        for (const char* radius : {"80", "81", "82"}) {
            type(parameter("wheel_radius"), radius);
            window->files().autosave();
        }
        EXPECT_EQ(told, 1);
        EXPECT_EQ(problems->count(), before + 1);
    }
    window->files().autosave();
    EXPECT_EQ(problems->count(), before);
    EXPECT_EQ(autosavedCopies().size(), 1);
}

TEST_F(FilesTest, FirstSaveKeepsWhatTheFileHeld) {
    const QString file = folder.filePath("mine.rover");
    std::ofstream(file.toStdString()) << bytesOf(projectFile("shrimp"));
    ASSERT_TRUE(window->document().open(file).empty());
    for (const char* name : {"first", "second"}) {
        simcore::project::Project next = window->document().project();
        next.rover.name = name;
        window->document().edit("Rename", next);
        ASSERT_TRUE(window->files().save());
    }
    EXPECT_EQ(bytesOf(file + "~"), bytesOf(projectFile("shrimp")));
    EXPECT_THAT(bytesOf(file), testing::HasSubstr("second"));
}

TEST_F(FilesTest, BackupThatFailsIsToldAndTheFileIsSaved) {
    const QString file = folder.filePath("mine.rover");
    std::ofstream(file.toStdString()) << bytesOf(projectFile("shrimp"));
    ASSERT_TRUE(QDir().mkpath(file + "~"));
    ASSERT_TRUE(window->document().open(file).empty());
    simcore::project::Project next = window->document().project();
    next.rover.name = "first";
    window->document().edit("Rename", next);
    QString told;
    QObject::connect(&window->files(), &widgets::FileCommands::message,
                     [&](const QString& text) { told = text; });
    EXPECT_TRUE(window->files().save());
    EXPECT_THAT(told.toStdString(), testing::HasSubstr("could not be kept"));
    EXPECT_THAT(bytesOf(file), testing::HasSubstr("first"));
    EXPECT_FALSE(window->document().isModified());
}

TEST_F(FilesTest, ChangeOnDiskIsReloadedAndReloadingIsUndone) {
    const QString file = ownFile();
    type(parameter("wheel_radius"), "80");
    std::ofstream(file.toStdString()) << bytesOf(projectFile("shrimp"));
    ASSERT_TRUE(waitUntil([this] { return changeBox() != nullptr; }));
    EXPECT_FALSE(changeBox()->isModal());
    QTest::mouseClick(changeBox()->button(QMessageBox::Yes), Qt::LeftButton);
    EXPECT_EQ(window->document().project().rover.name, "Shrimp");
    EXPECT_FALSE(window->document().isModified());
    window->document().undoStack().undo();
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.08);
    EXPECT_TRUE(window->document().isModified());
}

TEST_F(FilesTest, MineIsKeptAsUnsavedAndReplacesTheOthersWithABackup) {
    const QString file = ownFile();
    std::ofstream(file.toStdString()) << bytesOf(projectFile("shrimp"));
    ASSERT_TRUE(waitUntil([this] { return changeBox() != nullptr; }));
    QTest::mouseClick(changeBox()->button(QMessageBox::No), Qt::LeftButton);
    EXPECT_EQ(window->document().project().rover.name, "SOLERO");
    EXPECT_TRUE(window->document().isModified());
    EXPECT_TRUE(window->files().save());
    EXPECT_THAT(bytesOf(file), testing::HasSubstr("SOLERO"));
}

TEST_F(FilesTest, OwnSavesAreNoChangeOnDisk) {
    ownFile();
    type(parameter("wheel_radius"), "80");
    ASSERT_TRUE(window->files().save());
    QTest::qWait(700);
    EXPECT_EQ(changeBox(), nullptr);
}

TEST_F(FilesTest, SavingOverAChangedFileAsksFirst) {
    const QString file = ownFile();
    type(parameter("wheel_radius"), "80");
    std::ofstream(file.toStdString()) << "precious";
    QString said;
    answerNextBox(QMessageBox::Cancel, &said);
    EXPECT_FALSE(window->files().save());
    EXPECT_THAT(said.toStdString(), testing::HasSubstr("since it was read"));
    EXPECT_EQ(bytesOf(file), "precious");
    EXPECT_TRUE(window->document().isModified());
    answerNextBox(QMessageBox::Yes);
    EXPECT_TRUE(window->files().save());
    EXPECT_THAT(bytesOf(file), testing::HasSubstr("SOLERO"));
    EXPECT_EQ(bytesOf(file + "~"), "precious");
}

TEST_F(FilesTest, FileThatWasRemovedIsNoticed) {
    const QString file = ownFile();
    QFile::remove(file);
    ASSERT_TRUE(waitUntil([this] { return window->document().isModified(); }, 5000));
    QString said;
    answerNextBox(QMessageBox::Yes, &said);
    EXPECT_TRUE(window->files().save());
    EXPECT_THAT(said.toStdString(), testing::HasSubstr("no longer there"));
    EXPECT_TRUE(QFileInfo::exists(file));
}

TEST_F(FilesTest, ReadOnlyFileStaysAndAnotherNameIsOffered) {
    const QString file = ownFile();
    const std::string before = bytesOf(file);
    QFile::setPermissions(file, QFile::ReadOwner);
    type(parameter("wheel_radius"), "80");
    QString said;
    answerNextBox(QMessageBox::Cancel, &said);
    EXPECT_FALSE(window->files().save());
    EXPECT_THAT(said.toStdString(), testing::HasSubstr("read-only"));
    EXPECT_EQ(bytesOf(file), before);
    EXPECT_TRUE(window->document().isModified());
    const QString other = folder.filePath("other.rover");
    testsupport::onNext<QMessageBox>([other](QMessageBox* box) {
        chooseFile(other);
        QTest::mouseClick(box->button(QMessageBox::Save), Qt::LeftButton);
    });
    EXPECT_TRUE(window->files().save());
    EXPECT_EQ(window->document().file(), other);
    EXPECT_FALSE(window->document().isModified());
}

TEST_F(FilesTest, FullDiskLeavesTheOldFileAndTheMark) {
    const QString file = ownFile();
    const std::string before = bytesOf(file);
    type(parameter("wheel_radius"), "80");
    QString said;
    {
        const testsupport::FileSizeLimit full(1000);
        answerNextBox(QMessageBox::Cancel, &said);
        EXPECT_FALSE(window->files().save());
    }
    EXPECT_THAT(said.toStdString(), testing::HasSubstr("cannot write the file"));
    EXPECT_EQ(bytesOf(file), before);
    EXPECT_TRUE(window->document().isModified());
    EXPECT_THAT(QDir(folder.path()).entryList(QDir::Files).join(" ").toStdString(),
                testing::Not(testing::HasSubstr("mine.rover.")));
}

TEST_F(FilesTest, FailedOpeningAfterDiscardKeepsTheCopy) {
    type(parameter("wheel_radius"), "80");
    window->files().autosave();
    testsupport::onNext<QMessageBox>([](QMessageBox* box) {
        answerNextBox(QMessageBox::Ok);
        QTest::mouseClick(box->button(QMessageBox::Discard), Qt::LeftButton);
    });
    EXPECT_FALSE(window->files().openFile("/nonexistent.rover"));
    EXPECT_EQ(autosavedCopies().size(), 1);
}
