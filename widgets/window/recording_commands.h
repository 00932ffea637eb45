#pragma once

#include <QObject>
#include <functional>
#include <memory>

#include "simcore/base/result.h"
#include "widgets/session/run_session.h"

class QWidget;

namespace widgets {

class FileCommands;

/// Saves the run on show as a recording, opens recordings, and runs an opened one again.
class RecordingCommands : public QObject {
    Q_OBJECT
  public:
    RecordingCommands(RunSession* session, FileCommands* files, QWidget* window);

    /// Whether the name is that of a recording, be it an unfinished one.
    static bool isRecording(const QString& file);

    void open();
    /// Asks about unsaved changes first. False when it was not opened; says why.
    bool openFile(const QString& file);
    /// The same without any question: problems instead, critical when it was not opened.
    simcore::Problems load(const QString& file);
    /// Asks for a recording and reads it, to be held beside the run on show; the project stays.
    void add();
    /// The same of this file. False when it could not be read; says why.
    bool addFile(const QString& file);

    /// Asks for a file and saves what is in the run by then.
    void save() { save(*session_); }

    /// The same of another run, such as a kept one.
    void save(const RunSession& run);
    /// False when it was not saved; says why.
    bool saveTo(const QString& file);
    /// Runs the opened recording again and says whether it is the same run.
    void runAgain();

  signals:
    /// A recording was read.
    void opened(const std::shared_ptr<widgets::RecordedRun>& run);
    /// A recording was read to be compared with.
    void added(const std::shared_ptr<widgets::RecordedRun>& run);
    /// Something to tell in the status bar.
    void message(const QString& text);

  private:
    using Loaded = simcore::Result<std::shared_ptr<RecordedRun>>;
    Loaded read(const QString& file);
    bool take(const QString& file, const std::function<void(std::shared_ptr<RecordedRun>)>& use);
    bool saveCopy(const simcore::Result<simcore::io::RunCopy>& copy, const QString& file);

    RunSession* session_;
    FileCommands* files_;
    QWidget* window_;
};

}  // namespace widgets
