// SPDX-License-Identifier: Apache-2.0
#include "cli/mesh_repair.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/arguments.h"

namespace boxwood::cli {

void add_repair(CLI::App& command, std::vector<std::string>& steps) {
    command.add_option("--repair", steps, "what to do about a mesh, step by step")
        ->check(CLI::IsMember(names(repair_steps())))
        ->delimiter(',')
        ->allow_extra_args(false);
}

std::vector<RepairStep> repair_steps_of(const std::vector<std::string>& names) {
    std::vector<RepairStep> steps;
    steps.reserve(names.size());
    for (const std::string& name : names) steps.push_back(value_of(repair_steps(), name));
    return steps;
}

RepairReport repair(MeshData& mesh, const std::vector<std::string>& steps) {
    return boxwood::repair(mesh, repair_steps_of(steps));
}

std::string text_of(const RepairReport& report) {
    std::string text =
        fmt::format("{} vertices welded, {} faces dropped, {} faces turned around",
                    report.welded_vertices, report.dropped_faces, report.flipped_faces);
    if (report.unorientable_components > 0)
        text += fmt::format(", {} components can't be oriented", report.unorientable_components);
    return text;
}

}  // namespace boxwood::cli
