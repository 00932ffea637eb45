#include "widgets/window/recording_commands.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QRegularExpression>
#include <QSettings>
#include <QStandardPaths>

#include <exception>

#include "simcore/base/text.h"
#include "simcore/base/version.h"
#include "simcore/io/replay.h"
#include "widgets/session/may_replace.h"
#include "widgets/window/background.h"
#include "widgets/window/file_commands.h"

namespace widgets {

using simcore::Problems;

namespace {

constexpr const char* kFolderKey = "recordings/folder";
const char* const kFilter =
    QT_TRANSLATE_NOOP("widgets::RecordingCommands", "Recordings (*.roverrec *.roverrec.part)");

QString startFolder() {
    return QSettings()
        .value(kFolderKey, QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
        .toString();
}

}  // namespace

RecordingCommands::RecordingCommands(RunSession* session, FileCommands* files, QWidget* window)
    : QObject(window),
      session_(session),
      files_(files),
      window_(window) {}

bool RecordingCommands::isRecording(const QString& file) {
    return file.endsWith(".roverrec") || file.endsWith(".roverrec.part");
}

void RecordingCommands::open() {
    const QString file =
        QFileDialog::getOpenFileName(window_, tr("Open recording"), startFolder(), tr(kFilter));
    if (!file.isEmpty()) {
        openFile(file);
    }
}

RecordingCommands::Loaded RecordingCommands::read(const QString& file) {
    session_->pause();
    Loaded loaded = std::shared_ptr<RecordedRun>();
    workInBackground(window_, tr("Reading %1").arg(QFileInfo(file).fileName()),
                     [&](const GoOn& goOn) { loaded = loadRecording(file.toStdString(), goOn); });
    return loaded;
}

bool RecordingCommands::openFile(const QString& file) {
    if (!files_->mayDiscard()) {
        return false;
    }
    return take(file, [&](const std::shared_ptr<RecordedRun>& run) {
        emit opened(run);
        files_->remember(file);
    });
}

/// Reads a recording and hands it on; tells the user what is wrong with it.
bool RecordingCommands::take(const QString& file,
                             const std::function<void(std::shared_ptr<RecordedRun>)>& use) {
    const Loaded loaded = read(file);
    if (!loaded) {
        files_->complain(tr("The recording cannot be opened"), loaded.problems());
        return false;
    }
    if (*loaded == nullptr) {
        return false;  // stopped by the user
    }
    use(*loaded);
    QSettings().setValue(kFolderKey, QFileInfo(file).absolutePath());
    if (!loaded.problems().empty()) {
        files_->complain(tr("The recording is not whole"), loaded.problems());
    }
    return true;
}

Problems RecordingCommands::load(const QString& file) {
    const Loaded loaded = read(file);
    if (loaded && *loaded != nullptr) {
        emit opened(*loaded);
    }
    return loaded.problems();
}

void RecordingCommands::add() {
    const QString file = QFileDialog::getOpenFileName(window_, tr("Add recording to compare"),
                                                      startFolder(), tr(kFilter));
    if (!file.isEmpty()) {
        addFile(file);
    }
}

bool RecordingCommands::addFile(const QString& file) {
    return take(file, [this](const std::shared_ptr<RecordedRun>& run) { emit added(run); });
}

void RecordingCommands::save(const RunSession& run) {
    // What is in the run now, not when a name has been found.
    const auto copy = run.copyRun();
    if (!copy) {
        files_->complain(tr("The run cannot be saved"), copy.problems());
        return;
    }
    const auto& settings = run.settings();
    const QString name = QString::fromStdString(settings.mechanism.name + "-" + settings.scenario)
                             .toLower()
                             .replace(QRegularExpression("[^\\w-]+"), "-");
    QFileDialog dialog(window_, tr("Save recording"), startFolder(), tr("Recordings (*.roverrec)"));
    dialog.setObjectName("saveRecordingDialog");
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.selectFile(name + ".roverrec");
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    QString file = dialog.selectedFiles().front();
    if (QFileInfo(file).suffix().isEmpty()) {
        // Not by the dialog: one of the system may add it after asking about the file.
        file += ".roverrec";
        if (!mayReplace(window_, file)) {
            return;
        }
    }
    saveCopy(copy, file);
}

bool RecordingCommands::saveTo(const QString& file) {
    return saveCopy(session_->copyRun(), file);
}

bool RecordingCommands::saveCopy(const simcore::Result<simcore::io::RunCopy>& copy,
                                 const QString& file) {
    simcore::Result<bool> saved = copy.problems();
    if (copy) {
        workInBackground(window_, tr("Saving %1").arg(QFileInfo(file).fileName()),
                         [&](const GoOn& goOn) { saved = copy->save(file.toStdString(), goOn); });
    }
    if (!saved) {
        files_->complain(tr("The run was not saved"), saved.problems());
        return false;
    }
    if (!*saved) {
        return false;  // stopped by the user
    }
    QSettings().setValue(kFolderKey, QFileInfo(file).absolutePath());
    files_->remember(file);
    emit message(tr("Saved %1").arg(file));
    return true;
}

void RecordingCommands::runAgain() {
    const RecordedRun* recorded = session_->recorded();
    if (recorded == nullptr) {
        return;
    }
    const std::filesystem::path file = recorded->file;
    const double step = recorded->settings.step;
    std::string version;
    simcore::Result<simcore::io::ReplayResult> replayed = simcore::io::ReplayResult();
    workInBackground(window_, tr("Running the recorded run again"), [&](const GoOn& goOn) {
        try {
            auto reader = simcore::io::RecordingReader::open(file, [&goOn] { return goOn(0.0); });
            if (!reader) {
                replayed = reader.problems();
            } else if (*reader == nullptr) {
                replayed.value().stopped = true;
            } else {
                version = (*reader)->header().programVersion;
                replayed = simcore::io::replay(**reader, goOn);
            }
        } catch (const std::exception& error) {
            replayed = simcore::Problem{
                simcore::Severity::Critical, file.string(),
                simcore::Text::of("it cannot be read ({}).", error.what()),
                simcore::Text::of("Close other programs if there is no memory left.")};
        }
    });
    if (!replayed) {
        files_->complain(tr("The recording cannot be run again"), replayed.problems());
        return;
    }
    if (replayed->stopped) {
        return;
    }
    const bool same = replayed->same();
    QMessageBox box(same ? QMessageBox::Information : QMessageBox::Warning,
                    tr("Run again and compare"), same ? tr("The same run.") : tr("Another run."),
                    QMessageBox::Ok, window_);
    box.setObjectName("replayResult");
    const auto seconds = [step](long steps) {
        return QString::number(static_cast<double>(steps) * step, 'f', 2);
    };
    QString text =
        same ? tr("%1 s were run again, to the last bit as recorded. State hash %2.")
                   .arg(seconds(replayed->steps), QString::fromStdString(replayed->found))
             : tr("It is the same for the first %1 s, and differs at %2 s. State hash %3 was "
                  "recorded, %4 came out.")
                   .arg(seconds(replayed->sameUntil), seconds(replayed->steps),
                        QString::fromStdString(replayed->expected),
                        replayed->found.empty() ? tr("an earlier end")
                                                : QString::fromStdString(replayed->found));
    if (!same && version != simcore::programVersion()) {
        text += " " + tr("It was recorded with version %1, this is %2.")
                          .arg(QString::fromStdString(version),
                               QString::fromStdString(simcore::programVersion()));
    }
    box.setInformativeText(text);
    box.exec();
}

}  // namespace widgets
