// The search for exact sets against trying everything, and its criterion against the analysis.
#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "simcore/base/random.h"
#include "simcore/mobility/constraint_jacobian.h"
#include "simcore/mobility/exact_sets.h"
#include "simcore/mobility/factorisation.h"
#include "simcore/mobility/mobility.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::mobility;
using Eigen::MatrixXd;
using mechanism::Freedom;
using mechanism::FreedomKind;
using mechanism::Mechanism;

namespace {

const std::function<bool()> kNeverStop = [] { return false; };

using Elements = std::vector<std::vector<Choice>>;

MatrixXd stackOf(const Elements& elements, const std::vector<int>& choice, int columns) {
    MatrixXd rows(0, columns);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (choice[i] >= 0) {
            const MatrixXd& more = elements[i][static_cast<std::size_t>(choice[i])].relieved;
            rows.conservativeResize(rows.rows() + more.rows(), Eigen::NoChange);
            rows.bottomRows(more.rows()) = more;
        }
    }
    return rows;
}

double leastSingularValue(const MatrixXd& square) {
    return Eigen::JacobiSVD<MatrixXd>(square).singularValues().minCoeff();
}

/// Elements by lot, some of whose rows repeat or add up to others.
Elements randomElements(Random& random, int columns) {
    Elements elements(5);
    for (std::vector<Choice>& choices : elements) {
        const int count = 1 + static_cast<int>(random.next() % 3U);
        for (int k = 0; k < count; ++k) {
            Choice choice;
            choice.cost = 1 + static_cast<int>(random.next() % 4U);
            choice.relieved.resize(1 + static_cast<int>(random.next() % 2U), columns);
            for (Eigen::Index r = 0; r < choice.relieved.rows(); ++r) {
                for (Eigen::Index c = 0; c < columns; ++c) {
                    choice.relieved(r, c) = std::floor(random.uniform(-1.0, 2.0));
                }
            }
            choices.push_back(choice);
        }
    }
    return elements;
}

std::set<std::pair<int, std::vector<int>>> tryEverything(const Elements& elements, int columns) {
    std::set<std::pair<int, std::vector<int>>> exact;
    std::vector<int> choice(elements.size(), -1);
    const std::function<void(std::size_t, int)> walk = [&](std::size_t element, int cost) {
        if (element == elements.size()) {
            const MatrixXd rows = stackOf(elements, choice, columns);
            if (rows.rows() == columns && leastSingularValue(rows) > 1e-6) {
                exact.insert({cost, choice});
            }
            return;
        }
        for (int k = -1; k < static_cast<int>(elements[element].size()); ++k) {
            choice[element] = k;
            walk(element + 1,
                 cost + (k < 0 ? 0 : elements[element][static_cast<std::size_t>(k)].cost));
        }
    };
    walk(0, 0);
    return exact;
}

/// The shipped SOLERO, relaxed, but for its left bogie, which is as built.
Mechanism withOneBogieAsBuilt() {
    Mechanism rover = testsupport::mechanismOf("solero");
    for (mechanism::Joint& joint : rover.joints) {
        if (joint.name.find("bogie_left") == 0) {
            joint.relaxed = joint.built;
        }
    }
    return rover;
}

const std::vector<std::string> kPins{"upper_pivot", "lower_pivot", "upper_front",
                                     "upper_rear",  "lower_front", "lower_rear"};

}  // namespace

TEST(ExactSetSearchTest, FindsWhatTryingEverythingFinds) {
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const int columns = 2 + static_cast<int>(random.next() % 4U);
        const Elements elements = randomElements(random, columns);
        ExactSetSearch search(elements, columns);
        std::set<std::pair<int, std::vector<int>>> sets;
        int previous = -1;
        for (const int cost : search.costs()) {
            EXPECT_GT(cost, previous);
            previous = cost;
            EXPECT_TRUE(search.visit(cost, kNeverStop, [&](const ExactSet& set) {
                EXPECT_EQ(set.cost, cost);
                EXPECT_NEAR(set.margin, leastSingularValue(stackOf(elements, set.choice, columns)),
                            1e-9);
                EXPECT_TRUE(sets.insert({cost, set.choice}).second) << "found twice";
            }));
        }
        const auto exact = tryEverything(elements, columns);
        EXPECT_EQ(sets, exact);
        found += static_cast<int>(exact.size());
    }
    EXPECT_GT(found, 1000);  // or the lots are of no use
}

TEST(ExactSetSearchTest, NothingRedundantNeedsNothing) {
    ExactSetSearch search({}, 0);
    int sets = 0;
    for (const int cost : search.costs()) {
        search.visit(cost, kNeverStop, [&](const ExactSet& set) {
            EXPECT_EQ(set.cost, 0);
            ++sets;
        });
    }
    EXPECT_EQ(sets, 1);
}

TEST(ExactSetSearchTest, StopsWhenAsked) {
    // 2^20 sets of 10 out of 20 equal elements: far more steps than between two questions.
    Random random(7);
    Elements elements(20);
    for (std::vector<Choice>& choices : elements) {
        choices.push_back({1, MatrixXd(1, 10)});
        for (Eigen::Index c = 0; c < 10; ++c) {
            choices.back().relieved(0, c) = random.uniform(-1.0, 1.0);
        }
    }
    ExactSetSearch search(elements, 10);
    int asked = 0;
    int sets = 0;
    EXPECT_FALSE(search.visit(
        10, [&] { return ++asked == 3; }, [&](const ExactSet& /*set*/) { ++sets; }));
    EXPECT_EQ(asked, 3);
    EXPECT_LT(sets, 1000);
    EXPECT_TRUE(search.visit(9, kNeverStop, [&](const ExactSet& /*set*/) { FAIL(); }));
}

// Of the 60 ways to place two balls and a ball with slide in a bogie, the search finds those that
// the analysis calls exact, each built and analysed on its own: 18, all with the slide in the
// bogie's plane and at right angles to its bars.
TEST(ExactSetSearchTest, AgreesWithTheAnalysisOnAllSixtyAssignmentsOfABogie) {
    const Mechanism rover = withOneBogieAsBuilt();
    ASSERT_EQ(analyse(rover, Model::Relaxed).redundant, 7);
    const ConstraintJacobian jacobian = constraintJacobian(rover, Model::Relaxed);
    const MatrixXd states = Factorisation(jacobian.matrix).selfStress;
    const std::vector<Freedom> ball{{FreedomKind::Turn, Vec3::UnitX()},
                                    {FreedomKind::Turn, Vec3::UnitY()},
                                    {FreedomKind::Turn, Vec3::UnitZ()}};
    for (int axis = 0; axis < 3; ++axis) {
        SCOPED_TRACE(axis);
        std::vector<int> pins;
        Elements elements;
        for (const std::string& name : kPins) {
            pins.push_back(rover.findJoint("bogie_left_" + name));
            MatrixXd turns(0, states.cols());
            MatrixXd slide(0, states.cols());
            for (std::size_t i = 0; i < jacobian.names.size(); ++i) {
                const ConstraintName& row = jacobian.names[i];
                const bool wanted = row.joint == pins.back() &&
                                    (row.kind == "turn" || std::abs(row.direction[axis]) > 0.5);
                if (wanted) {
                    MatrixXd& rows = row.kind == "turn" ? turns : slide;
                    rows.conservativeResize(rows.rows() + 1, Eigen::NoChange);
                    rows.bottomRows(1) = states.row(static_cast<Eigen::Index>(i));
                }
            }
            MatrixXd both(turns.rows() + slide.rows(), states.cols());
            both << turns, slide;
            ASSERT_EQ(both.rows(), 3);
            elements.push_back({{2, turns}, {5, both}});
        }
        std::set<std::vector<int>> found;
        ExactSetSearch search(elements, 7);
        search.visit(9, kNeverStop, [&](const ExactSet& set) { found.insert(set.choice); });
        std::set<std::vector<int>> exact;
        std::vector<int> choice{-1, -1, -1, 0, 0, 1};
        int tried = 0;
        do {
            Mechanism variant = rover;
            for (std::size_t k = 0; k < pins.size(); ++k) {
                if (choice[k] >= 0) {
                    auto& relaxed = variant.joints[static_cast<std::size_t>(pins[k])].relaxed;
                    relaxed = ball;
                    if (choice[k] == 1) {
                        relaxed.push_back({FreedomKind::Slide, Vec3::Unit(axis)});
                    }
                }
            }
            const Report report = analyse(variant, Model::Relaxed);
            EXPECT_EQ(report.gruebler, 1);
            if (report.redundant == 0) {
                EXPECT_EQ(report.mobility, 1);
                exact.insert(choice);
            }
            ++tried;
        } while (std::next_permutation(choice.begin(), choice.end()));
        EXPECT_EQ(tried, 60);
        EXPECT_EQ(exact.size(), axis == 2 ? 18U : 0U);
        EXPECT_EQ(found, exact);
    }
}
