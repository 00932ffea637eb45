// Films of a run, and arrangements of the panels, in the real window.
#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include "tests/support/studio.h"
#include "widgets/session/run_bar.h"
#include "widgets/window/film.h"

using testing::HasSubstr;
using testsupport::waitUntil;
using State = widgets::RunSession::State;

namespace {

/// In place of ffmpeg: keeps what it is fed, in the file that it is told last.
constexpr const char* kEncoder = R"(#!/bin/sh
for last; do :; done
echo "$@" > "$(dirname "$0")/arguments"
exec cat > "$last"
)";

class FilmTest : public testsupport::StudioTest {
  protected:
    FilmTest() : path_(qgetenv("PATH")) {
        QFile script(folder_.filePath("ffmpeg"));
        EXPECT_TRUE(script.open(QFile::WriteOnly));
        script.write(kEncoder);
        script.close();
        script.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        qputenv("PATH", folder_.path().toUtf8() + ":" + path_);
        window->runBar().setScenario("flat");
        session().setSpeedFactor(0.0);
        press(Qt::Key_Space);
        EXPECT_TRUE(waitUntil([&] { return session().endTime() >= 1.0; }));
        press(Qt::Key_Space);
    }

    ~FilmTest() override { qputenv("PATH", path_); }

    widgets::RunSession& session() { return window->session(); }

    widgets::FilmRequest request(const QString& name) {
        widgets::FilmRequest r;
        r.file = folder_.filePath(name);
        r.to = 0.8;
        r.speed = 2.0;
        return r;
    }

    QTemporaryDir folder_;
    QByteArray path_;
};

}  // namespace

// 0 to 0.8 s at twice the speed and 25 pictures a second: every 0.08 s, 11 pictures.
TEST_F(FilmTest, EveryPictureGoesToTheEncoder) {
    session().scrub(0.5);
    const double shown = session().shownTime();
    int calls = 0;
    const auto problems = widgets::writeFilm(session(), *window->viewport(), request("a.mp4"),
                                             [&](double) { return ++calls > 0; });
    ASSERT_TRUE(problems.empty()) << toString(problems);
    EXPECT_EQ(calls, 11);
    const QSize size = window->viewport()->grabImage().size();
    const qint64 picture = 3LL * (size.width() / 2 * 2) * (size.height() / 2 * 2);
    EXPECT_EQ(QFileInfo(folder_.filePath("a.mp4")).size(), 11 * picture);
    EXPECT_DOUBLE_EQ(session().shownTime(), shown);
    // Pictures differ: the rover drives.
    QFile film(folder_.filePath("a.mp4"));
    ASSERT_TRUE(film.open(QFile::ReadOnly));
    const QByteArray all = film.readAll();
    EXPECT_NE(all.left(picture), all.right(picture));
    QFile arguments(folder_.filePath("arguments"));
    ASSERT_TRUE(arguments.open(QFile::ReadOnly));
    EXPECT_THAT(arguments.readAll().toStdString(), HasSubstr("libx264"));
}

/// Where the real one is installed: what it makes can be read, with all pictures.
TEST_F(FilmTest, TheRealEncoderMakesFilms) {
    qputenv("PATH", path_);
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) {
        GTEST_SKIP() << "ffmpeg is not installed";
    }
    for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
        const auto film = request(name);
        const auto problems =
            widgets::writeFilm(session(), *window->viewport(), film, [](double) { return true; });
        ASSERT_TRUE(problems.empty()) << toString(problems);
        QProcess reader;
        reader.start("ffmpeg", {"-loglevel", "error", "-i", film.file, "-f", "framemd5", "-"});
        ASSERT_TRUE(reader.waitForFinished(30000));
        EXPECT_EQ(reader.exitCode(), 0) << name;
        int pictures = 0;
        for (const QByteArray& line : reader.readAllStandardOutput().split('\n')) {
            pictures += line.startsWith("0, ") ? 1 : 0;
        }
        EXPECT_EQ(pictures, 11) << name;
    }
}

TEST_F(FilmTest, AnEndedFilmLeavesNothing) {
    const auto problems = widgets::writeFilm(session(), *window->viewport(), request("b.gif"),
                                             [](double part) { return part < 0.5; });
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(QDir(folder_.path()).entryList({"*.gif"}, QDir::Files | QDir::Hidden).size(), 0);
}

TEST_F(FilmTest, WhatCannotBeFilmedIsSaid) {
    const auto film = [&](const widgets::FilmRequest& r) {
        const auto problems =
            widgets::writeFilm(session(), *window->viewport(), r, [](double) { return true; });
        EXPECT_EQ(problems.size(), 1U);
        return problems.empty() ? std::string() : problems.front().reason;
    };
    EXPECT_THAT(film(request("c.avi")), HasSubstr("format"));
    EXPECT_THAT(film(request("nowhere/c.mp4")), HasSubstr("could not be written"));
    qputenv("PATH", "/nowhere");
    EXPECT_THAT(film(request("c.mp4")), HasSubstr("ffmpeg"));
    session().clear();
    EXPECT_THAT(film(request("c.mp4")), HasSubstr("no run"));
}

TEST_F(FilmTest, ArrangementsShowWhatTheirWorkNeeds) {
    const auto shows = [&](const QString& name) {
        return find<QDockWidget>(name + "Dock")->isVisible();
    };
    window->actions().at("arrange:design")->trigger();
    EXPECT_TRUE(shows("rover"));
    EXPECT_TRUE(shows("mobility"));
    EXPECT_FALSE(shows("run"));
    window->actions().at("arrange:simulate")->trigger();
    EXPECT_FALSE(shows("rover"));
    EXPECT_TRUE(shows("run"));
    EXPECT_FALSE(shows("mobility"));
    window->actions().at("arrange:compare")->trigger();
    EXPECT_TRUE(shows("run"));
    EXPECT_TRUE(shows("compare"));
    window->actions().at("resetLayout")->trigger();
    EXPECT_TRUE(shows("rover"));
    EXPECT_TRUE(shows("run"));
}
