#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <memory>
#include <set>

#include "widgets/document/derived.h"

namespace widgets {

/// The project being edited, its file and its undo history.
///
/// A project is a value: every edit replaces the whole, undo puts the old one back. Nothing in the
/// window keeps a project of its own; all of it follows changed().
class Document : public QObject {
    Q_OBJECT
  public:
    explicit Document(QObject* parent = nullptr);

    const simcore::project::Project& project() const { return *project_; }

    /// The project as it is now, for another thread.
    std::shared_ptr<const simcore::project::Project> snapshot() const { return project_; }

    const Derived& derived() const { return derived_; }

    QUndoStack& undoStack() { return undo_; }

    /// Replaces the project, undoable as `text`. Edits that follow one another with the same
    /// non-empty `mergeKey` (a slider's drag) become one step. Nothing happens when it is equal.
    void edit(const QString& text, simcore::project::Project next, const QString& mergeKey = {});
    /// The next edit starts a step of its own, whatever its key.
    void endMerging();

    /// An empty rover on flat ground, without a file.
    void createNew();
    /// Reads a file; on failure the present project stays and the problems tell why. The problems
    /// of a project that was read are in derived().
    simcore::Problems open(const QString& file);
    /// Reads a file as a template: it becomes a project without a file.
    simcore::Problems openCopy(const QString& file);
    /// Writes to `file`, which becomes the document's. A critical problem when it could not be
    /// written: nothing is changed then, on disk or here. What the file held is kept as "NAME~",
    /// once while a project is open and whenever somebody else changed it; a warning when it could
    /// not be.
    simcore::Problems saveAs(const QString& file);
    /// Takes a project out of a recording: it has no file, and `files` may carry what it names.
    void openProject(simcore::project::Project project, simcore::project::ProjectFiles files);
    /// Takes a project recovered from an autosaved copy: modified, belonging to `file`, whose
    /// content was last seen as `digest`.
    void recover(simcore::project::Project project, const QString& file, const QByteArray& digest);

    /// How the file is now, beside what was last read from it or written to it.
    enum class OnDisk {
        Same,  ///< or there is no file
        Changed,
        Gone  ///< or cannot be read
    };
    OnDisk compareWithDisk() const;
    /// Takes what the file holds now, as an edit that can be undone. On failure nothing is changed
    /// and the problems tell why.
    simcore::Problems reload();
    /// The file's present content counts as seen, and the project as not saved.
    void keepMine();

    /// Of the content last read or written, or seen by keepMine(); empty without a file.
    const QByteArray& digest() const { return digest_; }

    /// Absolute path; empty when never saved.
    QString file() const { return file_; }

    /// Where the terrain files are: those that came with the project, and the folder of its file.
    simcore::project::ProjectFiles files() const;

    /// File name, or "Untitled".
    QString displayName() const;

    bool isModified() const { return !undo_.isClean(); }

  signals:
    /// Project and derived values are new.
    void changed();
    /// Another project is there, not an edit of the same; comes after changed().
    void replaced();
    void fileChanged();
    void modifiedChanged(bool modified);

  private:
    friend class ProjectCommand;
    using ProjectPtr = std::shared_ptr<const simcore::project::Project>;
    void show(ProjectPtr project);
    void start(simcore::project::Project project, const QString& file,
               simcore::project::ProjectFiles files = {}, const QByteArray& digest = {});

    ProjectPtr project_;
    Derived derived_;
    QUndoStack undo_;
    QString file_;
    QByteArray digest_;                     ///< of the file's content as last seen
    std::set<QString> backedUp_;            ///< files whose earlier content has been kept
    simcore::project::ProjectFiles files_;  ///< that came with the project
    int mergeRun_ = 0;
};

}  // namespace widgets
