// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "boxwood/world/world.h"
#include "cli/arguments.h"
#include "cli/command_line.h"

namespace boxwood::cli {

/// What render and demo have in common: how a picture is made, and where it goes.
struct PictureOptions {
    std::string output = "raytrace.png";
    Accelerator accelerator;
    std::size_t threads = 0;
    bool quiet = false;

    // Where they are missing, the world says how it wants its picture.
    std::optional<std::pair<int, int>> size;
    std::optional<std::string> integrator;
    std::optional<int> samples;
    std::optional<std::uint64_t> seed;

    PictureSettings applied_to(const PictureSettings& settings) const;
};

void add_picture_options(CLI::App& command, PictureOptions& options);

/// Throws what making the picture would fail with in the end, before the work begins.
void check_output(const PictureOptions& options);

/// Renders the world and writes the picture; says where it is and what took how long.
void make_picture(World world, const PictureOptions& options, double load_seconds);

}  // namespace boxwood::cli
