// roversim: everything RoverStudio computes, without a display.
#include <cstdio>
#include <exception>

#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/base/version.h"

int main(int argc, char** argv) {
    CLI::App app{"Analyse and drive rovers of RoverStudio projects without a display.", "roversim"};
    app.set_version_flag("--version", "roversim " + simcore::programVersion());
    app.require_subcommand(1);
    app.failure_message(CLI::FailureMessage::simple);
    int exitCode = roversim::kGood;
    roversim::addNewCommand(app, exitCode);
    roversim::addMobilityCommand(app, exitCode);
    roversim::addRelaxCommand(app, exitCode);
    roversim::addValidateCommand(app, exitCode);
    roversim::addRunCommand(app, exitCode);
    roversim::addCriticalFrictionCommand(app, exitCode);
    roversim::addExperimentCommand(app, exitCode);
    roversim::addChannelsCommand(app, exitCode);
    roversim::addReplayCommand(app, exitCode);
    roversim::addExportCommand(app, exitCode);
    roversim::addConvertCommand(app, exitCode);
    roversim::addStaticsCommand(app, exitCode);
    roversim::addTerrainCommand(app, exitCode);
    roversim::addReproduceCommand(app, exitCode);
    roversim::addWorkerCommand(app, exitCode);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? roversim::kGood : roversim::kWrongUse;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "roversim: %s\n", error.what());
        return roversim::kAnswerIsNo;
    }
    return exitCode;
}
