#pragma once

#include <QApplication>
#include <QLineEdit>
#include <QTest>
#include <functional>

#include <gtest/gtest.h>

#include "widgets/editors/quantity_field.h"
#include "widgets/window/action_registry.h"
#include "widgets/window/file_commands.h"
#include "widgets/window/main_window.h"

/// A studio window with SOLERO in it, for tests with real clicks and keys.
namespace testsupport {

inline QString projectFile(const QString& name) {
    return QString(ROVER_SOURCE_DIR) + "/assets/projects/" + name + ".rover";
}

/// Lets events run until `done`; false when that takes too long.
inline bool waitUntil(const std::function<bool()>& done, int limit_ms = 20000) {
    return QTest::qWaitFor(done, limit_ms);
}

class StudioTest : public testing::Test {
  protected:
    StudioTest() {
        window = std::make_unique<widgets::MainWindow>();
        window->setDark(true);
        EXPECT_TRUE(window->document().open(projectFile("solero")).empty());
        window->resize(1440, 900);
        window->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->activateWindow();
        QTest::qWait(50);
    }

    ~StudioTest() override {
        // Tests leave edits behind; closing must not ask.
        window->document().undoStack().setClean();
        window->files().discardAutosave();
    }

    template <class Widget = QWidget>
    Widget* find(const QString& name) {
        Widget* found = window->findChild<Widget*>(name);
        EXPECT_NE(found, nullptr) << name.toStdString();
        return found;
    }

    /// Types into a line as a user does: click, select all, keys, Enter.
    static void type(QLineEdit* line, const QString& text) {
        QTest::mouseClick(line, Qt::LeftButton);
        line->selectAll();
        QTest::keyClicks(line, text);
        QTest::keyClick(line, Qt::Key_Return);
    }

    widgets::QuantityField* parameter(const QString& name) {
        return find<widgets::QuantityField>("parameter:" + name);
    }

    double parameterValue(const std::string& name) const {
        return window->document().derived().parameters.at(name);
    }

    /// Presses a key where shortcuts are heard: on the window itself.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        window->activateWindow();  // shortcuts are for the active window only
        EXPECT_TRUE(QTest::qWaitForWindowActive(window.get()));
        window->setFocus();
        QTest::keyClick(window.get(), key, modifiers);
    }

    std::unique_ptr<widgets::MainWindow> window;
};

}  // namespace testsupport
