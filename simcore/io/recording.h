#pragma once

#include <filesystem>
#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simcore/base/result.h"
#include "simcore/io/snapshot_columns.h"
#include "simcore/run/simulation.h"

/// Recordings (`.roverrec`): a run with all that is needed to make it again. docs/recordings.md
/// defines the format.
namespace simcore::io {

/// What a run was made from, and what its tables mean.
struct RecordingHeader {
    std::string programVersion;
    std::string projectFile;  ///< as the user knew it; only for people
    std::string projectText;  ///< whole
    /// Scenario and what was asked for on top of it. A writer puts the carried files into the
    /// recording; a reader leaves them there: RecordingReader::readFiles().
    run::RunRequest request;
    std::string variant;  ///< of the scenario
    std::string engine;   ///< what computed it
    int seed = 1;
    project::ParameterValues parameters;  ///< as used [SI]
    std::vector<run::Channel> channels;
    SnapshotSize size;
};

/// Reads the files of the requested scenario's ground into `request`: the run then drives on the
/// very bytes that its recording carries. Problems when there are none such.
Problems carryFiles(const project::Project& project, run::RunRequest& request);

/// The header of a run of this project as requested and prepared.
RecordingHeader recordingHeader(const project::Project& project, const run::RunRequest& request,
                                const run::ResolvedRun& run, const std::string& engine,
                                const std::string& projectFile);

/// A person's command, in force from this step on.
struct TimedCommand {
    long step = 0;
    run::ManualCommand command;
};

/// State hash of the run after this many steps.
struct HashMark {
    long step = 0;
    std::string stateHash;  ///< 16 hex digits
};

/// Writes a recording while the run goes, into `FILE.part`; finish() makes it FILE. What is there
/// when the program ends otherwise can be opened. After the first failure nothing more is written,
/// problems() says why, and the run may go on.
class RecordingWriter {
  public:
    /// Refuses when FILE.part is there: it may be all that is left of another run.
    static Result<std::unique_ptr<RecordingWriter>> create(const std::filesystem::path& file,
                                                           const RecordingHeader& header);
    ~RecordingWriter();
    RecordingWriter(const RecordingWriter&) = delete;
    RecordingWriter& operator=(const RecordingWriter&) = delete;

    /// Takes rows and frames; writes them when there are enough of them to compress well.
    void add(const std::vector<std::vector<double>>& rows,
             const std::vector<std::shared_ptr<const run::Snapshot>>& frames);
    void add(const TimedCommand& command);
    /// True when it is time for a mark: the rows so far have just been written.
    bool wantsMark() const;
    void add(const HashMark& mark);
    /// The rest, the report, and the file's own name.
    Result<bool> finish(const run::RunReport& report);

    const Problems& problems() const;

  private:
    struct Impl;
    explicit RecordingWriter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

/// Reads a recording piece by piece: only its outline is in memory.
///
/// Opening takes any bytes: what is no recording, or damaged at its beginning, is a problem; one
/// that ends early or is damaged further on opens up to there, with a warning.
///
/// One without its end is read through: `goOn` is called now and then; null when it said no.
class RecordingReader {
  public:
    static Result<std::unique_ptr<RecordingReader>> open(const std::filesystem::path& file,
                                                         const std::function<bool()>& goOn = {});
    static Result<std::unique_ptr<RecordingReader>> open(std::unique_ptr<std::istream> bytes,
                                                         const std::string& sourceName,
                                                         const std::function<bool()>& goOn = {});
    ~RecordingReader();
    RecordingReader(const RecordingReader&) = delete;
    RecordingReader& operator=(const RecordingReader&) = delete;

    const RecordingHeader& header() const;
    /// Written to its end; else there is no report.
    bool complete() const;
    /// The report as JSON text, as `roversim run --json` prints it; empty when not complete.
    const std::string& reportText() const;
    /// The same as numbers; what cannot be read of it keeps its default. Stopped when not complete.
    run::RunReport report() const;
    const std::vector<TimedCommand>& commands() const;
    /// In order of steps; the last one is the last that is known.
    const std::vector<HashMark>& marks() const;

    /// The files of the ground: those that the recording carries or, when it is of a version that
    /// carried none, their folder. A problem when one is damaged or not whole.
    Result<project::ProjectFiles> readFiles();

    std::size_t rowCount() const;
    std::size_t frameCount() const;
    /// Rows are read in the blocks they were written in.
    std::size_t rowBlockCount() const;
    Result<std::vector<std::vector<double>>> rowBlock(std::size_t block);
    Result<run::Snapshot> frame(std::size_t index);

  private:
    struct Impl;
    explicit RecordingReader(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace simcore::io
