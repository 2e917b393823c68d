// SPDX-License-Identifier: Apache-2.0
// From the leaves up: a leaf is written anew from the mesh, by what wrote it first, and a node's
// box is the smallest around its children. Subtrees lie side by side, so how large they are is
// known from where they end, and the large ones are tasks of their own. Explained in
// docs/algorithms/refit.md.
#include "boxwood/query/refit.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/query/wide_cost.h"
#include "boxwood/query/wide_layout.h"
#include "boxwood/query/write_block.h"
#include "boxwood/query/write_node.h"

namespace boxwood {

namespace {

/// Subtrees of fewer bytes are done by the task that comes to them.
constexpr std::size_t kSmallestTask = std::size_t{1} << 18;

/// A node or a leaf with all that is below.
struct Part {
    Box3f box;
    double cost = 0;  ///< with areas as they are, not yet as chances
};

template <int N>
class Refitter {
public:
    Refitter(MeshView mesh, float scale, bool compact, std::byte* memory)
        : mesh_(mesh), scale_(scale), compact_(compact), memory_(memory) {}

    /// The node there, and all that lies from there to the end.
    Part refit_node(std::uint32_t place, std::uint32_t end) const {
        auto& node = *reinterpret_cast<WideNode<N>*>(memory_ + byte_offset(place));
        const ChildEnds<N> ends(node, end);
        std::array<Part, N> parts;
        refit_blocks(node, ends, parts);
        const bool is_large = byte_offset(end - place) > kSmallestTask;
        parallel_for(N, is_large ? 1 : N, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) {
                const WideReference child = node.child[i];
                if (child != 0 && !is_leaf(child))
                    parts[i] = refit_node(child, ends[static_cast<int>(i)]);
            }
        });
        Part whole;
        std::array<Box3f, N> boxes;
        for (int i = 0; i < N; ++i) {
            boxes[i] = parts[i].box;
            whole.box.extend(parts[i].box);
            whole.cost += parts[i].cost;
        }
        whole.cost += kNodeCost * whole.box.surface_area();
        write_boxes<N>(boxes, scale_, node);
        return whole;
    }

private:
    void refit_blocks(const WideNode<N>& node, const ChildEnds<N>& ends,
                      std::array<Part, N>& parts) const {
        std::array<BlockTriangles<N>, N> blocks;
        std::array<int, N> slots;
        int count = 0;
        for (int i = 0; i < N; ++i) {
            if (!is_leaf(node.child[i])) continue;
            blocks[count] = triangles_at(node.child[i]);
            blocks[count].fetch_faces(mesh_);
            slots[count++] = i;
        }
        for (int i = 0; i < count; ++i) {
            if (i + 1 < count) blocks[i + 1].fetch_vertices(mesh_);
            const int slot = slots[i];
            write(blocks[i], node.child[slot], ends[slot]);
            Part& part = parts[slot];
            for (int k = 0; k < blocks[i].count; ++k)
                part.box.extend(triangle_box(mesh_, blocks[i].index[k]));
            part.cost = kBlockCost * part.box.surface_area();
        }
    }

    /// Both kinds of leaves have their triangles' indices, if not in the same place.
    BlockTriangles<N> triangles_at(WideReference reference) const {
        const std::byte* place = memory_ + byte_offset(reference);
        const std::uint32_t* triangles =
            compact_ ? reinterpret_cast<const CompactBlock<N>*>(place)->triangle
                     : reinterpret_cast<const TriangleBlock<N>*>(place)->triangle;
        BlockTriangles<N> result;
        for (int i = 0; i < N; ++i) {
            if (triangles[i] != kEmptySlot) result.index[result.count++] = triangles[i];
        }
        return result;
    }

    void write(const BlockTriangles<N>& triangles, WideReference reference,
               std::uint32_t end) const {
        std::byte* place = memory_ + byte_offset(reference);
        if (!compact_) {
            write_block(mesh_, scale_, triangles, *reinterpret_cast<TriangleBlock<N>*>(place));
            return;
        }
        const BlockVertices<N> vertices(mesh_, triangles);
        const std::size_t room = byte_offset(end) - byte_offset(reference);
        if (compact_block_bytes(vertices) > room)
            throw InvalidInput("refit: the faces aren't those that the tree was made for");
        write_compact_block(mesh_, scale_, triangles, vertices,
                            *reinterpret_cast<CompactBlock<N>*>(place));
    }

    MeshView mesh_;
    float scale_;
    bool compact_;
    std::byte* memory_;
};

}  // namespace

void check_refit(const WideTree& tree, MeshView mesh) {
    const WideTreeParts& parts = tree.parts();
    if (mesh.faces.size() != parts.faces)
        throw InvalidInput(fmt::format("refit: the mesh has {} faces, expected {} as in the tree",
                                       mesh.faces.size(), parts.faces));
    check_indices(mesh);
    for (const std::uint32_t face : parts.left_out) {
        if (is_in_float_range(mesh, face))
            throw InvalidInput(fmt::format(
                "refit: face {} has no place in the tree, as it wasn't finite when that was built",
                face));
    }
}

namespace {

Part refit_all(WideTreeParts& parts, MeshView mesh) {
    if (parts.memory.size() == 0) return {};
    std::byte* memory = parts.memory.writable();
    const auto end = static_cast<std::uint32_t>(parts.memory.size() / kReferenceUnit);
    switch (lanes(parts.instruction_set)) {
        case 16:
            return Refitter<16>(mesh, parts.scale, parts.is_compact, memory).refit_node(0, end);
        case 8:
            return Refitter<8>(mesh, parts.scale, parts.is_compact, memory).refit_node(0, end);
        default:
            return Refitter<4>(mesh, parts.scale, parts.is_compact, memory).refit_node(0, end);
    }
}

}  // namespace

RefitQuality refit(WideTree& tree, MeshView moved) {
    check_refit(tree, moved);
    return refit_checked(tree, moved);
}

RefitQuality refit_checked(WideTree& tree, MeshView moved) {
    WideTreeParts parts = tree.release();
    Part root = refit_all(parts, moved);
    const float scale = scale_for(root.box);
    // Seldom, so that it may take as long again.
    if (scale != parts.scale) {
        parts.scale = scale;
        root = refit_all(parts, moved);
    }
    const double area = root.box.surface_area();
    parts.has_exact_corners = has_exact_corners(moved, scale);
    parts.bounds = root.box;
    parts.cost = area > 0 ? root.cost / area : 0;
    tree = WideTree(std::move(parts));
    return {tree.parts().cost_at_build, tree.cost()};
}

}  // namespace boxwood
