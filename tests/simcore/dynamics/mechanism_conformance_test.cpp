// Mechanisms with joints on every engine that has them: closed forms of linkages, energy, gears.
#include <cmath>
#include <numbers>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/engine_cases.h"
#include "tests/support/linkages.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::dynamics;
using namespace testsupport;

namespace {

constexpr double kPi = std::numbers::pi;

double turn(const World& world, int joint) {
    return jointAngle(world.mechanism().joints[static_cast<std::size_t>(joint)],
                      world.engine().poses());
}

class MechanismConformanceTest : public ::testing::TestWithParam<EngineCase> {};

/// A rod that hangs level from a pin in a fixed frame.
struct Pendulum {
    double mass = 0.8;                          ///< [kg]
    double arm = 0.3;                           ///< pin to centre of mass [m]
    double inertia = 0.024 + mass * arm * arm;  ///< about the pin [kg m^2]

    Mechanism make() const {
        Mechanism mechanism;
        mechanism.bodies = {makeBody("frame", 5.0, Vec3::Zero()),
                            makeBody("rod", mass, {arm, 0.0, 0.0}, {1e-3, 0.024, 0.024})};
        mechanism.bodies[0].fixed = true;
        mechanism.joints = {makePin("pin", 0, 1, Vec3::Zero())};
        return mechanism;
    }
};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Engines, MechanismConformanceTest,
                         ::testing::ValuesIn(enginesThatCan(Can::Joints)), nameOfCase);

// A rod released level swings through its lowest point after a quarter of the large-swing period,
// at the rate that energy gives.
TEST_P(MechanismConformanceTest, PendulumKeepsTimeAndEnergy) {
    const Pendulum rod;
    World world(GetParam(), rod.make(), kGravity, 0.0005);
    const double quarter = 0.5 * kPi * std::sqrt(rod.inertia / (rod.mass * kGravity * rod.arm)) *
                           periodFactor(kPi / 2.0);
    world.run(quarter);
    EXPECT_NEAR(turn(world, 0), kPi / 2.0, 5e-3);  // a turn about +y takes +x down
    EXPECT_NEAR(
        jointRate(world.mechanism().joints[0], world.engine().poses(), world.engine().velocities()),
        std::sqrt(2.0 * rod.mass * kGravity * rod.arm / rod.inertia), 5e-3);
    world.run(quarter);
    EXPECT_NEAR(turn(world, 0), kPi, 2e-2);
}

// Dry friction brakes a turning body by its torque, evenly, and then holds it still.
TEST_P(MechanismConformanceTest, DryFrictionBrakesEvenly) {
    Mechanism mechanism;
    mechanism.bodies = {makeBody("frame", 1.0, Vec3::Zero()),
                        makeBody("flywheel", 2.0, Vec3::Zero())};
    mechanism.bodies[0].fixed = true;
    mechanism.joints = {makePin("axle", 0, 1, Vec3::Zero())};
    mechanism.joints[0].friction = 0.03;
    const double inertia = mechanism.bodies[1].inertia(1, 1);
    constexpr double kRate = 2.0;
    World world(GetParam(), mechanism, kGravity);
    world.motors = {{0, kRate, 1e6}};
    world.step();
    world.motors.clear();
    const double braking = mechanism.joints[0].friction / inertia;
    constexpr double kTime = 0.5;
    world.run(kTime);
    ASSERT_GT(kRate, braking * kTime) << "it is to turn still";
    EXPECT_NEAR(jointRate(mechanism.joints[0], world.engine().poses(), world.engine().velocities()),
                kRate - braking * kTime, 1e-3 * kRate);
    world.run(1.0);
    EXPECT_NEAR(jointRate(mechanism.joints[0], world.engine().poses(), world.engine().velocities()),
                0.0, 1e-6);
}

// A rod that leans stays up by its pin's dry friction up to m g l sin(lean), and falls beyond.
TEST_P(MechanismConformanceTest, DryFrictionHoldsUpToItsTorque) {
    for (const double share : {0.98, 1.02}) {
        const Pendulum rod;
        Mechanism mechanism = rod.make();
        // Drawn level: the whole weight turns it.
        mechanism.joints[0].friction = rod.mass * kGravity * rod.arm / share;
        World world(GetParam(), mechanism, kGravity);
        world.run(1.0);
        if (share < 1.0) {
            EXPECT_NEAR(turn(world, 0), 0.0, 1e-4);
        } else {
            EXPECT_GT(std::abs(turn(world, 0)), 0.01);
        }
    }
}

// The pin of a swinging rod carries its weight and the centripetal force: m g (1 + 2 m l^2 / I) at
// the lowest point after a fall from level.
TEST_P(MechanismConformanceTest, PinReactionIsThatOfTheSwing) {
    const Pendulum rod;
    World world(GetParam(), rod.make(), kGravity, 0.0005);
    double largest = 0.0;
    for (int i = 0; i < 2000; ++i) {
        world.step();
        largest = std::max(largest, world.engine().jointReactions()[0].force.z());
        EXPECT_NEAR(world.engine().jointReactions()[0].torque.norm(), 0.0, 1e-6);
    }
    const double expected =
        rod.mass * kGravity * (1.0 + 2.0 * rod.mass * rod.arm * rod.arm / rod.inertia);
    EXPECT_NEAR(largest, expected, 5e-3 * expected);
}

// A four-bar that swings under its weight goes on to swing with the energy it had. In 5 s at 2 ms
// the means over the first and the last second differ by less than 0.1 % of the energy that goes to
// and fro, and no step is off by more than 1 %: forces and poses of a step are half a step apart.
TEST_P(MechanismConformanceTest, FourBarKeepsItsEnergyUnderGravity) {
    constexpr double kTwo = 0.002;
    World world(GetParam(), FourBar().make(1.0), kGravity, kTwo);
    const auto energy = [&world] {
        double sum = world.kineticEnergy();
        for (std::size_t i = 0; i < world.mechanism().bodies.size(); ++i) {
            const Body& body = world.mechanism().bodies[i];
            sum += body.mass * kGravity * (world.engine().poses()[i] * body.com).z();
        }
        return sum;
    };
    const double start = energy();
    const int second = static_cast<int>(std::lround(1.0 / kTwo));
    double most = 0.0;
    double worst = 0.0;
    double first = 0.0;
    double last = 0.0;
    for (int i = 0; i < 5 * second; ++i) {
        world.step();
        most = std::max(most, world.kineticEnergy());
        worst = std::max(worst, std::abs(energy() - start));
        first += i < second ? energy() / second : 0.0;
        last += i >= 4 * second ? energy() / second : 0.0;
    }
    ASSERT_GT(most, 0.3) << "it is to swing";
    EXPECT_NEAR(last, first, 0.001 * most);
    EXPECT_LT(worst, 0.01 * most);
}

// A driven crank takes the follower where the closed form of the loop says, all around.
TEST_P(MechanismConformanceTest, FourBarFollowsItsClosedForm) {
    const FourBar bar;
    const double start = 1.0;
    World world(GetParam(), bar.make(start), kGravity);
    world.motors = {{0, -2.0, 1e6}};  // a turn about +y takes +x to -z
    double swing = 0.0;
    for (int i = 0; i < 3500; ++i) {
        world.step();
        const double crank = start - turn(world, 0);
        const double follower = bar.followerAngle(start) - turn(world, 3);
        ASSERT_NEAR(std::remainder(follower - bar.followerAngle(crank), 2.0 * kPi), 0.0, 2e-5)
            << "crank at " << crank;
        ASSERT_LT(loopError(world.mechanism(), world.engine().poses()), 1e-5);
        swing = std::max(swing, std::abs(turn(world, 3)));
    }
    EXPECT_GT(swing, 0.5);
}

// Bennett's loop turns all around and stays closed, although it counts as held.
TEST_P(MechanismConformanceTest, BennettStaysClosed) {
    const Mechanism mechanism = mechanismOf("../mechanisms/bennett");
    World world(GetParam(), mechanism, 0.0);
    world.motors = {{0, 2.0, 1e6}};
    std::vector<double> widest(4, 0.0);
    for (int i = 0; i < 3500; ++i) {
        world.step();
        ASSERT_LT(loopError(mechanism, world.engine().poses()), 1e-5) << "at step " << i;
        for (int k = 0; k < 4; ++k) {
            double& w = widest[static_cast<std::size_t>(k)];
            w = std::max(w, std::abs(turn(world, k)));
        }
    }
    for (const double w : widest) {
        EXPECT_GT(w, 3.0) << "every hinge turns all around";
    }
}

// A rover floating in space, its wheels spun up and its bogies swinging: with neither springs nor
// damping its energy changes by less than 0.15 % in 10 s.
TEST_P(MechanismConformanceTest, FloatingRoverKeepsItsEnergy) {
    Mechanism rover = mechanismOf("bench_rover");
    rover.springs.clear();
    for (Joint& joint : rover.joints) {
        joint.damping = 0.0;
    }
    for (const mechanism::Model joints : {mechanism::Model::Built, mechanism::Model::Relaxed}) {
        World world(GetParam(), rover, 0.0, 0.001, joints);
        for (std::size_t i = 0; i < world.drive.size(); ++i) {
            world.drive[i] = i % 2 == 0 ? 0.05 : -0.04;
        }
        world.run(0.3);
        world.drive.assign(world.drive.size(), 0.0);
        const double start = world.kineticEnergy();
        const Vec3 momentum = world.momentum();
        ASSERT_GT(start, 0.1);
        world.run(10.0);
        EXPECT_NEAR(world.kineticEnergy(), start, 0.0015 * start);
        EXPECT_LT((world.momentum() - momentum).norm(), 1e-5);
    }
}

// Four worlds in threads end as one alone: to the last bit.
TEST_P(MechanismConformanceTest, RoversInThreadsEndAsAlone) {
    const auto run = [&] {
        World world(GetParam(), mechanismOf("solero"), kGravity, 0.002);
        const terrain::Terrain ground = levelGround();
        world.placeOn(ground, 0.7);
        world.drive.assign(world.drive.size(), 0.3);
        world.run(0.3);
        return world.engine().saveState();
    };
    const std::vector<double> alone = run();
    std::vector<std::vector<double>> together(4);
    std::vector<std::thread> threads;
    for (auto& state : together) {
        threads.emplace_back([&state, &run] { state = run(); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (const auto& state : together) {
        EXPECT_EQ(state, alone);
    }
}

namespace {

/// The mirror image of a mechanism, y to -y.
Mechanism mirrored(Mechanism mechanism) {
    const auto point = [](Vec3& p) { p.y() = -p.y(); };
    const auto axis = [](Vec3& a) { a = Vec3(-a.x(), a.y(), -a.z()); };
    for (Body& body : mechanism.bodies) {
        point(body.com);
        body.inertia(0, 1) = body.inertia(1, 0) = -body.inertia(0, 1);
        body.inertia(1, 2) = body.inertia(2, 1) = -body.inertia(1, 2);
    }
    for (Joint& joint : mechanism.joints) {
        point(joint.point);
        axis(joint.axis);
        for (auto* freedoms : {&joint.built, &joint.relaxed}) {
            for (Freedom& freedom : *freedoms) {
                freedom.kind == FreedomKind::Turn ? axis(freedom.direction)
                                                  : point(freedom.direction);
            }
        }
    }
    for (Wheel& wheel : mechanism.wheels) {
        point(wheel.center);
        axis(wheel.axis);
    }
    for (auto& spring : mechanism.springs) {
        point(spring.firstPoint);
        point(spring.secondPoint);
    }
    return mechanism;
}

/// Ground that differs left and right: waves that run at an angle.
terrain::Terrain obliqueWaves(double side) {
    constexpr double kCell = 0.02;
    const int nx = 200;
    const int ny = 101;
    std::vector<double> heights;
    for (int ix = 0; ix < nx; ++ix) {
        for (int iy = 0; iy < ny; ++iy) {
            const double x = -1.0 + kCell * ix;
            const double y = side * (-1.0 + kCell * iy);
            const double share = std::clamp((x - 0.45) / 0.3, 0.0, 1.0);
            heights.push_back(0.02 * share * (1.0 - std::cos(9.0 * (x - 0.45) + 4.0 * y)));
        }
    }
    return terrain::Terrain::grid(-1.0, -1.0, kCell, nx, ny, heights);
}

}  // namespace

// A rover that is not the same left and right, on such ground, and the mirror image of both: the
// second run is the mirror image of the first, as exactly as friction is iterated (to 2 % of a
// limit).
TEST_P(MechanismConformanceTest, MirroredRoverMakesTheMirroredRun) {
    Mechanism rover = mechanismOf("solero");
    rover.bodies[static_cast<std::size_t>(rover.chassis)].com.y() += 0.02;
    World left(GetParam(), rover, kGravity, 0.002);
    World right(GetParam(), mirrored(rover), kGravity, 0.002);
    const terrain::Terrain ground = obliqueWaves(1.0);
    const terrain::Terrain mirror = obliqueWaves(-1.0);
    left.placeOn(ground, 0.7);
    right.placeOn(mirror, 0.7);
    left.drive.assign(left.drive.size(), 0.12);
    right.drive = left.drive;
    double away = 0.0;
    for (int i = 0; i < 1500; ++i) {
        left.step();
        right.step();
        for (std::size_t k = 0; k < rover.bodies.size(); ++k) {
            const Vec3& p = left.engine().poses()[k].position;
            const Vec3& q = right.engine().poses()[k].position;
            ASSERT_LT((p - Vec3(q.x(), -q.y(), q.z())).norm(), 1e-3) << "at step " << i;
            away = std::max(away, std::abs(p.y()));
        }
    }
    EXPECT_GT(left.engine().poses()[0].position.x(), 0.2) << "it hardly drove";
    EXPECT_GT(away, 1e-3) << "nothing was different left and right";
}

// A bevel gear between two rockers makes the chassis pitch by their mean, however it tilts: with
// one wheel lifted, by half of that rocker's turn.
TEST_P(MechanismConformanceTest, GearDifferentialPitchesByTheMean) {
    Mechanism rocker = makeDifferential(-1.0);
    rocker.joints[1] = makePin("right", 0, 2, {0.02, -0.25, 0.3});
    World world(GetParam(), rocker, 0.0);
    const auto pitch = [&](std::size_t body) {
        const Eigen::Quaterniond& q = world.engine().poses()[body].rotation;
        return 2.0 * std::atan2(q.y(), q.w());
    };
    std::vector<JointMotor> lift{{0, 0.5, 0.3}};
    world.motors = lift;
    world.run(0.5);
    EXPECT_GT(std::abs(pitch(1) - pitch(2)), 0.1);
    EXPECT_NEAR(pitch(0), 0.5 * (pitch(1) + pitch(2)), 1e-5);
}

namespace {

/// The bar differential of the shipped rocker-bogie, about its rocker pivots: an arm stands up from
/// each rocker, a rod leads from its tip back to the end of a bar that turns on an upright pin.
struct BarDifferential {
    double arm, rod, half;  ///< height of the arms, length of rods, half of the bar [m]

    /// Ways that a rod of constant length lets its ends come nearer along x, when they part
    /// sideways by the turned bar and in height by the turned rocker [m].
    double shortening(double rocker, double bar) const {
        const double side = half * (1.0 - std::cos(bar));
        const double down = arm * (1.0 - std::cos(rocker));
        return rod - std::sqrt(rod * rod - side * side - down * down);
    }

    /// Turn of the right rocker for one of the left [rad], both against the chassis.
    double right(double left) const {
        // arm sin(left) + half sin(bar) = -shortening, and the same with the other end of the bar:
        // solved from the first order on. Each round gains at least a factor of 10.
        double bar = -arm * left / half;
        double other = -left;
        for (int i = 0; i < 40; ++i) {
            bar = std::asin((-shortening(left, bar) - arm * std::sin(left)) / half);
            other = std::asin((-shortening(other, bar) + half * std::sin(bar)) / arm);
        }
        return other;
    }

    /// By how much the sum of both turns is not 0: the shortening of both rods to lowest order,
    /// over the arm [rad]. What comes after it is of the sixth order, a seventh of it at 0.5 rad.
    double excess(double turn) const {
        return arm / (4.0 * rod) * (1.0 + arm * arm / (half * half)) * std::pow(turn, 4);
    }
};

}  // namespace

// A bar makes the chassis pitch by the mean of the rockers as well, to the third order of their
// turns: with one wheel lifted, by half of the rockers' difference. What is left is the closed form
// of the linkage, all the way to the stops at 45 deg.
TEST_P(MechanismConformanceTest, BarDifferentialPitchesByNearlyTheMean) {
    const Mechanism rover = mechanismOf("rocker_bogie_bar");
    const auto point = [&](const std::string& joint) {
        return rover.joints.at(static_cast<std::size_t>(rover.findJoint(joint))).point;
    };
    const int left = rover.findJoint("rocker_pivot_left");
    const int right = rover.findJoint("rocker_pivot_right");
    const Vec3 tip = point("rod_front_left");
    const Vec3 end = point("rod_rear_left");
    const BarDifferential bar{(tip - point("rocker_pivot_left")).z(), (tip - end).x(), end.y()};
    World world(GetParam(), rover, 0.0);
    world.motors = {{left, 0.5, 50.0}};
    double r = 0.0;
    for (int i = 0; i < 1500 && r > -0.77; ++i) {
        world.step();
        const double l = turn(world, left);
        r = turn(world, right);
        ASSERT_NEAR(r, bar.right(l), 2e-5) << "left rocker at " << l;
        // The chassis' turn against the mean of the rockers: 0.15 mrad at 0.2 rad, 6.5 at 0.5.
        if (std::abs(l) < 0.5) {
            ASSERT_LT(std::abs(0.5 * (l + r)), 0.6 * bar.excess(l) + 2e-5) << "left at " << l;
        }
    }
    EXPECT_LT(r, -0.77);
}
