// SPDX-License-Identifier: Apache-2.0
// How long trees take to build and how much memory they hold, and how fast rays go through them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "build_tables.h"
#include "cli/stopwatch.h"
#include "meshes.h"
#include "options.h"
#include "peers/load_peers.h"
#include "ray_tables.h"

namespace boxwood::bench {

namespace {

/// One line of the table, with what it takes to measure it.
struct Entry {
    const Peer* peer;
    BuildScore score;
    std::vector<double> seconds[2] = {};
};

std::vector<Entry> entries_for(const BenchMesh& mesh, const Peers& peers) {
    std::vector<Entry> entries;
    for (const auto& peer : peers)
        for (const Quality quality : peer->qualities()) {
            BuildScore score;
            score.mesh = mesh.name;
            score.triangles = mesh.exact.faces.size();
            score.library = peer->library();
            score.name = fmt::format("{} {}", peer->name(), name_of(quality));
            score.quality = quality;
            entries.push_back({peer.get(), score});
        }
    return entries;
}

/// One thread is timed by its processor time, two by the clock. Only this tree is there meanwhile:
/// Embree's devices share threads.
void time_build(const BenchMesh& mesh, int threads, Entry& entry) {
    const auto tree = entry.peer->make(threads);
    const double start = thread_seconds();
    cli::Stopwatch stopwatch;
    tree->build(mesh.plain(), entry.score.quality);
    const double by_clock = stopwatch.lap(), by_processor = thread_seconds() - start;
    entry.seconds[threads - 1].push_back(threads == 1 ? by_processor : by_clock);
    entry.score.bytes_a_triangle =
        static_cast<double>(tree->bytes()) / static_cast<double>(entry.score.triangles);
}

/// Single rays of all kinds through all trees; they stand side by side, so that passes interleave.
std::vector<Score> trace(const BenchMesh& mesh, const CommonOptions& options,
                         std::vector<Entry>& entries) {
    const std::vector<RaySet> sets = make_ray_sets(mesh, options.kinds(), options.rays);
    std::vector<std::unique_ptr<Accelerator>> trees;
    std::vector<Contestant> contestants;
    for (const Entry& entry : entries) {
        trees.push_back(entry.peer->make(kUntimedThreads));
        trees.back()->build(mesh.plain(), entry.score.quality);
        contestants.push_back({entry.score.library, entry.score.name, trees.back().get()});
    }
    std::vector<Score> scores;
    std::vector<std::vector<double>> mrays(entries.size());
    for (const RaySet& set : sets) {
        const std::vector<Score> of_kind = run_contest(mesh.name, set, contestants, options.passes);
        for (std::size_t i = 0; i < entries.size(); ++i) mrays[i].push_back(of_kind[i].mrays);
        scores.insert(scores.end(), of_kind.begin(), of_kind.end());
    }
    for (std::size_t i = 0; i < entries.size(); ++i)
        entries[i].score.mrays = geometric_mean(mrays[i]);
    return scores;
}

int run(const CommonOptions& options) {
    const Peers peers = load_peers(options.libraries);
    std::vector<BuildScore> builds;
    std::vector<Score> scores;
    for (const std::string& name : options.meshes.empty() ? default_meshes() : options.meshes) {
        const BenchMesh mesh = load_bench_mesh(name);
        fmt::print("{}: {} triangles\n", mesh.name, mesh.exact.faces.size());
        std::vector<Entry> entries = entries_for(mesh, peers);
        for (int pass = 0; pass < options.passes; ++pass)
            for (const int threads : {1, 2})
                for (Entry& entry : entries) time_build(mesh, threads, entry);
        const std::vector<Score> of_mesh = trace(mesh, options, entries);
        scores.insert(scores.end(), of_mesh.begin(), of_mesh.end());

        std::vector<BuildScore> rows;
        for (Entry& entry : entries) {
            entry.score.one_thread = median(entry.seconds[0]);
            entry.score.two_threads = median(entry.seconds[1]);
            rows.push_back(entry.score);
        }
        print_builds(rows);
        fmt::print("\n");
        std::fflush(stdout);
        builds.insert(builds.end(), rows.begin(), rows.end());
    }
    return finish(options, build_targets(builds), scores,
                  {{"builds", as_json(builds)}, {"scores", as_json(scores)}});
}

}  // namespace

}  // namespace boxwood::bench

int main(int argc, char** argv) {
    CLI::App app("Builds, Boxwood and its peers", "bench_build");
    boxwood::bench::CommonOptions options;
    options.rays.count = 131'072;
    boxwood::bench::add_common_options(app, options);
    return boxwood::bench::run_benchmark(app, argc, argv,
                                         [&] { return boxwood::bench::run(options); });
}
