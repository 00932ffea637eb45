// The user guide: opened by F1, all its pages, links, pictures and words can be reached.
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTreeWidget>

#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/support/studio.h"
#include "widgets/window/guide_window.h"

using testing::IsEmpty;

namespace {

class GuideTest : public testsupport::StudioTest {
  protected:
    widgets::GuideWindow* open() {
        press(Qt::Key_F1);
        auto* guide = window->findChild<widgets::GuideWindow*>("guide");
        EXPECT_TRUE(guide != nullptr && guide->isVisible());
        takeKeys(guide);
        return guide;
    }

    /// Until the guide has the keys for good: on a busy machine the window that had them is told
    /// so late, and takes them back.
    static void takeKeys(widgets::GuideWindow* guide) {
        constexpr int kForGood = 5;
        int active = 0;
        EXPECT_TRUE(QTest::qWaitFor(
            [&] {
                if (QApplication::activeWindow() != guide) {
                    guide->activateWindow();
                    active = 0;
                }
                QTest::qWait(20);
                return ++active > kForGood && QApplication::activeWindow() == guide;
            },
            30000));
    }

    static QString textOf(const QString& file) {
        QFile page(file);
        EXPECT_TRUE(page.open(QIODevice::ReadOnly)) << file.toStdString();
        return QString::fromUtf8(page.readAll());
    }
};

}  // namespace

TEST_F(GuideTest, OpensBesideTheWindowAndListsItsPages) {
    auto* guide = open();
    EXPECT_FALSE(guide->isModal());
    EXPECT_EQ(guide->page(), "studio.md");
    EXPECT_THAT(testsupport::unnamedWidgets(guide), IsEmpty());
    auto* contents = guide->findChild<QTreeWidget*>("guideContents");
    ASSERT_GT(contents->topLevelItemCount(), 10);
    EXPECT_EQ(contents->topLevelItem(0)->text(0), "The window");
    QTreeWidgetItem* plots = nullptr;
    for (int i = 0; i < contents->topLevelItem(0)->childCount(); ++i) {
        QTreeWidgetItem* item = contents->topLevelItem(0)->child(i);
        plots = item->text(0) == "Plots" ? item : plots;
    }
    ASSERT_NE(plots, nullptr);
    QTest::mouseClick(contents->viewport(), Qt::LeftButton, {},
                      contents->visualItemRect(plots).center());
    EXPECT_EQ(guide->headingOnShow(), "Plots");
    // Again, and it is the same window.
    press(Qt::Key_F1);
    EXPECT_EQ(window->findChildren<widgets::GuideWindow*>().size(), 1);
}

TEST_F(GuideTest, GoesBackAndForward) {
    auto* guide = open();
    EXPECT_FALSE(guide->canGoBack());
    ASSERT_TRUE(guide->showPage("mobility.md", "the-advisor"));
    EXPECT_EQ(guide->headingOnShow(), "The Advisor");
    takeKeys(guide);
    QTest::keyClick(guide, Qt::Key_Left, Qt::AltModifier);
    EXPECT_EQ(guide->page(), "studio.md");
    takeKeys(guide);
    QTest::keyClick(guide, Qt::Key_Right, Qt::AltModifier);
    EXPECT_EQ(guide->page(), "mobility.md");
    EXPECT_FALSE(guide->showPage("nothing.md"));
    EXPECT_EQ(guide->page(), "mobility.md");
}

TEST_F(GuideTest, SearchGoesOnThroughAllPages) {
    auto* guide = open();
    auto* field = guide->findChild<QLineEdit*>("guideSearch");
    type(field, "PlotJuggler");
    const QString first = guide->page();
    EXPECT_NE(first, "studio.md");
    EXPECT_EQ(guide->findChild<QTextBrowser*>("guideText")->textCursor().selectedText(),
              "PlotJuggler");
    EXPECT_FALSE(guide->findNext("xyzzy is nowhere"));
}

// What leads nowhere in the guide: links between pages, to headings, and pictures.
TEST_F(GuideTest, EveryLinkLeadsSomewhere) {
    const QString folder = widgets::guideFolder();
    ASSERT_FALSE(folder.isEmpty());
    auto* guide = open();
    std::vector<std::string> dead;
    const QRegularExpression link("\\]\\(([^)\\s]+)\\)");
    for (const QString& page : QDir(folder).entryList({"*.md"}, QDir::Files)) {
        auto found = link.globalMatch(textOf(folder + "/" + page));
        while (found.hasNext()) {
            const QString target = found.next().captured(1);
            if (target.startsWith("http")) {
                continue;
            }
            const QString file = target.section('#', 0, 0);
            const QString heading = target.section('#', 1);
            bool good = file.isEmpty() || QFile::exists(folder + "/" + file);
            if (good && !heading.isEmpty() && (file.isEmpty() || file.endsWith(".md")) &&
                !file.contains('/')) {
                const QString on = file.isEmpty() ? page : file;
                guide->showPage(on, heading);
                const auto* text = guide->findChild<QTextBrowser*>("guideText");
                good = widgets::headingName(text->textCursor().block().text()) == heading;
            }
            if (!good) {
                dead.push_back((page + ": " + target).toStdString());
            }
        }
    }
    EXPECT_THAT(dead, IsEmpty());
}

TEST_F(GuideTest, PicturesKeepToTheWidthOfTheWindow) {
    auto* guide = open();
    auto* text = guide->findChild<QTextBrowser*>();
    ASSERT_NE(text, nullptr);
    const auto widest = [text] {
        double width = 0.0;
        for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next()) {
            for (auto it = block.begin(); !it.atEnd(); ++it) {
                const QTextImageFormat image = it.fragment().charFormat().toImageFormat();
                width = std::max(width, image.isValid() ? image.width() : 0.0);
            }
        }
        return width;
    };
    for (const int width : {1000, 700}) {
        guide->resize(width, 600);
        QTest::qWait(50);
        EXPECT_LT(widest(), text->viewport()->width());
        EXPECT_GT(widest(), 0.8 * text->viewport()->width());
    }
}
