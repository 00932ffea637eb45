// Every action of the window is taken, and whatever asks is cancelled; every widget has a name.
#include <QAction>
#include <QClipboard>
#include <QDir>
#include <QDockWidget>
#include <QMenu>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeWidget>
#include <QUndoStack>
#include <set>

#include <gmock/gmock.h>

#include "simcore/io/project_file.h"
#include "tests/support/names.h"
#include "tests/support/studio.h"
#include "widgets/editors/parts_tree.h"
#include "widgets/session/run_library.h"
#include "widgets/window/recording_commands.h"
#include "widgets/window/recovery_dialog.h"

using testing::IsEmpty;
using testsupport::unnamedWidgets;
using testsupport::waitUntil;

namespace {

/// Presses Escape in every menu and dialog that opens while it lives.
class Canceller : public QObject {
  public:
    Canceller() {
        QObject::connect(&timer_, &QTimer::timeout, this, &Canceller::look);
        timer_.start(60);
    }

    /// Titles of the dialogs that were cancelled.
    const QStringList& dialogs() const { return dialogs_; }

    const std::vector<std::string>& unnamed() const { return unnamed_; }

    /// Escape did not close one.
    bool stuck() const { return stuck_; }

  private:
    void look() {
        QWidget* open = QApplication::activePopupWidget();
        if (open == nullptr) {
            open = QApplication::activeModalWidget();
        }
        if (open == nullptr) {
            return;
        }
        // A progress box is the work of its action, not a question.
        if (open != last_) {
            last_ = open;
            tries_ = 0;
            dialogs_ << open->windowTitle();
            for (const std::string& text : unnamedWidgets(open)) {
                unnamed_.push_back(text);
            }
        }
        QTest::keyClick(open->focusWidget() != nullptr ? open->focusWidget() : open,
                        Qt::Key_Escape);
        if (++tries_ > 20) {
            stuck_ = true;
            open->close();
        }
    }

    QTimer timer_;
    QPointer<QWidget> last_;
    int tries_ = 0;
    QStringList dialogs_;
    std::vector<std::string> unnamed_;
    bool stuck_ = false;
};

class EveryActionTest : public testsupport::StudioTest {
  protected:
    EveryActionTest() { QDir::setCurrent(folder_.path()); }

    ~EveryActionTest() override { QDir::setCurrent(before_); }

    QUndoStack& steps() { return window->document().undoStack(); }

    std::string bytes() const { return simcore::io::formatProject(window->document().project()); }

    /// A run of some tenths of a second, paused.
    void drive() {
        window->session().setSpeedFactor(0.0);
        ASSERT_TRUE(window->playPause());
        ASSERT_TRUE(waitUntil([&] { return window->session().endTime() > 0.2; }));
        window->session().pause();
    }

    void selectPart(simcore::project::ElementKind kind, int index) {
        window->findChild<widgets::PartsTree*>()->select({kind, index});
    }

    static std::set<QString> openWindows() {
        std::set<QString> names;
        for (const QWidget* top : QApplication::topLevelWidgets()) {
            if (top->isVisible() && qobject_cast<const QMenu*>(top) == nullptr &&
                top->windowType() != Qt::ToolTip) {
                names.insert(top->objectName() + "|" + top->metaObject()->className());
            }
        }
        return names;
    }

    /// Files of the folder that dialogs begin in: cancelled ones write none.
    QStringList written() const { return QDir(folder_.path()).entryList(QDir::Files); }

    /// As it was before the action: no edit, no run playing, the usual panels.
    void settle(int index) {
        window->session().pause();
        steps().setIndex(index);
        if (window->actions().at("moveParts")->isChecked()) {
            window->actions().at("moveParts")->trigger();
        }
        window->actions().at("resetLayout")->trigger();
        window->setWindowState(Qt::WindowNoState);
        if (!window->session().hasRun() || window->session().isStale()) {
            drive();
        }
    }

    QTemporaryDir folder_;
    QString before_ = QDir::currentPath();
};

/// Those that change the project, each in one step of undo.
bool edits(const QString& name) {
    static const std::set<QString> kEdits{"cut",    "paste", "duplicate", "delete",
                                          "mirror", "split", "moveUp",    "moveDown"};
    return kEdits.count(name) == 1 || name.startsWith("add");
}

/// Those that begin with a question in the state of the test.
const std::set<QString> kAsk{
    "new",           "newFromTemplate", "open",           "saveAs",       "openRecording",
    "saveRecording", "exportCsv",       "exportChannels", "addRecording", "recover",
    "exportPlots",   "screenshot",      "exportFilm",     "quit",         "shortcuts",
    "system",        "about",           "languageDE",     "languageEN",   "languageSystem"};

}  // namespace

TEST_F(EveryActionTest, IsTakenAndWhatAsksIsCancelled) {
    // An edit, so that leaving the project asks; one undone, so that redo can be taken.
    auto next = window->document().project();
    next.rover.bodies.front().mass = 7.25;
    window->document().edit("Load", next);
    next.rover.bodies.front().mass = 7.5;
    window->document().edit("More load", next);
    steps().undo();
    const int index = steps().index();
    const std::string before = bytes();
    std::vector<std::string> never;
    for (QAction* action : window->actions().all()) {
        const QString name = action->objectName();
        SCOPED_TRACE(name.toStdString());
        // In the file of a test there is nothing to save over.
        if (name == "save") {
            continue;
        }
        settle(index);
        ASSERT_EQ(bytes(), before);
        if (name == "redo") {
            window->document().edit("More load", next);
            steps().undo();
        }
        if (edits(name) || name == "rename" || name == "copy") {
            // A joint that is mirrored can be split, one that is not can be mirrored.
            const bool mirrors = name == "mirror";
            const auto& joints = window->document().project().rover.joints;
            int joint = 0;
            for (int i = 0; i < static_cast<int>(joints.size()); ++i) {
                if (joints[static_cast<std::size_t>(i)].mirror != mirrors) {
                    joint = i;
                    break;
                }
            }
            selectPart(simcore::project::ElementKind::Joint, name == "moveUp"     ? 1
                                                             : name == "moveDown" ? 0
                                                                                  : joint);
        }
        if (!action->isEnabled()) {
            never.push_back(name.toStdString());
            continue;
        }
        const auto windows = openWindows();
        Canceller canceller;
        action->trigger();
        QTest::qWait(150);
        if (name == "rename") {
            auto* editor = window->findChild<QTreeWidget*>("partsTree")->findChild<QLineEdit*>();
            ASSERT_NE(editor, nullptr);
            QTest::keyClick(editor, Qt::Key_Escape);
        }
        if (name == "playPause" || name == "experiment") {
            window->session().pause();
        }
        EXPECT_THAT(canceller.unnamed(), IsEmpty());
        EXPECT_FALSE(canceller.stuck()) << "Escape does not close it";
        EXPECT_EQ(canceller.dialogs().isEmpty(), kAsk.count(name) == 0)
            << canceller.dialogs().join(", ").toStdString();
        EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
        EXPECT_TRUE(window->isVisible());
        EXPECT_THAT(written(), IsEmpty());
        if (name != "showGraph" && name != "guide") {
            EXPECT_EQ(openWindows(), windows);
        }
        if (edits(name)) {
            // Cut and copied parts, refused deletions: at most one step, which undo takes back.
            EXPECT_LE(steps().index(), index + 1);
        } else if (name != "undo" && name != "redo") {
            EXPECT_EQ(steps().index(), index);
            EXPECT_EQ(bytes(), before);
        }
        steps().setIndex(index);
        EXPECT_EQ(bytes(), before);
    }
    // Only a recording that was opened can be run again.
    EXPECT_THAT(never, testing::ElementsAre("runAgain"));
}

TEST_F(EveryActionTest, EveryWidgetIsNamed) {
    drive();
    window->library().keep(window->session(), window->document().project());
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
        dock->show();
    }
    using simcore::project::ElementKind;
    std::set<std::string> unnamed;
    const auto look = [&] {
        QTest::qWait(20);
        for (const std::string& text : unnamedWidgets(window.get())) {
            unnamed.insert(text);
        }
    };
    look();
    for (const ElementKind kind : simcore::project::allElementKinds()) {
        selectPart(kind, 0);
        look();
    }
    EXPECT_THAT(unnamed, IsEmpty());
}

TEST_F(EveryActionTest, DialogsThatNoActionOpensAreNamedToo) {
    std::vector<widgets::Recovered> found(2);
    for (auto& one : found) {
        one.project = window->document().project();
    }
    widgets::RecoveryDialog dialog(std::move(found), window.get());
    EXPECT_THAT(unnamedWidgets(&dialog), IsEmpty());
}
