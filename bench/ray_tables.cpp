// SPDX-License-Identifier: Apache-2.0
#include "ray_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

namespace boxwood::bench {

namespace {

using Question = std::function<bool(const Score&)>;

/// The most million rays a second among those; 0 when there are none.
double best(const std::vector<Score>& scores, const Question& counts) {
    double result = 0;
    for (const Score& score : scores)
        if (counts(score)) result = std::max(result, score.mrays);
    return result;
}

Question is_embree(const std::string& mesh, RayKind kind, const std::vector<Mode>& modes) {
    return [=](const Score& score) {
        return score.library.starts_with("embree") && score.mesh == mesh && score.kind == kind &&
               score.threads == 1 &&
               std::find(modes.begin(), modes.end(), score.mode) != modes.end();
    };
}

Question is_boxwood(const std::string& mesh, RayKind kind, Mode mode, int threads) {
    return [=](const Score& score) {
        return score.library == "boxwood" && score.mesh == mesh && score.kind == kind &&
               score.mode == mode && score.threads == threads;
    };
}

template <class Value, class Of>
std::vector<Value> distinct(const std::vector<Score>& scores, const Of& of) {
    std::vector<Value> result;
    for (const Score& score : scores)
        if (std::find(result.begin(), result.end(), of(score)) == result.end())
            result.push_back(of(score));
    return result;
}

std::vector<std::string> meshes_of(const std::vector<Score>& scores) {
    return distinct<std::string>(scores, [](const Score& score) { return score.mesh; });
}

std::vector<std::string> names_of(const std::vector<Score>& scores) {
    return distinct<std::string>(scores, [](const Score& score) { return score.name; });
}

/// To Embree's single rays, over all meshes; 0 when that can't be told.
double mean_ratio(const std::vector<Score>& scores, const std::string& name, RayKind kind) {
    std::vector<double> ratios;
    for (const std::string& mesh : meshes_of(scores)) {
        const double one = best(scores, is_embree(mesh, kind, {Mode::single}));
        const double mrays = best(scores, [&](const Score& score) {
            return score.name == name && score.mesh == mesh && score.kind == kind;
        });
        if (one > 0 && mrays > 0) ratios.push_back(mrays / one);
    }
    return geometric_mean(ratios);
}

void print_head(const std::string& title, const std::vector<RayKind>& kinds) {
    fmt::print("{:<38}", title);
    for (const RayKind kind : kinds) fmt::print("{:>20}", name_of(kind));
    fmt::print("\n");
}

/// One of the columns that the project's goal names.
struct Column {
    std::string name;
    RayKind kind;
    Mode ours;
    std::vector<Mode> embrees;
    double with_avx512, with_avx2;
};

const std::vector<Column>& columns() {
    const std::vector<Mode> single = {Mode::single},
                            any = {Mode::single, Mode::packet8, Mode::packet16};
    static const std::vector<Column> kColumns = {
        {"single, primary", RayKind::primary, Mode::single, single, 1.5, 1.2},
        {"single, ao", RayKind::ao, Mode::single, single, 1.6, 1.25},
        {"single, diffuse", RayKind::diffuse, Mode::single, single, 1.4, 1.1},
        {"single, random", RayKind::random, Mode::single, single, 1.25, 1.1},
        {"batch, primary", RayKind::primary, Mode::batch, {Mode::coherent16}, 2.2, 1.2},
        {"batch, ao", RayKind::ao, Mode::batch, any, 1.3, 1.0},
        {"batch, diffuse", RayKind::diffuse, Mode::batch, any, 1.6, 1.2},
        {"batch, random", RayKind::random, Mode::batch, any, 1.6, 1.2}};
    return kColumns;
}

using Ratios = std::vector<std::pair<std::string, double>>;

void add_ratio(const std::string& mesh, double ours, double theirs, Ratios& ratios) {
    if (ours > 0 && theirs > 0) ratios.emplace_back(mesh, ours / theirs);
}

}  // namespace

void print_scores(const std::vector<Score>& scores, const std::vector<RayKind>& kinds) {
    print_head("  Mrays/s, times Embree's single rays", kinds);
    for (const std::string& name : names_of(scores)) {
        fmt::print("  {:<36}", name);
        std::size_t wrong_hits = 0, wrong_t = 0;
        for (const RayKind kind : kinds) {
            const auto score =
                std::find_if(scores.begin(), scores.end(), [&](const Score& candidate) {
                    return candidate.name == name && candidate.kind == kind;
                });
            if (score == scores.end()) {
                fmt::print("{:>20}", "");
                continue;
            }
            fmt::print("{:>12.2f}{:>8.2f}", score->mrays, mean_ratio(scores, name, kind));
            wrong_hits += score->wrong_hits;
            wrong_t += score->wrong_t;
        }
        fmt::print("  wrong: {} hits, {} t\n", wrong_hits, wrong_t);
    }
}

void print_means(const std::vector<Score>& scores, const std::vector<RayKind>& kinds) {
    print_head("Geometric mean over meshes", kinds);
    for (const std::string& name : names_of(scores)) {
        fmt::print("  {:<36}", name);
        for (const RayKind kind : kinds) {
            const double ratio = mean_ratio(scores, name, kind);
            fmt::print("{:>20}", ratio > 0 ? fmt::format("{:.2f}", ratio) : "");
        }
        fmt::print("\n");
    }
}

std::vector<Target> ray_targets(const std::vector<Score>& scores) {
    constexpr double kWorstAllowed = 0.95;
    std::vector<Target> targets;
    const std::vector<std::string> meshes = meshes_of(scores);
    for (const Column& column : columns()) {
        Ratios ratios;
        for (const std::string& mesh : meshes)
            add_ratio(mesh, best(scores, is_boxwood(mesh, column.kind, column.ours, 1)),
                      best(scores, is_embree(mesh, column.kind, column.embrees)), ratios);
        if (!ratios.empty())
            targets.push_back(over_meshes(column.name,
                                          has_avx512() ? column.with_avx512 : column.with_avx2,
                                          kWorstAllowed, ratios));
    }
    Ratios two_threads;
    for (const std::string& mesh : meshes)
        for (const RayKind kind : kRayKinds)
            add_ratio(fmt::format("{} {}", mesh, name_of(kind)),
                      best(scores, is_boxwood(mesh, kind, Mode::batch, 2)),
                      best(scores, is_boxwood(mesh, kind, Mode::batch, 1)), two_threads);
    if (!two_threads.empty())
        targets.push_back(over_meshes("batch, two threads to one", 1.9, 0, two_threads));
    return targets;
}

nlohmann::ordered_json as_json(const std::vector<Score>& scores) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const Score& score : scores)
        json.push_back({{"mesh", score.mesh},
                        {"kind", name_of(score.kind)},
                        {"library", score.library},
                        {"name", score.name},
                        {"mode", name_of(score.mode)},
                        {"threads", score.threads},
                        {"rays", score.rays},
                        {"mrays_per_second", score.mrays},
                        {"wrong_hits", score.wrong_hits},
                        {"wrong_t", score.wrong_t}});
    return json;
}

}  // namespace boxwood::bench
