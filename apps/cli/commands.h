// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/command_line.h"

namespace boxwood::cli {

// The subcommands, one a file: each adds itself, its options and what it does.
void add_render(CLI::App& app);
void add_demo(CLI::App& app);
void add_info(CLI::App& app);
void add_bench(CLI::App& app);
void add_convert(CLI::App& app);
void add_scene(CLI::App& app);

}  // namespace boxwood::cli
