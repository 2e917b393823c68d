// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>

#include "boxwood/core/parallel.h"
#include "boxwood/world/classic_scene.h"
#include "cli/commands.h"
#include "cli/picture.h"
#include "cli/stopwatch.h"
#include "cli/warnings.h"

namespace boxwood::cli {

namespace {

struct RenderArguments {
    std::string scene;
    std::string data;
    PictureOptions picture;
};

void run(const RenderArguments& arguments) {
    const ThreadLimit limit(arguments.picture.threads);
    check_output(arguments.picture);
    Stopwatch stopwatch;
    const World world = read_classic_scene(arguments.scene, arguments.data);
    if (!arguments.picture.quiet) print_warnings(world.warnings);
    make_picture(world, arguments.picture, stopwatch.lap());
}

}  // namespace

void add_render(CLI::App& app) {
    CLI::App* command = app.add_subcommand("render", "Render a scene file to a picture");
    auto arguments = std::make_shared<RenderArguments>();
    command->add_option("SCENE", arguments->scene, "a scene.json")->required();
    command->add_option("--data", arguments->data, "where else to look for the scene's meshes")
        ->option_text("DIR");
    add_picture_options(*command, arguments->picture);
    command->footer(
        "Example:\n  boxwood render scene.json --integrator whitted --samples 16 -o picture.png");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace boxwood::cli
