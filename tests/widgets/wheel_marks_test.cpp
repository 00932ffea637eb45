// Signs that tell wheels apart without their colours.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "widgets/plots/wheel_marks.h"

using testing::ElementsAre;
using widgets::WheelMark;
using widgets::wheelMarks;

TEST(WheelMarks, PairsShareAShapeAndTheRightOneIsHollow) {
    EXPECT_THAT(wheelMarks({"front", "bogie_left_front", "bogie_left_rear", "bogie_right_front",
                            "bogie_right_rear", "rear"}),
                ElementsAre(WheelMark{0, false}, WheelMark{1, false}, WheelMark{2, false},
                            WheelMark{1, true}, WheelMark{2, true}, WheelMark{3, false}));
    EXPECT_THAT(wheelMarks({"rear_left", "rear_right", "left", "right"}),
                ElementsAre(WheelMark{0, false}, WheelMark{0, true}, WheelMark{1, false},
                            WheelMark{1, true}));
}

// "Bright" has nothing to do with sides.
TEST(WheelMarks, OnlyWholeWordsAreSides) {
    EXPECT_THAT(wheelMarks({"bright", "leftover"}),
                ElementsAre(WheelMark{0, false}, WheelMark{1, false}));
}

TEST(WheelMarks, ShapesDifferAndStayWithinTheirSize) {
    for (int a = 0; a < 6; ++a) {
        const QPainterPath path = widgets::markOutline(a, 8.0);
        EXPECT_TRUE(QRectF(-5.5, -5.5, 11.0, 11.0).contains(path.boundingRect())) << a;
        for (int b = 0; b < a; ++b) {
            EXPECT_NE(path, widgets::markOutline(b, 8.0)) << a << " " << b;
        }
    }
}
