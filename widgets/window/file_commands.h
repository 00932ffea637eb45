#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>

#include "widgets/document/autosave.h"
#include "widgets/document/disk_watch.h"
#include "widgets/document/document.h"

class QMessageBox;
class QWidget;

namespace widgets {

/// New, open, save and close with the questions they need, recent files, examples, autosaved copies
/// and what others do to the file. Nothing unsaved is lost without the user saying so.
class FileCommands : public QObject {
    Q_OBJECT
  public:
    FileCommands(Document* document, QWidget* window);

    void createNew();
    /// A rover from a template, with main dimensions that the user chooses.
    void createFromTemplate();
    /// Asks for a file to open; empty: none.
    QString chooseFile() const;
    /// Asks about unsaved changes first. False when it was not opened; says why.
    bool openFile(const QString& file);
    void openExample(const QString& file);
    /// Asks before it replaces what somebody else wrote. False when nothing was saved.
    bool save();
    bool saveAs();
    /// Asks what to do with unsaved changes. False: stay.
    bool mayDiscard();

    QStringList recentFiles() const;
    /// Puts a file first among the recent ones.
    void remember(const QString& file);
    void forgetRecentFiles();
    /// Files of the shipped projects.
    QStringList exampleFiles() const;

    /// Writes a copy of unsaved work at once, before a run.
    void autosave() { autosave_.writeNow(); }

    /// Removes the copy: the program ends well.
    void discardAutosave() { autosave_.discard(); }

    /// Offers what programs that ended badly left behind.
    /// False when there was nothing to offer.
    bool offerRecovery();
    /// The same whenever the user asks; says when there is nothing.
    void recover();
    /// Tells of problems in a box.
    void complain(const QString& title, const simcore::Problems& problems) const;

  signals:
    void recentFilesChanged();
    /// Something to tell in the status bar.
    void message(const QString& text);
    /// Something that went wrong, for the list of problems.
    void problems(const simcore::Problems& problems);
    /// Why unsaved work is not safe, as long as it is so; then none.
    void autosaveProblems(const simcore::Problems& problems);

  private:
    QString startFolder() const;
    /// Saves under the name and says so, or why not; then offers another name. False: not saved.
    bool write(const QString& file);
    /// Tells why a file was not saved and offers another name. False: not saved.
    bool offerSaveAs(const simcore::Problems& problems);
    void askAboutChange();
    void onGone();

    Document* document_;
    QWidget* window_;
    Autosave autosave_;
    DiskWatch watch_;
    QPointer<QMessageBox> changeBox_;
};

}  // namespace widgets
