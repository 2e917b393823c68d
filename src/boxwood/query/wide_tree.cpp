// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/wide_tree.h"

#include <utility>

#include "boxwood/query/collapse.h"

namespace boxwood {

WideTree::WideTree(MeshView mesh, const Tree& tree, const WideTreeOptions& options)
    : instruction_set_(options.instruction_set) {
    if (tree.is_empty() || tree.root().box.is_empty()) return;
    Collapsed collapsed = collapse(mesh, tree, width());
    memory_ = std::move(collapsed.memory);
    cost_ = collapsed.cost;
    bounds_ = tree.root().box;
}

}  // namespace boxwood
