#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simcore/run/simulation.h"
#include "tests/support/carts.h"
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

// -- the same ground in triangles of any size -----------------------------------------------------

namespace {

/// A narrow cart: a strip of ground 0.2 m wide carries it. Its rear wheels are on a beam that rolls
/// about x, so that all wheels stand on any ground and loads are determined.
Mechanism narrowCart() {
    CartNumbers numbers;
    numbers.halfBase = 0.1;
    numbers.halfTrack = 0.06;
    Mechanism cart = makeCart(numbers);
    const Vec3 middle(-numbers.halfBase, 0.0, numbers.radius);
    const int beam = static_cast<int>(cart.bodies.size());
    cart.bodies.push_back(makeBody("beam", 0.3, middle, {4e-4, 1e-4, 4e-4}));
    for (const std::size_t rear : {2, 3}) {
        cart.wheels[rear].carrier = beam;
        cart.joints[static_cast<std::size_t>(cart.wheels[rear].axle)].first = beam;
    }
    cart.joints.push_back(makePin("beam", 0, beam, middle, Vec3::UnitX()));
    // Drawn behind the middle of the strip, its wheels not above vertices, and 20 um deep: wheels
    // that just touch would do so or not by rounding, and a rigid cart keeps that for a while.
    const Vec3 behind(-0.2537, 0.0021, -2e-5);
    for (Body& body : cart.bodies) {
        body.com += behind;
    }
    for (Joint& joint : cart.joints) {
        joint.point += behind;
    }
    for (Wheel& wheel : cart.wheels) {
        wheel.center += behind;
    }
    return cart;
}

/// A strip of ground from x = -0.6 to 0.6 m, on a regular grid or in triangles of any shape.
terrain::Terrain strip(double cell, bool irregular, const Height& height) {
    constexpr double kHalf = 0.6;
    const double halfWidth = 2.0 * std::ceil(0.1 / cell / 2.0) * cell;
    if (irregular) {
        return patch(cell, kHalf, halfWidth, height, 0.2);
    }
    const int nx = static_cast<int>(std::lround(2.0 * kHalf / cell)) + 1;
    const int ny = static_cast<int>(std::lround(2.0 * halfWidth / cell)) + 1;
    std::vector<double> heights;
    for (int ix = 0; ix < nx; ++ix) {
        for (int iy = 0; iy < ny; ++iy) {
            heights.push_back(height(-kHalf + ix * cell, -halfWidth + iy * cell));
        }
    }
    return terrain::Terrain::grid(-kHalf, -halfWidth, cell, nx, ny, heights);
}

/// What is felt of the ground at one step.
struct Felt {
    double front = 0.0, rear = 0.0;      ///< loads of the axles, along the normals [N]
    double speed = 0.0;                  ///< [m/s]
    std::array<Vec3, 4> wheelCenters{};  ///< world [m]
    Vec3 chassis = Vec3::Zero();
};

struct Roll {
    std::vector<Felt> steps;  ///< from 0.1 s after the ramp on
    double penetration = 0.0;
    long solverMessages = 0;
    double weight = 0.0;
    double step = 0.0;
};

Roll roll(const Mechanism& cart, terrain::Terrain ground, double speed, double duration) {
    ResolvedRun run = runOf(cart, std::move(ground));
    run.speed = speed;
    run.distance = 10.0;
    run.duration = duration;
    Simulation simulation(run);
    Roll roll;
    roll.weight = cart.mass() * dynamics::kGravity;
    roll.step = run.step;
    while (!simulation.finished()) {
        simulation.step();
        const Snapshot& now = simulation.snapshot();
        if (now.time < run.settle + run.ramp + 0.1) {
            continue;
        }
        Felt felt;
        felt.front = now.wheels[0].normalForce + now.wheels[1].normalForce;
        felt.rear = now.wheels[2].normalForce + now.wheels[3].normalForce;
        felt.speed = now.speed;
        felt.chassis = now.bodies[0].position;
        for (std::size_t i = 0; i < 4; ++i) {
            const Wheel& wheel = cart.wheels[i];
            felt.wheelCenters[i] = now.bodies[static_cast<std::size_t>(wheel.body)] * wheel.center;
        }
        roll.steps.push_back(felt);
    }
    roll.penetration = simulation.report().penetrationMax;
    roll.solverMessages = simulation.report().solverMessages;
    return roll;
}

struct Triangles {
    double cell, speed;
    bool irregular;
};

std::string nameOfTriangles(const testing::TestParamInfo<Triangles>& test) {
    return std::to_string(std::lround(1e3 * test.param.cell)) + "mm_" +
           std::to_string(std::lround(1e3 * test.param.speed)) + "mm_s" +
           (test.param.irregular ? "_irregular" : "_regular");
}

class SameGroundTest : public testing::TestWithParam<Triangles> {};

INSTANTIATE_TEST_SUITE_P(Triangles, SameGroundTest,
                         testing::Values(Triangles{0.001, 0.01, false},
                                         Triangles{0.001, 0.01, true}, Triangles{0.001, 0.5, false},
                                         Triangles{0.001, 0.5, true}, Triangles{0.005, 0.01, false},
                                         Triangles{0.005, 0.01, true}, Triangles{0.005, 0.5, false},
                                         Triangles{0.005, 0.5, true}, Triangles{0.05, 0.01, false},
                                         Triangles{0.05, 0.01, true}, Triangles{0.05, 0.5, false},
                                         Triangles{0.05, 0.5, true}),
                         nameOfTriangles);

}  // namespace

// Level or rising, even ground in triangles is felt as the plane of two triangles is: at every step
// the same axle loads, speed and height.
TEST_P(SameGroundTest, PlaneIsFeltAsAPlane) {
    const auto [cell, speed, irregular] = GetParam();
    for (const double slope : {0.0, 0.2}) {
        const Mechanism cart = tilted(narrowCart(), slope);
        const double duration = speed < 0.1 ? 1.6 : 1.4;
        const Roll plane = roll(cart, slopeThroughOrigin(slope), speed, duration);
        const Roll triangles = roll(
            cart, strip(cell, irregular, [&](double x, double) { return x * std::tan(slope); }),
            speed, duration);
        ASSERT_EQ(triangles.steps.size(), plane.steps.size());
        ASSERT_GT(triangles.steps.size(), 100u);
        for (std::size_t i = 0; i < plane.steps.size(); ++i) {
            const Felt& felt = triangles.steps[i];
            const Felt& expected = plane.steps[i];
            // Rounding decides which way friction is iterated, to 2 %, when the brakes are released
            // on the rise: a few hundredths of a per mille of the loads stay of that.
            ASSERT_NEAR(felt.front, expected.front, 1e-3 * plane.weight) << "step " << i;
            ASSERT_NEAR(felt.rear, expected.rear, 1e-3 * plane.weight) << "step " << i;
            ASSERT_NEAR(felt.speed, expected.speed, 1e-3 * speed) << "step " << i;
            // As deep as wheels settle.
            ASSERT_LT((felt.chassis - expected.chassis).norm(), 5e-5) << "step " << i;
        }
        EXPECT_LT(triangles.penetration, 1e-4);
        EXPECT_EQ(triangles.solverMessages, 0);
        EXPECT_NEAR(plane.steps.back().front + plane.steps.back().rear,
                    plane.weight * std::cos(slope), 0.01 * plane.weight);
        EXPECT_NEAR(plane.steps.back().speed, speed, 0.05 * speed);
    }
}

namespace {

/// A bump z = h/2 (1 - cos(2 pi x / l)), level before and behind.
struct Bump {
    double height, length, start;  // [m]

    double at(double x) const {
        const double along = std::clamp((x - start) / length, 0.0, 1.0);
        return 0.5 * height * (1.0 - std::cos(2.0 * std::numbers::pi * along));
    }

    double bend() const {  // most, [1/m]
        return 0.5 * height * std::pow(2.0 * std::numbers::pi / length, 2);
    }

    /// Distance of a point above it from the bump, by trying; good to 1e-7 m for a radius of 7 cm.
    double distance(const Vec3& p) const {
        double best = 1e9;
        for (double s = -0.02; s <= 0.02; s += 1e-4) {
            best = std::min(best, std::hypot(s, p.z() - at(p.x() + s)));
        }
        return best;
    }
};

/// Mean of an axle's loads over 50 ms from each step on: at a convex edge taken quickly a wheel may
/// be in the air for a step, and is caught in the next.
std::vector<double> smoothed(const Roll& roll, double Felt::*axle) {
    const auto width = static_cast<std::size_t>(std::lround(0.05 / roll.step));
    std::vector<double> means;
    for (std::size_t i = 0; i + width <= roll.steps.size(); ++i) {
        double sum = 0.0;
        for (std::size_t k = i; k < i + width; ++k) {
            sum += roll.steps[k].*axle / static_cast<double>(width);
        }
        means.push_back(sum);
    }
    return means;
}

}  // namespace

// Over a bump the wheels stay at their radius from its closed form, but for what its triangles
// leave it by; they neither sink in nor catch nor fly. Small triangles carry the same loads at the
// same speed as the extruded curve, in pieces of half a millimetre.
TEST_P(SameGroundTest, BumpIsFeltAsItsCurve) {
    const auto [cell, speed, irregular] = GetParam();
    // Slowly, the front wheels climb half of a shorter bump of the same bend.
    const Bump bump = speed < 0.1 ? Bump{0.005, 0.2, -0.15} : Bump{0.02, 0.4, -0.05};
    const Mechanism cart = narrowCart();
    const double duration = speed < 0.1 ? 5.0 : 1.6;
    const Roll found =
        roll(cart, strip(cell, irregular, [&](double x, double) { return bump.at(x); }), speed,
             duration);
    // Chords of a curve of this bend, up to 1.4 cells long where vertices are moved.
    const double sagitta = bump.bend() * std::pow((irregular ? 1.4 : 1.0) * cell, 2) / 8.0;
    const double radius = cart.wheels[0].radius;
    double highest = 0.0;
    for (const Felt& felt : found.steps) {
        for (const Vec3& center : felt.wheelCenters) {
            // Where wheels settle to, and a hop of one step at a convex edge.
            ASSERT_NEAR(bump.distance(center), radius, sagitta + 1.5e-4) << center.transpose();
            highest = std::max(highest, center.z() - radius);
        }
        ASSERT_GT(felt.speed, 0.0) << "caught on an edge";
    }
    EXPECT_GT(highest, speed < 0.1 ? 0.0015 : 0.019) << "it hardly drove";
    EXPECT_LT(found.penetration, 5e-4);  // the depth that the engine does not push out
    EXPECT_EQ(found.solverMessages, 0);

    std::vector<Eigen::Vector2d> pieces;
    for (int i = -1200; i <= 1200; ++i) {
        pieces.emplace_back(0.0005 * i, bump.at(0.0005 * i));
    }
    const Roll curve = roll(cart, terrain::Terrain::extruded(pieces, -0.2, 0.2), speed, duration);
    const auto wayOf = [](const Roll& roll) {
        return (roll.steps.back().wheelCenters[0] - roll.steps.front().wheelCenters[0]).x();
    };
    EXPECT_NEAR(wayOf(found), wayOf(curve), 0.02 * wayOf(curve) + sagitta);
    if (cell > 0.01) {
        return;  // its edges are obstacles of their own
    }
    for (const auto axle : {&Felt::front, &Felt::rear}) {
        const std::vector<double> loads = smoothed(found, axle);
        const std::vector<double> expected = smoothed(curve, axle);
        ASSERT_GT(loads.size(), 100u);
        for (std::size_t i = 0; i < loads.size(); ++i) {
            ASSERT_NEAR(loads[i], expected[i], 0.05 * found.weight) << "step " << i;
        }
    }
}
