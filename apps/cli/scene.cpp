// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>

#include "boxwood/core/files.h"
#include "boxwood/world/classic_scene.h"
#include "cli/commands.h"

namespace boxwood::cli {

namespace {

struct UpgradeArguments {
    std::string input;
    std::string output;
};

void upgrade(const UpgradeArguments& arguments) {
    const MappedFile file(arguments.input);
    const std::string text =
        upgraded_classic_scene(JsonReader::parse(file.text(), arguments.input));
    OutputFile output(arguments.output);
    output.write(text);
    output.commit();
}

}  // namespace

void add_scene(CLI::App& app) {
    CLI::App* command = app.add_subcommand("scene", "Work on scene files");
    command->require_subcommand(1);
    command->footer("Example:\n  boxwood scene upgrade classic.json -o new.json");
    CLI::App* child = command->add_subcommand(
        "upgrade", "Write a classic scene as one of version 2, which gives the same picture");
    auto arguments = std::make_shared<UpgradeArguments>();
    child->add_option("SCENE", arguments->input, "a classic scene.json")->required();
    child->add_option("-o,--output", arguments->output, "the file to write, in the same folder")
        ->required();
    child->footer("Example:\n  boxwood scene upgrade classic.json -o new.json");
    child->callback([arguments] { upgrade(*arguments); });
}

}  // namespace boxwood::cli
