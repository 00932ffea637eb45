#include "simcore/io/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <bit>
#include <clocale>
#include <csignal>
#include <fstream>
#include <iterator>
#include <locale>
#include <sstream>

#include "simcore/base/random.h"
#include "simcore/io/recording_chunks.h"
#include "simcore/io/recording_header.h"
#include "simcore/run/sampler.h"
#include "tests/support/fake_run.h"

namespace simcore::io {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string bytesOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

Result<std::unique_ptr<RecordingReader>> openBytes(const std::string& bytes) {
    return RecordingReader::open(std::make_unique<std::istringstream>(bytes), "test");
}

/// Equal to the last bit, so that NaN equals NaN.
bool same(const std::vector<double>& a, const std::vector<double>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
        return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    });
}

class RecordingTest : public ::testing::Test {
  protected:
    RecordingTest()
        : folder(fs::path(::testing::TempDir()) /
                 (std::string("rover_rec_") +
                  ::testing::UnitTest::GetInstance()->current_test_info()->name())),
          file(folder / "run.roverrec") {
        fs::remove_all(folder);
        fs::create_directories(folder);
        header.programVersion = "0.0.1";
        header.projectText = "{\"any\": \"text, ü\"}";
        header.projectFile = "my rover.rover";
        header.request.scenario = "bump";
        header.request.engine = project::EngineKind::Reduced;
        header.request.controller = project::ControllerKind::Manual;
        header.request.friction = 0.1 + 0.2;
        header.request.seed = -3;
        header.request.files.folder = "/rovers/mine";
        header.request.distance = 1.7;
        header.request.terrainHeight = 0.08;
        header.request.step = 0.001;
        header.request.relaxedJoints = true;
        header.request.assignments = {{"wheel_radius", "7 cm"}};
        header.engine = "fake";
        header.parameters = {{"wheel_radius", 0.07}};
        header.channels = run::makeChannels(settings.mechanism);
        header.size = {1, 6, 0};
    }

    ~RecordingTest() override { fs::remove_all(folder); }

    /// Drives the fake rover, recording as the command line does.
    void drive(RecordingWriter& writer) {
        const auto stepper = test_support::fakeStepper()(settings);
        run::Sampler sampler(settings.mechanism);
        sampler.start(stepper->snapshot());
        std::vector<std::vector<double>> newRows;
        std::vector<std::shared_ptr<const run::Snapshot>> newFrames;
        const auto pass = [&] {
            sampler.moveTo(newRows, newFrames);
            writer.add(newRows, newFrames);
            if (writer.wantsMark()) {
                marks.push_back({stepper->snapshot().step, stepper->report().stateHash});
                writer.add(marks.back());
            }
            std::move(newRows.begin(), newRows.end(), std::back_inserter(rows));
            std::move(newFrames.begin(), newFrames.end(), std::back_inserter(frames));
            newRows.clear();
            newFrames.clear();
        };
        while (!stepper->finished()) {
            if (stepper->snapshot().step % 1000 == 10) {
                commands.push_back({stepper->snapshot().step, {0.05, -0.1}});
                stepper->setManualCommand(commands.back().command);
                writer.add(commands.back());
            }
            stepper->step();
            sampler.take(stepper->snapshot());
            pass();
        }
        sampler.finish(stepper->snapshot());
        pass();
        marks.push_back({stepper->snapshot().step, stepper->report().stateHash});
        writer.add(marks.back());
        report = stepper->report();
    }

    std::string recorded() {
        auto writer = RecordingWriter::create(file, header);
        EXPECT_TRUE(writer) << toString(writer.problems());
        drive(**writer);
        EXPECT_TRUE((*writer)->finish(report));
        return bytesOf(file);
    }

    /// Every row and frame that can be read is one that was written, in its place.
    void expectPrefix(RecordingReader& reader) {
        std::size_t at = 0;
        for (std::size_t block = 0; block < reader.rowBlockCount(); ++block) {
            const auto read = reader.rowBlock(block);
            if (!read) {
                return;  // damage was noticed
            }
            for (const std::vector<double>& row : *read) {
                ASSERT_LT(at, rows.size());
                ASSERT_TRUE(same(row, rows[at++]));
            }
        }
        for (std::size_t i = 0; i < reader.frameCount(); i += 50) {
            const auto frame = reader.frame(i);
            ASSERT_TRUE(!frame || same(toNumbers(*frame), toNumbers(*frames.at(i))));
        }
    }

    fs::path folder;
    fs::path file;
    run::ResolvedRun settings = test_support::fakeRun(8.0);
    RecordingHeader header;
    std::vector<std::vector<double>> rows;
    std::vector<std::shared_ptr<const run::Snapshot>> frames;
    std::vector<TimedCommand> commands;
    std::vector<HashMark> marks;
    run::RunReport report;
};

TEST_F(RecordingTest, EverythingComesBackAsItWas) {
    const std::string bytes = recorded();
    auto opened = RecordingReader::open(file);
    ASSERT_TRUE(opened) << toString(opened.problems());
    EXPECT_TRUE(opened.problems().empty());
    RecordingReader& reader = **opened;
    EXPECT_TRUE(reader.complete());
    EXPECT_THAT(reader.reportText(), HasSubstr(report.stateHash));
    const RecordingHeader& read = reader.header();
    EXPECT_EQ(read.programVersion, header.programVersion);
    EXPECT_EQ(read.projectText, header.projectText);
    EXPECT_EQ(read.request, header.request);
    EXPECT_EQ(read.parameters, header.parameters);
    ASSERT_EQ(read.channels.size(), header.channels.size());
    EXPECT_EQ(read.channels.back().column(), header.channels.back().column());
    EXPECT_EQ(read.channels.back().source, header.channels.back().source);
    EXPECT_EQ(reader.rowCount(), rows.size());
    EXPECT_EQ(reader.frameCount(), frames.size());
    expectPrefix(reader);
    ASSERT_EQ(reader.commands().size(), commands.size());
    EXPECT_EQ(reader.commands()[1].step, commands[1].step);
    EXPECT_EQ(reader.commands()[1].command.turn, -0.1);
    ASSERT_EQ(reader.marks().size(), marks.size());
    EXPECT_EQ(reader.marks().back().stateHash, marks.back().stateHash);
    EXPECT_EQ(reader.marks().front().step, marks.front().step);
    EXPECT_FALSE(fs::exists(file.string() + ".part"));
}

TEST_F(RecordingTest, FramesAreReadInAnyOrder) {
    recorded();
    auto reader = RecordingReader::open(file);
    ASSERT_TRUE(reader);
    for (const std::size_t i : {frames.size() - 1, std::size_t{0}, std::size_t{128},
                                std::size_t{127}, std::size_t{300}}) {
        const auto frame = (*reader)->frame(i);
        ASSERT_TRUE(frame);
        EXPECT_TRUE(same(toNumbers(*frame), toNumbers(*frames[i]))) << i;
    }
    EXPECT_THROW((void)(*reader)->frame(frames.size()), std::out_of_range);
}

// A run that is killed leaves a file that ends anywhere: it opens up to there, and says so.
TEST_F(RecordingTest, AFileThatEndsAnywhereOpensUpToThere) {
    const std::string bytes = recorded();
    std::size_t opened = 0;
    std::size_t most = 0;
    for (std::size_t end = 0; end < bytes.size(); end += 1 + bytes.size() / 150) {
        auto reader = openBytes(bytes.substr(0, end));
        ASSERT_FALSE(reader.problems().empty()) << end;
        if (reader) {
            ++opened;
            EXPECT_FALSE((*reader)->complete());
            EXPECT_THAT(toString(reader.problems()), HasSubstr("interrupted"));
            expectPrefix(**reader);
            EXPECT_GE((*reader)->rowCount(), most);
            most = (*reader)->rowCount();
        }
    }
    EXPECT_GT(opened, 100U);
    EXPECT_GT(most, rows.size() / 2);
}

/// A header whose ground is made from these files.
RecordingHeader withFiles(RecordingHeader header, project::CarriedFiles files) {
    header.request.files.carried = std::make_shared<const project::CarriedFiles>(std::move(files));
    return header;
}

TEST_F(RecordingTest, OpeningMayBeStopped) {
    const std::string bytes = recorded();
    int asked = 0;
    for (int most = 0; most < 4; ++most) {
        asked = 0;
        const auto reader = RecordingReader::open(
            std::make_unique<std::istringstream>(bytes.substr(0, bytes.size() - 1)), "test",
            [&] { return asked++ < most; });
        ASSERT_TRUE(reader);
        // Asked for the outline, and for rows and frames as there is no report.
        EXPECT_EQ(*reader == nullptr, most < 3) << most;
    }
    EXPECT_EQ(asked, 3);
}

// Nothing is written that no reader takes.
TEST_F(RecordingTest, ARecordingThatIsTooLargeIsNotBegun) {
    std::vector<RecordingHeader> tooLarge{withFiles(header, {{std::string(5000, 'a'), "ncols 2"}}),
                                          header, header, header};
    project::CarriedFiles many;
    for (int i = 0; i < 1001; ++i) {
        many.emplace(std::to_string(i), "");
    }
    tooLarge[1] = withFiles(header, many);
    tooLarge[2].size.bodies = kMostParts + 1;
    tooLarge[3].projectText = std::string(kLargestText, ' ');
    for (const RecordingHeader& one : tooLarge) {
        const auto writer = RecordingWriter::create(file, one);
        ASSERT_FALSE(writer);
        EXPECT_THAT(toString(writer.problems()), HasSubstr("than a recording can have"));
    }
    EXPECT_TRUE(fs::is_empty(folder));
}

// Whatever is damaged, no wrong number is read.
TEST_F(RecordingTest, DamageIsNoticed) {
    const std::string bytes = recorded();
    Random random(3);
    for (int i = 0; i < 150; ++i) {
        std::string damaged = bytes;
        const auto at = static_cast<std::size_t>(
            random.uniform(0.0, static_cast<double>(i % 3 == 0 ? 3000 : bytes.size())));
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << (i % 8)));
        auto reader = openBytes(damaged);
        if (reader) {
            expectPrefix(**reader);
        }
    }
}

TEST_F(RecordingTest, WhatIsNoRecordingIsRefused) {
    for (const std::string& bytes :
         {std::string(), std::string("ROVERREC"), std::string(kRecordingMagic),
          std::string(5000, '\0'), std::string(kRecordingMagic) + std::string(500, '\xff'),
          std::string(kRecordingMagic) + packText(kHeaderChunk, "{}"),
          std::string(kRecordingMagic) + packText(kHeaderChunk, std::string(100000, '[')),
          std::string(kRecordingMagic) + packText(kRowsChunk, "{}")}) {
        const auto reader = openBytes(bytes);
        ASSERT_FALSE(reader);
        EXPECT_FALSE(reader.problems().front().remedy.empty());
    }
    EXPECT_FALSE(RecordingReader::open(folder));
    EXPECT_FALSE(RecordingReader::open(folder / "missing.roverrec"));
}

// Writing it out again would take the stack.
TEST_F(RecordingTest, AReportThatIsNestedTooDeeplyIsNone) {
    const std::string begin =
        std::string(kRecordingMagic) + packText(kHeaderChunk, formatHeader(header));
    for (const std::string& text : {std::string(1000000, '['), "{\"dt\":" + std::string(33, '{')}) {
        const auto reader = openBytes(begin + packText(kReportChunk, text));
        ASSERT_TRUE(reader) << toString(reader.problems());
        EXPECT_FALSE((*reader)->complete());
        EXPECT_TRUE((*reader)->reportText().empty());
    }
    std::string wheels = "{\"wheels\":[";
    for (int i = 0; i < 20000; ++i) {
        wheels += "{},";
    }
    wheels += "{}]}";
    const auto reader = openBytes(begin + packText(kReportChunk, wheels));
    ASSERT_TRUE(reader);
    EXPECT_EQ((*reader)->report().wheels.size(), kMostParts);
}

TEST_F(RecordingTest, AChunkOfAKindToComeIsPassedOver) {
    std::string bytes = recorded();
    const auto head = readHead(std::string_view(bytes).substr(16, kChunkHeadSize));
    ASSERT_TRUE(head);
    bytes.insert(16 + kChunkHeadSize + head->stored, packTable({'N', 'E', 'W', '!'}, {{1.0, 2.0}}));
    auto reader = openBytes(bytes);
    ASSERT_TRUE(reader);
    EXPECT_TRUE((*reader)->complete());
    EXPECT_EQ((*reader)->rowCount(), rows.size());
}

TEST_F(RecordingTest, FilesOfTheGroundComeBackByTheirNames) {
    Random random(5);
    std::string large(2 * kFilePart + 12345, '\0');
    for (char& c : large) {
        c = static_cast<char>(random.next());
    }
    const project::CarriedFiles files{
        {"../grounds/large.png", large}, {"/absolute.asc", "ncols 2\n"}, {"empty.obj", ""}};
    header = withFiles(header, files);
    recorded();
    auto reader = RecordingReader::open(file);
    ASSERT_TRUE(reader) << toString(reader.problems());
    const auto read = (*reader)->readFiles();
    ASSERT_TRUE(read) << toString(read.problems());
    ASSERT_TRUE(read->carried);
    EXPECT_TRUE(*read->carried == files);
    // Their folder is not asked: it is another machine's.
    EXPECT_TRUE(read->folder.empty());
    EXPECT_EQ((*reader)->rowCount(), rows.size());
}

// Recordings of versions that carried no files: the folder is all there is.
TEST_F(RecordingTest, WithoutAListOfFilesTheFolderIsAsked) {
    recorded();
    auto reader = RecordingReader::open(file);
    ASSERT_TRUE(reader);
    const auto read = (*reader)->readFiles();
    ASSERT_TRUE(read);
    EXPECT_FALSE(read->carried);
    EXPECT_EQ(read->folder, "/rovers/mine");
}

// Whatever of a carried file is lost or changed, it is not read as ground.
TEST_F(RecordingTest, DamagedFilesAreNoticed) {
    const RecordingHeader carrying =
        withFiles(header, {{"a.asc", "ncols 2"}, {"b.asc", "nrows 2"}});
    const std::string begin =
        std::string(kRecordingMagic) + packText(kHeaderChunk, formatHeader(carrying));
    const std::string a = packFilePart("a.asc", 0, "ncols 2");
    const std::string b = packFilePart("b.asc", 0, "nrows 2");
    const auto read = [&](const std::string& chunks) {
        auto reader = openBytes(begin + chunks);
        EXPECT_TRUE(reader) << toString(reader.problems());
        return (*reader)->readFiles();
    };
    ASSERT_TRUE(read(a + b));
    ASSERT_TRUE(read(packFilePart("a.asc", 0, "nco") + b + packFilePart("a.asc", 3, "ls 2")));
    EXPECT_THAT(toString(read(a).problems()), HasSubstr("'b.asc' there are 0 of 7 bytes"));
    std::string flipped = a;
    flipped.back() = static_cast<char>(flipped.back() ^ 1);
    EXPECT_THAT(toString(read(flipped + b).problems()), HasSubstr("damaged at byte"));
    for (const std::string& wrong :
         {packFilePart("a.asc", 1, "cols 2"), packFilePart("a.asc", 0, "ncols 22"),
          packFilePart("c.asc", 0, "other"), a + a, packText(kFileChunk, "short"),
          packText(kFileChunk, std::string("\xff\xff\xff\x7f") + "and no name as long")}) {
        const auto files = read(wrong + b);
        EXPECT_FALSE(files);
        EXPECT_FALSE(toString(files.problems()).empty());
    }
}

TEST_F(RecordingTest, AListOfTooLargeFilesIsRefused) {
    const std::string text = formatHeader(withFiles(header, {{"a.asc", "ncols 2"}}));
    for (const char* bytes : {"\"bytes\":300000000", "\"bytes\":-1", "\"bytes\":1e99"}) {
        std::string changed = text;
        const std::string was = "\"bytes\":7";
        changed.replace(changed.find(was), was.size(), bytes);
        EXPECT_FALSE(openBytes(std::string(kRecordingMagic) + packText(kHeaderChunk, changed)))
            << bytes;
    }
}

TEST_F(RecordingTest, AnUnfinishedRecordingIsNotOverwritten) {
    std::ofstream(file.string() + ".part") << "precious";
    const auto writer = RecordingWriter::create(file, header);
    ASSERT_FALSE(writer);
    EXPECT_THAT(toString(writer.problems()), HasSubstr("unfinished"));
    EXPECT_EQ(bytesOf(file.string() + ".part"), "precious");
    EXPECT_FALSE(RecordingWriter::create(folder / "missing" / "run.roverrec", header));
}

// Until the new one is whole, the old recording stays.
TEST_F(RecordingTest, TheOldFileStaysUntilTheNewOneIsWhole) {
    std::ofstream(file) << "old";
    {
        auto writer = RecordingWriter::create(file, header);
        ASSERT_TRUE(writer);
        drive(**writer);
        EXPECT_EQ(bytesOf(file), "old");
    }  // the program ends here
    EXPECT_EQ(bytesOf(file), "old");
    auto reader = RecordingReader::open(file.string() + ".part");
    ASSERT_TRUE(reader);
    EXPECT_FALSE((*reader)->complete());
    EXPECT_GT((*reader)->rowCount(), rows.size() / 2);
    expectPrefix(**reader);
}

// A full disk, played by a limit of the file size: the run goes on, what was written opens.
TEST_F(RecordingTest, AFullDiskEndsTheRecordingButNotTheRun) {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
    const rlimit small{60000, old.rlim_max};
    auto writer = RecordingWriter::create(file, header);
    ASSERT_TRUE(writer);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    drive(**writer);
    const auto finished = (*writer)->finish(report);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &old), 0);
    ASSERT_FALSE(finished);
    ASSERT_EQ(finished.problems().size(), 1U);
    EXPECT_THAT(toString(finished.problems()), HasSubstr(".part"));
    EXPECT_FALSE(fs::exists(file));
    EXPECT_EQ(report.stopReason, run::StopReason::Completed);
    auto reader = RecordingReader::open(file.string() + ".part");
    ASSERT_TRUE(reader);
    expectPrefix(**reader);
}

TEST_F(RecordingTest, NumbersSurviveWhateverTheyAre) {
    const Table table{{0.0, -0.0, std::nan("1"), 5e-324, -INFINITY},
                      {1.0, 1e308, 0.1, -5e-324, INFINITY}};
    const std::string bytes = packTable(kRowsChunk, table);
    const auto head = readHead(std::string_view(bytes).substr(0, kChunkHeadSize));
    ASSERT_TRUE(head);
    const auto read = unpackTable(*head, std::string_view(bytes).substr(kChunkHeadSize));
    ASSERT_TRUE(read);
    ASSERT_EQ(read->size(), 2U);
    EXPECT_TRUE(same(table[0], (*read)[0]));
    EXPECT_TRUE(same(table[1], (*read)[1]));
}

}  // namespace
}  // namespace simcore::io
