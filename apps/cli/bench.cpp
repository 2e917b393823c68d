// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "boxwood/core/parallel.h"
#include "cli/arguments.h"
#include "cli/bench_counters.h"
#include "cli/bench_rays.h"
#include "cli/commands.h"
#include "cli/stopwatch.h"

namespace boxwood::cli {

namespace {

struct BenchArguments {
    std::vector<std::string> meshes;
    std::vector<std::string> builders = {"median", "binned_sah", "balanced"};
    std::string cost = "surface_area";
    std::size_t rays = 100'000;
    bool counters = false;
    bool json = false;
};

/// One line of the table; seconds are those of one ray, on one core.
struct Row {
    std::string accelerator;
    double build_seconds = 0;
    std::size_t bytes = 0;
    std::vector<double> seconds = {};  ///< by ray set
};

/// The least time of three passes over the rays, or over as many as half a second allows.
double seconds_per_ray(const Scene& scene, const RaySet& set) {
    constexpr int kPasses = 3;
    constexpr double kBudget = 0.5;
    constexpr std::size_t kBetweenLooks = 16;
    double best = std::numeric_limits<double>::infinity();
    std::size_t most = set.rays.size();
    volatile bool sink = false;
    for (int pass = 0; pass < kPasses; ++pass) {
        Stopwatch stopwatch;
        double seconds = 0;
        std::size_t done = 0;
        // A stride spreads a part of the rays over all of the picture.
        const std::size_t stride = set.rays.size() / std::max<std::size_t>(most, 1);
        while (done < most) {
            const Ray& ray = set.rays[done * stride];
            sink = set.any_hit ? scene.any_hit(ray) : scene.closest_hit(ray).has_value();
            if (++done % kBetweenLooks != 1) continue;
            seconds += stopwatch.lap();
            if (seconds > kBudget) break;
        }
        seconds += stopwatch.lap();
        best = std::min(best, seconds / static_cast<double>(std::max<std::size_t>(done, 1)));
        most = std::max<std::size_t>(done, 1);
    }
    static_cast<void>(sink);
    return best;
}

Row measure(const std::string& name, const Scene& scene, double build_seconds,
            const std::vector<RaySet>& sets) {
    Row row = {.accelerator = name, .build_seconds = build_seconds};
    for (const WideTree& tree : scene.wide_trees()) row.bytes += tree.bytes();
    for (const RaySet& set : sets) row.seconds.push_back(seconds_per_ray(scene, set));
    return row;
}

void print_text(const std::string& mesh, std::size_t triangles, const std::vector<RaySet>& sets,
                const std::vector<Row>& rows) {
    fmt::print("{}: {} triangles; all on one core; microseconds a ray, and times brute force\n",
               mesh, triangles);
    fmt::print("{:<16}{:>10}{:>9}", "", "build ms", "MB");
    for (const RaySet& set : sets) fmt::print("{:>22}", set.name);
    fmt::print("\n");
    for (const Row& row : rows) {
        fmt::print("{:<16}{:>10.1f}{:>9.2f}", row.accelerator, 1e3 * row.build_seconds,
                   1e-6 * static_cast<double>(row.bytes));
        for (std::size_t i = 0; i < sets.size(); ++i)
            fmt::print("{:>12.3f}{:>9.0f}x", 1e6 * row.seconds[i],
                       rows[0].seconds[i] / row.seconds[i]);
        fmt::print("\n");
    }
    fmt::print("\n");
}

nlohmann::ordered_json as_json(const std::string& mesh, std::size_t triangles,
                               const std::vector<RaySet>& sets, const std::vector<Row>& rows) {
    nlohmann::ordered_json json = {{"mesh", mesh},
                                   {"triangles", triangles},
                                   {"accelerators", nlohmann::ordered_json::array()}};
    for (const Row& row : rows) {
        nlohmann::ordered_json rays;
        for (std::size_t i = 0; i < sets.size(); ++i)
            rays[std::string(sets[i].name)] = {
                {"seconds_per_ray", row.seconds[i]},
                {"times_brute_force", rows[0].seconds[i] / row.seconds[i]}};
        json["accelerators"].push_back({{"name", row.accelerator},
                                        {"build_seconds", row.build_seconds},
                                        {"bytes", row.bytes},
                                        {"rays", rays}});
    }
    return json;
}

/// The options of an accelerator, with a warning where its build takes long.
SceneOptions announced(const std::string& builder, const BenchArguments& arguments,
                       const TriangleMesh& mesh) {
    const SceneOptions options = Accelerator{builder, arguments.cost}.scene_options();
    if (const auto warning = slow_build_warning(mesh.faces.size(), options))
        fmt::print(stderr, "boxwood: warning: {}\n", *warning);
    return options;
}

/// Prints a table; or returns JSON, if that is asked for.
nlohmann::ordered_json time_rays(const BenchArguments& arguments, const std::string& name,
                                 const TriangleMesh& mesh, const std::vector<RaySet>& sets) {
    const ThreadLimit one_core(1);
    std::vector<Row> rows = {measure("brute", Scene({mesh}, {.brute_force = true}), 0, sets)};
    for (const std::string& builder : arguments.builders) {
        const SceneOptions options = announced(builder, arguments, mesh);
        Stopwatch stopwatch;
        const Scene scene({mesh}, options);
        rows.push_back(measure(builder, scene, stopwatch.lap(), sets));
    }
    if (arguments.json) return as_json(name, mesh.faces.size(), sets, rows);
    print_text(name, mesh.faces.size(), sets, rows);
    return {};
}

/// Likewise.
nlohmann::ordered_json count_rays(const BenchArguments& arguments, const std::string& name,
                                  const TriangleMesh& mesh, const std::vector<RaySet>& sets) {
    std::vector<CounterRow> rows;
    for (const std::string& builder : arguments.builders)
        rows.push_back(
            count_visits(builder, Scene({mesh}, announced(builder, arguments, mesh)), sets));
    if (arguments.json) return counters_as_json(name, mesh.faces.size(), rows);
    print_counters(name, mesh.faces.size(), rows);
    return {};
}

void run(const BenchArguments& arguments) {
    const std::vector<std::string>& builders = arguments.builders;
    if (arguments.counters && std::count(builders.begin(), builders.end(), "brute") > 0)
        throw CLI::ValidationError("--counters", "brute force has no tree to visit");
    nlohmann::ordered_json results = nlohmann::ordered_json::array();
    for (const std::string& name : arguments.meshes) {
        const TriangleMesh mesh = load_mesh(name);
        const std::vector<RaySet> sets = make_ray_sets(Scene({mesh}), arguments.rays);
        results.push_back(
            (arguments.counters ? count_rays : time_rays)(arguments, name, mesh, sets));
    }
    if (arguments.json) fmt::print("{}\n", results.dump(2));
}

}  // namespace

void add_bench(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("bench", "Time builders and rays, with brute force for scale");
    auto arguments = std::make_shared<BenchArguments>();
    command->add_option("MESH", arguments->meshes, mesh_argument_help())->required();
    command->add_option("--accelerator", arguments->builders, "presets and builders to time")
        ->check(CLI::IsMember(accelerator_names()))
        ->delimiter(',')
        ->capture_default_str();
    add_cost(*command, arguments->cost);
    command->add_option("--rays", arguments->rays, "rays of each kind")
        ->check(CLI::Range(1, 100'000'000))
        ->capture_default_str();
    command->add_flag("--counters", arguments->counters,
                      "print what a ray in float visits on average in place of times");
    command->add_flag("--json", arguments->json, "print JSON");
    command->footer(
        "Example:\n  boxwood bench gyroid:1k gyroid:10k gyroid:100k gyroid:1M\n"
        "  boxwood bench gyroid:100k --counters --accelerator fast,balanced,best");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace boxwood::cli
