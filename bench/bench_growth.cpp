// SPDX-License-Identifier: Apache-2.0
// How the time of builds and of rays grows with the number of triangles.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "boxwood/core/parallel.h"
#include "boxwood/scene/scene.h"
#include "cli/arguments.h"
#include "growth_tables.h"
#include "options.h"

namespace boxwood::bench {

namespace {

constexpr RayKind kKinds[] = {RayKind::primary, RayKind::random};

struct GrowthOptions {
    std::vector<std::string> meshes = {"gyroid:1k",  "gyroid:3k",   "gyroid:10k",
                                       "gyroid:30k", "gyroid:100k", "gyroid:300k",
                                       "gyroid:1M",  "gyroid:3M",   "gyroid:10M"};
    std::vector<std::string> names = {"fast", "balanced", "best", "median", "agglomerative"};
    RayOptions rays = {.count = 262'144};
    int passes = 5;
    std::size_t most_quadratic = 50'000;
    bool check_hits = false;
    std::string json;
};

/// One builder or preset, with what it takes to measure it.
struct Entry {
    SceneOptions options;
    GrowthScore score;
    std::optional<Scene> scene = {};  ///< of a preset
    std::vector<double> build_seconds = {};

    bool is_preset() const { return !options.build; }
    bool is_quadratic() const {
        return options.build && options.build->method == BuildMethod::agglomerative;
    }
};

std::vector<Entry> entries_for(const BenchMesh& mesh, const GrowthOptions& options) {
    std::vector<Entry> entries;
    for (const std::string& name : options.names) {
        Entry entry = {
            .options = cli::Accelerator{.name = name}.scene_options(),
            .score = {.mesh = mesh.name, .triangles = mesh.exact.faces.size(), .name = name}};
        if (!entry.is_quadratic() || entry.score.triangles <= options.most_quadratic)
            entries.push_back(std::move(entry));
    }
    return entries;
}

/// A preset builds all that queries need; of the textbook's builders it is the tree that counts.
void time_build(const BenchMesh& mesh, Entry& entry) {
    entry.scene.reset();
    const double start = thread_seconds();
    if (entry.is_preset())
        entry.scene.emplace(std::vector<SceneMesh>{mesh.exact}, entry.options);
    else
        build_tree(mesh.exact, *entry.options.build);
    entry.build_seconds.push_back(thread_seconds() - start);
}

void time_rays(const std::vector<Ray>& rays, std::vector<Hit>& hits, const Entry& entry,
               std::vector<double>& seconds) {
    const double start = thread_seconds();
    entry.scene->closest_hits(rays, hits, {.on_this_thread = true});
    seconds.push_back((thread_seconds() - start) / static_cast<double>(rays.size()));
}

std::size_t count_wrong(const RaySet& set, const std::vector<Hit>& hits) {
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) wrong += hits[i].t != set.truth[i];
    return wrong;
}

void measure_builds(const BenchMesh& mesh, int passes, std::vector<Entry>& entries) {
    // Of what takes long, noise is a small part, and few passes will do.
    constexpr double kBudget = 3;
    for (int pass = 0; pass < passes; ++pass)
        for (Entry& entry : entries) {
            const std::vector<double>& before = entry.build_seconds;
            if (std::accumulate(before.begin(), before.end(), 0.0) < kBudget)
                time_build(mesh, entry);
        }
    for (Entry& entry : entries) entry.score.build_seconds = median(entry.build_seconds);
}

void measure_rays(const std::vector<RaySet>& sets, int passes, std::vector<Entry>& entries) {
    for (const RaySet& set : sets) {
        std::vector<Ray> rays;
        rays.reserve(set.rays.size());
        for (const PlainRay& ray : set.rays) rays.push_back(exact(ray));
        std::vector<Hit> hits(rays.size());
        std::vector<std::vector<double>> seconds(entries.size());
        for (int pass = 0; pass < passes; ++pass)
            for (std::size_t i = 0; i < entries.size(); ++i) {
                if (!entries[i].is_preset()) continue;
                time_rays(rays, hits, entries[i], seconds[i]);
                if (pass == 0) entries[i].score.wrong_hits += count_wrong(set, hits);
            }
        for (std::size_t i = 0; i < entries.size(); ++i)
            if (entries[i].is_preset())
                entries[i].score.seconds_per_ray.push_back(median(seconds[i]));
    }
}

std::vector<GrowthScore> measure(const BenchMesh& mesh, const GrowthOptions& options) {
    const std::vector<RaySet> sets =
        make_ray_sets(mesh, {std::begin(kKinds), std::end(kKinds)}, options.rays);
    const ThreadLimit one(1);
    std::vector<Entry> entries = entries_for(mesh, options);
    measure_builds(mesh, options.passes, entries);
    measure_rays(sets, options.passes, entries);
    std::vector<GrowthScore> scores;
    scores.reserve(entries.size());
    for (Entry& entry : entries) scores.push_back(std::move(entry.score));
    return scores;
}

int run(const GrowthOptions& options) {
    std::vector<std::string> kinds;
    for (const RayKind kind : kKinds) kinds.emplace_back(name_of(kind));
    std::vector<GrowthScore> all;
    std::size_t wrong = 0;
    for (const std::string& name : options.meshes) {
        const BenchMesh mesh = load_bench_mesh(name);
        fmt::print("{}: {} triangles\n", mesh.name, mesh.exact.faces.size());
        const std::vector<GrowthScore> scores = measure(mesh, options);
        print_growth(scores, kinds);
        fmt::print("\n");
        std::fflush(stdout);
        for (const GrowthScore& score : scores) wrong += score.wrong_hits;
        all.insert(all.end(), scores.begin(), scores.end());
    }
    print_fits(all, kinds);
    nlohmann::ordered_json json = report({});
    json.update(as_json(all, kinds));
    write_json(options.json, json);
    if (wrong > 0) fmt::print("{} hits aren't the exact ones\n", wrong);
    return options.check_hits && wrong > 0 ? 1 : 0;
}

}  // namespace

}  // namespace boxwood::bench

int main(int argc, char** argv) {
    namespace bench = boxwood::bench;
    namespace cli = boxwood::cli;
    CLI::App app("How builds and rays grow with the triangles, on one thread", "bench_growth");
    bench::GrowthOptions options;
    std::vector<std::string> names = cli::names(boxwood::build_presets());
    for (const std::string& name : cli::names(boxwood::build_methods())) names.push_back(name);
    app.add_option("MESH", options.meshes, "the same shape in several sizes")
        ->capture_default_str();
    app.add_option("--accelerator", options.names,
                   "presets, of which rays are timed too, and builders")
        ->check(CLI::IsMember(names))
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--most-quadratic", options.most_quadratic,
                   "triangles up to which agglomerative takes part")
        ->capture_default_str();
    bench::add_rays_option(app, options.rays);
    bench::add_passes_option(app, options.passes);
    app.add_flag("--check-hits", options.check_hits, "exit with 1 when a hit isn't the exact one");
    bench::add_json_option(app, options.json);
    return bench::run_benchmark(app, argc, argv, [&] { return bench::run(options); });
}
