// SPDX-License-Identifier: Apache-2.0
// How many rays a second: Boxwood and the peers that are at hand, on the same rays in one process.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "boxwood/core/error.h"
#include "meshes.h"
#include "peers/load_peers.h"
#include "ray_tables.h"
#include "views.h"

namespace boxwood::bench {

namespace {

struct Options {
    std::vector<std::string> meshes;
    std::vector<std::string> kinds = {"primary", "ao", "diffuse", "random"};
    std::vector<std::string> libraries;
    RayOptions rays;
    int passes = 5;
    int threads = 1;
    bool check = false;
    bool check_hits = false;
    std::string json;
};

std::vector<RayKind> chosen_kinds(const Options& options) {
    std::vector<RayKind> kinds;
    for (const RayKind kind : kRayKinds)
        if (std::find(options.kinds.begin(), options.kinds.end(), name_of(kind)) !=
            options.kinds.end())
            kinds.push_back(kind);
    return kinds;
}

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

std::vector<Score> measure(const BenchMesh& mesh, const Peers& peers, const Options& options) {
    std::vector<std::unique_ptr<Accelerator>> trees;
    std::vector<RaySet> sets;
    {
        const Scene scene({mesh.exact});
        sets = make_ray_sets(scene, views_of(mesh.name, bounds(mesh.exact)), chosen_kinds(options),
                             options.rays);
    }
    for (const auto& peer : peers) {
        trees.push_back(peer->make(1));
        trees.back()->build(mesh.plain(), Quality::high);
    }
    std::vector<Score> scores;
    for (const RaySet& set : sets) {
        if (set.rays.empty()) continue;
        std::vector<Contestant> contestants;
        for (std::size_t i = 0; i < peers.size(); ++i)
            for (const auto& who : contestants_for(set.kind, *peers[i], *trees[i], options.threads))
                contestants.push_back(who);
        for (const Score& score : run_contest(mesh.name, set, contestants, options.passes))
            scores.push_back(score);
    }
    return scores;
}

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

int run(Options options) {
    if (options.meshes.empty()) options.meshes = default_meshes();
    const Peers peers = load_peers(options.libraries);
    const std::vector<RayKind> kinds = chosen_kinds(options);
    std::vector<Score> all;
    for (const std::string& name : options.meshes) {
        const BenchMesh mesh = load_bench_mesh(name);
        fmt::print("{}: {} triangles\n", mesh.name, mesh.exact.faces.size());
        const std::vector<Score> scores = measure(mesh, peers, options);
        print_scores(scores, kinds);
        fmt::print("\n");
        std::fflush(stdout);
        all.insert(all.end(), scores.begin(), scores.end());
    }
    print_means(all, kinds);
    fmt::print("\n");
    const std::vector<Target> targets = ray_targets(all);
    print_targets(targets);

    nlohmann::ordered_json json = report(targets);
    json["scores"] = as_json(all);
    write_json(options.json, json);
    if (options.check_hits && !hits_agree(all)) return 1;
    return options.check && !all_met(targets) ? 1 : 0;
}

void add_options(CLI::App& app, Options& options) {
    app.add_option("MESH", options.meshes,
                   "OFF or OBJ files or shapes such as gyroid:100k; MESH@3 cuts each triangle into "
                   "3 * 3; without any, all there are");
    app.add_option("--kinds", options.kinds, "kinds of rays")
        ->delimiter(',')
        ->check(CLI::IsMember({"primary", "ao", "diffuse", "random"}))
        ->capture_default_str();
    app.add_option("--peers", options.libraries,
                   "libraries to compare with: embree3, embree4, tinybvh, cgal; without any, all "
                   "there are")
        ->delimiter(',');
    app.add_option("--rays", options.rays.count, "rays of each kind")
        ->check(CLI::Range(1, 100'000'000))
        ->capture_default_str();
    app.add_option("--tile", options.rays.tile,
                   "side of the tiles in which primary rays come, in pixels; 1: row by row")
        ->check(CLI::IsMember({1, 2, 4, 8, 16, 32, 64, 128, 256}))
        ->capture_default_str();
    app.add_option("--passes", options.passes, "passes to take the median of")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--threads", options.threads, "threads that trace")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    app.add_flag("--check", options.check, "exit with 1 when a target isn't reached");
    app.add_flag("--check-hits", options.check_hits,
                 "exit with 1 when somebody's hits differ from the exact ones");
    app.add_option("--json", options.json, "a file for all results");
}

}  // namespace

}  // namespace boxwood::bench

int main(int argc, char** argv) {
    CLI::App app("Rays a second, Boxwood and its peers");
    boxwood::bench::Options options;
    boxwood::bench::add_options(app, options);
    CLI11_PARSE(app, argc, argv);
    try {
        return boxwood::bench::run(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_rays: {}\n", error.what());
        return 1;
    }
}
