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
    view_.memory = memory_.data();
    view_.bytes = memory_.size();
    view_.stack_size = collapsed.stack_size;
    for (int k = 0; k < 3; ++k) {
        view_.lo[k] = bounds_.lo[k];
        view_.hi[k] = bounds_.hi[k];
    }
}

}  // namespace boxwood
