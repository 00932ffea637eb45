#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/io/atomic_file.h"
#include "tests/support/file_size_limit.h"

using namespace simcore;
using simcore::io::backUp;
using simcore::io::writeFileAtomically;
using testsupport::FileSizeLimit;
namespace fs = std::filesystem;

namespace {

class AtomicFileTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "rover_atomic_XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }

    void TearDown() override { fs::remove_all(folder_); }

    static std::string contentOf(const fs::path& file) {
        std::ostringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        return text.str();
    }

    std::size_t filesInFolder() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    fs::path folder_;
};

}  // namespace

TEST_F(AtomicFileTest, WritesAndReplaces) {
    const fs::path file = folder_ / "a.rover";
    ASSERT_TRUE(writeFileAtomically(file, "first\n"));
    EXPECT_EQ(contentOf(file), "first\n");
    ASSERT_TRUE(writeFileAtomically(file, std::string(3'000'000, 'x')));
    EXPECT_EQ(contentOf(file).size(), 3'000'000u);
    ASSERT_TRUE(writeFileAtomically(file, ""));
    EXPECT_EQ(contentOf(file), "");
    EXPECT_EQ(filesInFolder(), 1u) << "temporary files are left";
}

TEST_F(AtomicFileTest, OldFileIsWholeWhenWritingFails) {
    const fs::path file = folder_ / "a.rover";
    ASSERT_TRUE(writeFileAtomically(file, "old content"));
    {
        const FileSizeLimit limit(1000);
        const auto result = writeFileAtomically(file, std::string(5000, 'x'));
        ASSERT_FALSE(result);
        EXPECT_EQ(result.problems()[0].element, file.string());
        EXPECT_THAT(result.problems()[0].reason, testing::HasSubstr("cannot write"));
    }
    EXPECT_EQ(contentOf(file), "old content");
    EXPECT_EQ(filesInFolder(), 1u) << "temporary files are left";
}

TEST_F(AtomicFileTest, FolderThatIsNotThereIsAProblem) {
    const auto result = writeFileAtomically(folder_ / "none" / "a.rover", "text");
    ASSERT_FALSE(result);
    EXPECT_THAT(result.problems()[0].reason, testing::HasSubstr("cannot create"));
    EXPECT_FALSE(result.problems()[0].remedy.empty());
    EXPECT_FALSE(writeFileAtomically(folder_, "text")) << "a folder is replaced by a file";
    EXPECT_TRUE(fs::is_directory(folder_));
}

TEST_F(AtomicFileTest, PermissionsAndLinksAreKept) {
    const fs::path file = folder_ / "a.rover";
    const fs::path link = folder_ / "link.rover";
    ASSERT_TRUE(writeFileAtomically(file, "old"));
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("a.rover", link);
    ASSERT_TRUE(writeFileAtomically(link, "new"));
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(contentOf(file), "new");
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

// Renaming would do it, for a folder that may be written to.
TEST_F(AtomicFileTest, WriteProtectedFileIsNotReplaced) {
    const fs::path file = folder_ / "a.rover";
    ASSERT_TRUE(writeFileAtomically(file, "old"));
    fs::permissions(file, fs::perms::owner_read);
    const auto result = writeFileAtomically(file, "new");
    ASSERT_FALSE(result);
    EXPECT_THAT(result.problems()[0].reason, testing::HasSubstr("read-only"));
    EXPECT_EQ(contentOf(file), "old");
    EXPECT_EQ(filesInFolder(), 1u) << "temporary files are left";
}

TEST_F(AtomicFileTest, BackupHasContentAndPermissions) {
    const fs::path file = folder_ / "a.rover";
    const fs::path link = folder_ / "link.rover";
    ASSERT_TRUE(writeFileAtomically(file, "first"));
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("a.rover", link);
    ASSERT_TRUE(backUp(link));
    const fs::path backup = folder_ / "a.rover~";
    EXPECT_EQ(contentOf(backup), "first");
    EXPECT_EQ(fs::status(backup).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    ASSERT_TRUE(writeFileAtomically(file, "second"));
    ASSERT_TRUE(backUp(file));
    EXPECT_EQ(contentOf(backup), "second");
    EXPECT_EQ(contentOf(file), "second");
}

TEST_F(AtomicFileTest, FailedBackupLeavesTheOlderOne) {
    const fs::path file = folder_ / "a.rover";
    ASSERT_TRUE(writeFileAtomically(file, std::string(5000, 'x')));
    ASSERT_TRUE(writeFileAtomically(folder_ / "a.rover~", "older"));
    const FileSizeLimit limit(1000);
    EXPECT_FALSE(backUp(file));
    EXPECT_EQ(contentOf(folder_ / "a.rover~"), "older");
    EXPECT_EQ(contentOf(file).size(), 5000u);
}
