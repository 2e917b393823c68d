// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "boxwood/build/build.h"
#include "boxwood/scene/scene.h"
#include "boxwood/tree/validate.h"

namespace boxwood {

struct NamedBuild {
    std::string name;
    BuildOptions options;
};

/// Each builder, and the agglomerative one with each of its costs.
inline std::vector<NamedBuild> all_builds() {
    std::vector<NamedBuild> builds;
    for (const auto& method : build_methods()) {
        if (method.value != BuildMethod::agglomerative) {
            builds.push_back({std::string(method.name), {.method = method.value}});
            continue;
        }
        for (const auto& cost : merge_costs())
            builds.push_back({std::string(method.name) + "_" + std::string(cost.name),
                              {.method = method.value, .cost = cost.value}});
    }
    return builds;
}

/// What is wrong with a tree that this method built, where some put parts of primitives into
/// leaves.
inline std::optional<std::string> find_fault(const Tree& tree, std::span<const Box3f> boxes,
                                             BuildMethod method) {
    const bool splits = method == BuildMethod::spatial_split || method == BuildMethod::reinsertion;
    return splits ? find_fault_in_split_tree(tree, boxes) : find_fault(tree, boxes);
}

struct NamedAccelerator {
    std::string name;
    SceneOptions options;
};
/// How tests that it is a parameter of are listed.
inline void PrintTo(const NamedAccelerator& accelerator, std::ostream* out) {
    *out << accelerator.name;
}

/// Brute force first, then a tree of each preset and each build.
inline std::vector<NamedAccelerator> all_accelerators() {
    std::vector<NamedAccelerator> accelerators = {{"brute", {.brute_force = true}}};
    for (const auto& preset : build_presets())
        accelerators.push_back({std::string(preset.name), {.preset = preset.value}});
    for (const auto& [name, options] : all_builds())
        accelerators.push_back({name, {.build = options}});
    return accelerators;
}

}  // namespace boxwood
