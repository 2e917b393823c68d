// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "boxwood/world/world.h"
#include "cli/arguments.h"
#include "cli/command_line.h"

namespace boxwood::cli {

/// What render and demo have in common: how a picture is made, and where it goes.
struct PictureOptions {
    std::string output = "raytrace.png";
    int width = 640;
    int height = 480;
    std::string integrator = "phong";
    Accelerator accelerator;
    std::size_t threads = 0;
    int samples = 1;
    std::uint64_t seed = 0;
    bool quiet = false;
};

void add_picture_options(CLI::App& command, PictureOptions& options);

/// Throws what making the picture would fail with in the end, before the work begins.
void check_output(const PictureOptions& options);

/// Renders the world and writes the picture; says where it is and what took how long.
void make_picture(const World& world, const PictureOptions& options, double load_seconds);

}  // namespace boxwood::cli
