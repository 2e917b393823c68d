// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/world/read_world.h"
#include "cli/commands.h"
#include "cli/mesh_repair.h"
#include "cli/picture.h"
#include "cli/stopwatch.h"
#include "cli/warnings.h"

namespace boxwood::cli {

namespace {

constexpr Named<UpAxis> kUpAxes[] = {{"y", UpAxis::y}, {"z", UpAxis::z}};

struct RenderArguments {
    std::string scene;
    std::string data;
    std::string up;
    std::vector<std::string> repair;
    std::size_t camera = 0;
    bool allow_outside_files = false;
    PictureOptions picture;
};

void choose_camera(World& world, std::size_t camera) {
    if (world.cameras.empty() && camera == 0) return;
    if (camera >= world.cameras.size())
        throw InvalidInput(fmt::format("--camera: found {}, but the scene has {} cameras", camera,
                                       world.cameras.size()));
    use_camera(world, camera);
}

void run(const RenderArguments& arguments) {
    const ThreadLimit limit(arguments.picture.threads);
    check_output(arguments.picture);
    Stopwatch stopwatch;
    WorldOptions options = {.data_folder = arguments.data};
    options.read.allow_outside_files = arguments.allow_outside_files;
    options.repair = repair_steps_of(arguments.repair);
    if (!arguments.up.empty())
        options.up = value_of(std::span<const Named<UpAxis>>(kUpAxes), arguments.up);
    World world = read_world(arguments.scene, options);
    choose_camera(world, arguments.camera);
    if (!arguments.picture.quiet) print_warnings(world.warnings);
    make_picture(std::move(world), arguments.picture, stopwatch.lap());
}

}  // namespace

void add_render(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("render", "Render a scene, or a mesh by itself, to a picture");
    auto arguments = std::make_shared<RenderArguments>();
    command->add_option("SCENE", arguments->scene, "a scene.json, a glTF file or a mesh file")
        ->required();
    command->add_option("--data", arguments->data, "where else to look for the scene's meshes")
        ->option_text("DIR");
    command->add_option("--up", arguments->up, "which axis of a mesh file points up")
        ->check(CLI::IsMember(names(std::span<const Named<UpAxis>>(kUpAxes))));
    command->add_option("--camera", arguments->camera, "which of a glTF file's cameras, from 0")
        ->capture_default_str();
    command->add_flag("--allow-outside-files", arguments->allow_outside_files,
                      "let files name others outside their own folder");
    add_repair(*command, arguments->repair);
    add_picture_options(*command, arguments->picture);
    command->footer(
        "Example:\n"
        "  boxwood render dragon.ply -o dragon.png\n"
        "  boxwood render scene.json --integrator whitted --samples 16 -o picture.png");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace boxwood::cli
