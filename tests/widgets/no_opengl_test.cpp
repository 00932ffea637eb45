// The window where OpenGL is missing: a message instead of the 3D view, all else works.
#include <QLabel>

#include <gmock/gmock.h>

#include "tests/support/studio.h"

using testsupport::waitUntil;

namespace {

class NoOpenGlTest : public testsupport::StudioTest {};

}  // namespace

TEST_F(NoOpenGlTest, PlaceholderSaysWhatIsMissing) {
    EXPECT_EQ(window->viewport(), nullptr);
    const auto* label = qobject_cast<QLabel*>(window->centralWidget());
    ASSERT_NE(label, nullptr);
    EXPECT_THAT(label->text().toStdString(), testing::HasSubstr("OpenGL is not available"));
}

TEST_F(NoOpenGlTest, EditingAndRunningWork) {
    type(parameter("wheel_radius"), "80");
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.08);
    ASSERT_TRUE(window->playPause());
    EXPECT_TRUE(waitUntil([&] { return window->session().endTime() > 0.1; }));
    window->session().pause();
}
