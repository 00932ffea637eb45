// The drawing of the graph: nobody in another's place, the right side the mirror image of the left.
#include <gtest/gtest.h>

#include "simcore/mobility/joint_graph.h"
#include "tests/support/linkages.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::mobility;
using namespace testsupport;

namespace {

void expectDrawn(const Mechanism& mechanism) {
    SCOPED_TRACE(mechanism.name);
    const JointGraph graph = jointGraph(mechanism);
    ASSERT_EQ(graph.bodies.size(), mechanism.bodies.size());
    ASSERT_EQ(graph.edges.size(), mechanism.joints.size() + mechanism.wheels.size());
    for (std::size_t a = 0; a < graph.bodies.size(); ++a) {
        for (std::size_t b = a + 1; b < graph.bodies.size(); ++b) {
            EXPECT_GT((graph.bodies[a] - graph.bodies[b]).norm(), 0.99)
                << mechanism.bodies[a].name << " and " << mechanism.bodies[b].name;
        }
    }
    for (const GraphEdge& edge : graph.edges) {
        if (edge.joint < 0) {
            continue;
        }
        const auto& joint = mechanism.joints[static_cast<std::size_t>(edge.joint)];
        EXPECT_EQ(edge.path.front(), graph.bodies[static_cast<std::size_t>(joint.first)]);
        EXPECT_EQ(edge.path.back(), graph.bodies[static_cast<std::size_t>(joint.second)]);
        // A passage is nobody's place.
        for (std::size_t i = 1; i + 1 < edge.path.size(); ++i) {
            for (const GraphPoint& body : graph.bodies) {
                EXPECT_GT((edge.path[i] - body).norm(), 0.99);
            }
        }
    }
}

}  // namespace

TEST(JointGraphTest, EveryShippedRoverIsDrawnWithoutOverlap) {
    for (const std::string& name : shippedNames()) {
        expectDrawn(mechanismOf(name));
    }
    expectDrawn(FourBar().make(1.1));
    expectDrawn(makeDifferential(-1.0));
}

TEST(JointGraphTest, MirroredPartsStandMirrored) {
    const Mechanism rover = mechanismOf("solero");
    const JointGraph graph = jointGraph(rover);
    EXPECT_EQ(graph.bodies[static_cast<std::size_t>(rover.chassis)], GraphPoint(0.0, 0.0));
    int pairs = 0;
    for (std::size_t a = 0; a < rover.bodies.size(); ++a) {
        for (std::size_t b = 0; b < rover.bodies.size(); ++b) {
            const Vec3 mirrored = rover.bodies[b].com.cwiseProduct(Vec3(1.0, -1.0, 1.0));
            if (rover.bodies[a].com.y() > 0.01 && (rover.bodies[a].com - mirrored).norm() < 1e-9 &&
                rover.bodies[a].name.find("left") != std::string::npos) {
                ++pairs;
                EXPECT_LT(graph.bodies[a].x(), 0.0) << rover.bodies[a].name;
                EXPECT_EQ(graph.bodies[a].x(), -graph.bodies[b].x()) << rover.bodies[a].name;
                EXPECT_EQ(graph.bodies[a].y(), graph.bodies[b].y()) << rover.bodies[a].name;
            }
        }
    }
    EXPECT_EQ(pairs, 6);
    EXPECT_TRUE(graph.hasGround);
    for (const GraphPoint& body : graph.bodies) {
        EXPECT_LT(body.y(), graph.ground.y());
    }
}

TEST(JointGraphTest, NothingIsDrawnOfNothing) {
    const JointGraph graph = jointGraph({});
    EXPECT_TRUE(graph.bodies.empty());
    EXPECT_TRUE(graph.edges.empty());
    EXPECT_FALSE(graph.hasGround);
}
