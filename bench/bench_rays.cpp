// SPDX-License-Identifier: Apache-2.0
// How many rays a second: Boxwood and the peers that are at hand, on the same rays in one process.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "meshes.h"
#include "options.h"
#include "peers/load_peers.h"
#include "ray_tables.h"
#include "views.h"

namespace boxwood::bench {

namespace {

std::vector<Contestant> contestants_for(RayKind kind, const Peer& peer, const Accelerator& tree,
                                        int threads) {
    std::vector<Contestant> result;
    for (const Mode mode : peer.modes()) {
        // Only a camera's rays are alike.
        if (mode == Mode::coherent16 && kind != RayKind::primary) continue;
        result.push_back({peer.library(), fmt::format("{} {}", peer.name(), name_of(mode)), &tree,
                          mode, threads});
    }
    // The goal names two threads against one.
    if (peer.library() == "boxwood" && threads == 1)
        result.push_back({peer.library(), "boxwood batch, two threads", &tree, Mode::batch, 2});
    return result;
}

std::vector<Score> measure(const BenchMesh& mesh, const Peers& peers, const CommonOptions& options,
                           int threads) {
    const std::vector<RaySet> sets = make_ray_sets(mesh, options.kinds(), options.rays);
    std::vector<std::unique_ptr<Accelerator>> trees;
    for (const auto& peer : peers) {
        trees.push_back(peer->make(kUntimedThreads));
        trees.back()->build(mesh.plain(), Quality::high);
    }
    std::vector<Score> scores;
    for (const RaySet& set : sets) {
        std::vector<Contestant> contestants;
        for (std::size_t i = 0; i < peers.size(); ++i)
            for (const auto& who : contestants_for(set.kind, *peers[i], *trees[i], threads))
                contestants.push_back(who);
        for (const Score& score : run_contest(mesh.name, set, contestants, options.passes))
            scores.push_back(score);
    }
    return scores;
}

int run(const CommonOptions& options, int threads) {
    const Peers peers = load_peers(options.libraries);
    std::vector<Score> all;
    for (const std::string& name : options.meshes.empty() ? default_meshes() : options.meshes) {
        const BenchMesh mesh = load_bench_mesh(name);
        fmt::print("{}: {} triangles\n", mesh.name, mesh.exact.faces.size());
        const std::vector<Score> scores = measure(mesh, peers, options, threads);
        print_scores(scores, options.kinds());
        fmt::print("\n");
        std::fflush(stdout);
        all.insert(all.end(), scores.begin(), scores.end());
    }
    print_means(all, options.kinds());
    fmt::print("\n");
    return finish(options, ray_targets(all), all, {{"scores", as_json(all)}});
}

}  // namespace

}  // namespace boxwood::bench

int main(int argc, char** argv) {
    CLI::App app("Rays a second, Boxwood and its peers", "bench_rays");
    boxwood::bench::CommonOptions options;
    int threads = 1;
    boxwood::bench::add_common_options(app, options);
    app.add_option("--threads", threads, "threads that trace")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    return boxwood::bench::run_benchmark(app, argc, argv,
                                         [&] { return boxwood::bench::run(options, threads); });
}
