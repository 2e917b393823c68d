// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "boxwood/core/error.h"
#include "boxwood/mesh/mesh_file.h"
#include "boxwood/tree/statistics.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/mesh_repair.h"
#include "cli/mesh_report.h"
#include "cli/stopwatch.h"

namespace boxwood::cli {

namespace {

struct InfoArguments {
    std::string mesh;
    std::vector<std::string> repair;
    std::vector<std::string> builders = {"median", "binned_sah"};
    std::string cost = "surface_area";
    bool json = false;
};

struct TreeReport {
    std::string builder;
    double build_seconds;
    TreeStatistics statistics;
};

TreeReport report_tree(MeshView mesh, const std::string& builder, const std::string& cost) {
    const BuildOptions options = *Accelerator{builder, cost}.scene_options().build;
    if (const auto warning = warning_before_build(mesh.faces.size(), options))
        fmt::print(stderr, "boxwood: warning: {}\n", *warning);
    Stopwatch stopwatch;
    const Tree tree = build_tree(mesh, options);
    return {builder, stopwatch.lap(), statistics(tree)};
}

void print_json(const MeshInfo& info, const std::vector<TreeReport>& trees) {
    nlohmann::ordered_json json = as_json(info);
    json["trees"] = nlohmann::ordered_json::array();
    for (const TreeReport& tree : trees) {
        json["trees"].push_back({{"builder", tree.builder},
                                 {"nodes", tree.statistics.nodes},
                                 {"leaves", tree.statistics.leaves},
                                 {"depth", tree.statistics.depth},
                                 {"largest_leaf", tree.statistics.largest_leaf},
                                 {"sah_cost", tree.statistics.sah_cost},
                                 {"build_seconds", tree.build_seconds},
                                 {"bytes", tree.statistics.bytes}});
    }
    // Names in files may be of any bytes, and JSON has only UTF-8.
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void print_text(const MeshInfo& info, const std::vector<TreeReport>& trees) {
    print_text(info);
    fmt::print("\n{:<16}{:>12}{:>8}{:>12}{:>12}{:>14}\n", "builder", "nodes", "depth", "SAH cost",
               "build ms", "bytes");
    for (const TreeReport& tree : trees)
        fmt::print("{:<16}{:>12}{:>8}{:>12.1f}{:>12.1f}{:>14}\n", tree.builder,
                   tree.statistics.nodes, tree.statistics.depth, tree.statistics.sah_cost,
                   1e3 * tree.build_seconds, tree.statistics.bytes);
}

MeshInfo info_of(const InfoArguments& arguments, MeshData& mesh) {
    MeshInfo info;
    if (!names_generated_shape(arguments.mesh)) info.format = mesh_format_of(arguments.mesh).name;
    if (!arguments.repair.empty()) info.repair = repair(mesh, arguments.repair);
    for (const AttributeName& attribute : attribute_names(mesh.attributes))
        info.attributes.push_back(one_line(attribute.text()));
    info.warnings = mesh.warnings;
    info.report = inspect(mesh);
    return info;
}

void run(const InfoArguments& arguments) {
    MeshData mesh = load_mesh(arguments.mesh);
    const MeshInfo info = info_of(arguments, mesh);
    std::vector<TreeReport> trees;
    for (const std::string& builder : arguments.builders)
        trees.push_back(report_tree(mesh, builder, arguments.cost));
    if (arguments.json) {
        print_json(info, trees);
    } else {
        print_text(info, trees);
    }
}

}  // namespace

void add_info(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("info", "Say what is in a mesh, and what trees it gives");
    auto arguments = std::make_shared<InfoArguments>();
    command->add_option("MESH", arguments->mesh, mesh_argument_help())->required();
    command->add_option("--accelerator", arguments->builders, "builders to try")
        ->check(CLI::IsMember(names(build_methods())))
        ->delimiter(',')
        ->capture_default_str();
    add_cost(*command, arguments->cost);
    add_repair(*command, arguments->repair);
    command->add_flag("--json", arguments->json, "print JSON");
    command->footer("Example:\n  boxwood info dragon.off --accelerator median,binned_sah");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace boxwood::cli
