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

/// Over every builder with every instruction set.
inline std::vector<NamedTree> all_trees(const TriangleMesh& mesh) {
    std::vector<NamedTree> trees;
    for (const auto& [name, options] : all_builds()) {
        const Tree tree = build_tree(mesh, options);
        for (const auto& [set_name, set] : instruction_sets()) {
            if (is_supported(set))
                trees.push_back({name + "/" + std::string(set_name), WideTree(mesh, tree, {set})});
        }
    }
    return trees;
}

}  // namespace boxwood
