#include "simcore/statics/pose_solver.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simcore/dynamics/engine.h"
#include "simcore/run/simulation.h"
#include "simcore/statics/static_study.h"
#include "tests/support/carts.h"
#include "tests/support/projects.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::statics;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

terrain::Terrain slope(double angle) {
    const double rise = 20.0 * std::tan(angle);
    return terrain::Terrain::extruded({{-20.0, -rise}, {20.0, rise}}, -20.0, 20.0);
}

run::ResolvedRun prepared(const std::string& name, const std::string& scenario) {
    run::RunRequest request;
    request.scenario = scenario;
    request.files.folder = testsupport::shippedFile(name).parent_path();
    auto run = run::prepareRun(testsupport::shipped(name), request);
    if (!run) {
        throw std::runtime_error(toString(run.problems()));
    }
    return std::move(run).value();
}

/// From a wheel's rim to a polyline under it, < 0 inside.
double gapTo(const std::vector<Eigen::Vector2d>& profile, const Vec3& center, double radius) {
    const Eigen::Vector2d c(center.x(), center.z());
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const Eigen::Vector2d along = profile[i + 1] - profile[i];
        const double share =
            std::clamp((c - profile[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (profile[i] + share * along - c).norm());
    }
    return least - radius;
}

/// The loads that statics finds for the engine's own torques, to a share of a wheel's mean load.
void expectLoadsOf(const run::Snapshot& now, StaticModel& model, const StandingPose& pose,
                   double share) {
    const mechanism::Mechanism& mechanism = model.mechanism();
    const std::vector<Contact> contacts = rollingAlong(pose);
    dynamics::TreeState state = pose.state;
    model.place(state);
    const Traction traction(
        model.equilibrium(contacts, ContactSet::Free, dynamics::kGravity, stopsOf(model, pose)),
        mechanism, contacts);
    std::vector<double> torques;
    for (const run::WheelState& wheel : now.wheels) {
        torques.push_back(wheel.torqueApplied);
    }
    const Forces forces = traction.under(torques);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const auto w = static_cast<std::size_t>(contacts[i].wheel);
        EXPECT_NEAR(forces.normal[i], now.wheels[w].normalForce,
                    share * mechanism.mass() * dynamics::kGravity / 6.0)
            << mechanism.wheels[w].name << " at " << now.time << " s";
    }
}

}  // namespace

TEST(PoseSolverTest, LevelGroundKeepsTheDrawnPose) {
    const terrain::Terrain ground = slope(0.0);
    for (const std::string& name : testsupport::shippedNames()) {
        const mechanism::Mechanism mechanism = testsupport::mechanismOf(name);
        StaticModel model(mechanism, Model::Built);
        PoseSolver solver(model, ground);
        const StandingPose pose = solver.settle({0.3, -0.2, 0.7});
        ASSERT_EQ(pose.standing, Standing::Stands) << name;
        EXPECT_EQ(pose.footholds.size(), mechanism.wheels.size()) << name;
        const Pose& chassis = pose.bodies[static_cast<std::size_t>(mechanism.chassis)];
        EXPECT_NEAR(chassis.position.x(), 0.3, 1e-9) << name;
        EXPECT_NEAR(chassis.position.y(), -0.2, 1e-9) << name;
        EXPECT_NEAR(chassis.position.z(), 0.0, 1e-7) << name;
        EXPECT_LT(
            (chassis.rotation * Vec3::UnitX() - Vec3(std::cos(0.7), std::sin(0.7), 0.0)).norm(),
            1e-6)
            << name;
    }
}

// Along a slope, across it and at an angle to it the required friction is the tangent.
TEST(PoseSolverTest, SlopesAskForTheirTangent) {
    const mechanism::Mechanism solero = testsupport::mechanismOf("solero");
    for (const double angle : {5.0, 10.0, 15.0}) {
        const terrain::Terrain ground = slope(angle * kDegree);
        for (const double heading : {0.0, 90.0, 30.0}) {
            StaticModel model(solero, Model::Built);
            PoseSolver solver(model, ground);
            const StandingPose pose = solver.settle({0.0, 0.0, heading * kDegree});
            ASSERT_EQ(pose.standing, Standing::Stands);
            ASSERT_EQ(pose.footholds.size(), 6U);
            const Study study = studyPose(model, pose, ContactSet::All);
            ASSERT_TRUE(study.feasible);
            EXPECT_NEAR(study.frictionRequired, std::tan(angle * kDegree), 1e-6)
                << angle << " deg, heading " << heading;
        }
    }
}

// The gap of every wheel to the polyline, worked out anew; the rover stands wherever it is put.
TEST(PoseSolverTest, StandsAnywhereOnRoughProfiles) {
    for (const std::string name : {"solero", "shrimp", "rocker_bogie", "rocker_bogie_bar"}) {
        const run::ResolvedRun run = prepared(name, "rough-profile");
        StaticModel model(run.mechanism, Model::Built);
        PoseSolver solver(model, *run.terrain);
        for (double x = 0.0; x < 3.0; x += 0.083) {
            const StandingPose pose = solver.settle({x, 0.0, 0.0});
            ASSERT_EQ(pose.standing, Standing::Stands) << name << " at " << x;
            for (std::size_t w = 0; w < run.mechanism.wheels.size(); ++w) {
                const mechanism::Wheel& wheel = run.mechanism.wheels[w];
                const double gap = gapTo(
                    run.terrain->profile(),
                    pose.bodies[static_cast<std::size_t>(wheel.body)] * wheel.center, wheel.radius);
                const bool touches = std::any_of(
                    pose.footholds.begin(), pose.footholds.end(),
                    [&](const auto& f) { return f.contact.wheel == static_cast<int>(w); });
                EXPECT_GT(gap, -1e-5) << name << " at " << x << ' ' << wheel.name;
                if (touches) {
                    EXPECT_LT(gap, 1e-5) << name << " at " << x << ' ' << wheel.name;
                }
            }
        }
    }
}

// On ground that differs left and right, too, and from the pose before as from above.
TEST(PoseSolverTest, ColdAndWarmStartsAgree) {
    const run::ResolvedRun run = prepared("solero", "rough-3d");
    StaticModel model(run.mechanism, Model::Built);
    PoseSolver solver(model, *run.terrain);
    StandingPose last = solver.settle({0.0, 0.0, 0.0});
    int compared = 0;
    for (double x = 0.02; x < 3.0; x += 0.02) {
        const StandingPose warm = solver.settleFrom(last.state, {x, 0.0, 0.0});
        const StandingPose cold = solver.settle({x, 0.0, 0.0});
        ASSERT_EQ(cold.standing, Standing::Stands) << x;
        if (warm.standing == Standing::Stands) {
            const Vec3 apart = warm.bodies[0].position - cold.bodies[0].position;
            compared += apart.norm() < 1e-5 ? 1 : 0;
        }
        last = cold;
    }
    // Where a wheel stands before or behind an edge both may be right.
    EXPECT_GE(compared, 140);
}

TEST(PoseSolverTest, SaysWhyThereIsNoPose) {
    const mechanism::Mechanism solero = testsupport::mechanismOf("solero");
    const terrain::Terrain small = terrain::Terrain::extruded({{-1.0, 0.0}, {1.0, 0.0}}, -1.0, 1.0);
    StaticModel model(solero, Model::Built);
    PoseSolver solver(model, small);
    EXPECT_EQ(solver.settle({5.0, 0.0, 0.0}).standing, Standing::NoGround);
    // The centre of mass is beyond the border of the ground.
    const Standing beyond = solver.settle({1.15, 0.0, 0.0}).standing;
    EXPECT_TRUE(beyond == Standing::Tips || beyond == Standing::NoGround);
    // What it found before does not matter.
    EXPECT_EQ(solver.settle({0.0, 0.0, 0.0}).standing, Standing::Stands);
}

// The engine drives SOLERO onto an obstacle and stops there; statics is given where it stands and
// the torques of its wheels.
TEST(PoseSolverTest, AgreesWithTheEngineAtRest) {
    for (const double drive : {7.0, 10.0, 14.0, 18.0}) {
        project::Project project = testsupport::shipped("solero");
        for (project::Scenario& scenario : project.scenarios) {
            scenario.controller.kind = project::ControllerKind::Manual;
            scenario.soil.rollingResistance = 0.0;
        }
        run::RunRequest request;
        request.scenario = "rough-profile";
        request.engine = project::EngineKind::Reduced;
        request.duration = 60.0;
        request.step = 0.001;
        auto resolved = run::prepareRun(project, request);
        ASSERT_TRUE(resolved);
        run::Simulation simulation(std::move(resolved).value());
        simulation.setManualCommand({0.1, 0.0});
        while (simulation.snapshot().time < drive) {
            simulation.step();
        }
        simulation.setManualCommand({0.0, 0.0});
        while (simulation.snapshot().time < drive + 5.0) {
            simulation.step();
        }
        const run::ResolvedRun& run = simulation.settings();
        const run::Snapshot& end = simulation.snapshot();
        const Pose& chassis = end.bodies[static_cast<std::size_t>(run.mechanism.chassis)];
        StaticModel model(run.mechanism, Model::Built);
        PoseSolver solver(model, *run.terrain);
        const StandingPose pose = solver.settle({chassis.position.x(), chassis.position.y(), 0.0});
        ASSERT_EQ(pose.standing, Standing::Stands);
        const auto joints = run.mechanism.encoderJoints();
        for (std::size_t k = 0; k < joints.size(); ++k) {
            const mechanism::Joint& joint =
                run.mechanism.joints[static_cast<std::size_t>(joints[k])];
            EXPECT_NEAR(mechanism::jointAngle(joint, pose.bodies), end.joints[k].angle,
                        0.1 * kDegree)
                << joint.name << " after " << drive << " s";
        }
        if (pose.footholds.size() != run.mechanism.wheels.size()) {
            continue;  // a wheel between floor and wall: how it shares its load is the engine's
        }
        expectLoadsOf(end, model, pose, 0.01);
    }
}

// Lowered over a trench a rover comes to rest with its front in it, however far it falls on the
// way.
TEST(PoseSolverTest, ComesToRestInATrench) {
    StaticModel model(testsupport::mechanismOf("solero"), Model::Built);
    const terrain::Terrain ground = terrain::Terrain::extruded(
        {{-20.0, 0.0}, {0.6, 0.0}, {0.6, -0.6}, {0.95, -0.6}, {0.95, 0.0}, {20.0, 0.0}}, -5.0, 5.0);
    PoseSolver solver(model, ground);
    int reached = 0;
    int all = 0;
    for (double x = 0.2; x < 0.8; x += 0.02) {
        const StandingPose pose = solver.settle({x, 0.0, 0.0});
        reached += pose.standing == Standing::Stands || pose.standing == Standing::Tips ? 1 : 0;
        ++all;
    }
    EXPECT_GE(reached, all - 2);
    EXPECT_EQ(solver.settle({0.3, 0.0, 0.0}).standing, Standing::Stands);
    const StandingPose hangs = solver.settle({0.72, 0.0, 0.0});
    EXPECT_EQ(hangs.standing, Standing::Stands);
}

// Over a hole under one side the middle wheel hangs, its bogie at its stop; the engine is driven
// there and stops, and statics is given where it stands and the torques of its wheels.
TEST(PoseSolverTest, AHangingWheelHangsAsInTheEngine) {
    for (const char* rover : {"rocker_bogie", "rocker_bogie_bar"}) {
        SCOPED_TRACE(rover);
        project::Project project = testsupport::shipped(rover);
        for (project::Joint& joint : project.rover.joints) {
            if (joint.name == "bogie_pivot") {
                joint.stops = {
                    {project::Quantity{-5.0 * kDegree}, project::Quantity{5.0 * kDegree}}};
            }
        }
        for (project::Scenario& scenario : project.scenarios) {
            scenario.controller.kind = project::ControllerKind::Manual;
            scenario.soil.rollingResistance = 0.0;
            if (scenario.name == "flat") {
                scenario.terrain = {};
                scenario.terrain.kind = project::TerrainKind::Trench;
                scenario.terrain.start = 0.6;
                scenario.terrain.length = 0.3;
                scenario.terrain.sides = project::Sides::Left;
                scenario.terrain.height = 2.0;
            }
        }
        run::RunRequest request;
        request.scenario = "flat";
        request.engine = project::EngineKind::Reduced;
        request.duration = 60.0;
        request.step = 0.001;
        auto resolved = run::prepareRun(project, request);
        ASSERT_TRUE(resolved) << toString(resolved.problems());
        run::Simulation simulation(std::move(resolved).value());
        constexpr double kDrive = 8.0;  // [s]
        simulation.setManualCommand({0.1, 0.0});
        while (simulation.snapshot().time < kDrive) {
            simulation.step();
        }
        simulation.setManualCommand({0.0, 0.0});
        while (simulation.snapshot().time < kDrive + 8.0) {
            simulation.step();
        }
        const run::ResolvedRun& run = simulation.settings();
        const run::Snapshot& end = simulation.snapshot();
        const Pose& chassis = end.bodies[static_cast<std::size_t>(run.mechanism.chassis)];
        StaticModel model(run.mechanism, Model::Built);
        PoseSolver solver(model, *run.terrain);
        const StandingPose pose = solver.settle({chassis.position.x(), chassis.position.y(), 0.0});
        ASSERT_EQ(pose.standing, Standing::Stands);
        EXPECT_EQ(pose.jointsAtStop.size(), 1U);
        const auto hanging = static_cast<std::size_t>(run.mechanism.findWheel("left_middle"));
        EXPECT_EQ(pose.footholds.size(), run.mechanism.wheels.size() - 1);
        EXPECT_EQ(end.wheels[hanging].normalForce, 0.0);
        const auto joints = run.mechanism.encoderJoints();
        for (std::size_t k = 0; k < joints.size(); ++k) {
            const mechanism::Joint& joint =
                run.mechanism.joints[static_cast<std::size_t>(joints[k])];
            EXPECT_NEAR(mechanism::jointAngle(joint, pose.bodies), end.joints[k].angle,
                        0.1 * kDegree)
                << joint.name;
        }
        const Study study = studyPose(model, pose, std::nullopt);
        EXPECT_TRUE(study.feasible);
        EXPECT_FALSE(study.wheels[hanging].touches);
        EXPECT_EQ(study.wheels[hanging].normal, 0.0);
        expectLoadsOf(end, model, pose, 0.01);
    }
}

// A fifth wheel on an arm behind a cart, over a hole: only a spring about the arm's pin holds it,
// where
//     preload - k angle = moment of arm and wheel about the pin.
TEST(PoseSolverTest, ASpringAloneHoldsAWheelOverAHole) {
    constexpr double kStiffness = 10.0;  // [N m/rad]
    constexpr double kPreload = 1.0;     // [N m]
    constexpr double kArm = 0.3;         // [m]
    constexpr double kArmMass = 0.3;     // [kg]
    const testsupport::CartNumbers numbers;
    mechanism::Mechanism cart = testsupport::makeCart(numbers);
    const Vec3 pivot(-numbers.halfBase, 0.0, numbers.radius);
    const Vec3 hub = pivot - Vec3(kArm, 0.0, 0.0);
    const int arm = static_cast<int>(cart.bodies.size());
    cart.bodies.push_back(testsupport::makeBody("arm", kArmMass, 0.5 * (pivot + hub)));
    cart.bodies.push_back(cart.bodies[static_cast<std::size_t>(cart.wheels[0].body)]);
    cart.bodies.back().name = "trailing";
    cart.bodies.back().com = hub;
    cart.joints.push_back(testsupport::makePin("arm_pivot", 0, arm, pivot));
    const int pin = static_cast<int>(cart.joints.size()) - 1;
    cart.joints.push_back(testsupport::makePin("trailing_axle", arm, arm + 1, hub));
    mechanism::Wheel wheel = cart.wheels[0];
    wheel.name = "trailing";
    wheel.body = arm + 1;
    wheel.axle = pin + 1;
    wheel.carrier = arm;
    wheel.center = hub;
    cart.wheels.push_back(wheel);
    mechanism::Spring spring;
    spring.name = "arm_spring";
    spring.joint = pin;
    spring.first = 0;
    spring.second = arm;
    spring.stiffness = kStiffness;
    spring.preload = kPreload;
    cart.springs = {spring};
    const terrain::Terrain ground = terrain::Terrain::extruded(
        {{-20.0, 0.0}, {-0.75, 0.0}, {-0.75, -2.0}, {-0.25, -2.0}, {-0.25, 0.0}, {20.0, 0.0}}, -5.0,
        5.0);

    const double moment = dynamics::kGravity * kArm * (0.5 * kArmMass + numbers.wheelMass);
    double angle = 0.0;  // the fixed point contracts: moment / stiffness is 0.2
    for (int i = 0; i < 50; ++i) {
        angle = (kPreload - moment * std::cos(angle)) / kStiffness;
    }
    ASSERT_LT(angle, -0.05);

    StaticModel model(cart, Model::Built);
    PoseSolver solver(model, ground);
    const StandingPose pose = solver.settle({0.0, 0.0, 0.0});
    ASSERT_EQ(pose.standing, Standing::Stands);
    EXPECT_EQ(pose.footholds.size(), 4U);
    EXPECT_TRUE(pose.jointsAtStop.empty());
    EXPECT_NEAR(mechanism::jointAngle(cart.joints[static_cast<std::size_t>(pin)], pose.bodies),
                angle, 1e-6);
    const Study study = studyPose(model, pose, std::nullopt);
    EXPECT_TRUE(study.feasible);
    EXPECT_FALSE(study.wheels.back().touches);
    EXPECT_EQ(study.wheels.back().normal, 0.0);
    // What hangs behind the rear axle takes load off the front.
    const double front =
        (dynamics::kGravity * (numbers.chassisMass + 4.0 * numbers.wheelMass) * numbers.halfBase -
         moment * std::cos(angle)) /
        (2.0 * numbers.halfBase);
    EXPECT_NEAR(study.wheels[0].normal + study.wheels[1].normal, front, 1e-6 * front);
}

// At 0.1 m/s up a ramp and across its foot: the loads that statics finds for the engine's torques.
TEST(PoseSolverTest, LoadsOfADriveUpARampAreThoseOfStatics) {
    project::Project project = testsupport::shipped("solero");
    for (project::Scenario& scenario : project.scenarios) {
        if (scenario.name == "flat") {
            scenario.terrain = {};
            scenario.terrain.kind = project::TerrainKind::Ramp;
            scenario.terrain.start = 0.6;
            scenario.terrain.slope = 12.0 * kDegree;
            scenario.terrain.length = 5.0;
            scenario.soil.rollingResistance = 0.0;
            scenario.controller.kind = project::ControllerKind::Torque;
        }
    }
    run::RunRequest request;
    request.scenario = "flat";
    request.engine = project::EngineKind::Reduced;
    request.step = 0.001;
    request.distance = 2.0;
    auto resolved = run::prepareRun(project, request);
    ASSERT_TRUE(resolved) << toString(resolved.problems());
    run::Simulation simulation(std::move(resolved).value());
    const run::ResolvedRun& run = simulation.settings();
    StaticModel model(run.mechanism, Model::Built);
    PoseSolver solver(model, *run.terrain);
    int compared = 0;
    while (!simulation.finished()) {
        simulation.step();
        const run::Snapshot& now = simulation.snapshot();
        if (now.step % 1000 != 0 || now.time < 3.0) {
            continue;
        }
        const StandingPose pose = solver.settle({now.distance, 0.0, 0.0});
        ASSERT_EQ(pose.standing, Standing::Stands);
        if (pose.footholds.size() != run.mechanism.wheels.size()) {
            continue;
        }
        expectLoadsOf(now, model, pose, 0.03);
        ++compared;
    }
    EXPECT_GE(compared, 12);
}
