// SPDX-License-Identifier: Apache-2.0
#include "options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace boxwood::bench {

namespace {

/// Whether all agree with the exact answers, but for a ray in ten thousand that grazes an edge.
bool hits_agree(const std::vector<Score>& scores) {
    bool agree = true;
    for (const Score& score : scores) {
        if (score.wrong_hits + score.wrong_t <= 1 + score.rays / 10'000) continue;
        agree = false;
        fmt::print("{}, {}, {}: {} wrong hits and {} wrong t of {} rays\n", score.mesh, score.name,
                   name_of(score.kind), score.wrong_hits, score.wrong_t, score.rays);
    }
    return agree;
}

}  // namespace

std::vector<RayKind> CommonOptions::kinds() const {
    std::vector<RayKind> result;
    for (const RayKind kind : kRayKinds)
        if (std::find(kind_names.begin(), kind_names.end(), name_of(kind)) != kind_names.end())
            result.push_back(kind);
    return result;
}

void add_common_options(CLI::App& app, CommonOptions& options) {
    app.add_option("MESH", options.meshes,
                   "OFF or OBJ files or shapes such as gyroid:100k; MESH@3 cuts each triangle into "
                   "3 * 3; without any, all there are");
    app.add_option("--peers", options.libraries,
                   "libraries to compare with: embree3, embree4, tinybvh, cgal; without any, all "
                   "there are")
        ->delimiter(',');
    app.add_option("--kinds", options.kind_names, "kinds of rays")
        ->delimiter(',')
        ->check(CLI::IsMember({"primary", "ao", "diffuse", "random"}))
        ->capture_default_str();
    add_rays_option(app, options.rays);
    app.add_option("--tile", options.rays.tile,
                   "side of the tiles in which primary rays come, in pixels; 1: row by row")
        ->check(CLI::IsMember({1, 2, 4, 8, 16, 32, 64, 128, 256}))
        ->capture_default_str();
    add_passes_option(app, options.passes);
    add_check_option(app, options.check);
    app.add_flag("--check-hits", options.check_hits,
                 "exit with 1 when somebody's hits differ from the exact ones");
    add_json_option(app, options.json);
}

void add_rays_option(CLI::App& app, RayOptions& options) {
    app.add_option("--rays", options.count, "rays of each kind")
        ->check(CLI::Range(1, 100'000'000))
        ->capture_default_str();
}

void add_passes_option(CLI::App& app, int& passes) {
    app.add_option("--passes", passes, "passes to take the median of")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
}

void add_check_option(CLI::App& app, bool& check) {
    app.add_flag("--check", check, "exit with 1 when a target isn't reached");
}

void add_json_option(CLI::App& app, std::string& file) {
    app.add_option("--json", file, "a file for all results");
}

int finish(const CommonOptions& options, const std::vector<Target>& targets,
           const std::vector<Score>& scores, const nlohmann::ordered_json& details) {
    print_targets(targets);
    nlohmann::ordered_json json = report(targets);
    json.update(details);
    write_json(options.json, json);
    const bool failed =
        (options.check && !all_met(targets)) || (options.check_hits && !hits_agree(scores));
    return failed ? 1 : 0;
}

int run_benchmark(CLI::App& app, int argc, char** argv, const std::function<int()>& run) {
    CLI11_PARSE(app, argc, argv);
    try {
        return run();
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}: {}\n", app.get_name(), error.what());
        return 1;
    }
}

}  // namespace boxwood::bench
