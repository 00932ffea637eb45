// The real program, run as a user or a script would.
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "simcore/io/project_file.h"
#include "simcore/io/recording.h"

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

TEST_F(RoversimTest, NewMakesAValidRoverOfTheDimensionsAsked) {
    const auto file = folder_ / "mine.rover";
    const Outcome made = roversim("new rocker_bogie_gear --set wheelbase=0.6 --set 'mass=9 kg' " +
                                  std::string("--output '") + file.string() + "'");
    EXPECT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(roversim("validate '" + file.string() + "'").code, 0);
    const Outcome mobility = roversim("mobility '" + file.string() + "' --json");
    ASSERT_EQ(mobility.code, 0) << mobility.err;
    EXPECT_EQ(numbers(json::parse(mobility.out).at("models").at(0)),
              (std::array{-3, 69, 65, 1, 4}));
    EXPECT_THAT(readAll(file), HasSubstr("\"value\": 0.6"));
}

TEST_F(RoversimTest, NewListsTopologiesAndRefusesWhatDoesNotGoTogether) {
    const Outcome list = roversim("new");
    EXPECT_EQ(list.code, 0);
    for (const char* name : {"empty", "rigid_four_wheel", "rocker_bogie_gear", "rocker_bogie_bar",
                             "shrimp", "double_parallel_bogie", "triple_bogie"}) {
        EXPECT_THAT(list.out, HasSubstr(name + std::string(":")));
    }
    EXPECT_THAT(list.out, HasSubstr("wheelbase"));
    const auto file = folder_ / "not.rover";
    const std::string output = " --output '" + file.string() + "'";
    EXPECT_EQ(roversim("new tricycle" + output).code, 2);
    EXPECT_EQ(roversim("new shrimp").code, 2);  // where to?
    const Outcome fat = roversim("new rocker_bogie_gear --set wheel_radius=0.3" + output);
    EXPECT_EQ(fat.code, 1);
    EXPECT_THAT(fat.err, HasSubstr("wheel_gap"));
    const Outcome odd = roversim("new rocker_bogie_gear --set bogie_pivot_x=0.3" + output);
    EXPECT_EQ(odd.code, 1);
    EXPECT_THAT(odd.err, HasSubstr("Main dimensions"));
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(RoversimTest, HelpAndVersionSucceed) {
    for (const char* arguments :
         {"--help", "mobility --help", "validate --help", "run --help", "new --help",
          "convert --help", "replay --help", "export --help", "channels --help", "statics --help",
          "reproduce --help", "experiment --help", "relax --help"}) {
        const Outcome outcome = roversim(arguments);
        EXPECT_EQ(outcome.code, 0) << arguments;
        EXPECT_THAT(outcome.out, HasSubstr("Usage")) << arguments;
        EXPECT_EQ(outcome.err, "") << arguments;
    }
    EXPECT_THAT(roversim("--version").out, HasSubstr("roversim "));
}

TEST_F(RoversimTest, AnExperimentHoldsTwoControllersAgainstOneAnother) {
    const std::string what = "experiment " + shipped("solero") +
                             " --scenario step --engine reduced --height 0.05 --distance 1.2";
    const Outcome outcome = roversim(what + " --controller hybrid --against speed --json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json answer = json::parse(outcome.out);
    EXPECT_EQ(answer.at("runs").at(0).at("controller"), "hybrid");
    EXPECT_EQ(answer.at("runs").at(1).at("controller"), "speed");
    EXPECT_EQ(answer.at("same_way"), true);
    EXPECT_EQ(answer.at("slip").at("less"), "hybrid");
    const double ratio = answer.at("runs").at(1).at("slip_abs_m").get<double>() /
                         answer.at("runs").at(0).at("slip_abs_m").get<double>();
    EXPECT_NEAR(answer.at("slip").at("ratio").get<double>(), ratio, 1e-9);
    EXPECT_THAT(roversim(what + " --controller hybrid --against speed").out,
                HasSubstr("Slip: less with hybrid"));
    // Too slippery for either.
    const Outcome stuck = roversim(what + " --against hybrid --mu 0.1");
    EXPECT_EQ(stuck.code, 1);
    EXPECT_THAT(stuck.out, HasSubstr("Neither completes"));
    EXPECT_EQ(roversim(what).code, 2);
    EXPECT_EQ(roversim(what + " --against anyhow").code, 2);
    EXPECT_EQ(roversim("experiment " + shipped("solero") + " --scenario x --against speed").code,
              1);
}

TEST_F(RoversimTest, WrongUseIsTwoAndSaysSoOnStderr) {
    for (const std::string& arguments :
         {std::string(),
          std::string("fly"),
          std::string("mobility"),
          "mobility --model loose " + shipped("solero"),
          "mobility --wings " + shipped("solero"),
          "mobility --set wheel_radius " + shipped("solero"),
          "run " + shipped("solero"),
          "run --scenario flat --mu -1 " + shipped("solero"),
          "run --scenario flat --engine bullet " + shipped("solero"),
          "statics --contact front " + shipped("solero"),
          "statics --contact front=steep " + shipped("solero"),
          "statics --pose settled " + shipped("solero"),
          "statics --along " + shipped("solero"),
          "statics --scenario step " + shipped("solero"),
          "statics --scenario step --along --contact front=90 " + shipped("solero"),
          "statics --climb 0 " + shipped("solero"),
          "statics --climb 0.5 --scenario step --along " + shipped("solero"),
          "statics --climb 0.5 --contact front=90 " + shipped("solero"),
          "statics --contacts 15 " + shipped("solero"),
          std::string("reproduce moons"),
          std::string("reproduce profiles --seeds 5..1"),
          std::string("reproduce profiles --mu 0"),
          std::string("reproduce profiles --controllers manual")}) {
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

TEST_F(RoversimTest, RelaxProposesExactJoints) {
    const Outcome outcome = roversim("relax --json --max 2 --time 300 " + shipped("solero"));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json found = json::parse(outcome.out);
    EXPECT_EQ(found.at("schema"), "roverstudio-relax-1");
    EXPECT_TRUE(found.contains("program_version"));
    EXPECT_EQ(found.at("already_exact"), false);
    EXPECT_EQ(found.at("complete"), true);
    EXPECT_EQ(numbers(found.at("built")), (std::array{-20, 128, 107, 1, 21}));
    ASSERT_EQ(found.at("proposals").size(), 2U);
    for (const json& proposal : found.at("proposals")) {
        EXPECT_EQ(numbers(proposal), (std::array{1, 107, 107, 1, 0}));
        EXPECT_EQ(proposal.at("idle"), 0);
        ASSERT_FALSE(proposal.at("joints").empty());
        for (const json& joint : proposal.at("joints")) {
            EXPECT_NE(joint.at("name"), "");
            EXPECT_NE(joint.at("from"), joint.at("to"));
        }
    }
    const Outcome table = roversim("relax --max 2 --time 300 " + shipped("solero"));
    EXPECT_EQ(table.code, 0);
    EXPECT_THAT(table.out, HasSubstr("Proposal 2"));
    EXPECT_THAT(table.out, HasSubstr("pin -> ball"));
}

TEST_F(RoversimTest, RelaxAppliesAProposal) {
    const auto file = folder_ / "relaxed.rover";
    const Outcome applied = roversim("relax --max 1 --time 300 --apply 2 --output '" +
                                     file.string() + "' " + shipped("rocker_bogie"));
    ASSERT_EQ(applied.code, 0) << applied.err;
    const Outcome model = roversim("mobility --json --model relaxed '" + file.string() + "'");
    ASSERT_EQ(model.code, 0) << model.err;
    EXPECT_EQ(numbers(json::parse(model.out)), (std::array{1, 65, 65, 1, 0}));
    const Outcome built = roversim("mobility --json --model built '" + file.string() + "'");
    EXPECT_EQ(numbers(json::parse(built.out)), (std::array{-3, 69, 65, 1, 4}));
    // It is in RoverStudio's own layout.
    const auto again = folder_ / "again.rover";
    ASSERT_EQ(roversim("convert '" + file.string() + "' '" + again.string() + "'").code, 0);
    EXPECT_EQ(readAll(again), readAll(file));
}

TEST_F(RoversimTest, RelaxSaysWhenThereIsNothingToDo) {
    const std::string exact = "'" ROVER_SOURCE_DIR "/assets/mechanisms/stewart_platform.rover'";
    const Outcome outcome = roversim("relax " + exact);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.out, HasSubstr("Exact as built"));
    const auto file = folder_ / "out.rover";
    const Outcome apply = roversim("relax --apply 1 --output '" + file.string() + "' " + exact);
    EXPECT_EQ(apply.code, 1);
    EXPECT_THAT(apply.err, HasSubstr("exact as built"));
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(RoversimTest, RelaxEndsWithItsTime) {
    const Outcome outcome = roversim("relax --json --time 0 " + shipped("solero"));
    const json found = json::parse(outcome.out);
    EXPECT_EQ(found.at("ended"), "time");
    EXPECT_EQ(found.at("complete"), false);
    EXPECT_EQ(outcome.code, found.at("proposals").empty() ? 1 : 0);
}

TEST_F(RoversimTest, RelaxRefusesWrongUse) {
    const std::string file = shipped("rocker_bogie");
    EXPECT_EQ(roversim("relax").code, 2);
    EXPECT_EQ(roversim("relax --max 0 " + file).code, 2);
    EXPECT_EQ(roversim("relax --time -1 " + file).code, 2);
    const Outcome half = roversim("relax --apply 1 " + file);
    EXPECT_EQ(half.code, 2);
    EXPECT_THAT(half.err, HasSubstr("--output"));
    EXPECT_EQ(roversim("relax --output out.rover " + file).code, 2);
    const Outcome missing = roversim("relax /nowhere.rover");
    EXPECT_EQ(missing.code, 1);
    EXPECT_THAT(missing.err, HasSubstr("nowhere.rover"));
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

TEST_F(RoversimTest, MobilityOfAPartIsThatOfItsLoop) {
    const std::string part =
        " --part chassis --part fork_upper --part fork_lower --part fork_arm " + shipped("solero");
    const json both = json::parse(roversim("mobility --json" + part).out);
    EXPECT_EQ(both.at("part").at("bodies").size(), 4U);
    EXPECT_EQ(both.at("part").at("held"), json::array({"chassis"}));
    EXPECT_EQ(both.at("part").at("pieces"), 1);
    const json& built = both.at("models").at(0);
    EXPECT_EQ(built.at("gruebler"), -2);
    EXPECT_EQ(built.at("redundant"), 3);
    EXPECT_EQ(built.at("loops").size(), 1U);
    double parts = 0.0;
    for (const json& share : built.at("self_stress")) {
        parts += share.at("part").get<double>();
    }
    EXPECT_NEAR(parts, 1.0, 1e-9);
    EXPECT_EQ(both.at("models").at(1).at("redundant"), 0);
    EXPECT_THAT(roversim("mobility" + part).out,
                HasSubstr("With chassis held: 1 freedom within it"));

    const Outcome unknown = roversim("mobility --part spoon " + shipped("solero"));
    EXPECT_EQ(unknown.code, 1);
    EXPECT_THAT(unknown.err, HasSubstr("spoon"));
    const Outcome apart = roversim("mobility --part fork_arm " + shipped("solero"));
    EXPECT_EQ(apart.code, 1);
    EXPECT_THAT(apart.err, HasSubstr("no joint connects"));
}

TEST_F(RoversimTest, MobilityTellsMovedPoseLoopsAndReactions) {
    const std::string file = "'" ROVER_SOURCE_DIR "/assets/mechanisms/bars_in_line.rover'";
    const json found = json::parse(roversim("mobility --json --model built " + file).out);
    EXPECT_EQ(found.at("mobility"), 1);
    const json motion = found.at("moved").at("free_motions").at(0);
    EXPECT_EQ(motion.at("continuation"), "infinitesimal");
    EXPECT_EQ(motion.at("inconsistent").size(), 1U);
    EXPECT_EQ(found.at("loops").at(0).at("redundant"), 4);
    EXPECT_EQ(found.at("reactions").size(), 3U);
    const Outcome table = roversim("mobility " + file);
    EXPECT_THAT(table.out, HasSubstr("yields only"));
    EXPECT_THAT(table.out, HasSubstr("inconsistent: pin_a slide"));
}

TEST_F(RoversimTest, StaticsOnAScenariosGround) {
    const Outcome settled =
        roversim("statics --json --scenario step --pose settled --x 0.3 " + shipped("solero"));
    ASSERT_EQ(settled.code, 0) << settled.err;
    const json standing = json::parse(settled.out);
    EXPECT_EQ(standing.at("pose").at("standing"), "stands");
    EXPECT_NEAR(standing.at("pose").at("x_m").get<double>(), 0.3, 1e-9);
    EXPECT_EQ(standing.at("pose").at("footholds").size(), 6U);
    EXPECT_LT(standing.at("optimal").at("mu_required").get<double>(), 1e-6);

    const std::string table = (folder_ / "along.csv").string();
    const Outcome along = roversim("statics --json --scenario step --along --csv '" + table + "' " +
                                   shipped("solero"));
    ASSERT_EQ(along.code, 0) << along.err;
    const json way = json::parse(along.out);
    EXPECT_EQ(way.at("end"), "arrived");
    EXPECT_GT(way.at("mu_required").get<double>(), 0.5);
    EXPECT_GE(way.at("events").size(), 8U);
    std::ifstream in(table);
    std::string line;
    std::size_t rows = 0;
    std::ptrdiff_t commas = 0;
    while (std::getline(in, line)) {
        const auto count = std::count(line.begin(), line.end(), ',');
        commas = rows == 0 ? count : commas;
        EXPECT_EQ(count, commas) << line;
        ++rows;
    }
    EXPECT_EQ(rows, way.at("samples").get<std::size_t>() + 1);
}

TEST_F(RoversimTest, StaticsTellsWhatARoverClimbs) {
    const Outcome outcome = roversim("statics --json --climb 0.4 " + shipped("solero"));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json can = json::parse(outcome.out);
    EXPECT_NEAR(can.at("forwards").at("slope_deg").get<double>(), 21.80, 0.05);
    EXPECT_GT(can.at("forwards").at("step_m").get<double>(), 0.01);
    EXPECT_GT(can.at("backwards").at("stair_m").get<double>(), 0.005);
}

// Dimensions do not change the counts; a value outside its range is refused with the range named.
TEST_F(RoversimTest, StaticsOfTheShrimpAtAWall) {
    const Outcome outcome =
        roversim("statics --json --contact front=90 --set fork_preload=10 " + shipped("shrimp"));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json study = json::parse(outcome.out);
    EXPECT_EQ(study.at("equations"), 108);
    EXPECT_EQ(study.at("internal_reactions"), 93);
    EXPECT_EQ(study.at("unknowns"), 20);
    EXPECT_EQ(study.at("solution_dimension"), 5);
    EXPECT_EQ(study.at("feasible"), true);
    EXPECT_NEAR(study.at("optimal").at("mu_required"), 0.309, 0.02 * 0.309);
    ASSERT_EQ(study.at("wheels").size(), 6U);
    const json& front = study.at("wheels").at(0);
    EXPECT_EQ(front.at("name"), "front");
    EXPECT_NEAR(front.at("contact_angle_deg"), 90.0, 1e-9);
    EXPECT_NEAR(front.at("ratio"),
                front.at("traction_force").get<double>() / front.at("normal_force").get<double>(),
                1e-9);
}

TEST_F(RoversimTest, StaticsOfWhatCannotBeIsNo) {
    for (const char* contact : {"front=120", "nose=10"}) {
        const Outcome outcome =
            roversim("statics --contact " + std::string(contact) + " " + shipped("solero"));
        EXPECT_EQ(outcome.code, 1) << contact;
        EXPECT_NE(outcome.err, "") << contact;
    }
}

// An experiment writes tables, and goes on with what is there instead of driving it again.
TEST_F(RoversimTest, ReproduceComparesAndGoesOn) {
    const std::string experiment =
        "reproduce profiles --mu 0.7 --controllers hybrid,speed --csv '" +
        (folder_ / "deep" / "out").string() + "' --json --jobs 2 ";
    const Outcome first = roversim(experiment + "--seeds 1..2");
    ASSERT_EQ(first.code, 0) << first.err;
    const json found = json::parse(first.out);
    ASSERT_EQ(found.at("runs").size(), 4U);
    EXPECT_EQ(found.at("runs").at(0).at("seed"), 1);
    EXPECT_EQ(found.at("runs").at(0).at("controller"), "hybrid");
    EXPECT_EQ(found.at("summary").at(0).at("rival"), "speed");
    EXPECT_TRUE(std::filesystem::exists(folder_ / "deep/out/profiles-runs.csv"));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "deep/out/profiles-summary.csv"));

    const Outcome again = roversim(experiment + "--seeds 1..2");
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(again.out, first.out);
    // Another plan does not mix with it.
    const Outcome other = roversim(experiment + "--seeds 1..3");
    EXPECT_EQ(other.code, 1);
    EXPECT_THAT(other.err, HasSubstr("another plan"));
}

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
    int files = 0;
    for (const char* where : {"projects", "mechanisms"}) {
        const auto assets = std::filesystem::path(ROVER_SOURCE_DIR) / "assets" / where;
        for (const auto& entry : std::filesystem::directory_iterator(assets)) {
            const std::string file = entry.path().string();
            const auto copy = folder_ / "copy.rover";
            ASSERT_EQ(roversim("convert '" + file + "' '" + copy.string() + "'").code, 0) << file;
            EXPECT_EQ(readAll(copy), readAll(file)) << file;
            ++files;
        }
    }
    EXPECT_GT(files, 10);
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
    for (const char* key : {"schema",
                            "program_version",
                            "engine",
                            "dt",
                            "steps",
                            "sim_time_s",
                            "wall_s",
                            "rtf",
                            "completed",
                            "stop_reason",
                            "distance_m",
                            "slip_abs_m",
                            "slip_loaded_m",
                            "slip_signed_m",
                            "friction_work_J",
                            "wheels",
                            "body_contacts",
                            "energy_J",
                            "state_hash",
                            "friction_violation_pct",
                            "loop_error_max_mm",
                            "penetration_max_mm"}) {
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

namespace {

/// A short run of SOLERO; a folder keeps what it wrote.
class RecordedRun : public RoversimTest {
  protected:
    std::string path(const char* name) const { return (folder_ / name).string(); }

    Outcome record(const std::string& more = {}) const {
        return roversim("run " + shipped("solero") + " --scenario rough-3d --duration 3 --json " +
                        "--record '" + path("run.roverrec") + "' --csv '" + path("run.csv") + "' " +
                        more);
    }

    /// What a reader makes of run.csv: "" when it reads what is there, "skip" when it is missing.
    std::string readBy(const std::string& reader) const {
        const std::string command =
            "/usr/bin/python3 '" ROVER_SOURCE_DIR "/tests/app/read_csv.py' " + reader + " '" +
            path("run.csv") + "' >'" + path("said") + "' 2>&1 </dev/null";
        const int status = std::system(command.c_str());
        const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        // 127: there is no Python.
        return code == 77 || code == 127 ? "skip"
               : code == 0               ? ""
                                         : "bad: " + readAll(path("said"));
    }
};

}  // namespace

TEST_F(RecordedRun, ReplayFromTheRecordingAloneGivesTheSameHash) {
    const Outcome run = record("--set fork_preload=12 --mu 0.6 --seed 4");
    ASSERT_EQ(run.code, 0) << run.err;
    const Outcome replay = roversim("replay --json '" + path("run.roverrec") + "'");
    EXPECT_EQ(replay.code, 0) << replay.err;
    const json result = json::parse(replay.out);
    EXPECT_EQ(result.at("same"), true);
    EXPECT_EQ(result.at("complete"), true);
    EXPECT_EQ(result.at("steps"), 1500);
    EXPECT_EQ(result.at("state_hash"), json::parse(run.out).at("state_hash"));
}

// The recording says which engine ran: it is run again on that one.
TEST_F(RecordedRun, ReplayRunsOnTheEngineOfTheRun) {
    const Outcome run = record("--engine reduced");
    ASSERT_EQ(run.code, 0) << run.err;
    const json report = json::parse(run.out);
    EXPECT_EQ(report.at("engine"), "reduced");
    const Outcome replay = roversim("replay --json '" + path("run.roverrec") + "'");
    EXPECT_EQ(replay.code, 0) << replay.err;
    EXPECT_EQ(json::parse(replay.out).at("state_hash"), report.at("state_hash"));
    const json other = json::parse(record("--engine ode").out);
    EXPECT_EQ(other.at("engine"), "ode");
    EXPECT_NE(other.at("state_hash"), report.at("state_hash"));
}

TEST_F(RecordedRun, ExportGivesTheTableOfTheRun) {
    ASSERT_EQ(record().code, 0);
    const Outcome part = roversim("export '" + path("run.roverrec") + "' '" + path("part.csv") +
                                  "' --channels normal_force,pitch_chassis --from 0.1 --to 0.2");
    ASSERT_EQ(part.code, 0) << part.err;
    std::ifstream partTable(path("part.csv"));
    std::string line;
    std::getline(partTable, line);
    EXPECT_THAT(line, testing::StartsWith("time [s],pitch_chassis [rad],normal_force_front [N],"));
    int partRows = 0;
    while (std::getline(partTable, line)) {
        ++partRows;
    }
    EXPECT_EQ(partRows, 11);  // every 10 ms, both ends
    const json cut = json::parse(std::ifstream(path("part.json")));
    EXPECT_EQ(cut.at("rows"), 11);
    EXPECT_EQ(cut.at("from"), 0.1);
    for (const char* wrong : {" --channels wings", " --from 100", " --from 0.3 --to 0.2"}) {
        const Outcome refused =
            roversim("export '" + path("run.roverrec") + "' '" + path("no.csv") + "'" + wrong);
        EXPECT_EQ(refused.code, 1) << wrong;
        EXPECT_FALSE(std::filesystem::exists(path("no.csv"))) << wrong;
    }
    const Outcome exported =
        roversim("export '" + path("run.roverrec") + "' '" + path("again.csv") + "'");
    ASSERT_EQ(exported.code, 0) << exported.err;
    EXPECT_EQ(readAll(path("again.csv")), readAll(path("run.csv")));
    EXPECT_EQ(json::parse(readAll(path("again.json"))), json::parse(readAll(path("run.json"))));
}

/// A rover on an imported ground: a project in a folder of its own.
class ImportedGround : public RecordedRun {
  protected:
    ImportedGround() {
        const std::filesystem::path assets(ROVER_SOURCE_DIR "/assets");
        std::filesystem::create_directories(folder_ / "mine" / "projects");
        std::filesystem::copy(assets / "terrains", folder_ / "mine" / "grounds");
        std::string project = readAll(assets / "projects" / "terrains.rover");
        // Another folder than that of the shipped grounds, which are found from anywhere.
        for (std::size_t at = 0; (at = project.find("../terrains/", at)) != std::string::npos;) {
            project.replace(at, 12, "../grounds/");
        }
        write("mine/projects/my.rover", project);
    }

    Outcome recordOn(const char* scenario) const {
        return roversim("run '" + path("mine/projects/my.rover") + "' --scenario " + scenario +
                        " --duration 1 --json --record '" + path("run.roverrec") + "'");
    }
};

// Image, grid and mesh: each is in the recording.
TEST_F(ImportedGround, ReplayNeedsNoFileButTheRecording) {
    for (const char* scenario : {"image", "ascii-grid", "mesh"}) {
        const Outcome run = recordOn(scenario);
        ASSERT_TRUE(std::filesystem::exists(path("run.roverrec"))) << run.err;
        std::filesystem::rename(path("mine"), path("gone"));
        const Outcome replay = roversim("replay --json '" + path("run.roverrec") + "'");
        EXPECT_EQ(replay.code, 0) << scenario << ": " << replay.err;
        EXPECT_EQ(json::parse(replay.out).at("same"), true) << scenario;
        EXPECT_EQ(json::parse(replay.out).at("state_hash"), json::parse(run.out).at("state_hash"));
        std::filesystem::rename(path("gone"), path("mine"));
    }
}

// What the recording lacks is not looked for elsewhere, even where it lies.
TEST_F(ImportedGround, ADamagedGroundIsAProblem) {
    recordOn("image");
    const std::string whole = readAll(path("run.roverrec"));
    const std::size_t file = whole.find("FILE");
    ASSERT_NE(file, std::string::npos);
    std::string damaged = whole;
    damaged[file + 100] = static_cast<char>(damaged[file + 100] ^ 4);
    write("damaged.roverrec", damaged);
    const Outcome replay = roversim("replay '" + path("damaged.roverrec") + "'");
    EXPECT_EQ(replay.code, 1);
    EXPECT_THAT(replay.err, HasSubstr("damaged at byte"));
    // The rest of it is good.
    const Outcome table =
        roversim("export '" + path("damaged.roverrec") + "' '" + path("x.csv") + "'");
    EXPECT_EQ(table.code, 0) << table.err;
}

TEST_F(ImportedGround, AGroundThatCannotBeCarriedIsRefusedBeforeTheRun) {
    std::filesystem::resize_file(path("mine/grounds/dunes.png"), (256U << 20U) + 1);
    const Outcome run = recordOn("image");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.err, HasSubstr("larger than 256 MiB"));
    EXPECT_FALSE(std::filesystem::exists(path("run.roverrec")));
    EXPECT_FALSE(std::filesystem::exists(path("run.roverrec.part")));
}

// A recording that wants to read or write where it likes: names of files are keys, nothing else.
TEST_F(ImportedGround, NamesInARecordingReachNoFile) {
    using namespace simcore;
    auto project = io::loadProject(path("mine/projects/my.rover"));
    ASSERT_TRUE(project);
    const std::string ground = readAll(path("mine/grounds/dunes.png"));
    const std::string hostile = path("planted.png");
    for (const std::string& name : {hostile, std::string("../../planted.png"), hostile + "/.."}) {
        run::RunRequest request;
        request.scenario = "image";
        request.duration = 0.1;
        project::Project changed = *project;
        for (project::Scenario& scenario : changed.scenarios) {
            if (scenario.name == "image") {
                for (project::Terrain& part : scenario.terrain.terrains) {
                    part.file = part.file.empty() ? "" : name;
                }
                scenario.terrain.file = scenario.terrain.file.empty() ? "" : name;
            }
        }
        const auto save = [&](const char* file, const project::CarriedFiles& files) {
            request.files.carried = std::make_shared<const project::CarriedFiles>(files);
            auto prepared = run::prepareRun(changed, request);
            ASSERT_TRUE(prepared) << toString(prepared.problems());
            run::Simulation simulation(std::move(prepared).value());
            io::RecordingHeader header =
                io::recordingHeader(changed, request, simulation.settings(), "ode", "");
            if (file == std::string("lacking.roverrec")) {
                header.request.files.carried = std::make_shared<const project::CarriedFiles>();
            }
            while (!simulation.finished()) {
                simulation.step();
            }
            std::filesystem::remove(path(file));
            auto writer = io::RecordingWriter::create(path(file), header);
            ASSERT_TRUE(writer);
            (*writer)->add(io::HashMark{simulation.snapshot().step, simulation.report().stateHash});
            ASSERT_TRUE((*writer)->finish(simulation.report()));
        };
        save("carried.roverrec", {{name, ground}});
        const Outcome replay = roversim("replay '" + path("carried.roverrec") + "'");
        EXPECT_EQ(replay.code, 0) << replay.err;
        EXPECT_FALSE(std::filesystem::exists(hostile));
        // Not even a good file at that very place is read.
        save("lacking.roverrec", {{name, ground}});
        write("planted.png", ground);
        const Outcome lacking = roversim("replay '" + path("lacking.roverrec") + "'");
        EXPECT_EQ(lacking.code, 1);
        EXPECT_THAT(lacking.err, HasSubstr("lacks its file"));
        std::filesystem::remove(hostile);
    }
}

// A recording of a version that carried no files is run on the files in their old folder.
TEST_F(ImportedGround, AnOldRecordingReadsItsFolder) {
    using namespace simcore;
    const auto project = io::loadProject(path("mine/projects/my.rover"));
    ASSERT_TRUE(project);
    run::RunRequest request;
    request.scenario = "image";
    request.duration = 0.1;
    request.files.folder = path("mine/projects");
    auto prepared = run::prepareRun(*project, request);
    ASSERT_TRUE(prepared) << toString(prepared.problems());
    run::Simulation simulation(std::move(prepared).value());
    auto writer = io::RecordingWriter::create(
        path("old.roverrec"),
        io::recordingHeader(*project, request, simulation.settings(), "ode", ""));
    ASSERT_TRUE(writer);
    while (!simulation.finished()) {
        simulation.step();
    }
    (*writer)->add(io::HashMark{simulation.snapshot().step, simulation.report().stateHash});
    ASSERT_TRUE((*writer)->finish(simulation.report()));
    EXPECT_EQ(roversim("replay '" + path("old.roverrec") + "'").code, 0);
    std::filesystem::remove_all(path("mine"));
    const Outcome gone = roversim("replay '" + path("old.roverrec") + "'");
    EXPECT_EQ(gone.code, 1);
    EXPECT_THAT(gone.err, HasSubstr("there is no file"));
}

// A recording that was cut short is run again as far as it goes.
TEST_F(RecordedRun, ACutRecordingIsReplayedAsFarAsItGoes) {
    ASSERT_EQ(record().code, 0);
    const std::string whole = readAll(path("run.roverrec"));
    write("cut.roverrec", whole.substr(0, whole.size() - 20000));
    const Outcome replay = roversim("replay --json '" + path("cut.roverrec") + "'");
    EXPECT_EQ(replay.code, 0) << replay.err;
    EXPECT_THAT(replay.err, HasSubstr("interrupted"));
    const json result = json::parse(replay.out);
    EXPECT_EQ(result.at("complete"), false);
    EXPECT_GT(result.at("steps"), 1000);
}

// The recording of a person's drive, made step by step here, is the same run in the program; with a
// command that was not given, it is another.
TEST_F(RecordedRun, ReplayObeysTheCommandsOfAPerson) {
    using namespace simcore;
    const auto project = io::loadProject(ROVER_SOURCE_DIR "/assets/projects/solero.rover");
    ASSERT_TRUE(project);
    run::RunRequest request;
    request.scenario = "flat";
    request.controller = project::ControllerKind::Manual;
    request.duration = 1.2;
    auto prepared = run::prepareRun(*project, request);
    ASSERT_TRUE(prepared);
    run::Simulation simulation(std::move(prepared).value());
    const std::vector<io::TimedCommand> commands{{300, {0.1, 0.0}}, {450, {0.05, 0.2}}};
    while (!simulation.finished()) {
        for (const io::TimedCommand& command : commands) {
            if (command.step == simulation.snapshot().step) {
                simulation.setManualCommand(command.command);
            }
        }
        simulation.step();
    }
    const auto save = [&](const char* name, std::size_t given) {
        auto writer = io::RecordingWriter::create(
            path(name),
            io::recordingHeader(*project, request, simulation.settings(), "ode", "solero.rover"));
        ASSERT_TRUE(writer);
        for (std::size_t i = 0; i < given; ++i) {
            (*writer)->add(commands[i]);
        }
        (*writer)->add(io::HashMark{simulation.snapshot().step, simulation.report().stateHash});
        ASSERT_TRUE((*writer)->finish(simulation.report()));
    };
    save("driven.roverrec", 2);
    save("forgotten.roverrec", 1);
    EXPECT_EQ(roversim("replay '" + path("driven.roverrec") + "'").code, 0);
    const Outcome other = roversim("replay '" + path("forgotten.roverrec") + "'");
    EXPECT_EQ(other.code, 1);
    EXPECT_THAT(other.out, HasSubstr("another run"));
}

// Driven by a script, a manual run is driven, recorded with its commands, and made again from them.
TEST_F(RecordedRun, ScriptDrivesAManualRun) {
    const std::string manual =
        "run --scenario flat --controller manual --duration 2 " + shipped("rocker_bogie_steered");
    const Outcome driven = roversim(manual + " --drive '0.5,0.1,0;1,0.1,0.2' --json --record '" +
                                    path("script.roverrec") + "'");
    ASSERT_EQ(driven.code, 0) << driven.err;
    // 0.1 m/s for 1.5 s, less what starting and turning the steered wheels takes.
    const double distance = json::parse(driven.out).at("distance_m").get<double>();
    EXPECT_GT(distance, 0.1);
    EXPECT_LT(distance, 0.15);
    EXPECT_EQ(roversim("replay '" + path("script.roverrec") + "'").code, 0);

    EXPECT_EQ(roversim(manual + " --drive '0,fast,0'").code, 2);
    const Outcome automatic =
        roversim("run --scenario flat --drive '0,0.1,0' " + shipped("solero"));
    EXPECT_EQ(automatic.code, 2);
    EXPECT_THAT(automatic.err, HasSubstr("manual"));
}

// With steering freed every pin is one more freedom of the count.
TEST_F(RoversimTest, MobilityCountsFreedSteering) {
    const auto count = [&](const char* options) {
        return json::parse(roversim("mobility --json --model built " + std::string(options) +
                                    shipped("rocker_bogie_steered"))
                               .out);
    };
    const json locked = count("");
    EXPECT_EQ(locked.at("gruebler"), -3);  // as the rocker-bogie without steering
    EXPECT_EQ(locked.at("gruebler_steering_free"), -3 + 4);
    EXPECT_EQ(count("--steering free ").at("gruebler"), -3 + 4);
}

TEST_F(RecordedRun, WhatIsNoRecordingIsRefused) {
    for (const char* verb : {"replay ", "export "}) {
        const Outcome outcome =
            roversim(verb + shipped("solero") + (verb[0] == 'e' ? " '" + path("x.csv") + "'" : ""));
        EXPECT_EQ(outcome.code, 1);
        EXPECT_THAT(outcome.err, HasSubstr("not a recording"));
    }
    EXPECT_FALSE(std::filesystem::exists(path("x.csv")));
    const Outcome run = roversim("run " + shipped("solero") +
                                 " --scenario flat --duration 1 --record /proc/none/run.roverrec");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.err, HasSubstr("cannot create"));
}

// Real readers open the table with no options.
class CsvReaders : public RecordedRun, public testing::WithParamInterface<const char*> {};

TEST_P(CsvReaders, ReadEveryNumber) {
    ASSERT_EQ(record().code, 0);
    const std::string verdict = readBy(GetParam());
    if (verdict == "skip") {
        GTEST_SKIP() << GetParam() << " is not installed";
    }
    EXPECT_EQ(verdict, "");
}

INSTANTIATE_TEST_SUITE_P(All, CsvReaders,
                         testing::Values("csv", "pandas", "plotjuggler", "libreoffice"),
                         [](const auto& reader) { return std::string(reader.param); });

// With a decimal comma in the environment nothing that is written changes.
TEST_F(RecordedRun, DecimalCommaOfTheUserChangesNothing) {
    const std::string make = "mkdir -p '" + path("loc") + "' && localedef -i de_DE -f UTF-8 '" +
                             path("loc") + "/de_DE.UTF-8' >/dev/null 2>&1";
    if (std::system(make.c_str()) != 0) {
        GTEST_SKIP() << "the German locale cannot be made here";
    }
    const Outcome plain = record();
    ASSERT_EQ(plain.code, 0);
    const std::string csv = readAll(path("run.csv"));
    setenv("LOCPATH", path("loc").c_str(), 1);
    setenv("LC_ALL", "de_DE.UTF-8", 1);
    const Outcome german = record();
    const Outcome replay = roversim("replay '" + path("run.roverrec") + "'");
    unsetenv("LC_ALL");
    unsetenv("LOCPATH");
    EXPECT_EQ(german.code, 0) << german.err;
    EXPECT_EQ(readAll(path("run.csv")), csv);
    EXPECT_EQ(json::parse(german.out).at("state_hash"), json::parse(plain.out).at("state_hash"));
    EXPECT_EQ(replay.code, 0) << replay.err;
}
