// Required friction by two other routes: linear programs of a library, and a grid.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <ClpSimplex.hpp>
#include <CoinPackedMatrix.hpp>
#include <CoinPackedVector.hpp>

#include "simcore/statics/static_study.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::statics;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// By how much |T| <= mu N has to be exceeded at some contact, over all U with M U = R, N >= 0 and
/// |tau| <= limit [N]: without lateral forces a linear program.
double excessAt(double mu, const Equilibrium& e, const mechanism::Mechanism& mechanism) {
    const auto unknowns = static_cast<int>(e.matrix.cols());
    const int excess = unknowns;
    CoinPackedMatrix matrix(false, 0, 0);
    matrix.setDimensions(0, unknowns + 1);
    std::vector<double> low, high;
    const auto addRow = [&](const std::vector<std::pair<int, double>>& terms, double from,
                            double to) {
        CoinPackedVector row;
        for (const auto& [column, factor] : terms) {
            if (std::abs(factor) > 1e-12) {
                row.insert(column, factor);
            }
        }
        matrix.appendRow(row);
        low.push_back(from);
        high.push_back(to);
    };
    for (Eigen::Index i = 0; i < e.matrix.rows(); ++i) {
        std::vector<std::pair<int, double>> terms;
        for (int k = 0; k < unknowns; ++k) {
            terms.emplace_back(k, e.matrix(i, k));
        }
        addRow(terms, e.right[i], e.right[i]);
    }
    for (std::size_t i = 0; i < e.normal.size(); ++i) {
        for (const double sign : {1.0, -1.0}) {
            addRow({{e.traction[i], sign}, {e.normal[i], -mu}, {excess, -1.0}}, -COIN_DBL_MAX, 0.0);
        }
    }
    std::vector<double> least(static_cast<std::size_t>(unknowns) + 1, -COIN_DBL_MAX);
    std::vector<double> most(static_cast<std::size_t>(unknowns) + 1, COIN_DBL_MAX);
    std::vector<double> cost(static_cast<std::size_t>(unknowns) + 1, 0.0);
    least.back() = 0.0;
    cost.back() = 1.0;
    for (const int column : e.normal) {
        least[static_cast<std::size_t>(column)] = 0.0;
    }
    for (std::size_t w = 0; w < e.torque.size(); ++w) {
        const auto column = static_cast<std::size_t>(e.torque[w]);
        least[column] = -mechanism.wheels[w].torqueLimit;
        most[column] = mechanism.wheels[w].torqueLimit;
    }
    ClpSimplex program;
    program.setLogLevel(0);
    program.setPrimalTolerance(1e-9);
    program.loadProblem(matrix, least.data(), most.data(), cost.data(), low.data(), high.data());
    program.dual();
    program.primal();
    EXPECT_TRUE(program.isProvenOptimal());
    return program.objectiveValue();
}

double leastByLinearPrograms(const Equilibrium& e, const mechanism::Mechanism& mechanism) {
    double low = 0.0;
    double high = 10.0;
    while (high - low > 1e-8) {
        const double middle = 0.5 * (low + high);
        (excessAt(middle, e, mechanism) < 1e-8 ? high : low) = middle;
    }
    return high;
}

struct Stand {
    std::string rover;
    std::vector<std::pair<std::string, double>> angles;  ///< [deg]
};

}  // namespace

TEST(RequiredFrictionTest, AgreesWithLinearProgramsOfClp) {
    const std::vector<Stand> stands{
        {"solero", {{"front", 90.0}}},
        {"solero", {{"front", 45.0}}},
        {"solero", {{"bogie_left_front", 60.0}, {"bogie_right_front", 60.0}}},
        {"solero", {{"bogie_left_rear", 90.0}, {"bogie_right_rear", 90.0}}},
        {"solero", {{"rear", 70.0}}},
        {"solero", {{"rear", -30.0}, {"front", 20.0}}},
        {"shrimp", {{"front", 85.0}}},
        {"shrimp", {{"rear", 90.0}}},
        {"shrimp", {{"bogie_left_front", 80.0}, {"bogie_right_front", 80.0}}},
    };
    for (const Stand& stand : stands) {
        const mechanism::Mechanism mechanism = testsupport::mechanismOf(stand.rover);
        StaticModel model(mechanism, Model::Built);
        std::vector<Contact> contacts;
        std::string name = stand.rover;
        for (std::size_t w = 0; w < mechanism.wheels.size(); ++w) {
            double angle = 0.0;
            for (const auto& [wheel, degrees] : stand.angles) {
                angle = wheel == mechanism.wheels[w].name ? degrees : angle;
            }
            name += " " + std::to_string(angle);
            contacts.push_back(
                contactAtAngle(mechanism, static_cast<int>(w), model.poses(), angle * kDegree));
        }
        const Equilibrium equilibrium = model.equilibrium(contacts, ContactSet::Free, 9.80665);
        // The two lateral forces that the paper leaves are zero where left and right are alike.
        const Traction traction(equilibrium, mechanism, contacts);
        const Solution best = traction.best(Objective::Friction);
        ASSERT_NE(best.way, Way::None) << name;
        EXPECT_NEAR(best.friction, leastByLinearPrograms(equilibrium, mechanism), 1e-6) << name;
    }
}

// Nothing within 3 N of the answer along any two axes of the solutions asks for less.
TEST(RequiredFrictionTest, NoPointOfAGridIsBetter) {
    const mechanism::Mechanism solero = testsupport::mechanismOf("solero");
    StaticModel model(solero, Model::Built);
    std::vector<Contact> contacts;
    for (int w = 0; w < 6; ++w) {
        contacts.push_back(contactAtAngle(solero, w, model.poses(),
                                          (w == 0   ? 80.0
                                           : w == 2 ? 10.0
                                                    : 0.0) *
                                              kDegree));
    }
    const Traction traction(model.equilibrium(contacts, ContactSet::All, 9.80665), solero,
                            contacts);
    const Solution best = traction.best(Objective::Friction);
    ASSERT_NE(best.way, Way::None);
    for (int a = 0; a < traction.dimension(); ++a) {
        for (int b = 0; b < a; ++b) {
            for (int i = -6; i <= 6; ++i) {
                for (int k = -6; k <= 6; ++k) {
                    const Forces other =
                        traction.moved(traction.moved(best.forces, a, 0.5 * i), b, 0.5 * k);
                    if (other.minNormal() >= 0.0) {
                        EXPECT_GE(other.maxRatio(), best.friction - 1e-7) << a << b;
                    }
                }
            }
        }
    }
}
