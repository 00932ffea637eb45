#include "widgets/session/recording_store.h"

#include <gtest/gtest.h>

namespace widgets {
namespace {

/// Feeds rows and frames at 0, 1, 2, ... s in batches of `batch`.
void feed(RecordingStore& store, int count, int batch) {
    std::vector<std::vector<double>> rows;
    std::vector<std::shared_ptr<const simcore::run::Snapshot>> frames;
    for (int i = 0; i < count; ++i) {
        rows.push_back({static_cast<double>(i)});
        auto frame = std::make_shared<simcore::run::Snapshot>();
        frame->time = i;
        frames.push_back(frame);
        if (i % batch == batch - 1 || i == count - 1) {
            store.append(rows, frames);
            ASSERT_TRUE(rows.empty() && frames.empty());
        }
    }
}

// A drive of any length is kept whole: the same spacing from the start to the end, within the
// limit.
TEST(RecordingStoreTest, ALongDriveIsThinnedEvenly) {
    for (const int batch : {1, 7, 1000}) {
        RecordingStore store(100, 50);
        feed(store, 10000, batch);
        const auto& rows = store.recording().rows;
        EXPECT_LE(rows.size(), 100U);
        EXPECT_GE(rows.size(), 50U);
        EXPECT_EQ(rows.front()[0], 0.0);
        for (std::size_t i = 1; i < rows.size(); ++i) {
            ASSERT_EQ(rows[i][0] - rows[i - 1][0], 128.0) << i;
        }
        const auto& frames = store.recording().frames;
        EXPECT_LE(frames.size(), 50U);
        for (std::size_t i = 1; i < frames.size(); ++i) {
            ASSERT_EQ(frames[i]->time - frames[i - 1]->time, 256.0) << i;
        }
    }
}

TEST(RecordingStoreTest, TellsWhatHappenedToWhatWasThere) {
    using Change = RecordingStore::Change;
    RecordingStore store(3, 100);
    std::vector<std::vector<double>> rows;
    std::vector<std::shared_ptr<const simcore::run::Snapshot>> frames;
    EXPECT_EQ(store.append(rows, frames), Change::None);
    rows = {{0.0}, {1.0}, {2.0}};
    EXPECT_EQ(store.append(rows, frames), Change::Appended);
    rows = {{3.0}};
    EXPECT_EQ(store.append(rows, frames), Change::Thinned);
    rows = {{4.0}};
    EXPECT_EQ(store.append(rows, frames), Change::Appended);
    // From the start again at full resolution.
    store.clearData();
    rows = {{0.0}, {1.0}, {2.0}};
    EXPECT_EQ(store.append(rows, frames), Change::Appended);
    EXPECT_EQ(store.recording().rows.size(), 3U);
}

}  // namespace
}  // namespace widgets
