#include <algorithm>
#include <fstream>
#include <map>

#include <fmt/format.h>

#include "simcore/base/text.h"
#include "simcore/io/recording.h"
#include "simcore/io/recording_chunks.h"
#include "simcore/io/recording_header.h"
#include "simcore/io/run_report_json.h"

namespace simcore::io {
namespace {

// Bounds of what a reader takes: months of rows, a command every 10 ms for hours.
constexpr std::size_t kMostChunks = 4'000'000;
constexpr std::size_t kMostEntries = 2'000'000;

struct Place {
    ChunkHead head;
    std::uint64_t offset = 0;  ///< of the stored bytes
    std::size_t before = 0;    ///< rows in the chunks of its kind before it
};

Problem damaged(const std::string& source, std::uint64_t offset, Severity severity) {
    return {severity, source, Text::of("it is damaged at byte {}.", offset),
            Text::of("Take another copy of the file if there is one.")};
}

/// A whole number of steps; nothing when it is none.
std::optional<long> stepFrom(double number) {
    if (!(number >= 0.0 && number < 9007199254740992.0)) {
        return std::nullopt;
    }
    return static_cast<long>(number);
}

}  // namespace

struct RecordingReader::Impl {
    std::unique_ptr<std::istream> stream;
    std::string source;
    std::function<bool()> goOn;
    bool stopped = false;
    std::uint64_t size = 0;
    ParsedHeader parsed;
    std::string report;
    bool complete = false;
    std::vector<TimedCommand> commands;
    std::vector<HashMark> marks;
    std::vector<Place> files, rows, frames;
    std::optional<project::ProjectFiles> filesRead;
    std::size_t rowCount = 0, frameCount = 0;
    std::size_t cachedBlock = static_cast<std::size_t>(-1);
    Table cached;  ///< the block of frames read last

    /// False when it is to stop; asked once in a while.
    bool mayGoOn(std::size_t count);
    bool readBytes(std::uint64_t offset, std::size_t count, std::string& bytes);
    Problems outline();
    bool take(const Place& place);
    bool takeEntries(const Place& place);
    Result<project::CarriedFiles> carried(const std::vector<ListedFile>& listed);
    Result<Table> table(const Place& place, std::size_t columns);
    std::uint64_t wholeUntil();
};

bool RecordingReader::Impl::mayGoOn(std::size_t count) {
    constexpr std::size_t kChunksPerQuestion = 256;
    stopped = stopped || (goOn && count % kChunksPerQuestion == 0 && !goOn());
    return !stopped;
}

bool RecordingReader::Impl::readBytes(std::uint64_t offset, std::size_t count, std::string& bytes) {
    if (count > size || offset > size - count) {
        return false;
    }
    bytes.resize(count);
    stream->clear();
    stream->seekg(static_cast<std::streamoff>(offset));
    stream->read(bytes.data(), static_cast<std::streamsize>(count));
    return stream->gcount() == static_cast<std::streamsize>(count);
}

bool RecordingReader::Impl::takeEntries(const Place& place) {
    std::string stored;
    if (commands.size() + marks.size() + place.head.count > kMostEntries ||
        !readBytes(place.offset, place.head.stored, stored) || !checksumHolds(place.head, stored)) {
        return false;
    }
    const auto entries = unpackTable(place.head, stored);
    if (!entries || entries->front().size() < 3) {
        return false;
    }
    for (const std::vector<double>& entry : *entries) {
        const auto step = stepFrom(entry[0]);
        if (!step) {
            return false;
        }
        if (place.head.tag == kCommandsChunk) {
            commands.push_back({*step, {entry[1], entry[2]}});
        } else if (entry[1] >= 0.0 && entry[1] < 4294967296.0 && entry[2] >= 0.0 &&
                   entry[2] < 4294967296.0) {
            marks.push_back(
                {*step, fmt::format("{:08x}{:08x}", static_cast<std::uint32_t>(entry[1]),
                                    static_cast<std::uint32_t>(entry[2]))});
        } else {
            return false;
        }
    }
    return true;
}

/// Files one chunk; false when its contents are not what they should be.
bool RecordingReader::Impl::take(const Place& place) {
    const ChunkTag& tag = place.head.tag;
    if (tag == kRowsChunk && place.head.count > 0) {
        rows.push_back(place);
        rows.back().before = rowCount;
        rowCount += place.head.count;
    } else if (tag == kFramesChunk && place.head.count > 0) {
        frames.push_back(place);
        frames.back().before = frameCount;
        frameCount += place.head.count;
    } else if (tag == kFileChunk) {
        files.push_back(place);
    } else if (tag == kCommandsChunk || tag == kMarksChunk) {
        return takeEntries(place);
    } else if (tag == kReportChunk) {
        std::string stored;
        if (!readBytes(place.offset, place.head.stored, stored) ||
            !checksumHolds(place.head, stored)) {
            return false;
        }
        const auto text = unpackText(place.head, stored);
        complete = text && !tooDeep(*text);
        report = complete ? *text : "";
        return complete;
    }
    return true;  // a kind of chunk this version does not know is passed over
}

/// Reads the heads from the beginning to the end, or to the first that is not whole.
Problems RecordingReader::Impl::outline() {
    const auto notOne = [this](std::string why) {
        return Problems{
            {Severity::Critical, source, std::move(why), Text::of("Choose a .roverrec file.")}};
    };
    std::string bytes;
    if (!readBytes(0, kRecordingMagic.size(), bytes) || bytes != kRecordingMagic) {
        return notOne(Text::of("this is not a recording."));
    }
    std::uint64_t offset = kRecordingMagic.size();
    std::string why;
    for (std::size_t chunks = 0; offset < size && !complete; ++chunks) {
        if (!mayGoOn(chunks)) {
            return {};
        }
        const auto head = readBytes(offset, kChunkHeadSize, bytes) && chunks < kMostChunks
                              ? readHead(bytes)
                              : std::nullopt;
        const Place place{head.value_or(ChunkHead{}), offset + kChunkHeadSize, 0};
        if (!head || place.head.stored > size - place.offset) {
            break;
        }
        if (chunks == 0) {
            std::string stored;
            const bool read = head->tag == kHeaderChunk &&
                              readBytes(place.offset, head->stored, stored) &&
                              checksumHolds(*head, stored);
            const auto text = read ? unpackText(*head, stored) : std::nullopt;
            if (!text) {
                return {damaged(source, offset, Severity::Critical)};
            }
            auto header = parseHeader(*text, source);
            if (!header) {
                return header.problems();
            }
            parsed = std::move(header).value();
        } else if (!take(place)) {
            break;
        }
        offset = place.offset + place.head.stored;
    }
    if (parsed.header.channels.empty()) {
        return {damaged(source, kRecordingMagic.size(), Severity::Critical)};
    }
    if (complete) {
        return {};
    }
    const std::uint64_t whole = std::min(offset, wholeUntil());
    const double end = std::max(rows.empty() ? 0.0 : rows.back().head.last,
                                frames.empty() ? 0.0 : frames.back().head.last);
    return {{Severity::Warning, source,
             Text::of("the recording was interrupted or is damaged: {} of its {} bytes can be "
                      "read, up to {:.2f} s.",
                      whole, size, end),
             Text::of("Go on with what is there, or take another copy.")}};
}

/// Without a report nobody said that all was written: every checksum is looked at, and the tables
/// end before the first that does not hold. Returns where that is.
std::uint64_t RecordingReader::Impl::wholeUntil() {
    std::uint64_t end = size;
    const auto check = [&](std::vector<Place>& places, std::size_t& count) {
        std::string stored;
        for (std::size_t i = 0; i < places.size() && mayGoOn(i); ++i) {
            if (!readBytes(places[i].offset, places[i].head.stored, stored) ||
                !checksumHolds(places[i].head, stored)) {
                end = std::min(end, places[i].offset - kChunkHeadSize);
                count = places[i].before;
                places.resize(i);
            }
        }
    };
    check(rows, rowCount);
    check(frames, frameCount);
    return end;
}

Result<Table> RecordingReader::Impl::table(const Place& place, std::size_t columns) {
    std::string stored;
    if (readBytes(place.offset, place.head.stored, stored) && checksumHolds(place.head, stored)) {
        auto rowsRead = unpackTable(place.head, stored);
        if (rowsRead && rowsRead->front().size() == columns) {
            return std::move(*rowsRead);
        }
    }
    return damaged(source, place.offset, Severity::Critical);
}

/// The listed files, each of its parts one after the other from its beginning.
Result<project::CarriedFiles> RecordingReader::Impl::carried(
    const std::vector<ListedFile>& listed) {
    project::CarriedFiles read;
    std::map<std::string, std::uint64_t> sizes;
    for (const ListedFile& file : listed) {
        sizes.emplace(file.name, file.size);
        read.emplace(file.name, std::string());
    }
    for (const Place& place : files) {
        std::string stored;
        const auto part =
            readBytes(place.offset, place.head.stored, stored) && checksumHolds(place.head, stored)
                ? unpackFilePart(place.head, stored)
                : std::nullopt;
        const auto whole = part ? sizes.find(part->name) : sizes.end();
        if (whole == sizes.end() || part->offset != read[part->name].size() ||
            part->bytes.size() > whole->second - part->offset) {
            return damaged(source, place.offset, Severity::Critical);
        }
        read[part->name] += part->bytes;
    }
    for (const auto& [name, bytes] : read) {
        if (bytes.size() != sizes[name]) {
            return Problem{Severity::Critical, source,
                           Text::of("of its file '{}' there are {} of {} bytes.", name,
                                    bytes.size(), sizes[name]),
                           Text::of("Take another copy of the recording if there is one.")};
        }
    }
    return read;
}

RecordingReader::RecordingReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

RecordingReader::~RecordingReader() = default;

Result<std::unique_ptr<RecordingReader>> RecordingReader::open(const std::filesystem::path& file,
                                                               const std::function<bool()>& goOn) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        return Problem{Severity::Critical, file.string(), Text::of("there is no such file."),
                       Text::of("Check the path.")};
    }
    return open(std::make_unique<std::ifstream>(file, std::ios::binary), file.string(), goOn);
}

Result<std::unique_ptr<RecordingReader>> RecordingReader::open(std::unique_ptr<std::istream> bytes,
                                                               const std::string& sourceName,
                                                               const std::function<bool()>& goOn) {
    auto impl = std::make_unique<Impl>();
    impl->goOn = goOn;
    impl->stream = std::move(bytes);
    impl->source = sourceName;
    impl->stream->seekg(0, std::ios::end);
    const std::streamoff size = impl->stream->tellg();
    if (!*impl->stream || size < 0) {
        return Problem{Severity::Critical, sourceName, Text::of("the file cannot be read."),
                       Text::of("Check its permissions.")};
    }
    impl->size = static_cast<std::uint64_t>(size);
    Problems problems = impl->outline();
    impl->goOn = {};
    if (impl->stopped) {
        return std::unique_ptr<RecordingReader>();
    }
    if (hasCritical(problems)) {
        return problems;
    }
    return Result<std::unique_ptr<RecordingReader>>(
        std::unique_ptr<RecordingReader>(new RecordingReader(std::move(impl))),
        std::move(problems));
}

const RecordingHeader& RecordingReader::header() const {
    return impl_->parsed.header;
}

bool RecordingReader::complete() const {
    return impl_->complete;
}

const std::string& RecordingReader::reportText() const {
    return impl_->report;
}

run::RunReport RecordingReader::report() const {
    return parseReport(impl_->report);
}

const std::vector<TimedCommand>& RecordingReader::commands() const {
    return impl_->commands;
}

const std::vector<HashMark>& RecordingReader::marks() const {
    return impl_->marks;
}

Result<project::ProjectFiles> RecordingReader::readFiles() {
    if (impl_->filesRead) {
        return *impl_->filesRead;
    }
    if (!impl_->parsed.files) {
        return project::ProjectFiles(header().request.files.folder);
    }
    auto carried = impl_->carried(*impl_->parsed.files);
    if (!carried) {
        return carried.problems();
    }
    impl_->filesRead = project::ProjectFiles(
        {}, std::make_shared<const project::CarriedFiles>(std::move(carried).value()));
    return *impl_->filesRead;
}

std::size_t RecordingReader::rowCount() const {
    return impl_->rowCount;
}

std::size_t RecordingReader::frameCount() const {
    return impl_->frameCount;
}

std::size_t RecordingReader::rowBlockCount() const {
    return impl_->rows.size();
}

Result<std::vector<std::vector<double>>> RecordingReader::rowBlock(std::size_t block) {
    return impl_->table(impl_->rows.at(block), header().channels.size());
}

Result<run::Snapshot> RecordingReader::frame(std::size_t index) {
    if (index >= impl_->frameCount) {
        throw std::out_of_range("RecordingReader::frame: there are not so many frames");
    }
    const auto after =
        std::upper_bound(impl_->frames.begin(), impl_->frames.end(), index,
                         [](std::size_t i, const Place& place) { return i < place.before; });
    const auto block = static_cast<std::size_t>(after - impl_->frames.begin()) - 1;
    if (block != impl_->cachedBlock) {
        auto table = impl_->table(impl_->frames[block], impl_->parsed.frameColumns);
        if (!table) {
            return table.problems();
        }
        impl_->cached = std::move(table).value();
        impl_->cachedBlock = block;
    }
    return snapshotFromNumbers(header().size, impl_->parsed.framePositions,
                               impl_->cached[index - impl_->frames[block].before]);
}

}  // namespace simcore::io
