#include "simcore/base/text.h"

#include <string_view>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "simcore/base/problem.h"
#include "tests/support/other_language.h"

namespace simcore {
namespace {

class TextTest : public testing::Test {
  protected:
    ~TextTest() override { Text::setLookUp(nullptr); }
};

std::string german(const char* pattern) {
    const std::string_view english = pattern;
    if (english == "{} of {} wheels roll") {
        return "von {1} Rädern rollen {0}";
    }
    if (english == "{:.1f} mm too deep") {
        return "um {:.1f} mm zu tief";
    }
    if (english == "it has {} wheels") {
        return "hat {} Räder und {}";  // one argument too many
    }
    if (english == "it has {} joints") {
        return "hat {:d Gelenke";
    }
    if (english == "it has {} bodies") {
        return "hat {:.2f} Körper";  // of no such type
    }
    return english == "pin {" ? "Stift {" : "";
}

}  // namespace

TEST_F(TextTest, IsEnglishWithoutALookUp) {
    EXPECT_EQ(Text::of("{} of {} wheels roll", 2, 6), "2 of 6 wheels roll");
    EXPECT_EQ(Text::translated(Text::mark("pin {")), "pin {");
}

TEST_F(TextTest, TranslationsMayChangeTheOrderAndUseTheFormats) {
    Text::setLookUp(german);
    EXPECT_EQ(Text::of("{} of {} wheels roll", 2, 6), "von 6 Rädern rollen 2");
    EXPECT_EQ(Text::of("{:.1f} mm too deep", 2.25), "um 2.2 mm zu tief");
    EXPECT_EQ(Text::translated(Text::mark("pin {")), "Stift {");
}

TEST_F(TextTest, WhatHasNoUsableTranslationIsEnglish) {
    Text::setLookUp(german);
    EXPECT_EQ(Text::of("{} bodies move", 3), "3 bodies move");
    EXPECT_EQ(Text::of("it has {} wheels", 6), "it has 6 wheels");
    EXPECT_EQ(Text::of("it has {} joints", 6), "it has 6 joints");
    EXPECT_EQ(Text::of("it has {} bodies", "many"), "it has many bodies");
    EXPECT_EQ(Text::translated(Text::mark("slider")), "slider");
}

TEST_F(TextTest, ThreadsReadIt) {
    Text::setLookUp(german);
    std::vector<std::thread> threads;
    std::vector<std::string> said(4);
    for (std::size_t i = 0; i < said.size(); ++i) {
        threads.emplace_back([&said, i] {
            for (int k = 0; k < 1000; ++k) {
                said[i] = Text::of("{} of {} wheels roll", i, k);
            }
        });
    }
    for (std::size_t i = 0; i < said.size(); ++i) {
        threads[i].join();
        EXPECT_EQ(said[i], "von 999 Rädern rollen " + std::to_string(i));
    }
}

TEST_F(TextTest, SeveritiesAreWordsForPeopleInProblemsAndNamesElsewhere) {
    const testsupport::InOtherLanguage other;
    EXPECT_EQ(toString(Severity::Critical), "critical");
    EXPECT_EQ(toString(Problem{Severity::Critical, "a.rover", "Gone.", ""}),
              "CRITICAL: a.rover: Gone.");
}

}  // namespace simcore
