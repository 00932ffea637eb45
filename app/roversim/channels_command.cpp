#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/run/channels.h"

namespace roversim {

using namespace simcore;

namespace {

struct ChannelsOptions {
    std::string file;
    bool markdown = false;
};

int listChannels(const ChannelsOptions& options) {
    if (options.markdown) {
        fmt::print("{}", run::channelTable());
        return kGood;
    }
    if (options.file.empty()) {
        fmt::print(stderr, "roversim: channels: give a project file, or --markdown\n");
        return kWrongUse;
    }
    const auto project = loadOrComplain(options.file);
    if (!project) {
        return kAnswerIsNo;
    }
    const auto mechanism = project::resolve(*project);
    printProblems(options.file, mechanism.problems());
    if (!mechanism) {
        return kAnswerIsNo;
    }
    for (const run::Channel& channel : run::makeChannels(*mechanism)) {
        fmt::print("{:<48} {:<9} {}\n", channel.column(), run::toString(channel.source),
                   channel.meaning);
    }
    return kGood;
}

}  // namespace

void addChannelsCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<ChannelsOptions>();
    CLI::App* command =
        app.add_subcommand("channels", "List what a run records: the columns of its CSV");
    command->add_option("FILE", options->file, "Project file (.rover)");
    command->add_flag("--markdown", options->markdown,
                      "Print the table of docs/csv.md, for any rover");
    command->callback([options, &exitCode] { exitCode = listChannels(*options); });
}

}  // namespace roversim
