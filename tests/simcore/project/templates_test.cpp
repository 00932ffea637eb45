// New rovers from templates: valid, as mobile as they must be, standing and driving.
#include <array>
#include <fstream>
#include <iterator>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/io/project_file.h"
#include "simcore/mobility/mobility.h"
#include "simcore/project/templates.h"
#include "simcore/run/simulation.h"

using namespace simcore;
using namespace simcore::project;
using testing::HasSubstr;

namespace {

std::vector<std::string> templateNames() {
    std::vector<std::string> names;
    for (const auto& file : io::templateFiles()) {
        names.push_back(file.stem().string());
    }
    return names;
}

Project templ(const std::string& name) {
    for (const auto& file : io::templateFiles()) {
        if (file.stem() == name) {
            return *io::loadProject(file);
        }
    }
    throw std::runtime_error("there is no template " + name);
}

Project make(const std::string& name, const std::vector<Assignment>& dimensions) {
    const auto project = fromTemplate(templ(name), dimensions);
    if (!project) {
        throw std::runtime_error(toString(project.problems()));
    }
    return *project;
}

/// Grübler count, rows, rank, mobility, redundant.
std::array<int, 5> numbers(const Project& project) {
    const auto mechanism = resolve(project);
    if (!mechanism) {
        throw std::runtime_error(toString(mechanism.problems()));
    }
    const auto report = mobility::analyse(*mechanism, mobility::Model::Built);
    return {report.gruebler, report.rows, report.rank, report.mobility, report.redundant};
}

const std::map<std::string, std::array<int, 5>> kCounts{
    {"empty", {6, 0, 0, 6, 0}},
    // A level stance of four: one load and three of the four sideways holds are redundant, less
    // the turn that these still hold.
    {"rigid_four_wheel", {-2, 32, 29, 1, 3}},
    {"rocker_bogie_gear", {-3, 69, 65, 1, 4}},
    {"rocker_bogie_bar", {-1, 85, 81, 3, 4}},
    {"shrimp", {-20, 128, 107, 1, 21}},
    {"triple_bogie", {-3, 63, 59, 1, 4}},
    // Two planar loops of five pins, 3 each, beside the 4 sideways holds of the contacts.
    {"double_parallel_bogie", {-9, 99, 89, 1, 10}}};

}  // namespace

class TemplateTest : public testing::TestWithParam<std::string> {};

TEST_P(TemplateTest, IsWrittenAsTheProgramWritesIt) {
    for (const auto& file : io::templateFiles()) {
        if (file.stem() == GetParam()) {
            std::ifstream stream(file, std::ios::binary);
            const std::string text{std::istreambuf_iterator<char>(stream), {}};
            EXPECT_EQ(io::formatProject(templ(GetParam())), text);
        }
    }
}

TEST_P(TemplateTest, HasTheExpectedMobilityAtAnyDimensions) {
    ASSERT_TRUE(kCounts.contains(GetParam())) << "give the counts of the new template here";
    const auto& expected = kCounts.at(GetParam());
    EXPECT_EQ(numbers(make(GetParam(), {})), expected);
    if (GetParam() == "empty") {
        return;
    }
    EXPECT_EQ(numbers(make(GetParam(), {{"wheelbase", "1.4"},
                                        {"track", "120 cm"},
                                        {"wheel_radius", "0.15"},
                                        {"wheel_width", "0.12"},
                                        {"chassis_height", "0.55"},
                                        {"mass", "180"}})),
              expected);
    EXPECT_EQ(numbers(make(GetParam(), {{"wheelbase", "0.42"},
                                        {"track", "0.3"},
                                        {"wheel_radius", "0.04"},
                                        {"wheel_width", "0.03"},
                                        {"chassis_height", "0.16"},
                                        {"mass", "2"}})),
              expected);
}

TEST_P(TemplateTest, MeasuresWhatWasAskedFor) {
    const bool empty = GetParam() == "empty";
    const Project project = make(GetParam(), {{"mass", "17"}});
    const auto mechanism = resolve(project);
    ASSERT_TRUE(mechanism);
    // The parts of SOLERO add up to its 12 kg within the rounding of its table.
    EXPECT_NEAR(mechanism->mass(), 17.0, GetParam() == "shrimp" ? 0.01 : 1e-9);
    EXPECT_LT(std::abs(mechanism->centerOfMass().y()), 1e-12);
    for (const Parameter& parameter : project.rover.parameters) {
        EXPECT_FALSE(parameter.meaning.empty()) << parameter.name;
        EXPECT_FALSE(parameter.source.empty()) << parameter.name;
    }
    if (empty) {
        return;
    }
    const Project wide = make(GetParam(), {{"wheelbase", "0.7"}, {"track", "0.55"}});
    const auto resolved = resolve(wide);
    ASSERT_TRUE(resolved);
    EXPECT_NEAR(resolved->wheelbase(), 0.7, 1e-9);
    double left = 0.0;
    for (const mechanism::Wheel& wheel : resolved->wheels) {
        left = std::max(left, wheel.center.y());
    }
    EXPECT_NEAR(left, 0.275, 1e-9);
}

TEST_P(TemplateTest, StandsOnItsWheelsAndDrives) {
    if (GetParam() == "empty") {
        GTEST_SKIP() << "it has no wheels";
    }
    const Project project = make(GetParam(), {});
    for (const Scenario& scenario : project.scenarios) {
        run::RunRequest request;
        request.scenario = scenario.name;
        EXPECT_FALSE(hasCritical(run::prepareRun(project, request).problems())) << scenario.name;
    }
    run::RunRequest request;
    request.scenario = "flat";
    request.engine = EngineKind::Reduced;
    auto prepared = run::prepareRun(project, request);
    ASSERT_TRUE(prepared) << toString(prepared.problems());
    run::Simulation simulation(*prepared);
    while (simulation.snapshot().time < 3.0) {
        ASSERT_FALSE(simulation.finished());
        simulation.step();
    }
    const mechanism::Mechanism& rover = simulation.settings().mechanism;
    const auto wheels = simulation.snapshot().wheels;
    ASSERT_EQ(wheels.size(), rover.wheels.size());
    const double share = rover.mass() * 9.81 / static_cast<double>(wheels.size());
    for (std::size_t i = 0; i < wheels.size(); ++i) {
        // A rover that is about to tip has a wheel with far less than its share.
        EXPECT_GT(wheels[i].normalForce, 0.5 * share) << rover.wheels[i].name;
    }
}

INSTANTIATE_TEST_SUITE_P(All, TemplateTest, testing::ValuesIn(templateNames()),
                         [](const auto& test) { return test.param; });

TEST(TemplatesTest, TopologiesOfTheWindowAreThere) {
    EXPECT_THAT(templateNames(),
                testing::UnorderedElementsAre("empty", "rigid_four_wheel", "rocker_bogie_gear",
                                              "rocker_bogie_bar", "shrimp", "double_parallel_bogie",
                                              "triple_bogie"));
}

TEST(TemplatesTest, WrongDimensionsAreRefusedWithAReason) {
    const Project rocker = templ("rocker_bogie_gear");
    const auto far = fromTemplate(rocker, {{"wheelbase", "40"}});
    ASSERT_FALSE(far);
    EXPECT_THAT(toString(far.problems()), HasSubstr("maximum"));
    const auto fat = fromTemplate(rocker, {{"wheel_radius", "0.2"}});
    ASSERT_FALSE(fat);
    EXPECT_THAT(toString(fat.problems()), HasSubstr("wheel_gap"));
    const auto derived = fromTemplate(rocker, {{"wheel_mass", "1"}});
    ASSERT_FALSE(derived);
    EXPECT_THAT(toString(derived.problems()), HasSubstr("Main dimensions: wheelbase"));
}
