// The window in German: nothing that has a text is left in English, nor what simcore says in it.
#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <algorithm>
#include <fstream>
#include <set>

#include <gmock/gmock.h>

#include "tests/support/dialogs.h"
#include "tests/support/projects.h"
#include "tests/support/studio.h"
#include "widgets/editors/parts_tree.h"
#include "widgets/panels/advisor_page.h"
#include "widgets/panels/mobility_panel.h"
#include "widgets/panels/problems_panel.h"
#include "widgets/plots/channel_titles.h"
#include "widgets/session/run_bar.h"
#include "widgets/window/language.h"

using simcore::project::ElementKind;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testsupport::waitUntil;

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

struct German {
    German() { widgets::installLanguage("de"); }

    ~German() { widgets::installLanguage("en"); }

    German(const German&) = delete;
    German& operator=(const German&) = delete;
};

/// A window that was started in German.
class GermanStudioTest : German, public testsupport::StudioTest {
  protected:
    GermanStudioTest() { QSettings().remove("problems/hidden"); }

    QTreeWidget* problems() { return find<QTreeWidget>("problemList"); }

    /// Elements and sentences of the problems panel, a line each.
    std::vector<std::string> problemTexts() {
        std::vector<std::string> texts;
        for (int i = 0; i < problems()->topLevelItemCount(); ++i) {
            const QTreeWidgetItem* item = problems()->topLevelItem(i);
            texts.push_back(item->text(0).toStdString());
            texts.push_back(item->child(0)->text(0).toStdString());
        }
        return texts;
    }

    void clickProblem(int place) {
        auto* list = problems();
        list->scrollToItem(list->topLevelItem(place));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualItemRect(list->topLevelItem(place)).center());
    }

    simcore::project::ElementRef selected() {
        return window->findChild<widgets::PartsTree*>()->selected();
    }

    template <class Change>
    void edit(const Change& change) {
        auto next = window->document().project();
        change(next);
        window->document().edit("Change", next);
    }

    /// Leaves one scenario of the project.
    void keepScenario(const std::string& name) {
        edit([&](auto& project) {
            std::erase_if(project.scenarios,
                          [&](const auto& scenario) { return scenario.name != name; });
        });
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

TEST_F(GermanStudioTest, WarningsAreGermanAndLeadToTheirElement) {
    keepScenario("flat");
    edit([](auto& project) {
        project.scenarios.front().run.step = 0.01;
        project.scenarios.front().controller.speed = 0.5;
    });
    press(Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_THAT(problemTexts(), Contains("Szenario flat"));
    EXPECT_THAT(problemTexts(),
                Contains(HasSubstr("Der Rover fährt 5.00 mm in einem Zeitschritt")));
    EXPECT_EQ(find<QPushButton>("fix:step")->text(), "Zeitschritt 1 ms");
    clickProblem(0);
    EXPECT_EQ(selected(), (simcore::project::ElementRef{ElementKind::Scenario, 0}));
}

TEST_F(GermanStudioTest, MistakesInTheProjectAreGermanAndLeadToTheirElement) {
    edit([](auto& project) {
        project.rover.joints[1].second = "nowhere";
        project.rover.bodies[1].shapes[0].radius = -1.0;
    });
    press(Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_THAT(problemTexts(), Contains(HasSubstr("Körper 'nowhere' gibt es nicht. Bekannt:")));
    for (int i = 0; i < problems()->topLevelItemCount(); ++i) {
        const QString title = problems()->topLevelItem(i)->text(0);
        clickProblem(i);
        const ElementKind kind =
            title.startsWith("Gelenk ") ? ElementKind::Joint : ElementKind::Body;
        EXPECT_EQ(selected().kind, kind) << title.toStdString();
        EXPECT_GE(selected().index, 0) << title.toStdString();
    }
}

TEST_F(GermanStudioTest, ARunThatCannotStartSaysWhyInGerman) {
    edit([](auto& project) {
        for (auto& scenario : project.scenarios) {
            scenario.terrain.kind = simcore::project::TerrainKind::Stairs;
            scenario.terrain.height = -1.0;
        }
    });
    EXPECT_FALSE(window->playPause());
    EXPECT_THAT(problemTexts(), Contains("Szenario flat, Gelände stairs, Höhe"));
    EXPECT_THAT(problemTexts(), Contains(HasSubstr("-1 liegt nicht zwischen")));
}

TEST_F(GermanStudioTest, AValueThatCannotBeIsRefusedInGerman) {
    widgets::QuantityField* field = parameter("wheel_radius");
    const std::vector<std::pair<QString, std::string>> refusals{
        {"7 kg", "'7 kg' gibt Masse an, verlangt ist Länge."},
        {"5 m", "liegt über dem Maximum von 300 mm"},
        {"7 +", "hat keinen Wert: unerwartetes Ende des Ausdrucks an Stelle"},
        {"nothing", "unerwartetes Zeichen \"nothing\" an Stelle 0"}};
    for (const auto& [bad, why] : refusals) {
        type(field, bad);
        EXPECT_THAT(field->refusal().toStdString(), HasSubstr(why));
        QTest::keyClick(field, Qt::Key_Escape);
    }
}

TEST_F(GermanStudioTest, FilesThatCannotBeReadAreComplainedOfInGerman) {
    const QTemporaryDir folder;
    const QString file = folder.filePath("bad.rover");
    const auto complaintOf = [&](const std::string& content) {
        std::ofstream(file.toStdString()) << content;
        QString text;
        testsupport::answerNextBox(QMessageBox::Ok, &text);
        EXPECT_FALSE(window->files().openFile(file));
        return text.toStdString();
    };
    EXPECT_THAT(complaintOf("{\"format\": 1,}"),
                AllOf(HasSubstr("Fehler: "), HasSubstr("Zeile 1, Spalte 14"),
                      HasSubstr("Ist kein gültiges JSON")));
    EXPECT_THAT(complaintOf("{}"), HasSubstr("Ist kein Projekt von RoverStudio."));
    EXPECT_THAT(complaintOf(R"({"format": "roverstudio-project", "version": 1, "rover": 5})"),
                HasSubstr("Erwartet: ein Objekt in geschweiften Klammern, gefunden: Zahl."));
}

TEST_F(GermanStudioTest, ARunThatStoppedSaysWhyInGerman) {
    keepScenario("flat");
    edit([](auto& project) { project.scenarios.front().soil.friction = 0.0; });
    window->runBar().setScenario("flat");
    window->session().setSpeedFactor(0.0);
    press(Qt::Key_Space);
    ASSERT_TRUE(waitUntil(
        [&] { return window->session().report().stopReason == simcore::run::StopReason::Stuck; },
        60000));
    EXPECT_THAT(window->session().report().stopDetail,
                HasSubstr("weniger als 10 mm vorangekommen"));
    const auto* status = find<QLabel>("runStatus");
    ASSERT_TRUE(waitUntil([&] { return status->text().startsWith("Steckt fest: "); }));
    EXPECT_THAT(status->toolTip().toStdString(), HasSubstr("vorangekommen"));
}

TEST_F(GermanStudioTest, TheAdvisorSpeaksGerman) {
    edit(testsupport::clearRelaxed);
    press(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    auto& session = window->mobility().advisor().session();
    ASSERT_TRUE(waitUntil([&] { return !session.isWorking(); }, 60000));
    EXPECT_THAT(find<QLabel>("advisorText")->text().toStdString(),
                AllOf(HasSubstr("Wie gebaut: 21 Bedingungen redundant. Gefunden sind"),
                      HasSubstr("Sätze von Gelenken")));
    const auto* list = find<QTreeWidget>("advisorList");
    ASSERT_GT(list->topLevelItemCount(), 0);
    EXPECT_THAT(list->topLevelItem(0)->toolTip(0).toStdString(),
                HasSubstr("Gelenke ändern sich: "));
    std::vector<std::string> changes;
    for (int i = 0; i < list->topLevelItem(0)->childCount(); ++i) {
        changes.push_back(list->topLevelItem(0)->child(i)->text(0).toStdString());
    }
    EXPECT_THAT(changes, Contains(HasSubstr(": Drehgelenk → ")));
    EXPECT_THAT(changes, Not(Contains(HasSubstr("contact "))));
}

// What files hold is the same in every language.
TEST_F(GermanStudioTest, ChannelsAreGermanOnTheScreenAndEnglishInFiles) {
    const auto channels = simcore::run::makeChannels(*window->document().derived().mechanism);
    for (const auto& channel : channels) {
        const bool same = channel.label.starts_with("Position");
        EXPECT_EQ(widgets::channelTitle(channel.label).toStdString() == channel.label, same)
            << channel.label;
        EXPECT_NE(widgets::channelTitle(channel.meaning).toStdString(), channel.meaning);
    }
    EXPECT_EQ(channels.front().label, "Time");
}
