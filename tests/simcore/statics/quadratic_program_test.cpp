#include "simcore/statics/quadratic_program.h"

#include <gtest/gtest.h>

#include "simcore/base/random.h"

using namespace simcore;
using namespace simcore::statics;

namespace {

Eigen::MatrixXd randomMatrix(Random& random, Eigen::Index rows, Eigen::Index cols) {
    return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return random.uniform(-1.0, 1.0); });
}

/// Feasible: the bounds are met by some x.
QuadraticProgram randomProgram(int seed, Eigen::Index n, Eigen::Index m, int equations) {
    Random random(static_cast<std::uint64_t>(seed));
    QuadraticProgram program;
    const Eigen::MatrixXd root = randomMatrix(random, n, n);
    program.hessian = root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
    program.right = randomMatrix(random, n, 1);
    program.rows = randomMatrix(random, m, n);
    const Eigen::VectorXd x = randomMatrix(random, n, 1);
    program.bounds = program.rows * x;
    for (Eigen::Index i = equations; i < m; ++i) {
        program.bounds[i] -= random.uniform(0.0, 0.5);
    }
    program.equations = equations;
    return program;
}

void expectConditionsOfOptimum(const QuadraticProgram& p, const Optimum& o) {
    const Eigen::VectorXd gradient = p.hessian * o.x - p.right - p.rows.transpose() * o.multipliers;
    EXPECT_LT(gradient.cwiseAbs().maxCoeff(), 1e-8);
    const Eigen::VectorXd room = p.rows * o.x - p.bounds;
    for (Eigen::Index i = 0; i < room.size(); ++i) {
        if (i < p.equations) {
            EXPECT_NEAR(room[i], 0.0, 1e-8);
            continue;
        }
        EXPECT_GT(room[i], -1e-8);
        EXPECT_GE(o.multipliers[i], 0.0);
        EXPECT_NEAR(room[i] * o.multipliers[i], 0.0, 1e-7);
    }
}

}  // namespace

// Karush, Kuhn and Tucker, on programs by lot, some with every row twice.
TEST(QuadraticProgramTest, FulfilsTheConditionsOfOptimum) {
    for (int seed = 1; seed <= 100; ++seed) {
        QuadraticProgram program = randomProgram(seed, 8, 5 + seed % 12, seed % 4);
        if (seed % 3 == 0) {
            const Eigen::MatrixXd rows = program.rows;
            const Eigen::VectorXd bounds = program.bounds;
            program.rows.resize(2 * rows.rows(), rows.cols());
            program.rows << rows, rows;
            program.bounds.resize(2 * bounds.size());
            program.bounds << bounds, bounds;
        }
        SCOPED_TRACE(seed);
        const Optimum optimum = minimise(program);
        expectConditionsOfOptimum(program, optimum);
        // Wherever it begins.
        const Eigen::VectorXd guesses[] = {
            optimum.multipliers, Eigen::VectorXd::Ones(program.bounds.size()),
            1e6 * Eigen::VectorXd::Unit(program.bounds.size(), program.bounds.size() - 1)};
        for (const Eigen::VectorXd& guess : guesses) {
            const Optimum other = minimise(program, guess);
            expectConditionsOfOptimum(program, other);
            EXPECT_LT((other.x - optimum.x).cwiseAbs().maxCoeff(), 1e-8) << seed;
        }
    }
}

TEST(QuadraticProgramTest, WithoutRowsIsALinearSystem) {
    QuadraticProgram program = randomProgram(7, 5, 3, 0);
    program.rows.resize(0, 5);
    program.bounds.resize(0);
    const Optimum optimum = minimise(program);
    EXPECT_LT((program.hessian * optimum.x - program.right).norm(), 1e-10);
}

// x >= 1 and x <= 0 in one coordinate: halfway, and finite.
TEST(QuadraticProgramTest, ContradictionsAreShared) {
    QuadraticProgram program;
    program.hessian = Eigen::MatrixXd::Identity(2, 2);
    program.right = Eigen::VectorXd::Zero(2);
    program.rows = Eigen::MatrixXd::Zero(2, 2);
    program.rows(0, 0) = 1.0;
    program.rows(1, 0) = -1.0;
    program.bounds = Eigen::Vector2d(1.0, 0.0);
    const Optimum optimum = minimise(program);
    EXPECT_TRUE(optimum.x.allFinite());
    EXPECT_NEAR(optimum.x[0], 0.5, 1e-3);
}
