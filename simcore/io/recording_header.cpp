#include "simcore/io/recording_header.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "simcore/base/text.h"
#include "simcore/base/version.h"
#include "simcore/io/csv.h"
#include "simcore/io/project_file.h"
#include "simcore/io/recording_chunks.h"
#include "simcore/io/terrain_file.h"
#include "simcore/project/names.h"

namespace simcore::io {
namespace {

using Json = nlohmann::ordered_json;
// Sorted keys: looking one up among very many must not be slow.
using ReadJson = nlohmann::json;

constexpr const char* kSchema = "roverstudio-recording-1";
// Bounds of what a reader takes; far beyond any rover.
constexpr int kDeepest = 32;
constexpr std::size_t kMostFiles = 1000;
constexpr std::size_t kLongestName = 4096;

template <class T>
void putOptional(Json& json, const char* key, const std::optional<T>& value) {
    if (value) {
        json[key] = *value;
    }
}

template <class T>
std::optional<T> getOptional(const ReadJson& json, const char* key) {
    return json.contains(key) ? std::optional<T>(json.at(key).get<T>()) : std::nullopt;
}

Json toJson(const run::RunRequest& request) {
    Json json;
    json["scenario"] = request.scenario;
    if (!request.files.folder.empty()) {
        json["folder"] = std::filesystem::absolute(request.files.folder).string();
    }
    if (request.engine) {
        json["engine"] = project::nameOf(*request.engine);
    }
    if (request.controller) {
        json["controller"] = project::nameOf(*request.controller);
    }
    putOptional(json, "friction", request.friction);
    putOptional(json, "duration", request.duration);
    putOptional(json, "distance", request.distance);
    putOptional(json, "terrain_height", request.terrainHeight);
    putOptional(json, "relaxed_joints", request.relaxedJoints);
    putOptional(json, "step", request.step);
    putOptional(json, "seed", request.seed);
    json["set"] = Json::array();
    for (const project::Assignment& assignment : request.assignments) {
        json["set"].push_back({assignment.parameter, assignment.value});
    }
    return json;
}

run::RunRequest requestFrom(const ReadJson& json) {
    run::RunRequest request;
    request.scenario = json.at("scenario").get<std::string>();
    request.files.folder = json.value("folder", std::string());
    if (json.contains("engine")) {
        const auto name = json.at("engine").get<std::string>();
        request.engine = project::fromName<project::EngineKind>(name);
        if (!request.engine) {
            throw std::runtime_error("engine '" + name + "' is not known");
        }
    }
    if (json.contains("controller")) {
        const auto name = json.at("controller").get<std::string>();
        request.controller = project::fromName<project::ControllerKind>(name);
        if (!request.controller) {
            throw std::runtime_error("controller '" + name + "' is not known");
        }
    }
    request.friction = getOptional<double>(json, "friction");
    request.duration = getOptional<double>(json, "duration");
    request.distance = getOptional<double>(json, "distance");
    request.terrainHeight = getOptional<double>(json, "terrain_height");
    request.relaxedJoints = getOptional<bool>(json, "relaxed_joints");
    request.step = getOptional<double>(json, "step");
    request.seed = getOptional<int>(json, "seed");
    for (const ReadJson& pair : json.at("set")) {
        request.assignments.push_back(
            {pair.at(0).get<std::string>(), pair.at(1).get<std::string>()});
    }
    return request;
}

Json toJson(const run::Channel& channel) {
    Json json;
    json["quantity"] = channel.quantity;
    json["object"] = channel.object;
    json["label"] = channel.label;
    json["symbol"] = channel.symbol;
    json["unit"] = channel.unit;
    json["group"] = run::toString(channel.group);
    json["source"] = run::toString(channel.source);
    json["meaning"] = channel.meaning;
    return json;
}

template <class Enum>
Enum enumFrom(const std::string& name, std::initializer_list<Enum> all) {
    for (const Enum one : all) {
        if (run::toString(one) == name) {
            return one;
        }
    }
    throw std::runtime_error("'" + name + "' is not known");
}

run::Channel channelFrom(const ReadJson& json) {
    using run::ChannelGroup;
    using run::ChannelSource;
    run::Channel channel;
    channel.quantity = json.at("quantity").get<std::string>();
    channel.object = json.at("object").get<std::string>();
    channel.label = json.at("label").get<std::string>();
    channel.symbol = json.at("symbol").get<std::string>();
    channel.unit = json.at("unit").get<std::string>();
    channel.meaning = json.at("meaning").get<std::string>();
    channel.group = enumFrom(
        json.at("group").get<std::string>(),
        {ChannelGroup::Time, ChannelGroup::Chassis, ChannelGroup::Wheel, ChannelGroup::Joint});
    channel.source =
        enumFrom(json.at("source").get<std::string>(),
                 {ChannelSource::Known, ChannelSource::Measured, ChannelSource::Oracle});
    return channel;
}

std::size_t partsFrom(const ReadJson& json, const char* key) {
    const auto parts = json.at(key).get<std::size_t>();
    if (parts > kMostParts) {
        throw std::runtime_error(fmt::format("{} {} are too many", parts, key));
    }
    return parts;
}

std::vector<ListedFile> filesFrom(const ReadJson& json) {
    std::vector<ListedFile> files;
    std::uint64_t total = 0;
    for (const ReadJson& file : json) {
        if (!file.at("bytes").is_number_unsigned()) {
            throw std::runtime_error("the size of a file is not a number of bytes");
        }
        files.push_back(
            {file.at("name").get<std::string>(), file.at("bytes").get<std::uint64_t>()});
        const ListedFile& last = files.back();
        if (files.size() > kMostFiles || last.name.size() > kLongestName ||
            last.size > kLargestTerrainFile || (total += last.size) > kMostCarried) {
            throw std::runtime_error("its files are too many or too large");
        }
    }
    return files;
}

ParsedHeader fromJson(const ReadJson& json) {
    if (json.at("schema") != kSchema) {
        throw std::runtime_error(
            fmt::format("schema {} is not one this program reads", json.at("schema").dump()));
    }
    ParsedHeader parsed;
    RecordingHeader& header = parsed.header;
    header.programVersion = json.at("program_version").get<std::string>();
    header.projectFile = json.at("project_file").get<std::string>();
    header.projectText = json.at("project").get<std::string>();
    header.request = requestFrom(json.at("request"));
    header.variant = json.at("variant").get<std::string>();
    header.engine = json.at("engine").get<std::string>();
    header.seed = json.at("seed").get<int>();
    if (json.contains("files")) {
        parsed.files = filesFrom(json.at("files"));
    }
    for (const auto& [name, value] : json.at("parameters").items()) {
        header.parameters[name] = value.get<double>();
    }
    for (const ReadJson& channel : json.at("channels")) {
        header.channels.push_back(channelFrom(channel));
    }
    if (header.channels.empty() || header.channels.front().quantity != "time") {
        throw std::runtime_error("the first channel is not the time");
    }
    header.size = {partsFrom(json, "bodies"), partsFrom(json, "wheels"), partsFrom(json, "joints")};
    std::map<std::string, int> positions;
    for (const ReadJson& name : json.at("frame_columns")) {
        positions.emplace(name.get<std::string>(), static_cast<int>(parsed.frameColumns++));
    }
    for (const std::string& name : snapshotColumns(header.size)) {
        const auto found = positions.find(name);
        parsed.framePositions.push_back(found == positions.end() ? -1 : found->second);
    }
    return parsed;
}

}  // namespace

bool tooDeep(const std::string& text) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && c == '\\') {
            ++i;
        } else if (c == '"') {
            quoted = !quoted;
        } else if (!quoted && (c == '[' || c == '{') && ++depth > kDeepest) {
            return true;
        } else if (!quoted && (c == ']' || c == '}')) {
            --depth;
        }
    }
    return false;
}

Problems carryFiles(const project::Project& project, run::RunRequest& request) {
    const auto scenario = run::findScenario(project, request.scenario);
    if (!scenario) {
        return scenario.problems();
    }
    auto carried = carryTerrainFiles((*scenario)->terrain, request.files);
    if (carried) {
        request.files.carried = *carried;
    }
    return carried.problems();
}

RecordingHeader recordingHeader(const project::Project& project, const run::RunRequest& request,
                                const run::ResolvedRun& run, const std::string& engine,
                                const std::string& projectFile) {
    RecordingHeader header;
    header.programVersion = programVersion();
    header.projectFile = projectFile;
    header.projectText = formatProject(project);
    header.request = request;
    header.engine = engine;
    header.seed = run.seed;
    const RecordingOrigin origin = originOf(project, request, projectFile);
    header.variant = origin.variant;
    header.parameters = origin.parameters;
    header.channels = run::makeChannels(run.mechanism);
    header.size = {run.mechanism.bodies.size(), run.mechanism.wheels.size(),
                   run.mechanism.encoderJoints().size()};
    return header;
}

std::string formatHeader(const RecordingHeader& header) {
    Json json;
    json["schema"] = kSchema;
    json["program_version"] = header.programVersion;
    json["project_file"] = header.projectFile;
    json["project"] = header.projectText;
    json["request"] = toJson(header.request);
    json["variant"] = header.variant;
    json["engine"] = header.engine;
    json["seed"] = header.seed;
    if (header.request.files.carried) {
        json["files"] = Json::array();
        for (const auto& [name, bytes] : *header.request.files.carried) {
            json["files"].push_back({{"name", name}, {"bytes", bytes.size()}});
        }
    }
    json["parameters"] = Json::object();
    for (const auto& [name, value] : header.parameters) {
        json["parameters"][name] = value;
    }
    json["channels"] = Json::array();
    for (const run::Channel& channel : header.channels) {
        json["channels"].push_back(toJson(channel));
    }
    json["bodies"] = header.size.bodies;
    json["wheels"] = header.size.wheels;
    json["joints"] = header.size.joints;
    json["frame_columns"] = snapshotColumns(header.size);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<bool> writeBeginning(const RecordingHeader& header,
                            const std::function<bool(std::string_view)>& write) {
    const auto tooMuch = [](std::string what) {
        return Problem{Severity::Critical, Text::of("recording"), std::move(what),
                       Text::of("Simplify the project, or run without recording.")};
    };
    if (std::max({header.size.bodies, header.size.wheels, header.size.joints}) > kMostParts) {
        return tooMuch(Text::of("the rover has more parts than a recording can have."));
    }
    if (const auto& carried = header.request.files.carried) {
        std::uint64_t total = 0;
        for (const auto& [name, bytes] : *carried) {
            total += bytes.size();
            if (name.size() > kLongestName || bytes.size() > kLargestTerrainFile) {
                return tooMuch(
                    Text::of("a file of the ground is larger or has a longer name than a recording "
                             "can have."));
            }
        }
        if (carried->size() > kMostFiles || total > kMostCarried) {
            return tooMuch(
                Text::of("the files of the ground are more or larger than a recording can have."));
        }
    }
    const std::string text = formatHeader(header);
    if (text.size() > kLargestText) {
        return tooMuch(Text::of("the project's text is longer than a recording can have."));
    }
    return write(kRecordingMagic) && write(packText(kHeaderChunk, text)) &&
           writeFileParts(header.request.files, write);
}

Result<ParsedHeader> parseHeader(const std::string& text, const std::string& source) {
    const auto bad = [&source](const std::string& why) {
        return Problem{Severity::Critical, source, Text::of("its header cannot be read ({}).", why),
                       Text::of("Open it with the RoverStudio version that wrote it.")};
    };
    if (tooDeep(text)) {
        return bad(Text::of("nested too deeply"));
    }
    try {
        return fromJson(ReadJson::parse(text));
    } catch (const std::exception& error) {
        return bad(error.what());
    }
}

}  // namespace simcore::io
