// Statics of simple vehicles, whose forces a pencil finds.
#include <cmath>

#include <gtest/gtest.h>

#include "simcore/control/rover_estimate.h"
#include "simcore/dynamics/engine.h"
#include "simcore/run/simulation.h"
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
        const Study study = studied(
            cart, {{"front_left", a}, {"front_right", a}, {"rear_left", a}, {"rear_right", a}});
        ASSERT_TRUE(study.feasible);
        const double front =
            weight * (std::cos(a) * (0.5 * base + com.x()) - std::sin(a) * com.z()) / base;
        EXPECT_NEAR(study.wheels[0].normal + study.wheels[1].normal, front, 1e-6 * weight);
        EXPECT_NEAR(study.wheels[2].normal + study.wheels[3].normal, weight * std::cos(a) - front,
                    1e-6 * weight);
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

// A bogie whose pin carries a load that a slide keeps level. On a slope the pin lies h over the
// ground and the wheels' centres R: moments about the pin leave
// N_rear - N_front = (T h - 2 w sin a (h - R)) / b with T = (W + 2 w) sin a.
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
        const double difference = (weight * std::sin(a) * kHeight -
                                   2.0 * kWheel * kG * std::sin(a) * (kHeight - kRadius)) /
                                  kHalf;
        EXPECT_NEAR(study.wheels[0].normal + study.wheels[1].normal, weight * std::cos(a), 1e-3);
        EXPECT_NEAR(study.wheels[1].normal - study.wheels[0].normal, difference, 1e-3);
    }
}

// While a rover climbs a step at a creep: what statics makes of the pose that its sensors read and
// of the torques it applies, against the loads of the engine. The mean over a quarter of a second,
// for what lifts a wheel is the mean; poses in which a wheel changes its ground are left out.
TEST(ClosedFormsTest, LoadsOverAStepAreThoseOfTheEngine) {
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
    const double meanLoad = mechanism.mass() * kG / 6.0;
    std::vector<double> worst;
    std::vector<double> sums(6, 0.0), predicted(6, 0.0);
    int count = 0;
    std::vector<double> sorted;
    while (!simulation.finished()) {
        simulation.step();
        const run::Snapshot& now = simulation.snapshot();
        if (now.step % 10 != 0 || now.time < 3.0) {
            continue;
        }
        estimate.update(now.measured);
        const auto& contacts = estimate.contacts();
        if (contacts.size() != 6) {
            count = 0;
            continue;
        }
        std::vector<double> torques;
        for (const run::WheelState& wheel : now.wheels) {
            torques.push_back(wheel.torqueApplied);
        }
        const Traction traction(estimate.model().equilibrium(contacts, ContactSet::All, kG),
                                mechanism, contacts);
        const Forces forces = traction.under(torques);
        for (std::size_t w = 0; w < 6; ++w) {
            sums[w] = count == 0 ? 0.0 : sums[w];
            predicted[w] = count == 0 ? 0.0 : predicted[w];
            sums[w] += now.wheels[w].normalForce;
            predicted[w] += forces.normal[w];
        }
        if (++count == 25) {
            double most = 0.0;
            for (std::size_t w = 0; w < 6; ++w) {
                most = std::max(most, std::abs(sums[w] - predicted[w]) / 25.0 / meanLoad);
            }
            std::printf("%.2f %.4f\n", now.time, most);
            sorted.push_back(most);
            count = 0;
        }
    }
}
