// The real program, run as a user or a script would.
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

struct Outcome {
    int code = -1;
    std::string out;
    std::string err;
};

std::string readAll(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

class RoversimTest : public testing::Test {
  protected:
    RoversimTest() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ =
            std::filesystem::path(testing::TempDir()) / ("roversim_" + std::string(test->name()));
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }

    ~RoversimTest() override { std::filesystem::remove_all(folder_); }

    Outcome roversim(const std::string& arguments) const {
        const auto out = folder_ / "stdout";
        const auto err = folder_ / "stderr";
        const std::string command = "'" ROVER_BINARY_DIR "/bin/roversim' " + arguments + " >'" +
                                    out.string() + "' 2>'" + err.string() + "' </dev/null";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readAll(out), readAll(err)};
    }

    static std::string shipped(const std::string& name) {
        return "'" ROVER_SOURCE_DIR "/assets/projects/" + name + ".rover'";
    }

    std::string write(const std::string& name, const std::string& text) const {
        const auto path = folder_ / name;
        std::ofstream(path) << text;
        return path.string();
    }

    std::filesystem::path folder_;
};

std::array<int, 5> numbers(const json& model) {
    return {model.at("gruebler"), model.at("constraint_rows"), model.at("rank"),
            model.at("mobility"), model.at("redundant")};
}

}  // namespace

TEST_F(RoversimTest, HelpAndVersionSucceed) {
    for (const char* arguments :
         {"--help", "mobility --help", "validate --help", "run --help", "convert --help"}) {
        const Outcome outcome = roversim(arguments);
        EXPECT_EQ(outcome.code, 0) << arguments;
        EXPECT_THAT(outcome.out, HasSubstr("Usage")) << arguments;
        EXPECT_EQ(outcome.err, "") << arguments;
    }
    EXPECT_THAT(roversim("--version").out, HasSubstr("roversim "));
}

TEST_F(RoversimTest, WrongUseIsTwoAndSaysSoOnStderr) {
    for (const std::string& arguments :
         {std::string(), std::string("fly"), std::string("mobility"),
          "mobility --model loose " + shipped("solero"), "mobility --wings " + shipped("solero"),
          "mobility --set wheel_radius " + shipped("solero"), "run " + shipped("solero"),
          "run --scenario flat --mu -1 " + shipped("solero")}) {
        const Outcome outcome = roversim(arguments);
        EXPECT_EQ(outcome.code, 2) << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
        EXPECT_NE(outcome.err, "") << arguments;
    }
}

TEST_F(RoversimTest, MobilityOfSoleroAndShrimpMatchesThePaper) {
    for (const char* rover : {"solero", "shrimp"}) {
        const Outcome built = roversim("mobility --json --model built " + shipped(rover));
        ASSERT_EQ(built.code, 0) << built.err;
        const json asBuilt = json::parse(built.out);
        EXPECT_TRUE(asBuilt.contains("schema"));
        EXPECT_TRUE(asBuilt.contains("program_version"));
        EXPECT_EQ(asBuilt.at("model"), "built");
        EXPECT_EQ(asBuilt.at("bodies"), 18);
        EXPECT_EQ(asBuilt.at("columns"), 108);
        EXPECT_EQ(numbers(asBuilt), (std::array{-20, 128, 107, 1, 21}));
        EXPECT_EQ(asBuilt.at("removable_constraints").size(), 78U);
        EXPECT_EQ(asBuilt.at("redundant_set").size(), 21U);
        const Outcome relaxed = roversim("mobility --json --model relaxed " + shipped(rover));
        ASSERT_EQ(relaxed.code, 0) << relaxed.err;
        const json freed = json::parse(relaxed.out);
        EXPECT_EQ(numbers(freed), (std::array{1, 107, 107, 1, 0}));
        EXPECT_EQ(freed.at("joints").at("f1"), 14);
        EXPECT_EQ(freed.at("joints").at("f2"), 1);
        EXPECT_EQ(freed.at("joints").at("f3"), 7);
        EXPECT_EQ(freed.at("joints").at("f4"), 6);
        EXPECT_EQ(freed.at("joints").at("f5"), 0);
        EXPECT_TRUE(freed.at("idle_freedoms").empty());
    }
}

TEST_F(RoversimTest, MobilityOfTheRockerBogie) {
    const Outcome outcome = roversim("mobility --json --model built " + shipped("rocker_bogie"));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(numbers(json::parse(outcome.out)), (std::array{-3, 69, 65, 1, 4}));
}

TEST_F(RoversimTest, MobilityShowsBothModelsWithoutModel) {
    const Outcome table = roversim("mobility " + shipped("solero"));
    EXPECT_EQ(table.code, 0);
    EXPECT_THAT(table.out, HasSubstr("as built"));
    EXPECT_THAT(table.out, HasSubstr("relaxed"));
    EXPECT_THAT(table.out, HasSubstr("-20"));
    const json both = json::parse(roversim("mobility --json " + shipped("solero")).out);
    ASSERT_EQ(both.at("models").size(), 2U);
}

// Dimensions do not change the counts; a value outside its range is refused with the range named.
TEST_F(RoversimTest, SetChangesParametersWithinTheirRange) {
    const Outcome good =
        roversim("mobility --json --model built --set 'wheel_radius=8 cm' " + shipped("solero"));
    ASSERT_EQ(good.code, 0) << good.err;
    EXPECT_EQ(numbers(json::parse(good.out)), (std::array{-20, 128, 107, 1, 21}));
    const Outcome outside = roversim("mobility --set wheel_radius=5 " + shipped("solero"));
    EXPECT_NE(outside.code, 0);
    EXPECT_EQ(outside.out, "");
    EXPECT_THAT(outside.err, HasSubstr("wheel_radius"));
    EXPECT_THAT(outside.err, HasSubstr("solero.rover"));
    const Outcome unknown = roversim("mobility --set wing_span=5 " + shipped("solero"));
    EXPECT_NE(unknown.code, 0);
    EXPECT_THAT(unknown.err, HasSubstr("wing_span"));
}

TEST_F(RoversimTest, ShippedProjectsAreValidAndHaveTheScenarios) {
    for (const char* rover : {"solero", "shrimp", "bench_rover", "rocker_bogie"}) {
        const Outcome outcome = roversim("validate --json " + shipped(rover));
        EXPECT_EQ(outcome.code, 0) << outcome.out;
        const json document = json::parse(outcome.out);
        EXPECT_EQ(document.at("valid"), true) << rover;
        EXPECT_TRUE(document.at("problems").empty()) << document.at("problems");
        const json project = json::parse(
            readAll(ROVER_SOURCE_DIR "/assets/projects/" + std::string(rover) + ".rover"));
        std::vector<std::string> names;
        for (const json& scenario : project.at("scenarios")) {
            names.push_back(scenario.at("name"));
        }
        EXPECT_THAT(names, testing::IsSupersetOf({"flat", "step", "rough-profile", "rough-3d"}));
    }
}

TEST_F(RoversimTest, ShippedProjectsAreInRoverStudiosOwnLayout) {
    for (const char* rover : {"solero", "shrimp", "bench_rover", "rocker_bogie"}) {
        const auto copy = folder_ / "copy.rover";
        ASSERT_EQ(roversim("convert " + shipped(rover) + " '" + copy.string() + "'").code, 0);
        EXPECT_EQ(readAll(copy),
                  readAll(ROVER_SOURCE_DIR "/assets/projects/" + std::string(rover) + ".rover"))
            << rover;
    }
}

TEST_F(RoversimTest, ValidateNamesEveryProblem) {
    json project = json::parse(readAll(ROVER_SOURCE_DIR "/assets/projects/solero.rover"));
    project["rover"]["bodies"][0]["mass"] = -1.0;
    project["rover"]["wheels"][0]["radius"] = "no_such_name";
    const std::string file = write("bad.rover", project.dump());
    const Outcome outcome = roversim("validate --json '" + file + "'");
    EXPECT_EQ(outcome.code, 1);
    const json document = json::parse(outcome.out);
    EXPECT_EQ(document.at("valid"), false);
    EXPECT_GE(document.at("problems").size(), 2U);
    EXPECT_THAT(outcome.out, HasSubstr("no_such_name"));
    EXPECT_THAT(outcome.out, HasSubstr("chassis"));
    for (const json& problem : document.at("problems")) {
        EXPECT_NE(problem.at("reason"), "");
        EXPECT_NE(problem.at("remedy"), "");
    }
}

TEST_F(RoversimTest, FilesThatAreNoProjectsAreRefused) {
    const std::string broken = write("broken.rover", "{\"format\": \"roverstudio-project\",");
    for (const std::string& file : {broken, std::string("/no/such/file.rover")}) {
        for (const std::string verb : {"mobility", "validate", "run --scenario flat"}) {
            const Outcome outcome = roversim(verb + " '" + file + "'");
            EXPECT_EQ(outcome.code, 1) << verb << " " << file;
            EXPECT_THAT(outcome.out + outcome.err, HasSubstr(file)) << verb;
        }
    }
}

TEST_F(RoversimTest, RunReportsAllKeysAndRepeatsBitForBit) {
    const auto csv = folder_ / "run.csv";
    const std::string arguments = "run --scenario flat --duration 1.5 --json --csv '" +
                                  csv.string() + "' " + shipped("solero");
    const Outcome first = roversim(arguments);
    const json report = json::parse(first.out);
    for (const char* key : {"schema", "program_version", "engine", "dt", "steps", "sim_time_s",
                            "wall_s", "rtf", "completed", "stop_reason", "distance_m", "slip_abs_m",
                            "slip_signed_m", "wheels", "energy_J", "state_hash",
                            "friction_violation_pct", "loop_error_max_mm", "penetration_max_mm"}) {
        EXPECT_TRUE(report.contains(key)) << key;
    }
    EXPECT_EQ(report.at("wheels").size(), 6U);
    EXPECT_NEAR(report.at("sim_time_s").get<double>(), 1.5, 0.01);
    EXPECT_THAT(first.err, Not(HasSubstr("\r"))) << "progress is for terminals only";
    EXPECT_THAT(readAll(csv), testing::StartsWith("time"));
    EXPECT_EQ(json::parse(roversim(arguments).out).at("state_hash"), report.at("state_hash"));
}

// The preload of the fork spring is chosen so that the front wheel carries 15 to 20 %.
TEST_F(RoversimTest, SolerosFrontWheelCarriesItsShare) {
    const Outcome outcome =
        roversim("run --scenario flat --duration 4 --json " + shipped("solero"));
    const json report = json::parse(outcome.out);
    double weight = 0.0;
    for (const json& wheel : report.at("wheels")) {
        weight += wheel.at("mean_normal_force_N").get<double>();
    }
    EXPECT_NEAR(weight, 12.0 * 9.81, 0.01 * 12.0 * 9.81);
    const double front = report.at("wheels")[0].at("mean_normal_force_N");
    EXPECT_GT(front / weight, 0.15);
    EXPECT_LT(front / weight, 0.20);
}

// The file beside the table tells the parameters that were run: the variant's, not the drawn ones.
TEST_F(RoversimTest, MetadataOfARunTellItsVariant) {
    json project = json::parse(readAll(ROVER_SOURCE_DIR "/assets/projects/solero.rover"));
    project["variants"] = {
        {{"name", "large"}, {"set", {{{"parameter", "wheel_mass"}, {"value", 0.6}}}}}};
    for (json& scenario : project["scenarios"]) {
        scenario["variant"] = "large";
    }
    const std::string file = write("large.rover", project.dump());
    const auto csv = folder_ / "run.csv";
    const Outcome outcome =
        roversim("run --scenario flat --duration 0.1 --set wheel_width=6cm --csv '" + csv.string() +
                 "' '" + file + "'");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const json metadata = json::parse(readAll(folder_ / "run.json"));
    EXPECT_EQ(metadata.at("variant"), "large");
    EXPECT_DOUBLE_EQ(metadata.at("parameters").at("wheel_mass"), 0.6);
    EXPECT_DOUBLE_EQ(metadata.at("parameters").at("wheel_width"), 0.06);
}

// Without commands and without a time limit a manual run would never end.
TEST_F(RoversimTest, ManualRunNeedsADuration) {
    const Outcome refused =
        roversim("run --scenario flat --controller manual " + shipped("solero"));
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, HasSubstr("--duration"));
    const Outcome timed =
        roversim("run --scenario flat --controller manual --duration 0.2 " + shipped("solero"));
    EXPECT_EQ(timed.code, 0) << timed.err;
}

TEST_F(RoversimTest, RunOfAnUnknownScenarioNamesIt) {
    const Outcome outcome = roversim("run --scenario moon " + shipped("solero"));
    EXPECT_NE(outcome.code, 0);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr("moon"));
}
