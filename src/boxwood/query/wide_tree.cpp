// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/wide_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "boxwood/query/collapse.h"

namespace boxwood {

namespace {

/// Sizes up to 2^40 and down to 2^-40 are as good as 1.
float scale_for(const Box3f& bounds) {
    const float largest = bounds.lo.cwiseAbs().cwiseMax(bounds.hi.cwiseAbs()).maxCoeff();
    if (largest == 0) return 1;
    const int exponent = std::ilogb(largest);
    return std::abs(exponent) <= 40 ? 1 : std::ldexp(1.0f, std::clamp(-exponent, -126, 126));
}

}  // namespace

WideTree::WideTree(MeshView mesh, const Tree& tree, const WideTreeOptions& options)
    : instruction_set_(options.instruction_set) {
    if (tree.is_empty() || tree.root().box.is_empty()) return;
    bounds_ = tree.root().box;
    scale_ = scale_for(bounds_);
    Collapsed collapsed = collapse(mesh, tree, width(), scale_, options.compact);
    memory_ = std::move(collapsed.memory);
    cost_ = collapsed.cost;
    view_.memory = memory_.data();
    view_.bytes = memory_.size();
    view_.is_compact = options.compact;
    view_.stack_size = collapsed.stack_size;
    for (int k = 0; k < 3; ++k) {
        view_.lo[k] = scale_ * bounds_.lo[k];
        view_.hi[k] = scale_ * bounds_.hi[k];
    }
}

}  // namespace boxwood
