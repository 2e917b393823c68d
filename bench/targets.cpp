// SPDX-License-Identifier: Apache-2.0
#include "targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <thread>

#include "boxwood/core/files.h"

namespace boxwood::bench {

namespace {

std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    std::string name = "unknown", family = name, model = name;
    for (std::string line; std::getline(in, line) && !line.empty();) {
        const std::string value = line.substr(std::min(line.find(':') + 2, line.size()));
        if (line.starts_with("model name")) name = value;
        if (line.starts_with("cpu family")) family = value;
        if (line.starts_with("model\t")) model = value;
    }
    // The name alone doesn't always tell the generation.
    return name + ", family " + family + ", model " + model;
}

}  // namespace

Target over_meshes(std::string name, double target, double worst_allowed,
                   const std::vector<std::pair<std::string, double>>& ratios) {
    Target result = {.name = std::move(name), .target = target, .worst_allowed = worst_allowed};
    std::vector<double> values;
    for (const auto& [mesh, ratio] : ratios) {
        if (values.empty() || ratio < result.worst) {
            result.worst = ratio;
            result.worst_mesh = mesh;
        }
        values.push_back(ratio);
    }
    result.ratio = geometric_mean(values);
    return result;
}

void print_targets(const std::vector<Target>& targets) {
    for (const Target& target : targets)
        fmt::print("{:<44} {:6.2f} {:6.2f}  {:<5}  worst {:.2f} {}\n", target.name, target.ratio,
                   target.target, target.is_met() ? "ok" : "short", target.worst,
                   target.worst_mesh);
}

bool all_met(const std::vector<Target>& targets) {
    bool result = true;
    for (const Target& target : targets) result = result && target.is_met();
    return result;
}

double geometric_mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += std::log(value);
    return values.empty() ? 0 : std::exp(sum / static_cast<double>(values.size()));
}

nlohmann::ordered_json report(const std::vector<Target>& targets) {
    nlohmann::ordered_json json = {{"machine",
                                    {{"processor", processor()},
                                     {"cores", std::thread::hardware_concurrency()},
                                     {"isa", has_avx512() ? "avx512" : "avx2"}}},
                                   {"compiler", __VERSION__},
                                   {"commit", BOXWOOD_COMMIT},
                                   {"targets", nlohmann::ordered_json::array()}};
    for (const Target& target : targets)
        json["targets"].push_back({{"name", target.name},
                                   {"ratio", target.ratio},
                                   {"target", target.target},
                                   {"worst", target.worst},
                                   {"worst_mesh", target.worst_mesh},
                                   {"ok", target.is_met()}});
    return json;
}

void write_json(const std::string& file, const nlohmann::ordered_json& json) {
    if (file.empty()) return;
    OutputFile out(file);
    out.write(json.dump(2) + "\n");
    out.commit();
}

bool has_avx512() {
    const char* forced = std::getenv("BOXWOOD_ISA");
    return __builtin_cpu_supports("avx512dq") && (!forced || std::string_view(forced) == "avx512");
}

}  // namespace boxwood::bench
