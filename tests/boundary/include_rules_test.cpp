#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/boundary/include_rules.h"

using boundary::Scan;
using boundary::scanIncludes;
using boundary::whyForbidden;
using testing::IsEmpty;
using testing::Not;

namespace {

/// A source tree of its own in a temporary folder.
class PlantedTree {
  public:
    PlantedTree()
        : root_(std::filesystem::temp_directory_path() /
                ("rover_boundary_" + std::to_string(getpid()))) {
        std::filesystem::remove_all(root_);
    }

    ~PlantedTree() { std::filesystem::remove_all(root_); }

    PlantedTree(const PlantedTree&) = delete;
    PlantedTree& operator=(const PlantedTree&) = delete;

    void plant(const std::string& file, const std::string& text) const {
        std::filesystem::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file) << text;
    }

    const std::filesystem::path& root() const { return root_; }

  private:
    std::filesystem::path root_;
};

}  // namespace

TEST(IncludeRulesTest, SourceTreeKeepsItsLayers) {
    const Scan scan = scanIncludes(ROVER_SOURCE_DIR);
    EXPECT_GT(scan.files, 80) << "the scan does not find the sources";
    EXPECT_GT(scan.includes, 300) << "the scan does not find the includes";
    EXPECT_THAT(scan.violations, IsEmpty()) << toString(scan.violations);
}

TEST(IncludeRulesTest, FindsAPlantedOffence) {
    const PlantedTree tree;
    tree.plant("simcore/terrain/good.cpp", "#include <vector>\n#include \"simcore/base/pose.h\"\n");
    EXPECT_THAT(scanIncludes(tree.root()).violations, IsEmpty());
    tree.plant("simcore/terrain/bad.cpp", "// one\n  #  include <QString>  // why not\n");
    const Scan scan = scanIncludes(tree.root());
    EXPECT_EQ(scan.files, 2);
    ASSERT_EQ(scan.violations.size(), 1u);
    EXPECT_EQ(scan.violations[0].file, "simcore/terrain/bad.cpp");
    EXPECT_EQ(scan.violations[0].line, 2);
    EXPECT_EQ(scan.violations[0].include, "QString");
    EXPECT_THAT(scan.violations[0].reason, Not(IsEmpty()));
}

TEST(IncludeRulesTest, EachLibraryStaysInItsFolder) {
    struct Case {
        const char* include;
        const char* allowed;
        const char* forbidden;
    };

    for (const Case& c : {
             Case{"QWidget", "widgets/panels/a.cpp", "render/a.cpp"},
             Case{"QtCore/QObject", "app/roverstudio/main.cpp", "app/roversim/main.cpp"},
             Case{"qglobal.h", "widgets/a.h", "simcore/base/a.h"},
             Case{"osg/Group", "render/a.cpp", "simcore/run/a.cpp"},
             Case{"osgViewer/Viewer", "widgets/viewport/a.cpp", "widgets/plots/a.cpp"},
             Case{"GL/gl.h", "render/a.cpp", "simcore/terrain/a.cpp"},
             Case{"ode/ode.h", "simcore/dynamics/a.cpp", "simcore/run/a.cpp"},
             Case{"nlohmann/json.hpp", "simcore/io/a.cpp", "simcore/project/a.cpp"},
             Case{"nlohmann/json_fwd.hpp", "app/roversim/a.cpp", "widgets/document/a.cpp"},
             Case{"qcustomplot.h", "widgets/plots/a.cpp", "widgets/panels/a.cpp"},
             Case{"muParser.h", "simcore/project/a.cpp", "widgets/editors/a.cpp"},
             Case{"CLI/CLI.hpp", "app/roversim/main.cpp", "simcore/base/a.cpp"},
         }) {
        EXPECT_THAT(whyForbidden(c.allowed, c.include, false), IsEmpty())
            << c.include << " in " << c.allowed;
        EXPECT_THAT(whyForbidden(c.forbidden, c.include, false), Not(IsEmpty()))
            << c.include << " in " << c.forbidden;
    }
}

TEST(IncludeRulesTest, LowerLayersDoNotKnowHigherOnes) {
    const std::vector<std::string> layers{"simcore", "render", "widgets", "app"};
    for (std::size_t from = 0; from < layers.size(); ++from) {
        for (std::size_t to = 0; to < layers.size(); ++to) {
            const std::string file = layers[from] + (from == 3 ? "/roverstudio" : "") + "/a.cpp";
            const std::string reason = whyForbidden(file, layers[to] + "/x/b.h", true);
            EXPECT_EQ(reason.empty(), to <= from) << layers[from] << " includes " << layers[to];
        }
    }
    // The headless program is the proof that simcore stands alone.
    EXPECT_THAT(whyForbidden("app/roversim/a.cpp", "render/scene.h", true), Not(IsEmpty()));
    EXPECT_THAT(whyForbidden("app/roversim/a.cpp", "widgets/x/a.h", true), Not(IsEmpty()));
}

TEST(IncludeRulesTest, RelativeIncludesAreRefused) {
    EXPECT_THAT(whyForbidden("simcore/run/a.cpp", "../../widgets/x/b.h", true), Not(IsEmpty()));
    EXPECT_THAT(whyForbidden("simcore/run/a.cpp", "sampler.h", true), Not(IsEmpty()));
    EXPECT_THAT(whyForbidden("simcore/run/a.cpp", "tests/support/fake_run.h", true),
                Not(IsEmpty()));
    EXPECT_THAT(whyForbidden("widgets/panels/a.cpp", "a.moc", true), IsEmpty());
}
