// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "boxwood/mesh/inspect.h"
#include "boxwood/tree/statistics.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/stopwatch.h"

namespace boxwood::cli {

namespace {

struct InfoArguments {
    std::string mesh;
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

std::array<double, 3> as_array(const Vec3d& v) { return {v.x(), v.y(), v.z()}; }

void print_json(const MeshReport& mesh, const std::vector<TreeReport>& trees) {
    nlohmann::ordered_json json = {
        {"vertices", mesh.vertices},
        {"faces", mesh.faces},
        {"bounds", nullptr},
        {"closed", mesh.closed},
        {"degenerate_faces", mesh.degenerate_faces},
        {"boundary_edges", mesh.boundary_edges},
        {"nonmanifold_edges", mesh.nonmanifold_edges},
        {"flipped_edges", mesh.flipped_edges},
        {"trees", nlohmann::ordered_json::array()},
    };
    if (!mesh.bounds.is_empty())
        json["bounds"] = {{"lo", as_array(mesh.bounds.lo)}, {"hi", as_array(mesh.bounds.hi)}};
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
    fmt::print("{}\n", json.dump(2));
}

void print_text(const MeshReport& mesh, const std::vector<TreeReport>& trees) {
    const Vec3d &lo = mesh.bounds.lo, &hi = mesh.bounds.hi;
    fmt::print("{:<18}{}\n{:<18}{}\n", "vertices", mesh.vertices, "faces", mesh.faces);
    if (!mesh.bounds.is_empty())
        fmt::print("{:<18}[{:.6g}, {:.6g}, {:.6g}] to [{:.6g}, {:.6g}, {:.6g}]\n", "bounds", lo.x(),
                   lo.y(), lo.z(), hi.x(), hi.y(), hi.z());
    fmt::print("{:<18}{}\n", "closed",
               mesh.closed ? "yes"
                           : fmt::format("no, {} boundary and {} non-manifold edges",
                                         mesh.boundary_edges, mesh.nonmanifold_edges));
    fmt::print("{:<18}{}\n{:<18}{}\n\n", "flipped edges", mesh.flipped_edges, "degenerate faces",
               mesh.degenerate_faces);
    fmt::print("{:<16}{:>12}{:>8}{:>12}{:>12}{:>14}\n", "builder", "nodes", "depth", "SAH cost",
               "build ms", "bytes");
    for (const TreeReport& tree : trees)
        fmt::print("{:<16}{:>12}{:>8}{:>12.1f}{:>12.1f}{:>14}\n", tree.builder,
                   tree.statistics.nodes, tree.statistics.depth, tree.statistics.sah_cost,
                   1e3 * tree.build_seconds, tree.statistics.bytes);
}

void run(const InfoArguments& arguments) {
    const TriangleMesh mesh = load_mesh(arguments.mesh);
    const MeshReport report = inspect(mesh);
    std::vector<TreeReport> trees;
    for (const std::string& builder : arguments.builders)
        trees.push_back(report_tree(mesh, builder, arguments.cost));
    (arguments.json ? print_json : print_text)(report, trees);
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
    command->add_flag("--json", arguments->json, "print JSON");
    command->footer("Example:\n  boxwood info dragon.off --accelerator median,binned_sah");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace boxwood::cli
