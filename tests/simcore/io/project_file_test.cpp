#include <cmath>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "simcore/base/random.h"
#include "simcore/io/project_file.h"
#include "simcore/project/resolve.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::io;
using namespace testsupport;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace {

std::string contentOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    if (at == std::string::npos) {
        throw std::runtime_error("the text has no " + what);
    }
    return text.replace(at, what.size(), with);
}

Problems problemsOf(const std::string& text) {
    const auto project = parseProject(text, "cart.rover");
    EXPECT_FALSE(project);
    for (const Problem& problem : project.problems()) {
        EXPECT_THAT(problem.element, HasSubstr("cart.rover"));
        EXPECT_THAT(problem.reason, Not(IsEmpty()));
        EXPECT_THAT(problem.remedy, Not(IsEmpty()));
    }
    return project.problems();
}

}  // namespace

class ShippedFileTest : public testing::TestWithParam<std::string> {};

// Files that RoverStudio wrote come back byte for byte; so the shipped files are as it writes them.
TEST_P(ShippedFileTest, LoadAndSaveIsTheIdentity) {
    const std::string text = contentOf(shippedFile(GetParam()));
    const auto project = parseProject(text, GetParam());
    ASSERT_TRUE(project) << toString(project.problems());
    const std::string written = formatProject(*project);
    EXPECT_TRUE(written == text) << "assets/projects/" << GetParam()
                                 << ".rover is not in the form the program writes";
    const auto again = parseProject(written, GetParam());
    ASSERT_TRUE(again);
    EXPECT_TRUE(*again == *project);
    EXPECT_EQ(formatProject(*again), written);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedFileTest, testing::ValuesIn(shippedNames()),
                         [](const auto& test) { return test.param; });

TEST(ProjectFileTest, ValuesAndExpressionsOfForeignFilesAreKept) {
    const std::string text = replaced(cartText(), "\"mass\": 5,",
                                      "\"mass\"  :\n\n 0.1000000000000000055511151231257827,");
    const auto project = parseProject(text, "cart.rover");
    ASSERT_TRUE(project) << toString(project.problems());
    EXPECT_EQ(project->rover.bodies[0].mass.literal(), 0.1);
    EXPECT_EQ(project->rover.parameters[1].value.text(), "5 cm");
    EXPECT_EQ(project->rover.parameters[2].value.text(), "wheel_radius*4");
    const auto again = parseProject(formatProject(*project), "again");
    ASSERT_TRUE(again);
    EXPECT_TRUE(*again == *project);
}

TEST(ProjectFileTest, BodyContactsAreWrittenWhereTheyAreOff) {
    project::Project project = cart();
    ASSERT_TRUE(project.scenarios[0].run.bodyContacts) << "on by default";
    EXPECT_EQ(formatProject(project).find("body_contacts"), std::string::npos);
    project.scenarios[0].run.bodyContacts = false;
    const std::string text = formatProject(project);
    EXPECT_NE(text.find("\"body_contacts\": false"), std::string::npos);
    const auto again = parseProject(text, "again");
    ASSERT_TRUE(again) << toString(again.problems());
    EXPECT_TRUE(*again == project);
    EXPECT_EQ(formatProject(*again), text);
    EXPECT_FALSE(parseProject(replaced(text, "\"body_contacts\": false", "\"body_contacts\": 0"),
                              "a number"));
}

TEST(ProjectFileTest, NumbersReadBackExactly) {
    project::Project project = cart();
    for (const double value :
         {1.0 / 3.0, 5e-324, 1.7976931348623157e308, -0.0, 1e22, 123456789.125, 0.1 + 0.2}) {
        project.rover.bodies[0].com[0] = value;
        const auto again = parseProject(formatProject(project), "again");
        ASSERT_TRUE(again) << value;
        const double read = again->rover.bodies[0].com[0].literal();
        EXPECT_EQ(read, value);
        EXPECT_EQ(std::signbit(read), std::signbit(value)) << value;
    }
}

TEST(ProjectFileTest, TextWithAnyCharacterReadsBack) {
    project::Project project = cart();
    project.rover.description = "quote \" backslash \\ newline \n tab \t Röver 火星 \x01";
    const auto again = parseProject(formatProject(project), "again");
    ASSERT_TRUE(again) << toString(again.problems());
    EXPECT_EQ(again->rover.description, project.rover.description);
}

TEST(ProjectFileTest, MalformedTextIsPlacedByLineAndColumn) {
    const Problems missingComma =
        problemsOf("{\n  \"format\": \"roverstudio-project\"\n  \"version\": 1\n}");
    ASSERT_EQ(missingComma.size(), 1u);
    // The parser stops at the end of the token "version": line 3.
    EXPECT_THAT(missingComma[0].element, HasSubstr("line 3, column"));
    EXPECT_THAT(missingComma[0].reason, HasSubstr("not valid JSON"));
    const Problems strange = problemsOf("{\"format\": ?}");
    EXPECT_THAT(strange[0].element, HasSubstr("line 1, column 12"));
    for (const char* text : {"", "{", "[1, 2", "\"half", "{\"a\": 1e999}", "\xff\xfe{}", "nul"}) {
        EXPECT_EQ(problemsOf(text).size(), 1u) << text;
    }
}

TEST(ProjectFileTest, OtherFilesAndVersionsAreRefused) {
    for (const char* text : {"{}", "[]", "3", "null", R"({"format": "other", "version": 1})",
                             R"({"format": 7, "version": 1})"}) {
        EXPECT_THAT(problemsOf(text)[0].reason, HasSubstr("not a RoverStudio project"));
    }
    const std::string version = "\"version\": 1";
    for (const char* other : {"\"version\": 2", "\"version\": 0", "\"version\": \"1\"",
                              "\"version\": 1.5", "\"version\": 4294967297", "\"version\": null"}) {
        const Problems problems = problemsOf(replaced(cartText(), version, other));
        ASSERT_EQ(problems.size(), 1u);
        EXPECT_THAT(problems[0].reason, HasSubstr("version")) << other;
        EXPECT_THAT(problems[0].remedy, HasSubstr("version"));
    }
    EXPECT_THAT(problemsOf(replaced(cartText(), "\"version\": 1,", ""))[0].reason,
                HasSubstr("(none)"));
}

TEST(ProjectFileTest, AllProblemsAtOnceWithTheirPlaces) {
    std::string text = cartText();
    text = replaced(text, "\"mass\": 5", "\"mass\": true");
    text = replaced(text, "\"com\": [0, 0, \"wheel_radius\"]", "\"com\": [0, 0]");
    text = replaced(text, "\"kind\": \"step\"", "\"kind\": \"stepp\"");
    text = replaced(text, "\"mirror\": true", "\"mirror\": 1");
    text = replaced(text, "\"name\": \"axle\", ", "\"nam\": \"axle\", ");
    const Problems problems = problemsOf(text);
    const std::string all = toString(problems);
    EXPECT_EQ(problems.size(), 6u) << all;
    EXPECT_THAT(all, AllOf(HasSubstr("rover.bodies[0] (chassis).mass"),
                           HasSubstr("expected a number or an expression in quotes, found boolean"),
                           HasSubstr("rover.bodies[0] (chassis).com"),
                           HasSubstr("scenarios[0] (step).terrain.kind"),
                           HasSubstr("random-profile"), HasSubstr("rover.bodies[1] (wheel).mirror"),
                           HasSubstr("'nam' is not a known key"), HasSubstr("'name' is missing")));
}

TEST(ProjectFileTest, KeysGivenTwiceAreRefused) {
    const Problems problems =
        problemsOf(replaced(cartText(), "\"mass\": 5,", "\"mass\": 5, \"mass\": 6,"));
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_THAT(problems[0].reason, HasSubstr("'mass' is given twice"));
}

// JSON is written recursively: a message that quotes such a file would overflow the stack.
TEST(ProjectFileTest, EndlessNestingIsRefused) {
    const std::string deep = std::string(200000, '[') + std::string(200000, ']');
    for (const std::string& text :
         {deep, R"({"format": "roverstudio-project", "version": )" + deep + "}",
          R"({"format": "roverstudio-project", "version": 1, "rover": )" + deep + "}"}) {
        EXPECT_THAT(problemsOf(text)[0].reason, HasSubstr("nest deeper"));
    }
}

// Looking a key up in a list of them would take minutes here.
TEST(ProjectFileTest, VeryManyKeysAreOnlyTooMany) {
    std::string text = R"({"format": "roverstudio-project", "version": 1)";
    constexpr int kKeys = 100000;
    for (int i = 0; i < kKeys; ++i) {
        text += ", \"k" + std::to_string(i) + "\": 1";
    }
    const auto project = parseProject(text + "}", "cart.rover");
    ASSERT_FALSE(project);
    EXPECT_EQ(project.problems().size(), kKeys + 1U);  // and the rover is missing
}

TEST(ProjectFileTest, MissingAndUnreadableFilesAreProblems) {
    EXPECT_THAT(loadProject("/nowhere/a.rover").problems()[0].reason, HasSubstr("no such file"));
    EXPECT_FALSE(loadProject(std::filesystem::temp_directory_path()));  // a folder
}

TEST(ProjectFileTest, ShippedProjectsAreFound) {
    EXPECT_TRUE(std::filesystem::exists(examplesFolder() / "solero.rover"));
}

namespace {

using Json = nlohmann::ordered_json;

/// Spoils one thing: a byte, a piece of text, or a value of the tree.
class Mutator {
  public:
    explicit Mutator(std::uint64_t seed) : random_(seed) {}

    std::string mutate(std::string text) {
        switch (pick(8)) {
            case 0:  // another byte
                text[pick(text.size())] = static_cast<char>(pick(256));
                return text;
            case 1:  // a piece is missing
                return text.erase(pick(text.size()), 1 + pick(40));
            case 2:  // a piece stands elsewhere
                return text.insert(pick(text.size()), text.substr(pick(text.size()), pick(60)));
            case 3:  // the file ends early
                return text.substr(0, pick(text.size()));
            default:
                return mutateTree(text);
        }
    }

  private:
    std::size_t pick(std::size_t count) { return static_cast<std::size_t>(random_.next() % count); }

    std::string mutateTree(const std::string& text) {
        Json json = Json::parse(text);
        Json* at = &json;
        while (at->is_structured() && !at->empty() && (at == &json || pick(6) != 0)) {
            auto child = at->begin();
            std::advance(child, static_cast<long>(pick(at->size())));
            at = &*child;
        }
        static const std::vector<Json> kValues{
            Json(nullptr), Json(0),         Json(-1),
            Json(1e300),   Json(-1e-300),   Json(true),
            Json(""),      Json("1/0"),     Json("wheel_radius"),
            Json("12 kg"), Json("chassis"), Json(3000000000),
            Json::array(), Json::object(),  Json::array({1, 2, 3}),
            Json("{side}")};
        *at = kValues[pick(kValues.size())];
        return json.dump(1, ' ', false, Json::error_handler_t::replace);
    }

    Random random_;
};

}  // namespace

// Whatever a file holds: problems or a project, and a project can be checked and written again.
TEST(ProjectFileFuzzTest, SpoiltFilesGiveProblemsOrAProject) {
    int projects = 0;
    int refused = 0;
    for (const std::string& name : shippedNames()) {
        const std::string good = contentOf(shippedFile(name));
        Mutator mutator(20260101);
        for (int i = 0; i < 100; ++i) {
            const std::string text = mutator.mutate(good);
            const auto project = parseProject(text, name);
            if (!project) {
                ++refused;
                ASSERT_TRUE(hasCritical(project.problems())) << text;
                continue;
            }
            ++projects;
            const Problems problems = project::validate(*project);
            const auto mechanism = project::resolve(*project);
            if (!hasCritical(problems)) {
                ASSERT_TRUE(mechanism) << name << ", mutation " << i;
                for (const auto& body : mechanism->bodies) {
                    ASSERT_TRUE(std::isfinite(body.mass) && body.com.allFinite() &&
                                body.inertia.allFinite())
                        << name << ", mutation " << i;
                }
            }
            const std::string written = formatProject(*project);
            const auto again = parseProject(written, name);
            ASSERT_TRUE(again) << name << ", mutation " << i << toString(again.problems());
            ASSERT_TRUE(*again == *project) << name << ", mutation " << i;
        }
    }
    EXPECT_GT(projects, 40);
    EXPECT_GT(refused, 200);
}
