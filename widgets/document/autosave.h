#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <QThreadPool>
#include <QTimer>
#include <memory>
#include <vector>

#include "widgets/document/document.h"

namespace widgets {

/// Keeps a copy of a document's unsaved changes outside the user's files: 2 s after an edit at the
/// latest, removed when there are none any more. Every session has copy and lock of its own, so
/// that programs running at once do not meet. Written on a thread of its own: a slow disk holds up
/// nobody.
class Autosave : public QObject {
    Q_OBJECT
  public:
    explicit Autosave(Document* document, QObject* parent = nullptr);
    /// Leaves the copy, for the next start to find.
    ~Autosave() override;

    /// Writes the copy and waits for it, before something that might end the program badly. Without
    /// unsaved changes, or when they are written already, nothing happens. False: it failed.
    bool writeNow();
    /// Removes the copy: the changes are saved, or may be lost.
    void discard();

  signals:
    /// A copy could not be written; not said again until one was.
    void failed(const simcore::Problems& problems);
    /// A copy was written after failed().
    void worksAgain();

  private:
    struct Job;
    void writeSoon();
    void startWriting();
    bool isUpToDate() const;
    /// Problems: nothing can be written where the copies are.
    simcore::Problems takeLock();
    Job makeJob() const;
    void finish(const Job& job, const simcore::Problems& problems);

    Document* document_;
    QTimer timer_;
    QThreadPool thread_;
    QString copy_;
    std::unique_ptr<QLockFile> lock_;
    std::shared_ptr<const simcore::project::Project> written_;
    QString writtenFor_;  ///< file of the project that was written
    int discarded_ = 0;   ///< times; results of writing before the last one mean nothing
    bool busy_ = false;
    bool again_ = false;
    bool failing_ = false;
};

/// What a program that ended badly left behind.
struct Leftover {
    QString copy;                     ///< the autosaved file
    QString original;                 ///< the file it belongs to; empty when never saved
    QByteArray digest;                ///< of what that file held then, as Document::digest()
    QDateTime time;                   ///< when the copy was written
    std::shared_ptr<QLockFile> lock;  ///< no other program offers it while this is held
};

/// Copies whose program has ended and which no other program offers now, newest first.
std::vector<Leftover> findLeftovers();
/// Throws the copy away.
void remove(const Leftover& leftover);

}  // namespace widgets
