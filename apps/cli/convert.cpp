// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "boxwood/mesh/mesh_file.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/mesh_repair.h"

namespace boxwood::cli {

namespace {

struct ConvertArguments {
    std::string input;
    std::string output;
    std::vector<std::string> repair;
};

void warn_of_losses(const MeshAttributes& attributes, const std::string& output) {
    const MeshFormat& format = mesh_format_of(output);
    for (const AttributeName& attribute : attribute_names(attributes)) {
        if (!format.holds(attribute))
            fmt::print(stderr, "boxwood: warning: {}: left out {}, which {} has no place for\n",
                       output, one_line(attribute.text()), format.extension);
    }
}

void run(const ConvertArguments& arguments) {
    MeshData mesh = load_mesh(arguments.input);
    const RepairReport report = repair(mesh, arguments.repair);
    write_mesh(arguments.output, mesh, mesh.attributes);
    warn_of_losses(mesh.attributes, arguments.output);
    if (!arguments.repair.empty()) fmt::print("{}\n", text_of(report));
}

}  // namespace

void add_convert(CLI::App& app) {
    CLI::App* command = app.add_subcommand("convert", "Write a mesh to a file");
    auto arguments = std::make_shared<ConvertArguments>();
    command->add_option("MESH", arguments->input, mesh_argument_help())->required();
    command
        ->add_option("OUT", arguments->output,
                     fmt::format("the file to write ({})", written_extensions()))
        ->required();
    add_repair(*command, arguments->repair);
    command->footer(
        "Example:\n  boxwood convert torus_knot:100k knot.off\n"
        "  boxwood convert part.stl part.off --repair weld,orient");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace boxwood::cli
