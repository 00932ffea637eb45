#include <cmath>

#include <gtest/gtest.h>

#include "simcore/run/simulation.h"
#include "tests/support/carts.h"
#include "tests/support/walls.h"

using namespace simcore;
using namespace simcore::run;
using namespace testsupport;

namespace {

constexpr double kSlope = 0.3;  // falls to the left, towards the wall [rad]
const CartNumbers kNumbers;
// The left wheels' outer slices stand this far to the left.
constexpr double kReach = 0.2 + 0.45 * 0.05;
constexpr double kGap = 0.004;

terrain::Terrain turnedGround(const terrain::Terrain& ground, const Mat3& R) {
    terrain::TriangleMesh mesh = ground.mesh();
    for (Vec3& vertex : mesh.vertices) {
        vertex = R * vertex;
    }
    return terrain::Terrain::fromMesh(std::move(mesh));
}

/// A cart on a slippery slope that falls towards a wall along its wheels.
ResolvedRun cartByTheWall(double cell, double height) {
    const Mat3 R = Eigen::AngleAxisd(-kSlope, Vec3::UnitX()).toRotationMatrix();
    ResolvedRun run = runOf(turned(makeCart(kNumbers), R),
                            turnedGround(floorAndWall(kReach + kGap, height, cell), R));
    run.friction = 0.05;
    run.rollingResistance = 0.0;
    run.controller = project::ControllerKind::Speed;
    run.headingHold = false;
    return run;
}

/// How far the left wheels' slices are beyond the wall [m].
double beyondWall(const Simulation& simulation) {
    const Vec3 left = Eigen::AngleAxisd(-kSlope, Vec3::UnitX()) * Vec3::UnitY();
    double most = -1.0;
    for (const mechanism::Wheel& wheel : simulation.settings().mechanism.wheels) {
        const Pose& pose = simulation.snapshot().bodies[static_cast<std::size_t>(wheel.body)];
        const Vec3 axis = pose.rotation * wheel.axis;
        const double rim =
            wheel.radius * std::sqrt(std::max(0.0, 1.0 - std::pow(axis.dot(left), 2)));
        most = std::max(most, (pose * wheel.center).dot(left) + rim +
                                  0.45 * wheel.width * std::abs(axis.dot(left)) - kReach - kGap);
    }
    return most;
}

}  // namespace

// A cart that slides sideways without friction comes to lean against a wall or a kerb, which then
// carries m g sin(slope) by its front and rear wheel.
TEST(WallsTest, SlidingCartLeansAgainstTheWall) {
    for (const double height : {0.3, 0.03}) {
        ResolvedRun run = cartByTheWall(2.0, height);
        run.friction = 0.0;
        run.speed = 0.0;
        run.duration = 3.0;
        Simulation simulation(run);
        while (!simulation.finished()) {
            simulation.step();
            // At a kerb it rolls a little when it hits it: then rims stand out over it.
            if (height > kNumbers.comZ) {
                ASSERT_LT(beyondWall(simulation), 0.001) << "t = " << simulation.snapshot().time;
            }
        }
        EXPECT_NEAR(beyondWall(simulation), 0.0, 0.0005) << "it touches";
        const double weight = run.mechanism.mass() * dynamics::kGravity;
        const std::vector<WheelState>& wheels = simulation.snapshot().wheels;
        double sum = 0.0;
        for (const WheelState& wheel : wheels) {
            sum += wheel.lateralForce;
        }
        EXPECT_NEAR(sum, -weight * std::sin(kSlope), 0.01 * weight) << "height " << height;
        for (const std::size_t left : {0U, 2U}) {
            EXPECT_LT(wheels[left].lateralForce, -0.35 * weight * std::sin(kSlope));
        }
        EXPECT_NEAR(wheels[1].lateralForce, 0.0, 0.01 * weight) << "on the right";
    }
}

// It drives along the wall, whatever triangles that is made of: held off it, and not caught.
TEST(WallsTest, CartDrivesAlongTheWall) {
    for (const double cell : {2.0, 0.01}) {
        ResolvedRun run = cartByTheWall(cell, 0.1);
        run.settle = 1.0;
        run.speed = 0.1;
        run.duration = 4.0;
        Simulation simulation(run);
        double least = 1.0;
        while (!simulation.finished()) {
            simulation.step();
            ASSERT_LT(beyondWall(simulation), 0.001) << "t = " << simulation.snapshot().time;
            if (simulation.snapshot().time > 2.0) {
                least = std::min(least, simulation.snapshot().speed);
            }
        }
        EXPECT_GT(beyondWall(simulation), -1e-4) << "it stays at the wall";
        EXPECT_GT(least, 0.09) << "cell " << cell;
    }
}
