// SPDX-License-Identifier: Apache-2.0
// How many points a second: the nearest place on a mesh and the signed distance, Boxwood and the
// peers that know them, on the same points in one process.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "boxwood/core/random.h"
#include "contest.h"
#include "meshes.h"
#include "options.h"
#include "peers/load_peers.h"

namespace boxwood::bench {

namespace {

struct QueryOptions {
    std::vector<std::string> meshes, libraries;
    std::size_t points = 1'000'000;
    int passes = 3;
    bool check = false, check_answers = false;
    std::string json;
};

struct Question {
    const char* name;
    bool signs;
    bool near_surface;
};
constexpr Question kQuestions[] = {{"closest point", false, false},
                                   {"closest point, near the surface", false, true},
                                   {"signed distance", true, false}};
constexpr double kTarget = 5;

struct Contender {
    std::string library, name;
    Accelerator* tree;
    Mode mode;
    int threads;
    std::vector<double> seconds = {};
};

struct QueryScore {
    std::string mesh, question, library, name;
    int threads;
    double mpoints;  ///< million points a second: the median of the passes
    std::size_t wrong;
};

/// In the bounds made half as large again, in no order; or off a random place of the mesh by up to
/// a hundredth of its size.
std::vector<PlainPoint> make_points(const BenchMesh& mesh, std::size_t count, bool near_surface) {
    const MeshView view = mesh.exact;
    const Box3d box = bounds(view);
    const Vec3d center = box.centroid(), half = 0.75 * box.extent();
    std::vector<PlainPoint> points(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = [&](std::uint32_t dimension) { return uniform(1, i, dimension); };
        const Vec3d spread = 2 * Vec3d(number(0), number(1), number(2)) - Vec3d::Ones();
        Vec3d point = center + half.cwiseProduct(spread);
        if (near_surface) {
            const auto face =
                static_cast<std::size_t>(number(3) * static_cast<double>(view.faces.size()));
            point = view.corner(face, 0) + 0.01 * box.extent().maxCoeff() * spread;
        }
        points[i] = {point.x(), point.y(), point.z()};
    }
    return points;
}

/// One, and all that there are.
std::vector<int> thread_counts() {
    const int all = static_cast<int>(std::thread::hardware_concurrency());
    return all > 1 ? std::vector<int>{1, all} : std::vector<int>{1};
}

std::vector<Contender> contenders_for(const Peers& peers,
                                      const std::vector<std::unique_ptr<Accelerator>>& trees) {
    std::vector<Contender> result;
    for (std::size_t i = 0; i < peers.size(); ++i) {
        if (!trees[i]->tells_distances()) continue;
        for (const Mode mode : peers[i]->modes()) {
            const std::string name = fmt::format("{} {}", peers[i]->name(), name_of(mode));
            for (const int threads : thread_counts())
                result.push_back({peers[i]->library(), name, trees[i].get(), mode, threads});
        }
    }
    return result;
}

/// Points whose distance isn't what Boxwood finds for single points.
std::size_t count_wrong(const std::vector<PlainNearest>& truth,
                        const std::vector<PlainNearest>& answers, double size) {
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        wrong += !(std::abs(answers[i].distance - truth[i].distance) <= 1e-9 * size);
    return wrong;
}

std::vector<QueryScore> measure(const BenchMesh& mesh, const Peers& peers,
                                const QueryOptions& options) {
    std::vector<std::unique_ptr<Accelerator>> trees;
    for (const auto& peer : peers) {
        trees.push_back(peer->make(1));
        trees.back()->build(mesh.plain(), Quality::medium);
    }
    const double size = bounds(mesh.exact).extent().maxCoeff();
    std::vector<QueryScore> scores;
    for (const Question& question : kQuestions) {
        const std::vector<PlainPoint> points =
            make_points(mesh, options.points, question.near_surface);
        std::vector<Contender> contenders = contenders_for(peers, trees);
        std::vector<PlainNearest> truth(points.size()), answers(points.size());
        std::vector<std::size_t> wrong(contenders.size());
        // A small pass warms up and checks.
        const auto some = std::span(points).first(std::min<std::size_t>(points.size(), 20'000));
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            auto& into = i == 0 ? truth : answers;
            contenders[i].tree->nearest(contenders[i].mode, question.signs, some, into.data());
            if (i > 0) wrong[i] = count_wrong(truth, answers, size);
        }
        for (int pass = 0; pass < options.passes; ++pass) {
            for (Contender& who : contenders) {
                const auto ask = [&](std::size_t begin, std::size_t end) {
                    who.tree->nearest(who.mode, question.signs,
                                      std::span(points).subspan(begin, end - begin),
                                      answers.data() + begin);
                };
                who.seconds.push_back(seconds_of(who.threads, points.size(), ask));
            }
        }
        for (std::size_t i = 0; i < contenders.size(); ++i)
            scores.push_back(
                {mesh.name, question.name, contenders[i].library, contenders[i].name,
                 contenders[i].threads,
                 1e-6 * static_cast<double>(points.size()) / median(contenders[i].seconds),
                 wrong[i]});
    }
    return scores;
}

double best(const std::vector<QueryScore>& scores, const std::string& mesh,
            const std::string& question, int threads, bool ours) {
    double result = 0;
    for (const QueryScore& score : scores)
        if (score.mesh == mesh && score.question == question && score.threads == threads &&
            (score.library == "boxwood") == ours)
            result = std::max(result, score.mpoints);
    return result;
}

std::vector<Target> targets_of(const std::vector<QueryScore>& scores) {
    std::vector<Target> targets;
    for (const Question& question : kQuestions) {
        for (const int threads : thread_counts()) {
            std::vector<std::pair<std::string, double>> ratios;
            for (const QueryScore& score : scores) {
                const bool is_new = ratios.empty() || ratios.back().first != score.mesh;
                const double theirs = best(scores, score.mesh, question.name, threads, false);
                const double ours = best(scores, score.mesh, question.name, threads, true);
                if (is_new && theirs > 0) ratios.emplace_back(score.mesh, ours / theirs);
            }
            const auto name =
                fmt::format("{}, {}", question.name, threads == 1 ? "one thread" : "all threads");
            if (!ratios.empty()) targets.push_back(over_meshes(name, kTarget, kTarget, ratios));
        }
    }
    return targets;
}

std::vector<std::string> meshes_for(const QueryOptions& options) {
    if (!options.meshes.empty()) return options.meshes;
    std::vector<std::string> result;
    for (const std::string& mesh : default_meshes())
        if (mesh.find("dragon") != std::string::npos && mesh.find('@') == std::string::npos)
            result.push_back(mesh);
    if (result.empty()) result.emplace_back("gyroid:200k");
    return result;
}

int run(const QueryOptions& options) {
    const Peers peers = load_peers(options.libraries);
    std::vector<QueryScore> all;
    bool right = true;
    for (const std::string& name : meshes_for(options)) {
        const BenchMesh mesh = load_bench_mesh(name);
        fmt::print("{}: {} triangles, million points a second\n", mesh.name,
                   mesh.exact.faces.size());
        for (const QueryScore& score : measure(mesh, peers, options)) {
            fmt::print("  {:<32}{:<24}{:>2} threads{:8.3f}  wrong: {}\n", score.question,
                       score.name, score.threads, score.mpoints, score.wrong);
            right = right && (score.wrong == 0 || score.library != "boxwood");
            all.push_back(score);
        }
        std::fflush(stdout);
    }
    const std::vector<Target> targets = targets_of(all);
    print_targets(targets);
    nlohmann::ordered_json json = report(targets);
    for (const QueryScore& score : all)
        json["scores"].push_back({{"mesh", score.mesh},
                                  {"question", score.question},
                                  {"library", score.library},
                                  {"name", score.name},
                                  {"threads", score.threads},
                                  {"points", options.points},
                                  {"mpoints_per_second", score.mpoints},
                                  {"wrong", score.wrong}});
    write_json(options.json, json);
    return (options.check && !all_met(targets)) || (options.check_answers && !right) ? 1 : 0;
}

}  // namespace

}  // namespace boxwood::bench

int main(int argc, char** argv) {
    CLI::App app("Points a second, Boxwood and its peers", "bench_queries");
    boxwood::bench::QueryOptions options;
    app.add_option("MESH", options.meshes,
                   "OFF or OBJ files or shapes such as gyroid:100k; without any, the dragons");
    app.add_option("--peers", options.libraries, "libraries to compare with")->delimiter(',');
    app.add_option("--points", options.points, "points of each kind")
        ->check(CLI::Range(1, 100'000'000))
        ->capture_default_str();
    boxwood::bench::add_passes_option(app, options.passes);
    boxwood::bench::add_check_option(app, options.check);
    app.add_flag("--check-answers", options.check_answers,
                 "exit with 1 when Boxwood's ways of asking differ");
    boxwood::bench::add_json_option(app, options.json);
    return boxwood::bench::run_benchmark(app, argc, argv,
                                         [&] { return boxwood::bench::run(options); });
}
