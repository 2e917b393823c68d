// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/demo.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "boxwood/core/parallel.h"
#include "cli/commands.h"
#include "cli/picture.h"
#include "cli/stopwatch.h"

namespace boxwood::cli {

namespace {

void run(const PictureOptions& options) {
    const ThreadLimit limit(options.threads);
    check_output(options);
    Stopwatch stopwatch;
    World world = make_demo_world();
    make_picture(std::move(world), options, stopwatch.lap());
}

}  // namespace

void add_demo(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("demo", "Render the built-in scene, which needs no file");
    auto options = std::make_shared<PictureOptions>();
    add_picture_options(*command, *options);
    command->footer("Example:\n  boxwood demo --size 1920x1080 --samples 64 -o demo.png");
    command->callback([options] { run(*options); });
}

}  // namespace boxwood::cli
