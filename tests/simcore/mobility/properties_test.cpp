// Properties that hold for every mechanism, checked on random ones by an independent route (SVD).
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <Eigen/SVD>

#include "simcore/mobility/constraint_system.h"
#include "simcore/mobility/moved_pose.h"
#include "tests/support/mechanisms.h"

using namespace simcore;
using namespace simcore::mobility;
using namespace testsupport;

namespace {

/// Between 3 and 8 bodies in a tree with a few extra loops; joints of 1 to 3 freedoms, axes partly
/// parallel so that redundancy occurs; some wheels.
Mechanism makeRandom(unsigned seed) {
    std::mt19937 random(seed);
    const auto real = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto integer = [&](int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(random);
    };
    const auto direction = [&] {
        return integer(0, 2) > 0 ? Vec3(Vec3::Unit(integer(0, 2)))
                                 : Vec3(real(-1, 1), real(-1, 1), real(0.1, 1)).normalized();
    };
    Mechanism mechanism;
    const int bodies = integer(3, 8);
    const auto join = [&](int first, int second) {
        const int index = static_cast<int>(mechanism.joints.size());
        Joint joint = makePin("joint" + std::to_string(index), first, second,
                              {real(-1, 1), real(-1, 1), real(0, 1)}, direction());
        switch (integer(0, 5)) {
            case 0:
                joint.built.push_back({FreedomKind::Slide, direction()});
                break;
            case 1:  // universal, its axes at any angle
                joint.built.push_back(
                    {FreedomKind::Turn, joint.axis.cross(Vec3(0.3, 0.5, 0.8)).normalized()});
                break;
            case 2:  // ball
                joint.built = {{FreedomKind::Turn, Vec3::UnitX()},
                               {FreedomKind::Turn, Vec3::UnitY()},
                               {FreedomKind::Turn, Vec3::UnitZ()}};
                break;
            case 3:  // slider
                joint.built = {{FreedomKind::Slide, direction()}};
                break;
            default:
                break;
        }
        mechanism.joints.push_back(joint);
    };
    for (int i = 0; i < bodies; ++i) {
        mechanism.bodies.push_back(makeBody("body" + std::to_string(i), 1.0, Vec3::Zero()));
        if (i > 0) {
            join(integer(0, i - 1), i);
        }
    }
    for (int loops = integer(0, 3); loops > 0; --loops) {
        const int first = integer(0, bodies - 2);
        join(first, integer(first + 1, bodies - 1));
    }
    for (int i = 0; i < integer(0, 4); ++i) {
        mechanism::Wheel wheel;
        wheel.name = "wheel" + std::to_string(i);
        wheel.body = integer(0, bodies - 1);
        wheel.radius = 0.1;
        wheel.center = {real(-1, 1), real(-1, 1), 0.1};
        mechanism.wheels.push_back(wheel);
    }
    return mechanism;
}

Eigen::Index svdRank(const Eigen::MatrixXd& matrix) {
    if (matrix.size() == 0) {
        return 0;
    }
    Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix);
    svd.setThreshold(1e-9);
    return svd.rank();
}

Eigen::MatrixXd without(const Eigen::MatrixXd& matrix, const std::set<Eigen::Index>& dropped) {
    Eigen::MatrixXd kept(matrix.rows() - static_cast<Eigen::Index>(dropped.size()), matrix.cols());
    Eigen::Index next = 0;
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        if (dropped.count(i) == 0) {
            kept.row(next++) = matrix.row(i);
        }
    }
    return kept;
}

/// Row of the Jacobian that a name belongs to.
Eigen::Index rowOf(const ConstraintJacobian& jacobian, const ConstraintName& name) {
    for (std::size_t i = 0; i < jacobian.names.size(); ++i) {
        const ConstraintName& candidate = jacobian.names[i];
        if (candidate.element == name.element && candidate.kind == name.kind &&
            (candidate.direction - name.direction).norm() < 1e-12) {
            return static_cast<Eigen::Index>(i);
        }
    }
    ADD_FAILURE() << "no row for " << name.element;
    return 0;
}

class RandomMechanismTest : public testing::TestWithParam<unsigned> {};

}  // namespace

TEST_P(RandomMechanismTest, QrAgreesWithSvdAndTheIdentitiesHold) {
    const Mechanism mechanism = makeRandom(GetParam());
    const auto jacobian = constraintJacobian(mechanism, Model::Built);
    const Report report = analyse(mechanism, Model::Built);
    EXPECT_EQ(report.rank, svdRank(jacobian.matrix));
    EXPECT_EQ(report.columns, 6 * static_cast<int>(mechanism.bodies.size()));
    EXPECT_EQ(report.gruebler, report.columns - report.rows);
    EXPECT_EQ(report.mobility, report.gruebler + report.redundant);
    double shares = 0.0;  // trace of the projector on the self-stress states
    for (const ConstraintName& name : report.removable) {
        EXPECT_LE(name.share, 1.0 + 1e-9);
        shares += name.share;
    }
    EXPECT_NEAR(shares, report.redundant, 1e-6);
}

TEST_P(RandomMechanismTest, ExactlyTheRemovableRowsMayGoWithoutNewMotion) {
    const Mechanism mechanism = makeRandom(GetParam());
    const auto jacobian = constraintJacobian(mechanism, Model::Built);
    const Report report = analyse(mechanism, Model::Built);
    std::set<Eigen::Index> removable;
    for (const ConstraintName& name : report.removable) {
        removable.insert(rowOf(jacobian, name));
    }
    for (Eigen::Index i = 0; i < jacobian.matrix.rows(); ++i) {
        const bool keepsRank = svdRank(without(jacobian.matrix, {i})) == report.rank;
        EXPECT_EQ(keepsRank, removable.count(i) == 1)
            << jacobian.names[static_cast<std::size_t>(i)].element;
    }
}

TEST_P(RandomMechanismTest, WithoutTheRedundantSetAllRowsAreIndependent) {
    const Mechanism mechanism = makeRandom(GetParam());
    const auto jacobian = constraintJacobian(mechanism, Model::Built);
    const Report report = analyse(mechanism, Model::Built);
    std::set<Eigen::Index> set;
    for (const ConstraintName& name : report.redundantSet) {
        set.insert(rowOf(jacobian, name));
    }
    ASSERT_EQ(static_cast<int>(set.size()), report.redundant);
    const Eigen::MatrixXd kept = without(jacobian.matrix, set);
    EXPECT_EQ(kept.rows(), report.rank);
    EXPECT_EQ(svdRank(kept), report.rank);
}

// The documented meaning: kept in order of priority, a row that depends on kept ones is given up.
TEST_P(RandomMechanismTest, RedundantSetFollowsThePriority) {
    const Mechanism mechanism = makeRandom(GetParam());
    const auto jacobian = constraintJacobian(mechanism, Model::Built);
    const Report report = analyse(mechanism, Model::Built);
    std::map<Priority, int> expected;
    Eigen::MatrixXd kept(0, jacobian.matrix.cols());
    for (const Priority priority :
         {Priority::ContactNormal, Priority::ContactRolling, Priority::Gear, Priority::JointSlide,
          Priority::JointTurn, Priority::ContactLateral}) {
        for (Eigen::Index i = 0; i < jacobian.matrix.rows(); ++i) {
            if (jacobian.priorities[static_cast<std::size_t>(i)] != priority) {
                continue;
            }
            Eigen::MatrixXd more(kept.rows() + 1, kept.cols());
            more << kept, jacobian.matrix.row(i);
            if (svdRank(more) == more.rows()) {
                kept = more;
            } else {
                ++expected[priority];
            }
        }
    }
    std::map<Priority, int> found;
    for (const ConstraintName& name : report.redundantSet) {
        ++found[jacobian.priorities[static_cast<std::size_t>(rowOf(jacobian, name))]];
    }
    EXPECT_EQ(found, expected);
}

// The matrix is the derivative of nonlinear closure conditions that were written down on their own.
TEST_P(RandomMechanismTest, MatrixIsTheDerivativeOfTheClosure) {
    const Mechanism mechanism = makeRandom(GetParam());
    const ConstraintSystem system(mechanism, Model::Built, drawnStance(mechanism));
    const Eigen::MatrixXd matrix = system.matrix(system.start());
    constexpr double kStep = 1e-6;
    Eigen::MatrixXd differences(matrix.rows(), matrix.cols());
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) {
        const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(matrix.cols(), k);
        differences.col(k) = (system.residual(system.moved(system.start(), step)) -
                              system.residual(system.moved(system.start(), -step))) /
                             (2.0 * kStep);
    }
    EXPECT_LT((differences - matrix).cwiseAbs().maxCoeff(), 1e-8);
    Eigen::JacobiSVD<Eigen::MatrixXd> svd(differences);
    svd.setThreshold(1e-7);  // of the differences
    EXPECT_EQ(svd.rank(), analyse(mechanism, Model::Built).rank);
}

// A finite motion has no more freedoms than velocities have, and those that close keep all rows.
TEST_P(RandomMechanismTest, ContinuedMotionsKeepEveryConstraint) {
    const Mechanism mechanism = makeRandom(GetParam());
    const ConstraintSystem system(mechanism, Model::Built, drawnStance(mechanism));
    const Report report = analyse(mechanism, Model::Built);
    const MovedPose moved = movedPose(mechanism, Model::Built, system.start());
    EXPECT_EQ(static_cast<int>(moved.motions.size()), report.mobility);
    EXPECT_LE(moved.mobility, report.mobility);
    for (const FreeMotion& motion : moved.motions) {
        if (motion.continuation != Continuation::Infinitesimal) {
            const Eigen::VectorXd left = system.residual(motion.reached);
            EXPECT_TRUE(left.size() == 0 || left.cwiseAbs().maxCoeff() <= 1e-12);
        } else {
            EXPECT_FALSE(motion.inconsistent.empty());
        }
    }
}

// Turning the rover about the vertical, moving it and changing its size changes no count.
TEST_P(RandomMechanismTest, CountsDoNotDependOnPlaceHeadingOrSize) {
    const Mechanism mechanism = makeRandom(GetParam());
    Mechanism moved = mechanism;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3::UnitZ()).toRotationMatrix();
    const double size = 30.0;
    for (Joint& joint : moved.joints) {
        joint.point = size * (turn * joint.point) + Vec3(2.0, -1.0, 0.0);
        joint.axis = turn * joint.axis;
        for (Freedom& freedom : joint.built) {
            freedom.direction = turn * freedom.direction;
        }
    }
    for (mechanism::Wheel& wheel : moved.wheels) {
        wheel.center = size * (turn * wheel.center) + Vec3(2.0, -1.0, 0.0);
        wheel.axis = turn * wheel.axis;
        wheel.radius *= size;
    }
    const Report before = analyse(mechanism, Model::Built);
    const Report after = analyse(moved, Model::Built);
    EXPECT_EQ(after.rank, before.rank);
    EXPECT_EQ(after.mobility, before.mobility);
    EXPECT_EQ(after.idle.size(), before.idle.size());
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomMechanismTest, testing::Range(1U, 41U));

// The checks above would mean little if nothing in the sample were redundant.
TEST(RandomSampleTest, HasRedundantAndExactMechanisms) {
    int redundant = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        redundant += analyse(makeRandom(seed), Model::Built).redundant > 0 ? 1 : 0;
    }
    EXPECT_GE(redundant, 8);
    EXPECT_LE(redundant, 32);
}

TEST(OrthogonalComplementTest, CompletesAnyDirectionsToABasis) {
    EXPECT_EQ(mechanism::orthogonalComplement({}).size(), 3U);
    EXPECT_EQ(mechanism::orthogonalComplement({Vec3::UnitX(), -Vec3::UnitX()}).size(), 2U);
    const Vec3 skew = Vec3(0.3, -0.8, 0.2);
    const auto rest = mechanism::orthogonalComplement({skew});
    ASSERT_EQ(rest.size(), 2U);
    EXPECT_NEAR(rest[0].dot(skew), 0.0, 1e-12);
    EXPECT_NEAR(rest[1].dot(skew), 0.0, 1e-12);
    EXPECT_NEAR(rest[0].dot(rest[1]), 0.0, 1e-12);
    EXPECT_TRUE(mechanism::orthogonalComplement({skew, Vec3::UnitX(), Vec3::UnitZ()}).empty());
}
