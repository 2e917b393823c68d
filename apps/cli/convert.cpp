// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>

#include "boxwood/mesh/mesh_file.h"
#include "cli/arguments.h"
#include "cli/commands.h"

namespace boxwood::cli {

namespace {

struct ConvertArguments {
    std::string input;
    std::string output;
};

}  // namespace

void add_convert(CLI::App& app) {
    CLI::App* command = app.add_subcommand("convert", "Write a mesh to a file");
    auto arguments = std::make_shared<ConvertArguments>();
    command->add_option("MESH", arguments->input, mesh_argument_help())->required();
    command->add_option("OUT", arguments->output, "the file to write (.off)")->required();
    command->footer("Example:\n  boxwood convert torus_knot:100k knot.off");
    command->callback([arguments] { write_mesh(arguments->output, load_mesh(arguments->input)); });
}

}  // namespace boxwood::cli
