// Where EGL finds no driver: an answer, not a crash.
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/offscreen.h"

// Without a driver the reasons are told, with a remedy, as often as one asks.
TEST(NoEgl, RendererIsRefusedWithARemedy) {
    for (int attempt = 0; attempt < 2; ++attempt) {
        const auto renderer = render::OffscreenRenderer::create(64, 48);
        ASSERT_FALSE(renderer.ok());
        ASSERT_EQ(renderer.problems().size(), 1U);
        const simcore::Problem& problem = renderer.problems().front();
        EXPECT_EQ(problem.severity, simcore::Severity::Critical);
        EXPECT_THAT(problem.reason, testing::HasSubstr("EGL"));
        EXPECT_THAT(problem.remedy, testing::HasSubstr("driver"));
    }
}

// The scene graph itself can be built, asked and picked in without any OpenGL.
TEST(NoEgl, SceneWorksWithoutDrawing) {
    render::Scene scene;
    const render::Pick pick = scene.pick({1, 2, 3}, {1, 2, -3}, 0.01);
    ASSERT_TRUE(pick.point.has_value());
    EXPECT_NEAR(pick.point->z(), 0.0, 1e-6);
}

int main(int argc, char** argv) {
    // Before EGL is first used: it looks for its drivers there, and nowhere else.
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent/vendor.json", 1);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
