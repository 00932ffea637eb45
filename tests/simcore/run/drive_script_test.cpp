// Driving commands as text.
#include "simcore/run/drive_script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace simcore;
using namespace simcore::run;
using testing::HasSubstr;

TEST(DriveScriptTest, CommandsHoldUntilTheNext) {
    const auto script = parseDriveScript("0.5,0.1,0; 3, -0.2 ,0.15;8,0,0");
    ASSERT_TRUE(script) << toString(script.problems());
    const auto at = [&](double time) { return commandAt(*script, time); };
    EXPECT_EQ(at(0.4).speed, 0.0);
    EXPECT_EQ(at(0.5).speed, 0.1);
    EXPECT_EQ(at(2.99).turn, 0.0);
    EXPECT_EQ(at(3.0).speed, -0.2);
    EXPECT_EQ(at(3.0).turn, 0.15);
    EXPECT_EQ(at(100.0).speed, 0.0);
}

TEST(DriveScriptTest, SaysWhichEntryIsWrong) {
    for (const auto& [text, where, why] : {std::tuple{"", "drive", "no entries"},
                                           {"1,2", "entry 1", "not understood"},
                                           {"0,0.1,0;1,x,0", "entry 2", "'1,x,0'"},
                                           {"0,0.1,0,7", "entry 1", "not understood"},
                                           {"0,0.1,0;0,0.2,0", "entry 2", "not after"},
                                           {"-1,0,0", "entry 1", "not after"},
                                           {"0,50,0", "entry 1", "above"},
                                           {"0,nan,0", "entry 1", ""}}) {
        const auto script = parseDriveScript(text);
        ASSERT_FALSE(script) << text;
        EXPECT_THAT(script.problems()[0].element, HasSubstr(where)) << text;
        EXPECT_THAT(script.problems()[0].reason, HasSubstr(why)) << text;
    }
}
