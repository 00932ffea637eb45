#include "widgets/document/autosave.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>

#include "simcore/io/atomic_file.h"
#include "simcore/io/project_file.h"

namespace widgets {

using simcore::Problems;

namespace {

constexpr int kDelay_ms = 2000;
/// A full disk may have room again.
constexpr int kRetry_ms = 20000;

QString autosaveFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/autosave";
}

/// Beside each copy: digest and path of the file it belongs to, on two lines.
QString noteFile(const QString& copy) {
    return copy + ".origin";
}

QString lockFile(const QString& copy) {
    return copy + ".lock";
}

std::shared_ptr<QLockFile> lockOf(const QString& copy) {
    auto lock = std::make_shared<QLockFile>(lockFile(copy));
    lock->setStaleLockTime(0);  // sessions may be long; only one that has ended is stale
    return lock->tryLock() ? lock : nullptr;
}

/// Copy, note and what was being written when the program ended.
void removeFiles(const QString& copy) {
    QFile::remove(copy);
    const QFileInfo info(copy);
    for (const QString& name : info.dir().entryList({info.fileName() + ".*"}, QDir::Files)) {
        if (!name.endsWith(".lock")) {
            QFile::remove(info.dir().filePath(name));
        }
    }
}

}  // namespace

struct Autosave::Job {
    std::shared_ptr<const simcore::project::Project> project;
    QString copy, original;
    QByteArray digest;
    int discarded;

    Problems write() const {
        const std::string note = digest.toStdString() + "\n" + original.toStdString();
        const std::string noteName = noteFile(copy).toStdString();
        // The note first: a copy always has the one that belongs to it.
        if (const auto old = simcore::io::readFile(noteName); !old || *old != note) {
            if (auto written = simcore::io::writeFileAtomically(noteName, note); !written) {
                return written.problems();
            }
        }
        return simcore::io::saveProject(*project, copy.toStdString()).problems();
    }
};

Autosave::Autosave(Document* document, QObject* parent)
    : QObject(parent),
      document_(document),
      copy_(autosaveFolder() + "/" + QUuid::createUuid().toString(QUuid::Id128) + ".rover") {
    thread_.setMaxThreadCount(1);
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &Autosave::startWriting);
    connect(document_, &Document::changed, this, &Autosave::writeSoon);
    connect(document_, &Document::modifiedChanged, this, [this](bool modified) {
        if (modified) {
            writeSoon();
        } else {
            discard();
        }
    });
}

Autosave::~Autosave() {
    thread_.waitForDone();
}

void Autosave::writeSoon() {
    // From the first edit on: who edits without a pause has copies, too.
    if (!timer_.isActive() || timer_.interval() != kDelay_ms) {
        timer_.start(kDelay_ms);
    }
}

bool Autosave::isUpToDate() const {
    return !document_->isModified() ||
           (written_ == document_->snapshot() && writtenFor_ == document_->file());
}

Problems Autosave::takeLock() {
    if (lock_ != nullptr && lock_->isLocked()) {
        return {};
    }
    const QString folder = autosaveFolder();
    if (!QFileInfo(folder).isDir() && QDir().mkpath(folder)) {
        // Projects may be private where the home folder is not.
        QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    }
    lock_ = std::make_unique<QLockFile>(lockFile(copy_));
    lock_->setStaleLockTime(0);
    if (lock_->tryLock()) {
        return {};
    }
    return {{simcore::Severity::Warning, folder.toStdString(),
             tr("copies of unsaved work cannot be written there.").toStdString(),
             tr("Check the permissions of the folder and the free space, and save often.")
                 .toStdString()}};
}

Autosave::Job Autosave::makeJob() const {
    return {document_->snapshot(), copy_, document_->file(), document_->digest(), discarded_};
}

void Autosave::startWriting() {
    if (busy_) {
        again_ = true;
        return;
    }
    if (isUpToDate()) {
        return;
    }
    const Job job = makeJob();
    if (const Problems problems = takeLock(); !problems.empty()) {
        finish(job, problems);
        return;
    }
    busy_ = true;
    thread_.start([this, job] {
        const Problems problems = job.write();
        QMetaObject::invokeMethod(
            this,
            [this, job, problems] {
                busy_ = false;
                finish(job, problems);
                if (again_) {
                    again_ = false;
                    startWriting();
                }
            },
            Qt::QueuedConnection);
    });
}

bool Autosave::writeNow() {
    timer_.stop();
    thread_.waitForDone();
    if (isUpToDate()) {
        return true;
    }
    const Job job = makeJob();
    Problems problems = takeLock();
    if (problems.empty()) {
        problems = job.write();
    }
    finish(job, problems);
    return problems.empty();
}

void Autosave::finish(const Job& job, const Problems& problems) {
    if (job.discarded != discarded_) {
        return;
    }
    if (problems.empty()) {
        written_ = job.project;
        writtenFor_ = job.original;
        if (failing_) {
            failing_ = false;
            emit worksAgain();
        }
        return;
    }
    written_.reset();
    if (!timer_.isActive()) {
        timer_.start(kRetry_ms);
    }
    if (!failing_) {
        failing_ = true;
        emit failed(problems);
    }
}

void Autosave::discard() {
    timer_.stop();
    again_ = false;
    ++discarded_;
    thread_.waitForDone();
    written_.reset();
    if (lock_ != nullptr) {
        removeFiles(copy_);
        lock_.reset();
    }
    if (failing_) {
        failing_ = false;
        emit worksAgain();
    }
}

std::vector<Leftover> findLeftovers() {
    const QDir folder(autosaveFolder());
    std::vector<Leftover> leftovers;
    for (const QFileInfo& info : folder.entryInfoList({"*.rover"}, QDir::Files, QDir::Time)) {
        Leftover leftover;
        leftover.copy = info.absoluteFilePath();
        leftover.time = info.lastModified();
        leftover.lock = lockOf(leftover.copy);
        if (leftover.lock == nullptr) {
            continue;
        }
        QFile note(noteFile(leftover.copy));
        if (note.open(QIODevice::ReadOnly)) {
            leftover.digest = note.readLine().trimmed();
            leftover.original = QString::fromUtf8(note.readAll());
        }
        leftovers.push_back(std::move(leftover));
    }
    // Sessions that ended before their first copy was whole.
    for (const QString& name : folder.entryList({"*.rover.lock"}, QDir::Files)) {
        const QString copy = folder.filePath(name.chopped(static_cast<int>(qstrlen(".lock"))));
        if (!QFileInfo::exists(copy)) {
            if (const auto lock = lockOf(copy)) {
                removeFiles(copy);
            }
        }
    }
    return leftovers;
}

void remove(const Leftover& leftover) {
    removeFiles(leftover.copy);
}

}  // namespace widgets
