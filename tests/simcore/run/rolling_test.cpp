#include <cmath>

#include <gtest/gtest.h>

#include "simcore/run/simulation.h"
#include "tests/support/patches.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::run;
using namespace testsupport;

namespace {

ResolvedRun soleroOn(std::shared_ptr<const terrain::Terrain> ground, double speed,
                     double duration) {
    project::Project project = shipped("solero");
    for (project::Scenario& scenario : project.scenarios) {
        scenario.controller.speed = speed;
    }
    RunRequest request;
    request.scenario = "flat";
    request.duration = duration;
    auto run = prepareRun(project, request);
    EXPECT_TRUE(run) << toString(run.problems());
    ResolvedRun resolved = std::move(run).value();
    resolved.terrain = std::move(ground);
    return resolved;
}

std::shared_ptr<const terrain::Terrain> levelPatch(double cell) {
    return std::make_shared<const terrain::Terrain>(patch(
        cell, 1.6, 0.6, [](double, double) { return 0.0; }, 0.2));
}

}  // namespace

struct Case {
    double cell, speed;
};

class EvenGroundTest : public testing::TestWithParam<Case> {};

// On even ground in triangles of any size and shape a rover rolls as on one plane.
TEST_P(EvenGroundTest, TrianglesAreNotFelt) {
    const auto [cell, speed] = GetParam();
    const double duration = std::min(4.0, 1.0 + 0.8 / speed);
    Simulation simulation(soleroOn(levelPatch(cell), speed, duration));
    const auto chassis = static_cast<std::size_t>(simulation.settings().mechanism.chassis);
    double lowest = 1.0;
    double highest = -1.0;
    while (!simulation.finished()) {
        simulation.step();
        const Vec3& place = simulation.snapshot().bodies[chassis].position;
        ASSERT_LT(std::abs(place.y()), 1e-4) << "pushed aside";
        if (simulation.snapshot().time > 1.2) {
            lowest = std::min(lowest, place.z());
            highest = std::max(highest, place.z());
        }
    }
    EXPECT_LT(highest - lowest, 5e-5) << "catches on edges";
    EXPECT_LT(simulation.report().penetrationMax, 1e-3);
    EXPECT_GT(simulation.report().distance, 0.5 * speed * (duration - 1.0));
    EXPECT_LT(simulation.report().slipAbs, 0.02 * simulation.report().distance * 6.0);
}

INSTANTIATE_TEST_SUITE_P(Cells, EvenGroundTest,
                         testing::Values(Case{0.05, 0.01}, Case{0.05, 0.5}, Case{0.02, 0.1},
                                         Case{0.005, 0.01}, Case{0.005, 0.5}),
                         [](const auto& test) {
                             return std::to_string(std::lround(1e3 * test.param.cell)) + "mm_" +
                                    std::to_string(std::lround(1e3 * test.param.speed)) + "mm_s";
                         });

// Vertical faces met at half a metre a second: no wheel sinks in, none gets through.
TEST(FastWheelsTest, FacesAndEdgesStopThem) {
    for (const bool trench : {true, false}) {
        const double h = trench ? -0.05 : 0.3;
        const auto ground = std::make_shared<const terrain::Terrain>(
            terrain::Terrain::extruded({{-2.5, 0.0},
                                        {0.8, 0.0},
                                        {0.8, h},
                                        {trench ? 0.9 : 0.802, h},
                                        {trench ? 0.9 : 0.802, 0.0},
                                        {6.0, 0.0}},
                                       -3.0, 3.0));
        Simulation simulation(soleroOn(ground, 0.5, 3.0));
        while (!simulation.finished()) {
            simulation.step();
        }
        EXPECT_LT(simulation.report().penetrationMax, 0.003) << (trench ? "trench" : "plate");
        if (!trench) {
            EXPECT_LT(simulation.report().distance, 0.8) << "through a plate of 2 mm";
        }
    }
}
