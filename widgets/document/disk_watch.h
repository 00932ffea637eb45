#pragma once

#include <QFileSystemWatcher>
#include <QTimer>

#include "widgets/document/document.h"

namespace widgets {

/// Notices when somebody else changes, replaces or removes the document's file.
class DiskWatch : public QObject {
    Q_OBJECT
  public:
    explicit DiskWatch(Document* document, QObject* parent = nullptr);

    /// Compares again, after the document has been told about what it found.
    void look();

  signals:
    /// The file holds something else than the document last read or wrote.
    void changed();
    /// The file is no longer there, or cannot be read.
    void gone();
    /// After one of these: the file is again as the document knows it.
    void settled();

  private:
    void follow();

    Document* document_;
    QFileSystemWatcher watcher_;
    QTimer timer_;
    Document::OnDisk told_ = Document::OnDisk::Same;
};

}  // namespace widgets
