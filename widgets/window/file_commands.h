#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>

#include "widgets/document/document.h"

class QWidget;

namespace widgets {

/// New, open, save and close with the questions they need, recent files, examples and autosaved
/// copies. Nothing unsaved is lost without the user saying so.
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

    /// A copy of unsaved work, before a run and every two minutes.
    void autosave();
    /// Offers what a program that ended badly left behind.
    void offerRecovery();
    /// Tells of problems in a box.
    void complain(const QString& title, const simcore::Problems& problems) const;

  signals:
    void recentFilesChanged();
    /// Something to tell in the status bar.
    void message(const QString& text);

  private:
    QString startFolder() const;

    Document* document_;
    QWidget* window_;
    QTimer autosaveTimer_;
};

}  // namespace widgets
