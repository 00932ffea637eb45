// Statics of simple vehicles, whose forces a pencil finds.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "simcore/control/rover_estimate.h"
#include "simcore/dynamics/engine.h"
#include "simcore/run/simulation.h"
#include "simcore/statics/pose_solver.h"
#include "simcore/statics/static_study.h"
#include "tests/support/carts.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::statics;

namespace {

constexpr double kG = dynamics::kGravity;

Study studied(const mechanism::Mechanism& mechanism, const std::vector<WheelAngle>& angles) {
    StudyRequest request;
    request.angles = angles;
    auto study = studyDrawnPose(mechanism, request);
    EXPECT_TRUE(study) << toString(study.problems());
    return std::move(study).value();
}

/// All bodies at the last three steps, now last.
using Course = std::array<std::vector<Pose>, 3>;

/// Turn from one attitude to another [rad], world.
Vec3 turnBetween(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
    const Eigen::AngleAxisd turn(to * from.conjugate());
    return turn.angle() * turn.axis();
}

/// Work, per unit of each motion, of what accelerates the bodies (d'Alembert).
Eigen::VectorXd workOfInertia(const StaticModel& model, const Course& course, double step) {
    const std::vector<mechanism::Body>& bodies = model.mechanism().bodies;
    Eigen::VectorXd work = Eigen::VectorXd::Zero(model.motions());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto com = [&](std::size_t k) -> Vec3 { return course[k][i] * bodies[i].com; };
        const Vec3 acceleration = (com(2) - 2.0 * com(1) + com(0)) / (step * step);
        const Eigen::Quaterniond& attitude = course[2][i].rotation;
        const Vec3 before = turnBetween(course[0][i].rotation, course[1][i].rotation) / step;
        const Vec3 now = turnBetween(course[1][i].rotation, attitude) / step;
        const Mat3 turned = attitude.toRotationMatrix();
        const Mat3 inertia = turned * model.mechanism().inertiaWithRotor(i) * turned.transpose();
        const Vec3 moment = inertia * (now - before) / step + now.cross(inertia * now);
        const int body = static_cast<int>(i);
        // At the place it has in the model's pose, which is elsewhere but turned alike.
        work += model.workOf(body, bodies[i].mass * acceleration, model.poses()[i] * bodies[i].com);
        work += model.workOfMoment(body, moment);
    }
    return work;
}

}  // namespace

// Two axles on a slope: moments about the foot of one axle leave the load of the other, whatever
// the torques are. N_front L = m g (cos a (L/2 + x) - sin a h).
TEST(ClosedFormsTest, TwoAxlesOnASlope) {
    testsupport::CartNumbers numbers;
    numbers.comX = 0.04;
    numbers.comZ = 0.25;
    const mechanism::Mechanism cart = testsupport::makeCart(numbers);
    const Vec3 com = cart.centerOfMass();
    const double weight = cart.mass() * kG;
    const double base = 2.0 * numbers.halfBase;
    for (const double a : {-0.3, 0.0, 0.2, 0.4}) {
        const double rise = 20.0 * std::tan(a);
        const auto ground = terrain::Terrain::extruded({{-20.0, -rise}, {20.0, rise}}, -20.0, 20.0);
        StaticModel model(cart, Model::Built);
        PoseSolver solver(model, ground);
        const StandingPose pose = solver.settle({});
        ASSERT_EQ(pose.standing, Standing::Stands);
        const Study study = studyPose(model, pose, ContactSet::All);
        ASSERT_TRUE(study.feasible);
        const double front =
            weight * (std::cos(a) * (0.5 * base + com.x()) - std::sin(a) * com.z()) / base;
        EXPECT_NEAR(study.wheels[0].normal + study.wheels[1].normal, front, 1e-5 * weight);
        EXPECT_NEAR(study.wheels[2].normal + study.wheels[3].normal, weight * std::cos(a) - front,
                    1e-5 * weight);
        EXPECT_NEAR(study.frictionRequired, std::tan(std::abs(a)), 1e-6);
        // Only the sum of the torques is asked for: the best shares are equal ones.
        const double share = weight * std::abs(std::sin(a)) * numbers.radius / 4.0;
        EXPECT_NEAR(study.minimumTorque, share, 1e-4);
        EXPECT_NEAR(study.leastSquares, 4.0 * share * share, 1e-3);
        EXPECT_GE(study.leastSquaresRatio, study.frictionRequired - 1e-6);
    }
}

// The same at the drawn pose with every wheel on a facet of its own: the best forces are all
// vertical, at feet that lie R sin a ahead. N_front L = m g cos a (L/2 + x - R sin a).
TEST(ClosedFormsTest, TwoAxlesOnFacets) {
    testsupport::CartNumbers numbers;
    numbers.comX = 0.04;
    const mechanism::Mechanism cart = testsupport::makeCart(numbers);
    const double weight = cart.mass() * kG;
    const double base = 2.0 * numbers.halfBase;
    for (const double a : {-0.3, 0.2, 0.4}) {
        const Study study = studied(
            cart, {{"front_left", a}, {"front_right", a}, {"rear_left", a}, {"rear_right", a}});
        const double front = weight * std::cos(a) *
                             (0.5 * base + cart.centerOfMass().x() - numbers.radius * std::sin(a)) /
                             base;
        EXPECT_NEAR(study.wheels[0].normal + study.wheels[1].normal, front, 1e-5 * weight);
        EXPECT_NEAR(study.frictionRequired, std::tan(std::abs(a)), 1e-6);
    }
}

// Both front wheels at a wall. With n the push of the wall: T_rear = n, T_front = (W a - n R) /
// (L + R), N_rear = W - T_front; the best n makes both ratios alike, which is
// mu^2 (L + R - a) + mu R - a = 0 with a the way from the rear axle to the centre of mass.
TEST(ClosedFormsTest, TwoAxlesAtAWall) {
    for (const double comX : {-0.1, 0.0, 0.08}) {
        testsupport::CartNumbers numbers;
        numbers.comX = comX;
        numbers.torqueLimit = 50.0;
        const mechanism::Mechanism cart = testsupport::makeCart(numbers);
        const double base = 2.0 * numbers.halfBase;
        const double radius = numbers.radius;
        const double a = numbers.halfBase + cart.centerOfMass().x();
        const double c = base + radius - a;
        const double mu = (-radius + std::sqrt(radius * radius + 4.0 * a * c)) / (2.0 * c);
        const Study study =
            studied(cart, {{"front_left", 0.5 * M_PI}, {"front_right", 0.5 * M_PI}});
        ASSERT_TRUE(study.feasible);
        EXPECT_NEAR(study.frictionRequired, mu, 1e-6) << comX;
        const double weight = cart.mass() * kG;
        const double rear = weight / (1.0 + mu * mu);
        EXPECT_NEAR(study.wheels[2].normal + study.wheels[3].normal, rear, 1e-4 * weight);
        EXPECT_NEAR(study.wheels[0].normal + study.wheels[1].normal, mu * rear, 1e-4 * weight);
    }
}

// A bogie whose pin carries a load that a slide keeps level, both wheels on facets: the best forces
// are vertical, so moments about the pin leave F_rear - F_front = W R sin a / b, N = F cos a.
TEST(ClosedFormsTest, ABogieUnderALoad) {
    constexpr double kLoad = 10.0, kWheel = 0.5, kHalf = 0.15, kRadius = 0.07, kHeight = 0.2;
    mechanism::Mechanism bogie;
    bogie.name = "bogie";
    const Vec3 pin(0.0, 0.0, kHeight);
    bogie.bodies = {testsupport::makeBody("frame", 1.0, pin),
                    testsupport::makeBody("load", kLoad, pin),
                    testsupport::makeBody("bogie", 1e-6, pin)};
    bogie.bodies[0].fixed = true;
    mechanism::Joint slide = testsupport::makePin("slide", 0, 1, pin);
    slide.built = slide.relaxed = {{mechanism::FreedomKind::Slide, Vec3::UnitX()},
                                   {mechanism::FreedomKind::Slide, Vec3::UnitZ()}};
    bogie.joints = {slide, testsupport::makePin("pin", 1, 2, pin)};
    for (const double x : {kHalf, -kHalf}) {
        const Vec3 center(x, 0.0, kRadius);
        const int body = static_cast<int>(bogie.bodies.size());
        bogie.bodies.push_back(testsupport::makeBody(x > 0.0 ? "front" : "rear", kWheel, center));
        bogie.joints.push_back(
            testsupport::makePin(bogie.bodies.back().name + "_axle", 2, body, center));
        mechanism::Wheel wheel;
        wheel.name = bogie.bodies.back().name;
        wheel.body = body;
        wheel.axle = static_cast<int>(bogie.joints.size()) - 1;
        wheel.carrier = 2;
        wheel.center = center;
        wheel.radius = kRadius;
        wheel.torqueLimit = 50.0;
        bogie.wheels.push_back(wheel);
    }
    bogie.chassis = 1;
    for (const double a : {0.0, 0.25, -0.15}) {
        const Study study = studied(bogie, {{"front", a}, {"rear", a}});
        ASSERT_TRUE(study.feasible);
        const double weight = (kLoad + 2.0 * kWheel) * kG;
        const double difference = weight * kRadius * std::sin(a) / kHalf * std::cos(a);
        EXPECT_NEAR(study.wheels[0].normal + study.wheels[1].normal, weight * std::cos(a), 1e-3);
        EXPECT_NEAR(study.wheels[1].normal - study.wheels[0].normal, difference, 1e-3);
    }
}

// While a rover climbs a step: what statics makes of the pose that its sensors read and of the
// torques it applies, against the loads of the engine, in means over a quarter of a second. Within
// 2 % of a wheel's mean load where inertia takes no more than that; and everywhere but when a wheel
// strikes the ground, once statics is told what accelerates the bodies. So the rest is inertia.
TEST(ClosedFormsTest, LoadsOverAStepAreThoseOfTheEngine) {
    constexpr double kTolerance = 0.02;
    project::Project project = testsupport::shipped("solero");
    for (project::Scenario& scenario : project.scenarios) {
        scenario.soil.rollingResistance = 0.0;
        scenario.controller.kind = project::ControllerKind::Torque;
        scenario.controller.speed = 0.1;
    }
    run::RunRequest request;
    request.scenario = "step";
    request.engine = project::EngineKind::Reduced;
    request.step = 0.001;
    request.terrainHeight = 0.05;
    auto resolved = run::prepareRun(project, request);
    ASSERT_TRUE(resolved) << toString(resolved.problems());
    run::Simulation simulation(std::move(resolved).value());
    const mechanism::Mechanism& mechanism = simulation.settings().mechanism;
    control::RoverEstimate estimate(mechanism, 0.01);
    const std::size_t wheels = mechanism.wheels.size();
    const double meanLoad = mechanism.mass() * kG / static_cast<double>(wheels);
    constexpr int kWindow = 25;       // control periods
    constexpr double kAtRest = 0.02;  // of a mean load
    constexpr double kImpact = 1.0;   // the same
    const auto none = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(wheels));
    Eigen::VectorXd lessStill = none;   // the engine's loads less those of statics
    Eigen::VectorXd lessMoving = none;  // the same with inertia
    int looks = 0;
    bool climbs = false;
    int quiet = 0;
    int compared = 0;
    Course course;
    while (!simulation.finished()) {
        simulation.step();
        const run::Snapshot& now = simulation.snapshot();
        std::rotate(course.begin(), course.begin() + 1, course.end());
        course.back() = now.bodies;
        if (now.step % 10 != 0 || now.time < 3.0) {
            continue;
        }
        estimate.reset();  // as they are now, not smoothed
        estimate.update(now.measured);
        const auto& contacts = estimate.contacts();
        if (looks == 0 || contacts.size() != wheels) {
            lessStill = lessMoving = none;
            looks = 0;
            climbs = false;
        }
        if (contacts.size() != wheels) {
            continue;
        }
        std::vector<double> torques;
        for (const run::WheelState& wheel : now.wheels) {
            torques.push_back(wheel.torqueApplied);
            climbs = climbs || std::abs(wheel.contactAngle) > 0.1;
        }
        Equilibrium equilibrium = estimate.model().equilibrium(contacts, ContactSet::All, kG);
        const Forces byWeight = Traction(equilibrium, mechanism, contacts).under(torques);
        equilibrium.right += workOfInertia(estimate.model(), course, request.step.value());
        const Forces byInertia = Traction(equilibrium, mechanism, contacts).under(torques);
        Eigen::VectorXd load = none, still = none, moving = none;
        for (std::size_t w = 0; w < wheels; ++w) {
            const auto at = static_cast<Eigen::Index>(w);
            load[at] = now.wheels[w].normalForce / meanLoad;
            still[at] = byWeight.normal[w] / meanLoad;
            moving[at] = byInertia.normal[w] / meanLoad;
        }
        if ((moving - still).cwiseAbs().maxCoeff() > kImpact) {
            looks = 0;
            continue;
        }
        lessStill += (load - still) / kWindow;
        lessMoving += (load - moving) / kWindow;
        if (++looks < kWindow) {
            continue;
        }
        looks = 0;
        if (!climbs) {
            continue;
        }
        ++compared;
        EXPECT_LT(lessMoving.cwiseAbs().maxCoeff(), kTolerance) << "at " << now.time << " s";
        if ((lessMoving - lessStill).cwiseAbs().maxCoeff() < kAtRest) {
            ++quiet;
            EXPECT_LT(lessStill.cwiseAbs().maxCoeff(), kTolerance) << "at " << now.time << " s";
        }
    }
    EXPECT_GE(compared, 20);
    EXPECT_GE(quiet, 5);
}
