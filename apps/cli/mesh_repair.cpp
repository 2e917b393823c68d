// SPDX-License-Identifier: Apache-2.0
#include "cli/mesh_repair.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/arguments.h"

namespace boxwood::cli {

void add_repair(CLI::App& command, std::vector<std::string>& steps) {
    command.add_option("--repair", steps, "what to do about the mesh, step by step")
        ->check(CLI::IsMember(names(repair_steps())))
        ->delimiter(',')
        ->allow_extra_args(false);
}

RepairReport repair(MeshData& mesh, const std::vector<std::string>& steps) {
    std::vector<RepairStep> values;
    values.reserve(steps.size());
    for (const std::string& step : steps) values.push_back(value_of(repair_steps(), step));
    return boxwood::repair(mesh, values);
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
