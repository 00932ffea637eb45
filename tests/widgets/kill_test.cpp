// A program that edits and saves is killed at random moments, several at once: the file is the old
// or the new one, and no more than 5 s of edits are lost.
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>
#include <QWidget>
#include <chrono>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "simcore/base/random.h"
#include "simcore/io/atomic_file.h"
#include "simcore/io/project_file.h"
#include "tests/support/projects.h"
#include "widgets/document/autosave.h"
#include "widgets/document/document.h"
#include "widgets/window/file_commands.h"

namespace {

constexpr int kAtOnce = 8;
constexpr double kAllowed_s = 5.0;

/// The same clock in all programs [s].
double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// The project after edit `number`.
simcore::project::Project edited(int number) {
    simcore::project::Project project = testsupport::cart();
    project.rover.name = std::to_string(number);
    return project;
}

int numberOf(const simcore::project::Project& project) {
    return std::stoi(project.rover.name);
}

/// What the program did, in records of text that outlive it: "edit", "save", "saved", with the
/// number of the edit and the time.
class Journal {
  public:
    explicit Journal(const std::string& file)
        : descriptor_(::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600)) {}

    void write(const char* what, int number) const {
        simcore::io::writeAll(descriptor_, std::string(what) + " " + std::to_string(number) + " " +
                                               std::to_string(now()) + "\n");
    }

  private:
    int descriptor_;
};

/// The program that is killed. Saves after about one in `saveEvery` edits.
int editForever(int argc, char** argv, const QString& folder, int seed, int saveEvery) {
    QApplication application(argc, argv);
    QWidget window;
    widgets::Document document;
    widgets::FileCommands files(&document, &window);
    const Journal journal(folder.toStdString() + "/journal");
    if (!document.open(folder + "/project.rover").empty()) {
        return 1;
    }
    simcore::Random random(static_cast<std::uint64_t>(seed));
    int number = 0;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        ++number;
        document.edit("Edit", edited(number));
        journal.write("edit", number);
        if (random.next() % static_cast<unsigned>(saveEvery) == 0) {
            journal.write("save", number);
            if (files.save()) {
                journal.write("saved", number);
            }
        }
    });
    timer.start(20);
    return QApplication::exec();
}

struct Victim {
    pid_t process = 0;
    std::unique_ptr<QTemporaryDir> folder;
    double end = 0.0;  ///< [s]
};

Victim startVictim(int seed, int saveEvery) {
    Victim victim;
    victim.folder = std::make_unique<QTemporaryDir>();
    const std::string folder = victim.folder->path().toStdString();
    EXPECT_TRUE(simcore::io::saveProject(edited(0), folder + "/project.rover"));
    const std::string seedText = std::to_string(seed);
    const std::string saveText = std::to_string(saveEvery);
    victim.process = ::fork();
    if (victim.process == 0) {
        ::execl("/proc/self/exe", "kill_test", "--edit", folder.c_str(), seedText.c_str(),
                saveText.c_str(), nullptr);
        ::_exit(2);
    }
    return victim;
}

/// Checks what the killed program left; edits lost [s].
double inspect(const Victim& victim, double killed) {
    const std::string folder = victim.folder->path().toStdString();
    int saved = 0;
    int saving = 0;
    std::vector<double> times{0.0};  // of the edits, by number
    std::ifstream journal(folder + "/journal");
    std::string what;
    int number = 0;
    double time = 0.0;
    while (journal >> what >> number >> time) {
        if (what == "edit") {
            times.push_back(time);
        } else {
            (what == "saved" ? saved : saving) = number;
        }
    }
    const std::string file = folder + "/project.rover";
    const auto text = simcore::io::readFile(file);
    const auto onDisk = simcore::io::loadProject(file);
    if (!text || !onDisk) {
        ADD_FAILURE() << "the file is broken";
        return 0.0;
    }
    int kept = numberOf(*onDisk);
    EXPECT_TRUE(kept == saved || kept == saving) << kept << ", saved " << saved;
    EXPECT_EQ(*text, simcore::io::formatProject(edited(kept)));
    if (kept > 0) {
        const auto backup = simcore::io::readFile(file + "~");
        EXPECT_TRUE(backup && *backup == simcore::io::formatProject(edited(0)));
    }
    for (const widgets::Leftover& leftover : widgets::findLeftovers()) {
        if (leftover.original.toStdString() == file) {
            const auto copy = simcore::io::loadProject(leftover.copy.toStdString());
            EXPECT_TRUE(copy) << "the copy is broken";
            kept = copy ? std::max(kept, numberOf(*copy)) : kept;
            widgets::remove(leftover);
        }
    }
    const auto next = static_cast<std::size_t>(kept) + 1;
    return next < times.size() ? killed - times[next] : 0.0;
}

}  // namespace

// ROVER_KILLS is the number of programs.
TEST(KillTest, FileIsOldOrNewAndFewEditsAreLost) {
    const char* wanted = std::getenv("ROVER_KILLS");
    const int kills = wanted == nullptr ? 25 : std::atoi(wanted);
    const auto seed =
        static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
    RecordProperty("seed", std::to_string(seed));
    simcore::Random random(seed);
    std::vector<Victim> victims;
    int started = 0;
    int unsaved = 0;
    double worst = 0.0;
    while (started < kills || !victims.empty()) {
        while (started < kills && victims.size() < kAtOnce) {
            // Some save all the time, others hardly ever.
            ++started;
            victims.push_back(startVictim(started, started % 2 == 0 ? 2 : 2000));
        }
        for (Victim& victim : victims) {
            const QString journal = victim.folder->filePath("journal");
            if (victim.end == 0.0 && QFileInfo(journal).size() > 0) {
                victim.end = now() + random.uniform(0.0, 8.0);
            }
            if (victim.end == 0.0 || now() < victim.end) {
                continue;
            }
            const double killed = now();
            ASSERT_EQ(::kill(victim.process, SIGKILL), 0);
            int status = 0;
            ::waitpid(victim.process, &status, 0);
            ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
            const double lost = inspect(victim, killed);
            worst = std::max(worst, lost);
            unsaved += lost > 0.0 ? 1 : 0;
            EXPECT_LE(lost, kAllowed_s) << "seed " << seed;
            victim.process = 0;
        }
        std::erase_if(victims, [](const Victim& victim) { return victim.process == 0; });
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    std::printf("%d killed, %d with edits lost, at most %.2f s of them\n", kills, unsaved, worst);
    EXPECT_TRUE(widgets::findLeftovers().empty());
}

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QCoreApplication::setOrganizationName("RoverStudioTest");
    QCoreApplication::setApplicationName("RoverStudioTest");
    if (argc == 5 && std::string(argv[1]) == "--edit") {
        return editForever(argc, argv, argv[2], std::atoi(argv[3]), std::atoi(argv[4]));
    }
    const QTemporaryDir home;
    for (const char* name : {"HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_RUNTIME_DIR"}) {
        qputenv(name, home.path().toUtf8());
    }
    testing::InitGoogleTest(&argc, argv);
    QCoreApplication application(argc, argv);
    return RUN_ALL_TESTS();
}
