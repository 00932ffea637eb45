#include "widgets/window/file_commands.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

#include "simcore/io/project_file.h"
#include "widgets/session/may_replace.h"
#include "widgets/window/new_rover_dialog.h"
#include "widgets/window/recovery_dialog.h"

namespace widgets {

using simcore::Problems;

namespace {

constexpr int kRecentLimit = 8;
constexpr const char* kRecentKey = "files/recent";
const char* const kFilter =
    QT_TRANSLATE_NOOP("widgets::FileCommands", "RoverStudio projects (*.rover);;All files (*)");

}  // namespace

FileCommands::FileCommands(Document* document, QWidget* window)
    : QObject(window),
      document_(document),
      window_(window),
      autosave_(document),
      watch_(document) {
    connect(&autosave_, &Autosave::failed, this, [this](const Problems& problems) {
        emit message(tr("Unsaved work cannot be kept safe: %1")
                         .arg(QString::fromStdString(problems.front().reason)));
        emit autosaveProblems(problems);
    });
    connect(&autosave_, &Autosave::worksAgain, this, [this] { emit autosaveProblems({}); });
    connect(&watch_, &DiskWatch::changed, this, &FileCommands::askAboutChange);
    connect(&watch_, &DiskWatch::gone, this, &FileCommands::onGone);
    connect(&watch_, &DiskWatch::settled, this, [this] { delete changeBox_; });
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
    const QString file = document_->file();
    if (file.isEmpty()) {
        return saveAs();
    }
    const Document::OnDisk onDisk = document_->compareWithDisk();
    if (onDisk == Document::OnDisk::Same) {
        return write(file);
    }
    const bool gone = onDisk == Document::OnDisk::Gone;
    QMessageBox box(QMessageBox::Warning, tr("Changed on disk"),
                    gone ? tr("%1 is no longer there, or cannot be read.").arg(file)
                         : tr("%1 was changed by somebody else since it was read.").arg(file),
                    QMessageBox::Yes | QMessageBox::Save | QMessageBox::Cancel, window_);
    box.setInformativeText(gone ? tr("It was removed, renamed or moved.")
                                : tr("What it holds now is kept as %1 if you replace it.")
                                      .arg(QFileInfo(file).fileName() + "~"));
    box.button(QMessageBox::Yes)->setText(gone ? tr("&Write it again") : tr("&Replace it"));
    box.button(QMessageBox::Save)->setText(tr("&Save as..."));
    box.setDefaultButton(QMessageBox::Save);
    box.setObjectName("overwrite");
    switch (box.exec()) {
        case QMessageBox::Yes:
            return write(file);
        case QMessageBox::Save:
            return saveAs();
        default:
            return false;
    }
}

bool FileCommands::write(const QString& file) {
    const Problems problems = document_->saveAs(file);
    if (hasCritical(problems)) {
        return offerSaveAs(problems);
    }
    const auto carried = document_->files().carried;
    if (!problems.empty()) {
        emit message(tr("Saved %1, but what it held before could not be kept: %2")
                         .arg(file, QString::fromStdString(problems.front().reason)));
        emit this->problems(problems);
    } else if (carried && !carried->empty()) {
        emit message(tr("Saved %1; the files of its ground are in the recording only").arg(file));
    } else {
        emit message(tr("Saved %1").arg(file));
    }
    return true;
}

bool FileCommands::offerSaveAs(const Problems& problems) {
    const QString title = tr("The project was not saved");
    QMessageBox box(QMessageBox::Warning, title, title, QMessageBox::Save | QMessageBox::Cancel,
                    window_);
    box.setInformativeText(QString::fromStdString(toString(problems)));
    box.button(QMessageBox::Save)->setText(tr("&Save as..."));
    box.setDefaultButton(QMessageBox::Save);
    box.setObjectName("notSaved");
    return box.exec() == QMessageBox::Save && saveAs();
}

void FileCommands::askAboutChange() {
    if (changeBox_ != nullptr) {
        return;
    }
    auto* box =
        new QMessageBox(QMessageBox::Question, tr("Changed on disk"),
                        tr("%1 was changed by another program.").arg(document_->displayName()),
                        QMessageBox::Yes | QMessageBox::No, window_);
    box->setInformativeText(document_->isModified()
                                ? tr("You have unsaved changes. Reloading can be undone.")
                                : tr("Reloading can be undone."));
    box->button(QMessageBox::Yes)->setText(tr("&Reload"));
    box->button(QMessageBox::No)->setText(tr("&Keep mine"));
    box->setEscapeButton(QMessageBox::No);
    box->setObjectName("changedOnDisk");
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    changeBox_ = box;
    connect(box, &QMessageBox::finished, this, [this](int answer) {
        changeBox_ = nullptr;
        if (answer != QMessageBox::Yes) {
            document_->keepMine();
        } else if (const Problems problems = document_->reload(); !problems.empty()) {
            document_->keepMine();
            complain(tr("The project cannot be read again"), problems);
        }
        watch_.look();
    });
    box->show();
}

void FileCommands::onGone() {
    delete changeBox_;
    document_->keepMine();
    emit message(tr("%1 is no longer there: save the project to keep it.").arg(document_->file()));
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
    if (!write(file)) {
        return false;
    }
    remember(document_->file());
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
            // Their copy stays until another project is there: opening that may fail.
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

bool FileCommands::offerRecovery() {
    std::vector<Recovered> found;
    for (Leftover& leftover : findLeftovers()) {
        auto project = simcore::io::loadProject(leftover.copy.toStdString());
        if (project) {
            found.push_back({std::move(leftover), std::move(project).value()});
        } else {
            emit problems(project.problems());  // left there, for who can read it
        }
    }
    if (found.empty()) {
        return false;
    }
    RecoveryDialog dialog(std::move(found), window_);
    if (dialog.exec() != QDialog::Accepted || !mayDiscard()) {
        return true;
    }
    const Recovered& chosen = dialog.chosen();
    document_->recover(chosen.project, chosen.leftover.original, chosen.leftover.digest);
    if (autosave_.writeNow()) {
        remove(chosen.leftover);
    }
    if (dialog.remaining() > 1) {
        emit message(
            tr("%n other project(s) with unsaved changes: File > Recover unsaved work, or at the "
               "next start.",
               nullptr, dialog.remaining() - 1));
    }
    return true;
}

void FileCommands::recover() {
    if (!offerRecovery()) {
        QMessageBox::information(window_, tr("Recover unsaved work"),
                                 tr("No other session left unsaved work behind. What is unsaved in "
                                    "this one is kept safe "
                                    "while it runs."));
    }
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
