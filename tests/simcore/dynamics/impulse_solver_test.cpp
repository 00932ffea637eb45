#include "simcore/dynamics/impulse_solver.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/LU>

using namespace simcore;
using namespace simcore::dynamics;

namespace {

constexpr double kStep = 0.002;  // [s]
constexpr double kMass = 2.0;    // [kg]
constexpr double kGravity = 9.81;

/// A point mass on a slope about +y through the origin, at rest, wanting to move by gravity.
struct PointOnSlope {
    explicit PointOnSlope(double angle, double friction) {
        problem.momentum = Eigen::Vector3d(0.0, 0.0, -kMass * kGravity * kStep);
        RateMap body;
        body.indices = {0, 1, 2};
        for (int axis = 0; axis < 3; ++axis) {
            body.twists.push_back(slideAlong(Vec3::Unit(axis)));
        }
        problem.bodies = {body};
        problem.touched = {0};
        const Vec3 normal(std::sin(angle), 0.0, std::cos(angle));
        const Vec3 down(std::cos(angle), 0.0, -std::sin(angle));
        ContactRow contact;
        contact.wrenches.col(0) = forceAt(normal, Vec3::Zero());
        contact.wrenches.col(1) = forceAt(down, Vec3::Zero());
        contact.wrenches.col(2) = forceAt(normal.cross(down), Vec3::Zero());
        contact.friction = friction;
        problem.contacts = {contact};
        problem.normalCompliance = 1e-7;
        problem.tangentialCompliance = 1e-6;
        problem.tolerance = 1e-9;
        lu.reset(3);
        lu.couple({0, 1, 2});
        lu.close();
        lu.shape(problem.mass);
        problem.mass.leftCols(3).diagonal().setConstant(kMass);
    }

    void solve() { solver.solve(problem, lu, u, counters); }

    ImpulseProblem problem;
    PatternedLu lu;
    ImpulseSolver solver;
    ImpulseCounters counters;
    Eigen::VectorXd u = Eigen::VectorXd::Zero(3);
};

}  // namespace

// Matrices with the arrow-like patterns of trees, without pivoting, against Eigen with it.
TEST(PatternedLuTest, SolvesAsDenseEliminationDoes) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    constexpr int kSize = 9;
    PatternedLu lu;
    lu.reset(kSize);
    RowMajor matrix = RowMajor::Zero(kSize, kSize);
    for (const std::vector<int>& group :
         {std::vector<int>{0, 1, 6, 7, 8}, {2, 7, 8}, {3, 4, 5, 8}}) {
        lu.couple(group);
        for (int i : group) {
            for (int j : group) {
                matrix(i, j) += number(random);
            }
            matrix(i, i) += 4.0;
        }
    }
    lu.close();
    Eigen::VectorXd right(kSize);
    for (int i = 0; i < kSize; ++i) {
        right[i] = number(random);
    }
    const Eigen::VectorXd expected = matrix.partialPivLu().solve(right);
    RowMajor factored;
    lu.shape(factored);
    factored.leftCols(kSize) = matrix;
    factored.col(kSize) = right;
    lu.factor(factored);
    Eigen::VectorXd carried;
    lu.solveCarried(factored, carried);
    EXPECT_LT((carried - expected).norm(), 1e-13);
    lu.solve(factored, right);
    EXPECT_LT((right - expected).norm(), 1e-13);
}

// A weight on a slope below the angle of friction stays, pushed by the ground with what it weighs.
TEST(ImpulseSolverTest, SticksBelowTheAngleOfFriction) {
    PointOnSlope point(0.3, 0.4);  // tan 0.3 = 0.309
    point.solve();
    EXPECT_LT(point.u.norm(), 1e-4);
    const Vec3 force =
        (point.problem.contacts[0].wrenches * point.problem.contacts[0].impulse / kStep).tail<3>();
    EXPECT_LT((force - Vec3(0.0, 0.0, kMass * kGravity)).norm(), 0.02);
    EXPECT_EQ(point.counters.fallbacks, 0);
}

// Above it, it slides by g (sin a - mu cos a) dt, and friction is on the cone against the sliding.
TEST(ImpulseSolverTest, SlidesAboveTheAngleOfFriction) {
    constexpr double kAngle = 0.5;
    constexpr double kFriction = 0.2;
    PointOnSlope point(kAngle, kFriction);
    point.solve();
    const ContactRow& contact = point.problem.contacts[0];
    const double expected = kGravity * (std::sin(kAngle) - kFriction * std::cos(kAngle)) * kStep;
    EXPECT_NEAR(contact.velocity[1], expected, 1e-4 * expected);
    EXPECT_NEAR(contact.impulse[1], -kFriction * contact.impulse[0], 1e-9);
    EXPECT_NEAR(contact.impulse[2], 0.0, 1e-9);
}

// A contact that opens pushes nothing.
TEST(ImpulseSolverTest, OpeningContactPushesNothing) {
    PointOnSlope point(0.0, 0.5);
    point.problem.momentum = Eigen::Vector3d(0.1, 0.0, 1.0);
    point.solve();
    EXPECT_EQ(point.problem.contacts[0].impulse, Vec3::Zero());
    EXPECT_LT((point.u - point.problem.momentum / kMass).norm(), 1e-12);
}

// A motor reaches its rate within its limit, and gives its limit beyond.
TEST(ImpulseSolverTest, MotorsKeepTheirLimit) {
    for (const double limit : {0.5, 0.01}) {
        PointOnSlope point(0.0, 0.0);
        point.problem.contacts.clear();
        point.problem.momentum.setZero();
        ScalarRow motor;
        motor.indices = {1};
        motor.factors = {1.0};
        motor.compliance = 1e-6;
        motor.bound = 0.1;
        motor.most = limit;
        motor.least = -limit;
        std::vector<ScalarRow> rows{motor};
        point.problem.rows = rows;
        point.solve();
        const double reached = std::min(0.1, limit / kMass);
        EXPECT_NEAR(point.u[1], reached, 1e-6);
        EXPECT_NEAR(point.problem.rows[0].impulse, kMass * reached, 1e-5);
    }
}
