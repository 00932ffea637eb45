#include "simcore/statics/quasi_convex.h"

#include <cmath>

#include <gtest/gtest.h>

#include "simcore/base/random.h"
#include "tests/support/quasi_convex_programs.h"

using namespace simcore;
using namespace simcore::statics;
using namespace testsupport;

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kTolerance = 1e-8;

}  // namespace

// Two loads on a beam of weight 2 that pull 1 and 0.5 and may shift their weight: both ratios are
// alike at the best.
TEST(QuasiConvexTest, SharesALoad) {
    Scratch room;
    QuasiConvexProgram program(room, 1, 2, 1);
    addCone(program, MatrixXd::Zero(1, 1), VectorXd::Constant(1, 1.0), VectorXd::Constant(1, 1.0),
            1.0);
    addCone(program, MatrixXd::Zero(1, 1), VectorXd::Constant(1, 0.5), VectorXd::Constant(1, -1.0),
            1.0);
    VectorXd y = VectorXd::Zero(1);
    ASSERT_TRUE(minimise(program, y, kTolerance));
    EXPECT_NEAR(y[0], 1.0 / 3.0, 1e-9);
    EXPECT_NEAR(program.reached(y), 0.75, 1e-9);
    // With a limit in the way, that holds.
    addHalfSpace(program, VectorXd::Constant(1, -1.0), 0.2);
    ASSERT_TRUE(minimise(program, y, kTolerance));
    EXPECT_NEAR(y[0], 0.2, 1e-9);
}

TEST(QuasiConvexTest, FindsThatNothingIsAllowed) {
    Scratch room;
    QuasiConvexProgram program(room, 1, 1, 2);
    addCone(program, MatrixXd::Ones(1, 1), VectorXd::Zero(1), VectorXd::Zero(1), 1.0);
    addHalfSpace(program, VectorXd::Constant(1, 1.0), -1.0);
    addHalfSpace(program, VectorXd::Constant(1, -1.0), 0.5);
    VectorXd y = VectorXd::Zero(1);
    EXPECT_FALSE(minimise(program, y, kTolerance));
}

// Where no force is needed at all, cones have no slope.
TEST(QuasiConvexTest, NeedsNothingWhereNothingPulls) {
    Scratch room;
    QuasiConvexProgram program(room, 2, 1, 0);
    addCone(program, MatrixXd::Identity(2, 2), VectorXd::Constant(2, 0.3), VectorXd::Zero(2), 1.0);
    VectorXd y = VectorXd::Constant(2, 5.0);
    ASSERT_TRUE(minimise(program, y, kTolerance));
    EXPECT_LE(program.reached(y), kTolerance);
}

// Where wheels press against each other without end, as where joints are nearly locked, a guess may
// be far away and ask for any friction.
TEST(QuasiConvexTest, ComesBackFromFarAway) {
    constexpr double kFar = 300.0;
    int far = 0;
    for (int seed = 1; seed <= 200; ++seed) {
        Scratch room;
        const QuasiConvexProgram program =
            randomProgram(room, seed, 2 + seed % 7, 3, 1 + seed % 2, 4.0 * kFar);
        const Eigen::Index n = program.unknowns();
        Random random(static_cast<std::uint64_t>(2000 + seed));
        VectorXd y = VectorXd::Zero(n);
        ASSERT_TRUE(minimise(program, y, kTolerance)) << seed;
        const double best = program.reached(y);
        for (int k = 0; k < 20; ++k) {
            VectorXd other = kFar * randomMatrix(random, n, 1);
            const double reached = program.reached(other);
            if (std::isfinite(reached) && reached > 10.0) {
                ++far;
                ASSERT_TRUE(minimise(program, other, kTolerance)) << seed;
                EXPECT_NEAR(program.reached(other), best, 1e-6 * (1.0 + best)) << seed;
            }
        }
    }
    EXPECT_GT(far, 20);
}

// From any start the same minimum, and nothing better by lot near it or far from it.
TEST(QuasiConvexTest, NothingIsBetter) {
    for (int seed = 1; seed <= 60; ++seed) {
        Scratch room;
        const QuasiConvexProgram program =
            randomProgram(room, seed, 2 + seed % 7, 3 + seed % 5, 1 + seed % 2);
        const Eigen::Index n = program.unknowns();
        Random random(static_cast<std::uint64_t>(1000 + seed));
        VectorXd y = VectorXd::Zero(n);
        ASSERT_TRUE(minimise(program, y, kTolerance)) << seed;
        const double best = program.reached(y);
        for (const HalfSpace& half : program.halfSpaces()) {
            EXPECT_GE(half.room(y), -1e-8) << seed;
        }
        for (int k = 0; k < 5; ++k) {
            VectorXd other = 10.0 * randomMatrix(random, n, 1);
            ASSERT_TRUE(minimise(program, other, kTolerance)) << seed;
            EXPECT_NEAR(program.reached(other), best, 1e-6 * (1.0 + best)) << seed;
        }
        for (int k = 0; k < 2000; ++k) {
            const double far = std::pow(10.0, random.uniform(-5.0, 0.5));
            const VectorXd other = y + far * randomMatrix(random, n, 1);
            bool allowed = true;
            for (const HalfSpace& half : program.halfSpaces()) {
                allowed = allowed && half.room(other) >= 0.0;
            }
            if (allowed) {
                EXPECT_GE(program.reached(other), best - 1e-7) << seed;
            }
        }
    }
}
