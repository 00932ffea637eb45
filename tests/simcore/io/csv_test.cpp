#include "simcore/io/csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "simcore/base/version.h"
#include "tests/support/fake_run.h"

namespace simcore::io {
namespace {

namespace fs = std::filesystem;
using ::testing::StartsWith;

/// A table as any reader sees it: split at LF and commas, numbers by strtod in the C locale.
struct Table {
    std::vector<std::string> header;
    std::vector<std::vector<double>> rows;
};

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells;
    std::string cell;
    std::istringstream in(line);
    while (std::getline(in, cell, ',')) {
        cells.push_back(cell);
    }
    if (line.ends_with(',')) {
        cells.emplace_back();
    }
    return cells;
}

Table parse(const std::string& text) {
    Table table;
    std::istringstream in(text);
    std::string line;
    std::getline(in, line);
    table.header = split(line);
    while (std::getline(in, line)) {
        auto& row = table.rows.emplace_back();
        for (const std::string& cell : split(line)) {
            std::istringstream number(cell);
            number.imbue(std::locale::classic());
            double value = std::nan("");
            if (!cell.empty()) {
                number >> value;
            }
            row.push_back(value);
        }
    }
    return table;
}

std::vector<run::Channel> twoChannels() {
    return {{"time", "", "Time", "t", "s", ""},
            {"torque_applied", "front", "Torque", "T", "N*m", ""}};
}

/// Decimal comma and grouping for everything that asks the global locale.
class CommaNumbers : public std::numpunct<char> {
  protected:
    char do_decimal_point() const override { return ','; }

    char do_thousands_sep() const override { return '.'; }

    std::string do_grouping() const override { return "\3"; }
};

/// Switches C and C++ locales to decimal comma and back.
class GermanLocale {
  public:
    GermanLocale() : old_(std::locale::global(std::locale(std::locale(), new CommaNumbers))) {
        std::setlocale(LC_ALL, "de_DE.UTF-8");  // where installed
    }

    ~GermanLocale() {
        std::locale::global(old_);
        std::setlocale(LC_ALL, "C");
    }

  private:
    std::locale old_;
};

TEST(Csv, HeaderIsOneUncommentedRowWithUnits) {
    EXPECT_EQ(formatCsv(twoChannels(), {}), "time [s],torque_applied_front [N*m]\n");
}

TEST(Csv, MissingValuesAreEmptyCells) {
    EXPECT_EQ(formatCsv(twoChannels(), {{0.0, std::nan("")}, {0.01, 1.5}}),
              "time [s],torque_applied_front [N*m]\n0,\n0.01,1.5\n");
}

TEST(Csv, NamesWithSeparatorsAreQuoted) {
    EXPECT_THAT(formatCsv({{"time", "a,\"b\"", "", "", "s", ""}}, {}),
                StartsWith("\"time_a,\"\"b\"\" [s]\"\n"));
}

TEST(Csv, RowsMustFitTheHeader) {
    EXPECT_THROW(formatCsv(twoChannels(), {{1.0}}), std::invalid_argument);
}

TEST(Csv, NumbersReadBackExactlyInAnyLocale) {
    std::mt19937_64 random(7);
    std::vector<std::vector<double>> rows;
    for (int i = 0; i < 2000; ++i) {
        double value = 0.0;
        do {  // any bit pattern that is a finite number
            value = std::bit_cast<double>(random());
        } while (!std::isfinite(value));
        rows.push_back({0.01 * i, value});
    }
    rows.push_back({0.1 + 0.2, 1234567.25});
    rows.push_back({-0.0, std::numeric_limits<double>::max()});
    const GermanLocale german;
    const std::string text = formatCsv(twoChannels(), rows);
    const Table table = parse(text);
    ASSERT_EQ(table.rows.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ASSERT_EQ(table.rows[i].size(), 2u);
        EXPECT_EQ(std::bit_cast<std::uint64_t>(table.rows[i][0]),
                  std::bit_cast<std::uint64_t>(rows[i][0]));
        EXPECT_EQ(std::bit_cast<std::uint64_t>(table.rows[i][1]),
                  std::bit_cast<std::uint64_t>(rows[i][1]));
    }
    EXPECT_EQ(text.find('\r'), std::string::npos);
}

TEST(Csv, MetadataFileStandsBesideTheTable) {
    EXPECT_EQ(csvMetadataFile("/a/run.csv"), fs::path("/a/run.json"));
    EXPECT_EQ(csvMetadataFile("/a/run"), fs::path("/a/run.json"));
    EXPECT_EQ(csvMetadataFile("/a/run.json"), fs::path("/a/run.json.json"));
}

class SavedCsv : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(::testing::TempDir()) /
                  (std::string("rover_csv_") +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        recording_.channels = run::makeChannels(settings_.mechanism);
        const auto stepper = test_support::fakeStepper()(settings_);
        for (int i = 0; i < 50; ++i) {
            stepper->step();
            run::sampleChannels(settings_.mechanism, stepper->snapshot(),
                                recording_.rows.emplace_back());
        }
        report_ = stepper->report();
        origin_.projectName = "SOLERO";
        origin_.parameters = {{"wheel_radius", 0.07}};
        origin_.assignments = {{"wheel_radius", "7 cm"}};
    }

    void TearDown() override { fs::remove_all(folder_); }

    static std::string read(const fs::path& file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    fs::path folder_;
    run::ResolvedRun settings_ = test_support::fakeRun();
    run::Recording recording_;
    run::RunReport report_;
    RecordingOrigin origin_;
};

TEST_F(SavedCsv, TableReadsBackAsRecorded) {
    const fs::path file = folder_ / "run.csv";
    ASSERT_TRUE(saveCsv(recording_, settings_, report_, origin_, file));
    const Table table = parse(read(file));
    EXPECT_EQ(table.rows, recording_.rows);
    ASSERT_EQ(table.header.size(), recording_.channels.size());
    EXPECT_EQ(table.header[0], "time [s]");
    EXPECT_EQ(table.header[1], "x_chassis [m]");
    // Nothing but the two files is left behind.
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}), 2);
}

TEST_F(SavedCsv, MetadataTellWhereTheNumbersComeFrom) {
    ASSERT_TRUE(saveCsv(recording_, settings_, report_, origin_, folder_ / "run.csv"));
    const auto json = nlohmann::json::parse(read(folder_ / "run.json"));
    EXPECT_EQ(json.at("schema"), "roverstudio.recording-table/1");
    EXPECT_EQ(json.at("program_version"), programVersion());
    EXPECT_EQ(json.at("project"), "SOLERO");
    EXPECT_EQ(json.at("scenario"), "bump");
    EXPECT_EQ(json.at("parameters").at("wheel_radius"), 0.07);
    EXPECT_EQ(json.at("overrides").at("wheel_radius"), "7 cm");
    EXPECT_EQ(json.at("engine"), "fake");
    EXPECT_EQ(json.at("step"), 0.002);
    EXPECT_EQ(json.at("seed"), 1);
    EXPECT_EQ(json.at("state_hash"), report_.stateHash);
    EXPECT_EQ(json.at("report").at("wheels").size(), 6u);
    EXPECT_EQ(json.at("report").at("stop_reason"), "running");
    EXPECT_EQ(json.at("columns").size(), recording_.channels.size());
    EXPECT_EQ(json.at("columns").at(0).at("name"), "time [s]");
}

TEST_F(SavedCsv, AFolderThatIsNotThereIsReported) {
    const auto result =
        saveCsv(recording_, settings_, report_, origin_, folder_ / "missing" / "run.csv");
    ASSERT_FALSE(result);
    EXPECT_FALSE(result.problems().front().remedy.empty());
}

// docs/csv.md holds what `roversim channels --markdown` prints.
TEST(CsvDocument, HoldsTheTableOfTheRegistry) {
    std::ifstream in(std::string(ROVER_SOURCE_DIR) + "/docs/csv.md");
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::string table = run::channelTable();
    EXPECT_GT(std::count(table.begin(), table.end(), '\n'), 20);
    EXPECT_NE(text.find("\n\n" + table + "\n"), std::string::npos)
        << "the table of docs/csv.md should be\n"
        << table;
}

}  // namespace
}  // namespace simcore::io
