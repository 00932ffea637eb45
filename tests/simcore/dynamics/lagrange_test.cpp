// Motions of mechanisms against Lagrange's and Euler's equations of their few coordinates, written
// here as textbooks have them: linkages with one freedom, chains of pendulums, a heavy top. The
// engines know nothing of such coordinates.
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include "tests/support/engine_cases.h"
#include "tests/support/linkages.h"
#include "tests/support/runge_kutta.h"

using namespace simcore;
using namespace simcore::dynamics;
using namespace testsupport;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double kPi = std::numbers::pi;

class LagrangeTest : public ::testing::TestWithParam<EngineCase> {};

/// Turn of a body about +y, which takes +z to +x [rad].
double turnOf(const World& world, std::size_t body) {
    return turnAbout(world.engine().poses()[body].rotation, Vec3::UnitY());
}

/// Turns of some bodies after a time, with one step length and with half of it.
struct Turns {
    VectorXd coarse, fine;

    /// To no step at all: what both have in common of first order cancels.
    VectorXd extrapolated() const {
        VectorXd turns = fine;
        for (Eigen::Index i = 0; i < turns.size(); ++i) {
            turns[i] += std::remainder(fine[i] - coarse[i], 2.0 * kPi);
        }
        return turns;
    }
};

double apart(const VectorXd& a, const VectorXd& b) {
    double largest = 0.0;
    for (Eigen::Index i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(std::remainder(a[i] - b[i], 2.0 * kPi)));
    }
    return largest;
}

Turns turnsAfter(const EngineCase& engine, const Mechanism& mechanism,
                 const std::vector<std::size_t>& bodies, double time, double step) {
    Turns turns;
    for (const double h : {step, 0.5 * step}) {
        World world(engine, mechanism, kGravity, h);
        world.run(time);
        VectorXd& found = h == step ? turns.coarse : turns.fine;
        found.resize(static_cast<Eigen::Index>(bodies.size()));
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            found[static_cast<Eigen::Index>(i)] = turnOf(world, bodies[i]);
        }
    }
    return turns;
}

// The engines are of first order: a step half as long leaves half of the error, and what is left
// once that is extrapolated is far less.
void expectFirstOrder(const Turns& turns, const VectorXd& exact, double coarse, double rest) {
    const double error = apart(turns.coarse, exact);
    EXPECT_LT(error, coarse);
    EXPECT_NEAR(apart(turns.fine, exact), 0.5 * error, 0.05 * error + rest);
    EXPECT_LT(apart(turns.extrapolated(), exact), rest);
}

// -- linkages with one freedom --------------------------------------------------------------------

/// Where a body of a plane linkage is.
struct Place {
    Eigen::Vector2d center;  ///< of mass, (x, z) [m]
    double angle;            ///< from +x to +z [rad]
};

/// A plane linkage by the closed form of its positions: from them, Lagrange's equation
/// M q'' + M' q'^2 / 2 + V' = 0 of its one coordinate.
struct OneFreedom {
    std::vector<double> masses, inertias;  ///< of the moving bodies; about their centres
    std::function<std::vector<Place>(double)> places;

    double mass(double q) const {
        constexpr double kDifference = 1e-5;
        const std::vector<Place> before = places(q - kDifference);
        const std::vector<Place> after = places(q + kDifference);
        double sum = 0.0;
        for (std::size_t i = 0; i < masses.size(); ++i) {
            const Eigen::Vector2d moved = after[i].center - before[i].center;
            const double turned = std::remainder(after[i].angle - before[i].angle, 2.0 * kPi);
            sum += (masses[i] * moved.squaredNorm() + inertias[i] * turned * turned) /
                   (4.0 * kDifference * kDifference);
        }
        return sum;
    }

    double potential(double q) const {
        double sum = 0.0;
        const std::vector<Place> at = places(q);
        for (std::size_t i = 0; i < masses.size(); ++i) {
            sum += masses[i] * kGravity * at[i].center.y();
        }
        return sum;
    }

    /// Coordinate after a time, from rest.
    double after(double start, double time) const {
        constexpr double kDifference = 1e-4;
        const auto slope = [&](const auto& of, double q) {
            return (of(q + kDifference) - of(q - kDifference)) / (2.0 * kDifference);
        };
        const auto derivative = [&](const VectorXd& y) -> VectorXd {
            const double massSlope = slope([&](double q) { return mass(q); }, y[0]);
            const double force = slope([&](double q) { return potential(q); }, y[0]);
            return Eigen::Vector2d(y[1], -(0.5 * massSlope * y[1] * y[1] + force) / mass(y[0]));
        };
        return rungeKutta(derivative, Eigen::Vector2d(start, 0.0), time, 4000)[0];
    }
};

Eigen::Vector2d ray(double angle, double length) {
    return length * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

Vec3 inSpace(const Eigen::Vector2d& point) {
    return {point.x(), 0.0, point.y()};
}

/// Crank at the origin, rod, and a block that slides along x.
struct SliderCrank {
    double crank = 0.12, rod = 0.3;

    std::vector<Place> places(double q) const {
        const double lean = -std::asin(crank * std::sin(q) / rod);
        const Eigen::Vector2d joint = ray(q, crank);
        const Eigen::Vector2d block = joint + ray(lean, rod);
        return {{0.5 * joint, q}, {0.5 * (joint + block), lean}, {block, 0.0}};
    }

    Mechanism make(double q) const {
        const std::vector<Place> at = places(q);
        const Vec3 joint = 2.0 * inSpace(at[0].center);
        const Vec3 block = inSpace(at[2].center);
        Mechanism mechanism;
        mechanism.bodies = {
            makeBody("frame", 5.0, Vec3::Zero()), makeBody("crank", 0.3, inSpace(at[0].center)),
            makeBody("rod", 0.4, inSpace(at[1].center)), makeBody("block", 0.6, block)};
        mechanism.bodies[0].fixed = true;
        Joint guide = makePin("guide", 0, 3, block);
        guide.built = guide.relaxed = {{FreedomKind::Slide, Vec3::UnitX()}};
        mechanism.joints = {makePin("shaft", 0, 1, Vec3::Zero()), makePin("big_end", 1, 2, joint),
                            makePin("small_end", 2, 3, block), guide};
        return mechanism;
    }
};

OneFreedom lagrangianOf(const Mechanism& mechanism,
                        std::function<std::vector<Place>(double)> places) {
    OneFreedom linkage;
    linkage.places = std::move(places);
    for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
        linkage.masses.push_back(mechanism.bodies[i].mass);
        linkage.inertias.push_back(mechanism.bodies[i].inertia(1, 1));
    }
    return linkage;
}

}  // namespace

INSTANTIATE_TEST_SUITE_P(Engines, LagrangeTest, ::testing::ValuesIn(enginesThatCan(Can::Joints)),
                         nameOfCase);

// A four-bar that falls from rest, its crank going around.
TEST_P(LagrangeTest, FourBarFalls) {
    const FourBar bar;
    const double start = 1.0;
    const Mechanism mechanism = bar.make(start);
    const OneFreedom linkage = lagrangianOf(mechanism, [&](double q) -> std::vector<Place> {
        const double follower = bar.followerAngle(q);
        const Eigen::Vector2d b = ray(q, bar.crank);
        const Eigen::Vector2d d(bar.ground, 0.0);
        const Eigen::Vector2d c = d + ray(follower, bar.follower);
        return {{0.5 * b, q},
                {0.5 * (b + c), std::atan2((c - b).y(), (c - b).x())},
                {0.5 * (c + d), follower}};
    });
    for (const double time : {0.3, 1.0}) {
        const VectorXd exact = VectorXd::Constant(1, start - linkage.after(start, time));
        const Turns turns = turnsAfter(GetParam(), mechanism, {1}, time, 0.0005);
        expectFirstOrder(turns, exact, 1e-2, 1e-5);
    }
}

// A crank that falls drives a block to and fro: a slide in a loop.
TEST_P(LagrangeTest, SliderCrankFalls) {
    const SliderCrank engine;
    const double start = 0.7;
    const Mechanism mechanism = engine.make(start);
    const OneFreedom linkage = lagrangianOf(mechanism, [&](double q) { return engine.places(q); });
    for (const double time : {0.3, 1.0}) {
        const VectorXd exact = VectorXd::Constant(1, start - linkage.after(start, time));
        const Turns turns = turnsAfter(GetParam(), mechanism, {1}, time, 0.0005);
        expectFirstOrder(turns, exact, 1e-2, 1e-5);
    }
}

// A bar on two equal parallel links keeps its attitude, wherever its centre of mass is, so the
// whole is one pendulum, whose period is known at any amplitude.
TEST_P(LagrangeTest, ParallelogramIsAPendulum) {
    const double length = 0.25;
    const double linkMass = 0.4;
    const double barMass = 1.1;
    const double linkInertia = 0.012 + linkMass * length * length / 4.0;  // about its pin
    const double inertia = 2.0 * linkInertia + barMass * length * length;
    const double weight = kGravity * (linkMass + barMass) * length;  // times sin = torque
    for (const double amplitude : {0.1, 1.0}) {
        const Vec3 link = length * Vec3(std::sin(amplitude), 0.0, -std::cos(amplitude));
        const Vec3 pins[2] = {{0.0, 0.1, 0.0}, {0.4, 0.1, 0.0}};
        Mechanism mechanism;
        mechanism.bodies = {makeBody("frame", 5.0, Vec3::Zero()),
                            makeBody("front", linkMass, pins[0] + 0.5 * link),
                            makeBody("bar", barMass, pins[0] + link + Vec3(0.13, 0.02, -0.05)),
                            makeBody("rear", linkMass, pins[1] + 0.5 * link)};
        mechanism.bodies[0].fixed = true;
        mechanism.joints = {makePin("a", 0, 1, pins[0]), makePin("b", 1, 2, pins[0] + link),
                            makePin("c", 2, 3, pins[1] + link), makePin("d", 3, 0, pins[1])};
        const double period = 2.0 * kPi * std::sqrt(inertia / weight) * periodFactor(amplitude);
        // On the other side after half a period, where it rests, so that it is there to second
        // order of a step; at the bottom a quarter later, off by half a step's way: pi / 4000.
        World world(GetParam(), mechanism, kGravity, period / 4000.0);
        world.run(0.5 * period);
        EXPECT_NEAR(turnOf(world, 1), 2.0 * amplitude, 1e-6 * amplitude);
        world.run(0.25 * period);
        const double rate = std::sqrt(2.0 * weight * (1.0 - std::cos(amplitude)) / inertia);
        EXPECT_NEAR(turnOf(world, 1), amplitude, 1e-3 * amplitude);
        EXPECT_NEAR(world.engine().velocities()[3].angular.y(), -rate, 1e-5 * rate);
        EXPECT_NEAR(turnOf(world, 2), 0.0, 1e-6);
    }
}

// -- chains of pendulums --------------------------------------------------------------------------

namespace {

/// Rods that hang from each other by pins, the first from the world; their coordinates are the
/// angles of all to the vertical. For instance L. Meirovitch, Methods of Analytical Dynamics, 1970.
struct Chain {
    struct Rod {
        double mass, length, arm;  ///< [kg], to the next pin, to the centre of mass [m]
        double inertia;            ///< about the centre of mass [kg m^2]
    };

    std::vector<Rod> rods;

    /// M of M_ij cos(a_i - a_j), and the torques of weight at a right angle.
    MatrixXd masses() const {
        const auto n = static_cast<Eigen::Index>(rods.size());
        MatrixXd M = MatrixXd::Zero(n, n);
        for (std::size_t k = 0; k < rods.size(); ++k) {
            // Speed of the k-th centre: the lengths before it and its arm, by their rates.
            VectorXd levers = VectorXd::Zero(n);
            for (std::size_t i = 0; i <= k; ++i) {
                levers[static_cast<Eigen::Index>(i)] = i < k ? rods[i].length : rods[i].arm;
            }
            M += rods[k].mass * levers * levers.transpose();
            M(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(k)) += rods[k].inertia;
        }
        return M;
    }

    VectorXd weights() const {
        VectorXd w = VectorXd::Zero(static_cast<Eigen::Index>(rods.size()));
        for (std::size_t k = 0; k < rods.size(); ++k) {
            for (std::size_t i = 0; i <= k; ++i) {
                w[static_cast<Eigen::Index>(i)] +=
                    rods[k].mass * kGravity * (i < k ? rods[i].length : rods[i].arm);
            }
        }
        return w;
    }

    /// Angles after a time, from rest.
    VectorXd after(const VectorXd& start, double time) const {
        const Eigen::Index n = start.size();
        const MatrixXd M = masses();
        const VectorXd w = weights();
        const auto derivative = [&](const VectorXd& y) -> VectorXd {
            MatrixXd A(n, n);
            VectorXd b(n);
            for (Eigen::Index i = 0; i < n; ++i) {
                b[i] = -w[i] * std::sin(y[i]);
                for (Eigen::Index j = 0; j < n; ++j) {
                    A(i, j) = M(i, j) * std::cos(y[i] - y[j]);
                    b[i] -= M(i, j) * std::sin(y[i] - y[j]) * y[n + j] * y[n + j];
                }
            }
            VectorXd rates(2 * n);
            rates << y.tail(n), A.ldlt().solve(b);
            return rates;
        };
        VectorXd y = VectorXd::Zero(2 * n);
        y.head(n) = start;
        return rungeKutta(derivative, y, time, 20000).head(n);
    }

    Mechanism make(const VectorXd& angles) const {
        Mechanism mechanism;
        mechanism.bodies = {makeBody("frame", 5.0, Vec3::Zero())};
        mechanism.bodies[0].fixed = true;
        Vec3 pin = Vec3::Zero();
        for (std::size_t k = 0; k < rods.size(); ++k) {
            const double a = angles[static_cast<Eigen::Index>(k)];
            const Vec3 down(std::sin(a), 0.0, -std::cos(a));
            const std::string name = "rod" + std::to_string(k);
            const auto at = static_cast<int>(k);
            mechanism.bodies.push_back(makeBody(name, rods[k].mass, pin + rods[k].arm * down,
                                                {rods[k].inertia, rods[k].inertia, 1e-3}));
            mechanism.joints.push_back(makePin(name, at, at + 1, pin));
            pin += rods[k].length * down;
        }
        return mechanism;
    }

    std::vector<std::size_t> bodies() const {
        std::vector<std::size_t> all(rods.size());
        for (std::size_t k = 0; k < rods.size(); ++k) {
            all[k] = k + 1;
        }
        return all;
    }
};

Chain threeRods() {
    return {{{0.8, 0.30, 0.14, 0.006}, {0.5, 0.25, 0.12, 0.003}, {0.6, 0.20, 0.11, 0.004}}};
}

Chain twoRods() {
    return {{{0.8, 0.30, 0.14, 0.006}, {0.5, 0.25, 0.12, 0.003}}};
}

}  // namespace

// Released at rest in the shape of one of its modes, a chain swings in that shape with the mode's
// frequency.
TEST_P(LagrangeTest, ChainsSwingInTheirModes) {
    for (const Chain& chain : {twoRods(), threeRods()}) {
        const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(
            chain.weights().asDiagonal().toDenseMatrix(), chain.masses());
        for (Eigen::Index k = 0; k < modes.eigenvalues().size(); ++k) {
            const double amplitude = 1e-3;
            const VectorXd shape = modes.eigenvectors().col(k).normalized();
            const double period = 2.0 * kPi / std::sqrt(modes.eigenvalues()[k]);
            World world(GetParam(), chain.make(amplitude * shape), kGravity, period / 4000.0);
            // After 5/4 of a period all pass through the vertical, off by half a step's way,
            // pi / 4000, at their greatest rates, which hardly change in that.
            world.run(1.25 * period);
            for (Eigen::Index i = 0; i < shape.size(); ++i) {
                const auto body = static_cast<std::size_t>(i + 1);
                EXPECT_NEAR(turnOf(world, body), amplitude * shape[i], 1e-3 * amplitude)
                    << "mode " << k << ", rod " << i;
                EXPECT_NEAR(world.engine().velocities()[body].angular.y(),
                            2.0 * kPi / period * amplitude * shape[i],
                            1e-5 * 2.0 * kPi / period * amplitude)
                    << "mode " << k << ", rod " << i;
            }
        }
    }
}

// Double and triple pendulums that fall from level: chaos, but not within a second.
TEST_P(LagrangeTest, ChainsFallAsLagrangeSays) {
    for (const Chain& chain : {twoRods(), threeRods()}) {
        const VectorXd start =
            VectorXd::Constant(static_cast<Eigen::Index>(chain.rods.size()), kPi / 2.0);
        for (const double time : {0.4, 1.0}) {
            const VectorXd exact = start - chain.after(start, time);
            const Turns turns =
                turnsAfter(GetParam(), chain.make(start), chain.bodies(), time, 0.0002);
            expectFirstOrder(turns, exact, 1e-2, 5e-5);
        }
    }
}

// -- a top ----------------------------------------------------------------------------------------

namespace {

/// An unsymmetrical heavy top that turns about the origin, driven about its own axis.
struct Top {
    double mass = 1.2;
    Vec3 arm{0.0, 0.15, 0.02};          ///< of its centre of mass, drawn [m]
    Vec3 moments{0.006, 0.009, 0.005};  ///< about that [kg m^2]
    double torque = 0.4;                ///< about its own y axis [N m]

    Mechanism make() const {
        Mechanism mechanism = makeDrum(mass, 0.1, 0.05, arm);
        mechanism.bodies = {makeBody("frame", 5.0, Vec3::Zero()),
                            makeBody("top", mass, arm, moments)};
        mechanism.bodies[0].fixed = true;
        mechanism.wheels[0].body = mechanism.wheels[0].carrier = 1;
        Joint ball = makePin("ball", 0, 1, Vec3::Zero());
        ball.built = {{FreedomKind::Turn, Vec3::UnitX()},
                      {FreedomKind::Turn, Vec3::UnitY()},
                      {FreedomKind::Turn, Vec3::UnitZ()}};
        ball.relaxed = ball.built;
        mechanism.joints = {ball};
        return mechanism;
    }

    /// Rotation after a time, from rest: Euler's equations about the fixed point, in body axes.
    Eigen::Quaterniond after(double time) const {
        const Mat3 inertia = Mat3(moments.asDiagonal()) +
                             mass * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
        const auto derivative = [&](const VectorXd& y) -> VectorXd {
            const Eigen::Quaterniond q(y[0], y[1], y[2], y[3]);
            const Vec3 w = y.tail<3>();
            const Vec3 weight = q.conjugate() * Vec3(0.0, 0.0, -mass * kGravity);
            const Vec3 moment = arm.cross(weight) + torque * Vec3::UnitY();
            const Eigen::Quaterniond turning = q * Eigen::Quaterniond(0.0, w.x(), w.y(), w.z());
            VectorXd rates(7);
            rates << 0.5 * turning.w(), 0.5 * turning.vec(),
                inertia.inverse() * (moment - w.cross(inertia * w));
            return rates;
        };
        VectorXd y = VectorXd::Zero(7);
        y[0] = 1.0;
        y = rungeKutta(derivative, y, time, 20000);
        return Eigen::Quaterniond(y[0], y[1], y[2], y[3]).normalized();
    }
};

}  // namespace

// Spun up about its own level axis, a top on a ball joint falls, and its axis turns about the
// vertical. Where its axes point is compared, as three directions each.
TEST_P(LagrangeTest, TopPrecesses) {
    const Top top;
    for (const double time : {0.25, 0.5}) {
        const Mat3 exact = top.after(time).toRotationMatrix();
        Mat3 found[2];
        for (int half = 0; half < 2; ++half) {
            World world(GetParam(), top.make(), kGravity, 0.0002 / (1 + half));
            world.external = {top.torque};
            world.run(time);
            found[half] = world.engine().poses()[1].rotation.toRotationMatrix();
        }
        const double error = (found[0] - exact).norm();
        EXPECT_LT(error, 0.015);
        EXPECT_NEAR((found[1] - exact).norm(), 0.5 * error, 0.05 * error);
        EXPECT_LT((2.0 * found[1] - found[0] - exact).norm(), 1e-4);
    }
}
