// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace boxwood::bench {

/// What a benchmark has to show: a ratio to a peer, and what it should be.
struct Target {
    std::string name;
    double ratio = 0;
    double target = 0;
    double worst = 1;  ///< the least ratio of any mesh
    double worst_allowed = 0;
    std::string worst_mesh = {};

    bool is_met() const { return ratio >= target && worst >= worst_allowed; }
};

/// A target over meshes: the geometric mean of their ratios is what counts.
Target over_meshes(std::string name, double target, double worst_allowed,
                   const std::vector<std::pair<std::string, double>>& ratios);

/// A line each: "name  ratio  target  ok|short", and the mesh that did worst.
void print_targets(const std::vector<Target>& targets);

bool all_met(const std::vector<Target>& targets);

double geometric_mean(const std::vector<double>& values);

/// The machine, the compiler, the commit and the targets; benchmarks add what they measured.
nlohmann::ordered_json report(const std::vector<Target>& targets);

/// Does nothing without a file name. Throws IoError.
void write_json(const std::string& file, const nlohmann::ordered_json& json);

/// Whether AVX-512 may be used: the machine has it and BOXWOOD_ISA doesn't forbid it.
bool has_avx512();

}  // namespace boxwood::bench
