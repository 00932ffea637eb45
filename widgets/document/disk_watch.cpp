#include "widgets/document/disk_watch.h"

#include <QFileInfo>

namespace widgets {

namespace {

/// Programs write files in several steps.
constexpr int kSettle_ms = 300;

}  // namespace

DiskWatch::DiskWatch(Document* document, QObject* parent) : QObject(parent), document_(document) {
    timer_.setSingleShot(true);
    timer_.setInterval(kSettle_ms);
    connect(&timer_, &QTimer::timeout, this, &DiskWatch::look);
    connect(&watcher_, &QFileSystemWatcher::fileChanged, &timer_, qOverload<>(&QTimer::start));
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, &timer_, qOverload<>(&QTimer::start));
    connect(document_, &Document::fileChanged, this, &DiskWatch::follow);
    follow();
}

void DiskWatch::follow() {
    const QStringList before = watcher_.files() + watcher_.directories();
    if (!before.isEmpty()) {
        watcher_.removePaths(before);
    }
    timer_.stop();
    if (told_ != Document::OnDisk::Same) {
        told_ = Document::OnDisk::Same;
        emit settled();
    }
    const QString file = document_->file();
    if (file.isEmpty()) {
        return;
    }
    // The folder, too: a file that is replaced is another one, and no longer watched.
    const QString folder = QFileInfo(file).absolutePath();
    if (QFileInfo(folder).isDir()) {
        watcher_.addPath(folder);
    }
    if (QFileInfo::exists(file)) {
        watcher_.addPath(file);
    }
    // A recovered project's file may have been changed long ago.
    timer_.start();
}

void DiskWatch::look() {
    const QString file = document_->file();
    if (!file.isEmpty() && !watcher_.files().contains(file) && QFileInfo::exists(file)) {
        watcher_.addPath(file);
    }
    const Document::OnDisk now = document_->compareWithDisk();
    if (now == told_) {
        return;
    }
    told_ = now;
    switch (now) {
        case Document::OnDisk::Same:
            emit settled();
            break;
        case Document::OnDisk::Changed:
            emit changed();
            break;
        case Document::OnDisk::Gone:
            emit gone();
            break;
    }
}

}  // namespace widgets
