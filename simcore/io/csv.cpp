#include "simcore/io/csv.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

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

}  // namespace

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

std::string formatCsvMetadata(const run::Recording& recording, const run::ResolvedRun& settings,
                              const run::RunReport& report, const RecordingOrigin& origin) {
    return formatJson(metadata(recording.channels, recording.rows.size(), settings, report.engine,
                               report.stateHash, origin, toJson(report)));
}

Result<bool> exportCsv(RecordingReader& recording, const std::string& recordingFile,
                       const std::filesystem::path& file) {
    const RecordingHeader& header = recording.header();
    const auto project = parseProject(header.projectText, recordingFile + " (its project)");
    if (!project) {
        return project.problems();
    }
    const auto settings = run::evaluateRun(*project, header.request);
    if (!settings) {
        return settings.problems();
    }
    AtomicFile table(file);
    std::string text;
    appendHeader(header.channels, text);
    table.write(text);
    for (std::size_t block = 0; block < recording.rowBlockCount(); ++block) {
        const auto rows = recording.rowBlock(block);
        if (!rows) {
            return rows.problems();
        }
        text.clear();
        appendRows(header.channels.size(), *rows, text);
        table.write(text);
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
    return writeFileAtomically(
        csvMetadataFile(file),
        formatJson(metadata(header.channels, recording.rowCount(), *settings, header.engine, hash,
                            origin, std::move(report))));
}

std::filesystem::path csvMetadataFile(const std::filesystem::path& csvFile) {
    std::filesystem::path file = csvFile;
    // A table named x.json keeps its own name: the metadata go to x.json.json.
    return file.extension() == ".json" ? file.replace_extension(".json.json")
                                       : file.replace_extension(".json");
}

Result<bool> saveCsv(const run::Recording& recording, const run::ResolvedRun& settings,
                     const run::RunReport& report, const RecordingOrigin& origin,
                     const std::filesystem::path& file) {
    Result<bool> table = writeFileAtomically(file, formatCsv(recording.channels, recording.rows));
    if (!table) {
        return table;
    }
    return writeFileAtomically(csvMetadataFile(file),
                               formatCsvMetadata(recording, settings, report, origin));
}

}  // namespace simcore::io
