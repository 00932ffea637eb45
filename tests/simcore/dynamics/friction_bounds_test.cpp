// Friction limits that follow the normal forces of the same step: the fixed point alone with
// solvers that can be solved by hand, then a drum in a corner through the engine.
#include <cmath>

#include <gtest/gtest.h>

#include "simcore/dynamics/engine.h"
#include "simcore/dynamics/friction_bounds.h"
#include "tests/support/carts.h"

using namespace simcore;
using namespace simcore::dynamics;
using namespace testsupport;

namespace {

constexpr double kMu = 0.7;

contact::Contact floorContact(int wheel = 0, int slice = 0, const Vec3& point = Vec3::Zero()) {
    contact::Contact contact;
    contact.wheel = wheel;
    contact.slice = slice;
    contact.point = point;
    return contact;
}

/// Remembers one step in which the contact carried this force.
FrictionBounds after(const contact::Contact& contact, const Vec3& force) {
    FrictionBounds bounds;
    bounds.begin({&contact, 1}, {&kMu, 1});
    bounds.end({&contact, 1}, {&force, 1});
    return bounds;
}

}  // namespace

// A new contact has no normal force yet: the solver guesses, along the rolling direction.
TEST(FrictionBoundsTest, NewContactIsGuessed) {
    FrictionBounds bounds;
    const contact::Contact contact = floorContact();
    bounds.begin({&contact, 1}, {&kMu, 1});
    EXPECT_TRUE(bounds.box(0).fromNormalForce);
    EXPECT_EQ(bounds.box(0).direction, contact.forward);
}

// The first limit of a known contact is mu times its last normal force, along its last tangential
// force.
TEST(FrictionBoundsTest, KnownContactStartsFromItsLastForce) {
    const contact::Contact contact = floorContact();
    FrictionBounds bounds = after(contact, {3.0, 4.0, 20.0});
    contact::Contact moved = contact;
    moved.point.x() += 0.02;
    bounds.begin({&moved, 1}, {&kMu, 1});
    EXPECT_FALSE(bounds.box(0).fromNormalForce);
    EXPECT_DOUBLE_EQ(bounds.box(0).along, kMu * 20.0);
    EXPECT_LT((bounds.box(0).direction - Vec3(0.6, 0.8, 0.0)).norm(), 1e-12);
}

// A contact of another wheel or disc, or one too far away, is a new one.
TEST(FrictionBoundsTest, OtherContactsAreNotMistakenForKnownOnes) {
    FrictionBounds bounds = after(floorContact(1, 0), {0.0, 0.0, 20.0});
    for (const contact::Contact& other :
         {floorContact(0, 0), floorContact(1, 1), floorContact(1, 0, {0.04, 0.0, 0.0})}) {
        bounds.begin({&other, 1}, {&kMu, 1});
        EXPECT_TRUE(bounds.box(0).fromNormalForce);
    }
}

// Of two contacts on one disc (floor and wall) each continues as the nearer one.
TEST(FrictionBoundsTest, NearestContactOfADiscIsRecalled) {
    std::vector<contact::Contact> contacts{floorContact(), floorContact(0, 0, {0.02, 0.0, 0.02})};
    contacts[1].normal = -Vec3::UnitX();
    contacts[1].forward = Vec3::UnitZ();
    const std::vector<Vec3> forces{{0.0, 0.0, 20.0}, {-6.0, 0.0, 0.0}};
    FrictionBounds bounds;
    bounds.begin(contacts, std::vector<double>(contacts.size(), kMu));
    bounds.end(contacts, forces);
    std::swap(contacts[0], contacts[1]);
    bounds.begin(contacts, std::vector<double>(contacts.size(), kMu));
    EXPECT_DOUBLE_EQ(bounds.box(0).along, kMu * 6.0);
    EXPECT_DOUBLE_EQ(bounds.box(1).along, kMu * 20.0);
}

// Forces within the cone of their own normal force are agreed to, forces outside are not, and a
// force that a too small limit held back is not either.
TEST(FrictionBoundsTest, AgreesWithForcesInTheConeOnly) {
    const contact::Contact contact = floorContact();
    const Vec3 rest = Vec3::Zero();
    const auto agrees = [&](double lastNormal, const Vec3& force) {
        FrictionBounds bounds = after(contact, {0.0, 0.0, lastNormal});
        bounds.begin({&contact, 1}, {&kMu, 1});
        return bounds.update({&contact, 1}, {&force, 1}, {&rest, 1});
    };
    EXPECT_TRUE(agrees(20.0, {5.0, 0.0, 20.0}));          // sticks
    EXPECT_TRUE(agrees(20.0, {kMu * 20.0, 0.0, 20.0}));   // slides, limit is right
    EXPECT_FALSE(agrees(20.0, {kMu * 20.0, 0.0, 10.0}));  // outside the cone
    EXPECT_FALSE(agrees(10.0, {kMu * 10.0, 0.0, 20.0}));  // held back by an old limit
    EXPECT_FALSE(agrees(20.0, {10.0, 10.0, 18.0}));       // outside on the diagonal only
}

// A sliding wheel is braked against its sliding direction, whatever that is.
TEST(FrictionBoundsTest, BoxTurnsAgainstSliding) {
    const contact::Contact contact = floorContact();
    FrictionBounds bounds;
    bounds.begin({&contact, 1}, {&kMu, 1});
    const Vec3 force(1.0, 0.0, 20.0);
    const Vec3 velocity(-0.3, 0.4, 0.05);
    (void)bounds.update({&contact, 1}, {&force, 1}, {&velocity, 1});
    EXPECT_LT((bounds.box(0).direction - Vec3(0.6, -0.8, 0.0)).norm(), 1e-12);
    EXPECT_DOUBLE_EQ(bounds.box(0).along, kMu * 20.0);
    EXPECT_LT(std::hypot(bounds.box(0).along, bounds.box(0).across), 1.03 * kMu * 20.0);
}

// The normal force may depend on friction, N = N0 + c T, as at a wedge: the limit converges to
// mu N0 / (1 - mu c) from any start, and what a step agrees to is within 10 % of the cone.
TEST(FrictionBoundsTest, FixedPointIsThatOfTheWedge) {
    constexpr double kLoad = 20.0;
    for (const double coupling : {-0.8, 0.5, 1.0}) {
        const double expected = kMu * kLoad / (1.0 - kMu * coupling);
        for (const double lastNormal : {1.0, 20.0, 200.0}) {
            const contact::Contact contact = floorContact();
            FrictionBounds bounds = after(contact, {0.0, 0.0, lastNormal});
            double tangential = 0.0;
            for (int step = 0; step < 20; ++step) {
                bounds.begin({&contact, 1}, {&kMu, 1});
                Vec3 force;
                for (int pass = 0; pass < 6; ++pass) {
                    tangential = bounds.box(0).along;  // it slides: friction is at its limit
                    force = {tangential, 0.0, kLoad + coupling * tangential};
                    const Vec3 velocity(-0.1, 0.0, 0.0);
                    if (bounds.update({&contact, 1}, {&force, 1}, {&velocity, 1})) {
                        EXPECT_LE(tangential, 1.1 * kMu * force.z());
                        break;
                    }
                }
                bounds.end({&contact, 1}, {&force, 1});
            }
            EXPECT_NEAR(tangential, expected, 0.01 * expected)
                << "coupling " << coupling << " from " << lastNormal;
        }
    }
}

TEST(FrictionBoundsTest, SavedMemoryIsRestored) {
    FrictionBounds bounds = after(floorContact(2, 1, {0.1, 0.2, 0.3}), {3.0, 4.0, 20.0});
    std::vector<double> numbers;
    bounds.save(numbers);
    FrictionBounds other;
    other.restore(numbers);
    std::vector<double> again;
    other.save(again);
    EXPECT_EQ(again, numbers);
    EXPECT_FALSE(numbers.empty());
    numbers.pop_back();
    EXPECT_THROW(other.restore(numbers), std::invalid_argument);
}

namespace {

constexpr double kRadius = 0.1;
constexpr double kMass = 2.0;
constexpr double kStep = 0.002;
constexpr double kG = 9.81;

/// A drum on the floor that touches a wall ahead of it, turned by an external torque.
class CornerTest : public ::testing::Test {
  protected:
    void run(double seconds, double torque, double friction) {
        const std::vector<double> none{0.0};
        const std::vector<double> external{torque};
        for (long i = std::lround(seconds / kStep); i > 0; --i) {
            contacts = finder.find(engine->poses());
            const std::vector<double> frictions(contacts.size(), friction);
            engine->step({none, external, contacts, frictions});
        }
    }

    double rate() const { return engine->velocities()[0].angular.y(); }

    /// Normal force and friction (+ as it acts on a drum that spins forward) of floor or wall [N].
    std::pair<double, double> forces(bool wall) const {
        std::pair<double, double> sum{0.0, 0.0};
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const Vec3& force = engine->contactForces()[i];
            if ((contacts[i].normal.x() < -0.9) == wall) {
                sum.first += force.dot(contacts[i].normal);
                sum.second += force.dot(contacts[i].forward);
            }
        }
        return sum;
    }

    const Mechanism drum = makeDrum(kMass, kRadius, 0.08, {0.0, 0.0, kRadius});
    const terrain::Terrain corner = terrain::Terrain::extruded(
        {{-5.0, 0.0}, {kRadius, 0.0}, {kRadius, 1.0}, {5.0, 1.0}}, -1.0, 1.0);
    contact::WheelContactFinder finder{drum, corner};
    std::unique_ptr<Engine> engine = makeOdeEngine(drum, {kStep, kG});
    std::vector<contact::Contact> contacts;
};

}  // namespace

// A spinning drum in a corner: friction at the floor F1 = mu N1 presses it to the wall, N2 = F1,
// where friction F2 = mu N2 lifts it, N1 + F2 = m g. So N1 = m g / (1 + mu^2), and the wall, which
// would carry nothing without friction, grips with mu^2 m g / (1 + mu^2).
TEST_F(CornerTest, WallGripsADrumPressedByFrictionOnly) {
    for (const double mu : {0.4, 0.7, 1.0}) {
        engine->reset();
        const double n1 = kMass * kG / (1.0 + mu * mu);
        const double n2 = mu * n1;
        const double slipping = kRadius * mu * (n1 + n2);
        const double torque = 1.5 * slipping;
        run(0.5, torque, mu);
        const double start = rate();
        run(0.3, torque, mu);
        ASSERT_EQ(contacts.size(), 4u);
        const auto [floorN, floorT] = forces(false);
        const auto [wallN, wallT] = forces(true);
        EXPECT_NEAR(floorN, n1, 0.02 * n1) << "mu " << mu;
        EXPECT_NEAR(wallN, n2, 0.02 * n1) << "mu " << mu;
        EXPECT_NEAR(floorT, mu * n1, 0.02 * n1) << "mu " << mu;
        EXPECT_NEAR(wallT, mu * n2, 0.02 * n1) << "mu " << mu;
        // What friction leaves of the torque spins the drum up.
        const double inertia = 0.5 * kMass * kRadius * kRadius;
        const double expected = (torque - slipping) / inertia;
        EXPECT_NEAR((rate() - start) / 0.3, expected, 0.02 * expected) << "mu " << mu;
    }
}

// Below the torque at which both contacts slip, R mu m g (1 + mu) / (1 + mu^2), the drum holds.
TEST_F(CornerTest, DrumHoldsUpToTheTorqueOfStatics) {
    for (const double mu : {0.4, 0.7}) {
        const double slipping = kRadius * mu * kMass * kG * (1.0 + mu) / (1.0 + mu * mu);
        engine->reset();
        run(0.5, 0.5 * slipping, mu);  // presses itself to the wall
        run(0.5, 0.93 * slipping, mu);
        EXPECT_LT(std::abs(rate()), 0.05) << "mu " << mu;
        run(0.5, 1.07 * slipping, mu);
        EXPECT_GT(rate(), 0.5) << "mu " << mu;
    }
}

// On level ground a sliding drum is held by mu N of the same step, against its sliding, while N
// itself swings as it lands; within 2 % once it has landed.
TEST(SlidingTest, FrictionIsMuTimesTheNormalForce) {
    const Mechanism drum = makeDrum(kMass, kRadius, 0.08, {0.0, 0.0, kRadius + 0.002});
    const terrain::Terrain ground = levelGround();
    contact::WheelContactFinder finder(drum, ground);
    const auto engine = makeOdeEngine(drum, {kStep, kG});
    const std::vector<double> none{0.0};
    const std::vector<double> spin{5.0};
    int slid = 0;
    double worst = 0.0;
    double lateral = 0.0;
    double last = 0.0;
    for (int i = 0; i < 200; ++i) {
        const auto& contacts = finder.find(engine->poses());
        const std::vector<double> frictions(contacts.size(), 0.3);
        engine->step({none, i < 20 ? spin : none, contacts, frictions});
        Vec3 force = Vec3::Zero();  // of both discs: how they share what is lateral is open
        for (const Vec3& part : engine->contactForces()) {
            force += part;
        }
        const double slip =
            engine->velocities()[0].linear.x() - kRadius * engine->velocities()[0].angular.y();
        if (force.z() > 2.0 && slip < -0.05) {
            ++slid;
            worst = std::max(worst, std::abs(force.x() / force.z() - 0.3) / 0.3);
            if (slip < -0.5) {
                last = force.x() / force.z();
            }
            lateral = std::max(lateral, std::abs(force.y()) / force.z());
        }
    }
    EXPECT_LT(lateral, 0.01 * 0.3);      // to what limits and normal forces agree
    EXPECT_NEAR(last, 0.3, 0.02 * 0.3);  // corners of the friction box stand 2 % outside
    EXPECT_GT(slid, 50);
    EXPECT_LT(worst, 0.1);  // from where a patch counts as a friction violation
    EXPECT_GT(engine->counters().passes, engine->counters().steps);
}
