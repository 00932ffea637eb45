#include "widgets/document/autosave.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>

namespace widgets::autosave {
namespace {

QString folder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/autosave";
}

QString copyFile() {
    return folder() + QString("/%1.rover").arg(QCoreApplication::applicationPid());
}

/// Beside each copy: the path of the file it belongs to.
QString noteFile(const QString& copy) {
    return copy + ".origin";
}

bool isRunning(const QString& processId) {
    return QFileInfo::exists("/proc/" + processId);
}

}  // namespace

simcore::Problems write(const Document& document) {
    if (!QDir().mkpath(folder())) {
        return {{simcore::Severity::Warning, folder().toStdString(),
                 "the folder for autosaved copies cannot be made.",
                 "Check the permissions of your home folder."}};
    }
    QSaveFile note(noteFile(copyFile()));
    if (note.open(QIODevice::WriteOnly)) {
        note.write(document.file().toUtf8());
        note.commit();
    }
    return document.saveCopy(copyFile());
}

void discard() {
    remove({copyFile(), {}});
}

std::optional<Leftover> findLeftover() {
    const QDir directory(folder());
    for (const QFileInfo& info : directory.entryInfoList({"*.rover"}, QDir::Files, QDir::Time)) {
        if (isRunning(info.completeBaseName())) {
            continue;
        }
        QFile note(noteFile(info.absoluteFilePath()));
        const QString original =
            note.open(QIODevice::ReadOnly) ? QString::fromUtf8(note.readAll()) : QString();
        return Leftover{info.absoluteFilePath(), original};
    }
    return std::nullopt;
}

void remove(const Leftover& leftover) {
    QFile::remove(leftover.copy);
    QFile::remove(noteFile(leftover.copy));
}

}  // namespace widgets::autosave
