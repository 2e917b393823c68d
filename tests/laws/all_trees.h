// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "boxwood/query/wide_tree.h"
#include "laws/accelerators.h"

namespace boxwood {

struct NamedTree {
    std::string name;
    WideTree tree;
};

/// Over every builder with every instruction set; that of the first one with compact leaves, too.
inline std::vector<NamedTree> all_trees(const TriangleMesh& mesh) {
    std::vector<NamedTree> trees;
    const auto add = [&](const std::string& build, const Tree& tree, bool compact) {
        for (const auto& [set_name, set] : instruction_sets()) {
            if (!is_supported(set)) continue;
            trees.push_back({build + "/" + std::string(set_name),
                             WideTree(mesh, tree, {.instruction_set = set, .compact = compact})});
        }
    };
    for (const auto& [name, options] : all_builds()) {
        const Tree tree = build_tree(mesh, options);
        if (trees.empty()) add(name + "/compact", tree, true);
        add(name, tree, false);
    }
    return trees;
}

}  // namespace boxwood
