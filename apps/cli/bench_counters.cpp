// SPDX-License-Identifier: Apache-2.0
#include "cli/bench_counters.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "boxwood/query/wide_hits.h"

namespace boxwood::cli {

namespace {

constexpr double kOffSurface = 1e-4;

Rayf in_float(const Ray& ray) {
    Rayf result;
    for (int k = 0; k < 3; ++k) {
        result.origin[k] = static_cast<float>(ray.origin[k]);
        result.direction[k] = static_cast<float>(ray.direction[k]);
    }
    const bool skips = ray.skip != TriangleId{};
    result.t_min = static_cast<float>(skips ? kOffSurface * ray.t_max : ray.t_min);
    result.t_max = static_cast<float>(ray.t_max);
    return result;
}

struct Column {
    const char* title;
    std::uint64_t WideCounts::*value;
};
constexpr Column kColumns[] = {{"nodes", &WideCounts::nodes},
                               {"boxes", &WideCounts::boxes},
                               {"blocks", &WideCounts::blocks},
                               {"triangles", &WideCounts::triangles},
                               {"lines", &WideCounts::lines}};

struct Query {
    const char* title;
    const char* key;  ///< in JSON
    WideCounts RayCounts::*counts;
};
constexpr Query kQueries[] = {{"closest hit", "closest_hit", &RayCounts::closest_hit},
                              {"any hit", "any_hit", &RayCounts::any_hit}};

double per_ray(const RayCounts& kind, const Query& query, const Column& column) {
    return static_cast<double>(kind.*query.counts.*column.value) /
           static_cast<double>(std::max<std::size_t>(kind.count, 1));
}

}  // namespace

CounterRow count_visits(const std::string& accelerator, const Scene& scene,
                        const std::vector<RaySet>& sets) {
    CounterRow row = {accelerator, {}};
    for (const RaySet& set : sets) {
        RayCounts kind = {set.name, set.rays.size(), {}, {}};
        for (const Ray& ray : set.rays) {
            const Rayf rayf = in_float(ray);
            for (const WideTree& tree : scene.wide_trees()) {
                Hitf hit;
                closest_hit(tree, rayf, hit, kind.closest_hit);
                any_hit(tree, rayf, kind.any_hit);
            }
        }
        row.kinds.push_back(kind);
    }
    return row;
}

void print_counters(const std::string& mesh, std::size_t triangles,
                    const std::vector<CounterRow>& rows) {
    fmt::print("{}: {} triangles; visits a ray in float, {} boxes a node; lines of 64 bytes\n",
               mesh, triangles, lanes(preferred_instruction_set()));
    fmt::print("{:<16}{:<19}{:<12}", "", "", "");
    for (const Column& column : kColumns) fmt::print("{:>11}", column.title);
    fmt::print("\n");
    for (const CounterRow& row : rows)
        for (const RayCounts& kind : row.kinds)
            for (const Query& query : kQueries) {
                fmt::print("{:<16}{:<19}{:<12}", row.accelerator, kind.rays, query.title);
                for (const Column& column : kColumns)
                    fmt::print("{:>11.2f}", per_ray(kind, query, column));
                fmt::print("\n");
            }
    fmt::print("\n");
}

nlohmann::ordered_json counters_as_json(const std::string& mesh, std::size_t triangles,
                                        const std::vector<CounterRow>& rows) {
    nlohmann::ordered_json json = {{"mesh", mesh},
                                   {"triangles", triangles},
                                   {"width", lanes(preferred_instruction_set())},
                                   {"accelerators", nlohmann::ordered_json::array()}};
    for (const CounterRow& row : rows) {
        nlohmann::ordered_json rays;
        for (const RayCounts& kind : row.kinds)
            for (const Query& query : kQueries)
                for (const Column& column : kColumns)
                    rays[std::string(kind.rays)][query.key][column.title] =
                        per_ray(kind, query, column);
        json["accelerators"].push_back({{"name", row.accelerator}, {"per_ray", rays}});
    }
    return json;
}

}  // namespace boxwood::cli
