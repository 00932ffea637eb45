#include "widgets/window/file_commands.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>
#include <QStandardPaths>

#include "simcore/io/project_file.h"
#include "widgets/document/autosave.h"
#include "widgets/session/may_replace.h"
#include "widgets/window/new_rover_dialog.h"

namespace widgets {

using simcore::Problems;

namespace {

constexpr int kRecentLimit = 8;
constexpr int kAutosavePeriod_ms = 120000;
constexpr const char* kRecentKey = "files/recent";
const char* const kFilter =
    QT_TRANSLATE_NOOP("widgets::FileCommands", "RoverStudio projects (*.rover);;All files (*)");

}  // namespace

FileCommands::FileCommands(Document* document, QWidget* window)
    : QObject(window),
      document_(document),
      window_(window) {
    autosaveTimer_.setInterval(kAutosavePeriod_ms);
    connect(&autosaveTimer_, &QTimer::timeout, this, &FileCommands::autosave);
    connect(document_, &Document::modifiedChanged, this, [this](bool modified) {
        if (modified) {
            autosaveTimer_.start();
        } else {
            autosaveTimer_.stop();
            autosave::discard();
        }
    });
}

void FileCommands::createNew() {
    if (mayDiscard()) {
        document_->createNew();
    }
}

void FileCommands::createFromTemplate() {
    NewRoverDialog dialog(window_);
    if (dialog.exec() == QDialog::Accepted && mayDiscard()) {
        document_->openProject(dialog.project(), {});
        emit message(tr("A new rover: save it under a name of your own."));
    }
}

QString FileCommands::startFolder() const {
    return document_->file().isEmpty()
               ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
               : QFileInfo(document_->file()).absolutePath();
}

QString FileCommands::chooseFile() const {
    return QFileDialog::getOpenFileName(window_, tr("Open project"), startFolder(), tr(kFilter));
}

bool FileCommands::openFile(const QString& file) {
    if (!mayDiscard()) {
        return false;
    }
    const Problems problems = document_->open(file);
    if (!problems.empty()) {
        complain(tr("The project cannot be opened"), problems);
        return false;
    }
    remember(file);
    return true;
}

void FileCommands::openExample(const QString& file) {
    if (!mayDiscard()) {
        return;
    }
    const Problems problems = document_->openCopy(file);
    if (!problems.empty()) {
        complain(tr("The example cannot be opened"), problems);
    } else {
        emit message(tr("Opened a copy of %1: save it under a name of your own.")
                         .arg(QFileInfo(file).fileName()));
    }
}

bool FileCommands::save() {
    if (document_->file().isEmpty()) {
        return saveAs();
    }
    const Problems problems = document_->saveAs(document_->file());
    if (!problems.empty()) {
        complain(tr("The project was not saved"), problems);
        return false;
    }
    emit message(tr("Saved %1").arg(document_->file()));
    return true;
}

bool FileCommands::saveAs() {
    const QString name =
        document_->file().isEmpty()
            ? QDir(startFolder())
                  .filePath(QString::fromStdString(document_->project().rover.name).toLower() +
                            ".rover")
            : document_->file();
    QString file = QFileDialog::getSaveFileName(window_, tr("Save project as"), name, tr(kFilter));
    if (file.isEmpty()) {
        return false;
    }
    if (QFileInfo(file).suffix().isEmpty()) {
        file += ".rover";
        if (!mayReplace(window_, file)) {
            return false;
        }
    }
    const Problems problems = document_->saveAs(file);
    if (!problems.empty()) {
        complain(tr("The project was not saved"), problems);
        return false;
    }
    remember(file);
    const auto carried = document_->files().carried;
    emit message(carried && !carried->empty()
                     ? tr("Saved %1; the files of its ground are in the recording only").arg(file)
                     : tr("Saved %1").arg(file));
    return true;
}

bool FileCommands::mayDiscard() {
    if (!document_->isModified()) {
        return true;
    }
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                    tr("Save the changes to %1?").arg(document_->displayName()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
    box.setInformativeText(tr("They are lost if you do not save them."));
    box.setDefaultButton(QMessageBox::Save);
    box.setObjectName("unsavedChanges");
    switch (box.exec()) {
        case QMessageBox::Save:
            return save();
        case QMessageBox::Discard:
            autosave::discard();
            return true;
        default:
            return false;
    }
}

QStringList FileCommands::recentFiles() const {
    QStringList files;
    for (const QString& file : QSettings().value(kRecentKey).toStringList()) {
        if (QFileInfo::exists(file)) {
            files << file;
        }
    }
    return files;
}

void FileCommands::forgetRecentFiles() {
    QSettings().remove(kRecentKey);
    emit recentFilesChanged();
}

void FileCommands::remember(const QString& file) {
    const QString path = QFileInfo(file).absoluteFilePath();
    QStringList files = recentFiles();
    files.removeAll(path);
    files.prepend(path);
    QSettings().setValue(kRecentKey, QStringList(files.mid(0, kRecentLimit)));
    emit recentFilesChanged();
}

QStringList FileCommands::exampleFiles() const {
    const QDir folder(QString::fromStdString(simcore::io::examplesFolder().string()));
    QStringList files;
    for (const QFileInfo& info : folder.entryInfoList({"*.rover"}, QDir::Files, QDir::Name)) {
        files << info.absoluteFilePath();
    }
    return files;
}

void FileCommands::autosave() {
    if (!document_->isModified()) {
        return;
    }
    const Problems problems = autosave::write(*document_);
    if (!problems.empty()) {
        emit message(tr("No copy could be autosaved: %1")
                         .arg(QString::fromStdString(problems.front().reason)));
    }
}

void FileCommands::offerRecovery() {
    const auto leftover = autosave::findLeftover();
    if (!leftover) {
        return;
    }
    auto project = simcore::io::loadProject(leftover->copy.toStdString());
    if (!project) {
        autosave::remove(*leftover);
        return;
    }
    const QString name = leftover->original.isEmpty() ? QString::fromStdString(project->rover.name)
                                                      : QFileInfo(leftover->original).fileName();
    QMessageBox box(
        QMessageBox::Question, tr("Unsaved work found"),
        tr("RoverStudio did not end well. Restore the unsaved changes to %1?").arg(name),
        QMessageBox::Yes | QMessageBox::No, window_);
    box.setObjectName("recovery");
    box.setInformativeText(tr("With No they are thrown away."));
    if (box.exec() == QMessageBox::Yes) {
        document_->recover(std::move(project).value(), leftover->original);
        autosave();
    }
    autosave::remove(*leftover);
}

void FileCommands::complain(const QString& title, const Problems& problems) const {
    QMessageBox box(QMessageBox::Warning, title, title, QMessageBox::Ok, window_);
    constexpr std::size_t kShown = 3;
    Problems first(problems.begin(), problems.begin() + static_cast<std::ptrdiff_t>(
                                                            std::min(kShown, problems.size())));
    box.setInformativeText(QString::fromStdString(toString(first)));
    if (problems.size() > kShown) {
        box.setDetailedText(QString::fromStdString(toString(problems)));
    }
    box.setObjectName("complaint");
    box.exec();
}

}  // namespace widgets
