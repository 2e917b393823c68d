// SPDX-License-Identifier: Apache-2.0
#include "build_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "meshes.h"

namespace boxwood::bench {

namespace {

constexpr std::array kQualities = {Quality::low, Quality::medium, Quality::high};

/// The builds of one mesh that the goal compares, by quality.
struct Compared {
    struct Best {
        double seconds = 0;
        double mrays = 0;
    };
    std::map<Quality, BuildScore> ours;
    std::map<Quality, Best> embrees;  ///< the least time and the most rays of any Embree
};

std::map<std::string, Compared> compared(const std::vector<BuildScore>& builds) {
    std::map<std::string, Compared> result;
    for (const BuildScore& build : builds) {
        Compared& mesh = result[build.mesh];
        if (build.library == "boxwood") mesh.ours[build.quality] = build;
        if (!build.library.starts_with("embree")) continue;
        const auto [best, is_first] = mesh.embrees.try_emplace(build.quality);
        if (is_first || build.one_thread < best->second.seconds)
            best->second.seconds = build.one_thread;
        best->second.mrays = std::max(best->second.mrays, build.mrays);
    }
    return result;
}

using Ratios = std::vector<std::pair<std::string, double>>;

void add(std::string name, double target, double worst_allowed, const Ratios& ratios,
         std::vector<Target>& targets) {
    if (!ratios.empty())
        targets.push_back(over_meshes(std::move(name), target, worst_allowed, ratios));
}

}  // namespace

std::string_view name_of(Quality quality) {
    constexpr std::string_view kNames[] = {"low", "medium", "high"};
    return kNames[static_cast<int>(quality)];
}

void print_builds(const std::vector<BuildScore>& builds) {
    fmt::print("  {:<28}{:>12}{:>14}{:>18}{:>18}\n", "", "1 thread ms", "2 threads ms",
               "bytes a triangle", "single Mrays/s");
    for (const BuildScore& build : builds)
        fmt::print("  {:<28}{:>12.1f}{:>14.1f}{:>18}{:>18.2f}\n", build.name,
                   1e3 * build.one_thread, 1e3 * build.two_threads,
                   build.bytes_a_triangle > 0 ? fmt::format("{:.1f}", build.bytes_a_triangle) : "",
                   build.mrays);
}

std::vector<Target> build_targets(const std::vector<BuildScore>& builds) {
    // A mesh may fall behind by no more than this; where nothing may, by no more than the noise.
    constexpr double kWorstAllowed = 0.95, kNoise = 0.98;
    const std::map<Quality, std::pair<const char*, double>> goals = {
        {Quality::low, {"fast", 1.0}},
        {Quality::medium, {"balanced", 1.2}},
        {Quality::high, {"best", 1.0}}};

    std::map<Quality, Ratios> time, traced;
    Ratios best_traced, best_traced_in_scenes, two_threads, memory;
    for (const auto& [name, mesh] : compared(builds)) {
        for (const auto& [quality, ours] : mesh.ours) {
            two_threads.emplace_back(fmt::format("{} {}", name, goals.at(quality).first),
                                     ours.one_thread / ours.two_threads);
            const auto embree = mesh.embrees.find(quality);
            if (embree == mesh.embrees.end()) continue;
            time[quality].emplace_back(name, embree->second.seconds / ours.one_thread);
            traced[quality].emplace_back(name, ours.mrays / embree->second.mrays);
        }
        const auto balanced = mesh.ours.find(Quality::medium), best = mesh.ours.find(Quality::high);
        if (balanced == mesh.ours.end()) continue;
        memory.emplace_back(name, 72 / balanced->second.bytes_a_triangle);
        if (best == mesh.ours.end()) continue;
        Ratios& kind = is_scene(name) ? best_traced_in_scenes : best_traced;
        kind.emplace_back(name, best->second.mrays / balanced->second.mrays);
    }

    std::vector<Target> targets;
    for (const Quality quality : kQualities) {
        const auto& [name, target] = goals.at(quality);
        add(fmt::format("build {}, time", name), target, kWorstAllowed, time[quality], targets);
        add(fmt::format("build {}, traced", name), 1, kWorstAllowed, traced[quality], targets);
    }
    add("best to balanced, traced, scenes", 1.15, kNoise, best_traced_in_scenes, targets);
    add("best to balanced, traced, other meshes", kNoise, kNoise, best_traced, targets);
    add("builds, two threads to one", 1.7, 0, two_threads, targets);
    add("72 bytes a triangle to those of balanced", 1, 1, memory, targets);
    return targets;
}

nlohmann::ordered_json as_json(const std::vector<BuildScore>& builds) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const BuildScore& build : builds)
        json.push_back({{"mesh", build.mesh},
                        {"triangles", build.triangles},
                        {"library", build.library},
                        {"name", build.name},
                        {"quality", name_of(build.quality)},
                        {"seconds_one_thread", build.one_thread},
                        {"seconds_two_threads", build.two_threads},
                        {"bytes_a_triangle", build.bytes_a_triangle},
                        {"mrays_per_second", build.mrays}});
    return json;
}

}  // namespace boxwood::bench
