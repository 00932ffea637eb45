#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/boundary/link_rules.h"

using namespace boundary;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

const std::filesystem::path kClosures{ROVER_LINK_CLOSURES};
const std::vector<Toolkit> kGraphics{Toolkit::Qt, Toolkit::OpenSceneGraph, Toolkit::OpenGL};

}  // namespace

TEST(LinkRulesTest, SimcoreLinksNoGraphics) {
    const std::vector<std::string> names = readLines(kClosures / "simcore.txt");
    EXPECT_THAT(names, Contains("Eigen3::Eigen")) << "public links are not followed";
    EXPECT_THAT(names, Contains("PkgConfig::ODE")) << "private links are not followed";
    EXPECT_THAT(linksOf(names, kGraphics), IsEmpty());
}

TEST(LinkRulesTest, RoversimLinksNoGraphics) {
    const std::vector<std::string> names = readLines(kClosures / "roversim.txt");
    EXPECT_THAT(names, Contains("simcore"));
    EXPECT_THAT(linksOf(names, kGraphics), IsEmpty());
}

TEST(LinkRulesTest, RenderLinksNoQt) {
    const std::filesystem::path file = kClosures / "render.txt";
    if (!std::filesystem::exists(file)) {
        GTEST_SKIP() << "built without the desktop program";
    }
    const std::vector<std::string> names = readLines(file);
    EXPECT_THAT(names, Contains("simcore"));
    EXPECT_THAT(linksOf(names, {Toolkit::Qt}), IsEmpty());
}

// What the loader maps, whatever the build files say.
TEST(LinkRulesTest, RoversimLoadsNoGraphics) {
    const std::vector<std::string> libraries = sharedLibrariesOf(ROVER_BINARY_DIR "/bin/roversim");
    EXPECT_THAT(libraries, Contains(HasSubstr("libode")));
    EXPECT_THAT(linksOf(libraries, kGraphics), IsEmpty());
}

TEST(LinkRulesTest, FindsAPlantedLink) {
    const std::vector<std::string> names = readLines(kClosures / "planted.txt");
    EXPECT_THAT(linksOf(names, {Toolkit::Qt}), testing::ElementsAre("Qt6::Core"));
    EXPECT_THAT(linksOf(names, {Toolkit::OpenSceneGraph}),
                testing::ElementsAre("/usr/lib/libosgViewer.so"));
}

TEST(LinkRulesTest, KnowsTheNamesOfTheToolkits) {
    for (const char* name : {"Qt6::Widgets", "/usr/lib/x86_64-linux-gnu/libQt6Core.so.6", "osg",
                             "-losgGA", "/usr/lib/libOpenThreads.so", "PkgConfig::OpenSceneGraph",
                             "OpenGL::GL", "libGL.so.1", "-lGL", "libEGL.so", "qcustomplot-qt6"}) {
        EXPECT_EQ(linksOf({name}, kGraphics).size(), 1u) << name;
    }
    for (const char* name : {"Eigen3::Eigen", "muparser::muparser", "PkgConfig::ODE", "fmt::fmt",
                             "Threads::Threads", "/usr/lib/libode.so", "libglib-2.0.so.0"}) {
        EXPECT_THAT(linksOf({name}, kGraphics), IsEmpty()) << name;
    }
}
