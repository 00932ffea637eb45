#include "simcore/io/csv.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "simcore/base/text.h"
#include "simcore/base/version.h"
#include "simcore/io/atomic_file.h"
#include "simcore/io/json_format.h"
#include "simcore/io/project_file.h"
#include "simcore/io/run_report_json.h"
#include "simcore/project/names.h"

namespace simcore::io {
namespace {

using Json = nlohmann::ordered_json;

/// A name with a comma, a quote or a line end is quoted as RFC 4180 says.
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string out = "\"";
    for (const char c : text) {
        out += c == '"' ? "\"\"" : std::string(1, c);
    }
    return out + "\"";
}

void appendNumber(double value, std::string& out) {
    if (std::isnan(value)) {
        return;  // missing
    }
    std::array<char, 32> digits{};
    // Shortest text that reads back exactly; std::to_chars knows no locale.
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{}) {
        throw std::logic_error("formatCsv: a double did not fit");
    }
    out.append(digits.data(), end);
}

Json columnsOf(const std::vector<run::Channel>& channels) {
    Json columns = Json::array();
    for (const run::Channel& channel : channels) {
        Json column;
        column["name"] = channel.column();
        column["quantity"] = channel.quantity;
        column["object"] = channel.object;
        column["unit"] = channel.unit;
        column["meaning"] = channel.meaning;
        columns.push_back(column);
    }
    return columns;
}

Json settingsOf(const run::ResolvedRun& run) {
    Json json;
    json["controller"] = project::nameOf(run.controller);
    json["speed"] = run.speed;
    json["assumed_friction"] = run.assumedFriction;
    json["control_period"] = run.controlPeriod;
    json["friction"] = run.friction;
    json["rolling_resistance"] = run.rollingResistance;
    json["step"] = run.step;
    json["distance"] = run.distance;
    json["duration"] = run.duration;
    json["settle"] = run.settle;
    json["ramp"] = run.ramp;
    json["joints"] = run.joints == mechanism::Model::Built ? "built" : "relaxed";
    return json;
}

void appendHeader(const std::vector<run::Channel>& channels, std::string& out) {
    for (std::size_t i = 0; i < channels.size(); ++i) {
        out += i == 0 ? "" : ",";
        out += quoted(channels[i].column());
    }
    out += '\n';
}

void appendRows(std::size_t columns, const std::vector<std::vector<double>>& rows,
                std::string& out) {
    for (const std::vector<double>& row : rows) {
        if (row.size() != columns) {
            throw std::invalid_argument("formatCsv: a row is not as long as the list of channels");
        }
        for (std::size_t i = 0; i < row.size(); ++i) {
            out += i == 0 ? "" : ",";
            appendNumber(row[i], out);
        }
        out += '\n';
    }
}

Json metadata(const std::vector<run::Channel>& channels, std::size_t rows,
              const run::ResolvedRun& settings, const std::string& engine,
              const std::string& stateHash, const RecordingOrigin& origin, Json report) {
    Json json;
    json["schema"] = "roverstudio.recording-table/1";
    json["program_version"] = programVersion();
    json["project"] = origin.projectName;
    json["project_file"] = origin.projectFile;
    json["variant"] = origin.variant;
    json["scenario"] = settings.scenario;
    json["parameters"] = Json::object();
    for (const auto& [name, value] : origin.parameters) {
        json["parameters"][name] = value;
    }
    json["overrides"] = Json::object();
    for (const project::Assignment& assignment : origin.assignments) {
        json["overrides"][assignment.parameter] = assignment.value;
    }
    json["engine"] = engine;
    json["step"] = settings.step;
    json["seed"] = settings.seed;
    json["state_hash"] = stateHash;
    json["settings"] = settingsOf(settings);
    json["report"] = std::move(report);
    json["rows"] = rows;
    json["columns"] = columnsOf(channels);
    return json;
}

/// Rows of a recorded table that lie in the times of a cut, with the columns chosen.
class Cutter {
  public:
    Cutter(const TableCut& cut, std::vector<std::size_t> columns)
        : columns_(std::move(columns)),
          from_(cut.from.value_or(-kForever) - kTolerance),
          to_(cut.to.value_or(kForever) + kTolerance) {}

    std::vector<std::vector<double>> take(const std::vector<std::vector<double>>& rows) {
        std::vector<std::vector<double>> taken;
        for (const std::vector<double>& row : rows) {
            if (row.empty() || row.front() < from_ || row.front() > to_) {
                continue;
            }
            auto& next = taken.emplace_back();
            next.reserve(columns_.size());
            for (const std::size_t column : columns_) {
                next.push_back(row.at(column));
            }
        }
        count_ += taken.size();
        return taken;
    }

    std::size_t count() const { return count_; }

    std::vector<run::Channel> channels(const std::vector<run::Channel>& all) const {
        std::vector<run::Channel> chosen;
        for (const std::size_t column : columns_) {
            chosen.push_back(all[column]);
        }
        return chosen;
    }

  private:
    static constexpr double kForever = std::numeric_limits<double>::infinity();
    /// Times are multiples of a step, with round-off [s].
    static constexpr double kTolerance = 1e-9;

    std::vector<std::size_t> columns_;
    double from_, to_;
    std::size_t count_ = 0;
};

Problem noRows(const std::filesystem::path& file) {
    return {Severity::Critical, file.string(), Text::of("no recorded instant lies in these times."),
            Text::of("Choose times between the start and the end of the run.")};
}

/// What the metadata say of a cut; nothing when it leaves all times.
void tellCut(const TableCut& cut, Json& json) {
    if (cut.from || cut.to) {
        json["from"] = cut.from ? Json(*cut.from) : Json(nullptr);
        json["to"] = cut.to ? Json(*cut.to) : Json(nullptr);
    }
}

}  // namespace

Result<std::vector<std::size_t>> chosenChannels(const std::vector<run::Channel>& channels,
                                                const std::vector<std::string>& names) {
    std::vector<bool> chosen(channels.size(), names.empty());
    Problems problems;
    for (const std::string& name : names) {
        bool found = false;
        for (std::size_t i = 0; i < channels.size(); ++i) {
            const run::Channel& channel = channels[i];
            if (name == channel.id() || name == channel.quantity || name == channel.column()) {
                chosen[i] = true;
                found = true;
            }
        }
        if (!found) {
            problems.push_back({Severity::Critical, Text::of("channel {}", name),
                                Text::of("the run has no channel of this name."),
                                Text::of("roversim channels FILE lists those of a rover.")});
        }
    }
    if (!problems.empty()) {
        return problems;
    }
    std::vector<std::size_t> positions;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (chosen[i] || i == 0) {
            positions.push_back(i);
        }
    }
    return positions;
}

RecordingOrigin originOf(const project::Project& project, const run::RunRequest& request,
                         const std::string& projectFile) {
    RecordingOrigin origin;
    origin.projectName = project.rover.name;
    origin.projectFile = projectFile;
    origin.assignments = request.assignments;
    for (const project::Scenario& scenario : project.scenarios) {
        if (scenario.name == request.scenario) {
            origin.variant = scenario.variant;
        }
    }
    const auto values = project::evaluateParameters(project, origin.variant, request.assignments);
    if (values) {
        origin.parameters = *values;
    }
    return origin;
}

std::string formatCsv(const std::vector<run::Channel>& channels,
                      const std::vector<std::vector<double>>& rows) {
    std::string out;
    out.reserve(64 * channels.size() + 12 * channels.size() * rows.size());
    appendHeader(channels, out);
    appendRows(channels.size(), rows, out);
    return out;
}

Result<bool> exportCsv(RecordingReader& recording, const std::string& recordingFile,
                       const std::filesystem::path& file, const TableCut& cut) {
    const RecordingHeader& header = recording.header();
    const auto project =
        parseProject(header.projectText, Text::of("{} (its project)", recordingFile));
    if (!project) {
        return project.problems();
    }
    const auto settings = run::evaluateRun(*project, header.request);
    if (!settings) {
        return settings.problems();
    }
    const auto columns = chosenChannels(header.channels, cut.channels);
    if (!columns) {
        return columns.problems();
    }
    Cutter cutter(cut, *columns);
    const std::vector<run::Channel> channels = cutter.channels(header.channels);
    AtomicFile table(file);
    std::string text;
    appendHeader(channels, text);
    table.write(text);
    for (std::size_t block = 0; block < recording.rowBlockCount(); ++block) {
        const auto rows = recording.rowBlock(block);
        if (!rows) {
            return rows.problems();
        }
        text.clear();
        appendRows(channels.size(), cutter.take(*rows), text);
        table.write(text);
    }
    if (cutter.count() == 0 && (cut.from || cut.to)) {
        return noRows(file);
    }
    if (auto written = table.commit(); !written) {
        return written;
    }
    const RecordingOrigin origin{project->rover.name, header.projectFile, header.variant,
                                 header.parameters, header.request.assignments};
    // The report is text of a file: what cannot be read of it is left out.
    Json report = Json::parse(recording.reportText(), nullptr, false);
    if (report.is_discarded()) {
        report = nullptr;
    }
    const std::string hash =
        recording.marks().empty() ? std::string() : recording.marks().back().stateHash;
    Json json = metadata(channels, cutter.count(), *settings, header.engine, hash, origin,
                         std::move(report));
    tellCut(cut, json);
    return writeFileAtomically(csvMetadataFile(file), formatJson(json));
}

std::filesystem::path csvMetadataFile(const std::filesystem::path& csvFile) {
    std::filesystem::path file = csvFile;
    // A table named x.json keeps its own name: the metadata go to x.json.json.
    return file.extension() == ".json" ? file.replace_extension(".json.json")
                                       : file.replace_extension(".json");
}

Result<bool> saveCsv(const run::Recording& recording, const run::ResolvedRun& settings,
                     const run::RunReport& report, const RecordingOrigin& origin,
                     const std::filesystem::path& file, const TableCut& cut) {
    const auto columns = chosenChannels(recording.channels, cut.channels);
    if (!columns) {
        return columns.problems();
    }
    Cutter cutter(cut, *columns);
    const std::vector<run::Channel> channels = cutter.channels(recording.channels);
    const auto rows = cutter.take(recording.rows);
    if (rows.empty() && (cut.from || cut.to)) {
        return noRows(file);
    }
    Result<bool> table = writeFileAtomically(file, formatCsv(channels, rows));
    if (!table) {
        return table;
    }
    Json json = metadata(channels, rows.size(), settings, report.engine, report.stateHash, origin,
                         toJson(report));
    tellCut(cut, json);
    return writeFileAtomically(csvMetadataFile(file), formatJson(json));
}

}  // namespace simcore::io
