// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "boxwood/mesh/repair.h"
#include "cli/command_line.h"

namespace boxwood::cli {

/// Adds --repair.
void add_repair(CLI::App& command, std::vector<std::string>& steps);

std::vector<RepairStep> repair_steps_of(const std::vector<std::string>& names);

/// Takes the steps of those names.
RepairReport repair(MeshData& mesh, const std::vector<std::string>& steps);

/// "welded 3 vertices, dropped 0 faces, turned 1 face around", and what could not be done.
std::string text_of(const RepairReport& report);

}  // namespace boxwood::cli
