// The window in German: nothing that has a text is left in English.
#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QSettings>
#include <QTreeWidget>
#include <set>

#include <gmock/gmock.h>

#include "tests/support/studio.h"
#include "widgets/window/language.h"

using testing::IsEmpty;

namespace {

/// Texts of actions, panels, buttons and heads of lists.
std::set<QString> textsOf(widgets::MainWindow& window) {
    std::set<QString> texts;
    for (const QAction* action : window.actions().all()) {
        texts.insert(action->text());
        texts.insert(action->toolTip());
    }
    for (const auto* dock : window.findChildren<QDockWidget*>()) {
        texts.insert(dock->windowTitle());
    }
    for (const auto* button : window.findChildren<QAbstractButton*>()) {
        texts.insert(button->text());
        texts.insert(button->accessibleName());
    }
    for (const auto* list : window.findChildren<QTreeWidget*>()) {
        for (int column = 0; column < list->columnCount(); ++column) {
            texts.insert(list->headerItem()->text(column));
        }
    }
    return texts;
}

std::unique_ptr<widgets::MainWindow> windowIn(const QString& language) {
    widgets::installLanguage(language);
    auto window = std::make_unique<widgets::MainWindow>();
    EXPECT_TRUE(window->document().open(testsupport::projectFile("solero")).empty());
    return window;
}

class LanguageTest : public testing::Test {
  protected:
    ~LanguageTest() override {
        widgets::installLanguage("en");
        widgets::chooseLanguage({});
    }
};

}  // namespace

TEST_F(LanguageTest, NothingIsLeftInEnglish) {
    const std::set<QString> english = textsOf(*windowIn("en"));
    const std::set<QString> german = textsOf(*windowIn("de"));
    // The same word in both, names of languages, and names of wheels and parts.
    const std::set<QString> alike{"Rover", "Name", "Parameter", "Margin", "English", "Deutsch"};
    std::vector<std::string> left;
    for (const QString& text : german) {
        const bool isName = text.contains('_') || text == text.toLower();
        if (english.count(text) == 1 && alike.count(text) == 0 && !isName && !text.isEmpty()) {
            left.push_back(text.toStdString());
        }
    }
    EXPECT_THAT(left, IsEmpty());
    EXPECT_GT(german.size(), 150U);
}

TEST_F(LanguageTest, TheChoiceIsKeptAndUnknownOnesAreNot) {
    EXPECT_EQ(widgets::languages(), (QStringList{"en", "de"}));
    widgets::chooseLanguage("de");
    EXPECT_EQ(widgets::chosenLanguage(), "de");
    QSettings().setValue("window/language", "tlh");
    EXPECT_EQ(widgets::chosenLanguage(), "");
    EXPECT_TRUE(widgets::languages().contains(widgets::systemLanguage()));
}
