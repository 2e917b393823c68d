// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/wide_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "boxwood/query/collapse.h"

namespace boxwood {

namespace {

WideTreeParts collapsed_parts(MeshView mesh, const Tree& tree, const WideTreeOptions& options,
                              Arena spare) {
    WideTreeParts parts;
    parts.instruction_set = options.instruction_set;
    parts.is_compact = options.compact;
    parts.faces = mesh.faces.size();
    if (tree.is_empty() || tree.root().box.is_empty()) {
        parts.left_out.resize(parts.faces);
        std::iota(parts.left_out.begin(), parts.left_out.end(), 0u);
        return parts;
    }
    parts.bounds = tree.root().box;
    parts.scale = scale_for(parts.bounds);
    Collapsed collapsed = collapse(mesh, tree,
                                   {.width = lanes(options.instruction_set),
                                    .scale = parts.scale,
                                    .compact = options.compact,
                                    .spare = std::move(spare)});
    parts.has_exact_corners = has_exact_corners(mesh, parts.scale);
    parts.memory = WideMemory(std::move(collapsed.memory));
    parts.stack_size = collapsed.stack_size;
    parts.cost = parts.cost_at_build = collapsed.cost;
    parts.left_out = std::move(collapsed.left_out);
    return parts;
}

}  // namespace

float scale_for(const Box3f& bounds) {
    if (bounds.is_empty()) return 1;
    const float largest = bounds.lo.cwiseAbs().cwiseMax(bounds.hi.cwiseAbs()).maxCoeff();
    if (largest == 0) return 1;
    // Sizes up to 2^40 and down to 2^-40 are as good as 1.
    const int exponent = std::ilogb(largest);
    return std::abs(exponent) <= 40 ? 1 : std::ldexp(1.0f, std::clamp(-exponent, -126, 126));
}

bool has_exact_corners(MeshView mesh, float scale) {
    return scale == 1 && are_floats(mesh.vertices);
}

WideTree::WideTree(MeshView mesh, const Tree& tree, const WideTreeOptions& options, Arena spare)
    : WideTree(collapsed_parts(mesh, tree, options, std::move(spare))) {}

WideTree::WideTree(WideTreeParts parts) : parts_(std::move(parts)) {
    view_.memory = parts_.memory.data();
    view_.bytes = parts_.bounds.is_empty() ? 0 : parts_.memory.size();
    view_.is_compact = parts_.is_compact;
    view_.stack_size = parts_.stack_size;
    if (!parts_.bounds.is_empty()) {
        const Vec3d lo = parts_.bounds.lo.cast<double>(), hi = parts_.bounds.hi.cast<double>();
        middle_ = 0.5 * lo + 0.5 * hi;
        near_size_ = 2 * (hi - lo).norm();
    }
    for (int k = 0; k < 3; ++k) {
        view_.lo[k] = parts_.scale * parts_.bounds.lo[k];
        view_.hi[k] = parts_.scale * parts_.bounds.hi[k];
    }
}

WideTreeParts WideTree::release() {
    WideTree released = std::exchange(*this, WideTree());
    return std::move(released.parts_);
}

}  // namespace boxwood
