// SPDX-License-Identifier: Apache-2.0
// A walk stays inside and ends if each node's children follow it without gaps, each subtree within
// the place that its parent has for it: then nothing is reached twice. Besides, empty slots must be
// such that no ray enters them, and each order of slots must name them all.
#include "boxwood/query/wide_fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "boxwood/core/parallel.h"
#include "boxwood/query/wide_layout.h"
#include "boxwood/query/write_block.h"

namespace boxwood {

namespace {

/// Subtrees of fewer bytes are done by the task that comes to them.
constexpr std::size_t kSmallestTask = std::size_t{1} << 18;

template <int N>
class FaultFinder {
public:
    explicit FaultFinder(const WideTreeParts& parts)
        : parts_(parts), memory_(parts.memory.data()) {}

    /// What was found in a subtree.
    struct Finding {
        const char* fault = nullptr;
        std::uint32_t place = 0;
        int stack_size = 0;
    };

    Finding check_node(std::uint32_t place, std::uint32_t end, int depth) const {
        if (depth > kDeepestWideTree) return {"the tree is too deep", place};
        if (byte_offset(place) % alignof(WideNode<N>) != 0 ||
            byte_offset(end) - byte_offset(place) < sizeof(WideNode<N>))
            return {"a node is not where it can be", place};
        const auto& node = *reinterpret_cast<const WideNode<N>*>(memory_ + byte_offset(place));
        const ChildEnds<N> ends(node, end);
        if (const char* fault = fault_in(node, place, ends)) return {fault, place};

        std::array<Finding, N> findings;
        const bool is_large = byte_offset(end - place) > kSmallestTask;
        parallel_for(N, is_large ? 1 : N, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i)
                findings[i] = check_child(node, ends, static_cast<int>(i), depth);
        });
        Finding worst = {nullptr, place};
        int children = 0;
        for (int i = 0; i < N; ++i) {
            if (findings[i].fault) return findings[i];
            worst.stack_size = std::max(worst.stack_size, findings[i].stack_size);
            children += node.child[i] != 0;
        }
        worst.stack_size += std::max(children, 1) - 1;
        return worst;
    }

private:
    static const char* fault_in(const WideNode<N>& node, std::uint32_t place,
                                const ChildEnds<N>& ends) {
        if (byte_offset(ends.first()) != byte_offset(place) + sizeof(WideNode<N>))
            return "the first child doesn't follow its node";
        for (int i = 0; i < N; ++i) {
            if (node.child[i] != 0) {
                if ((node.child[i] & ~kLeafBit) >= ends[i]) return "children aren't in order";
            } else if (can_be_hit(node, i)) {
                return "an empty slot has a box";
            }
        }
        for (std::uint32_t octant = 0; octant < 8; ++octant) {
            std::uint32_t named = 0;
            for (int k = 0; k < N; ++k) named |= 1u << (node.order[k] >> (4 * octant) & 15);
            if (named != (1u << N) - 1) return "an order of slots doesn't name each once";
        }
        return nullptr;
    }

    static bool can_be_hit(const WideNode<N>& node, int slot) {
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        bool is_empty = true;
        for (const auto& slab : node.slabs)
            is_empty &= slab.lo[slot] == kInfinity && slab.hi[slot] == -kInfinity;
        return !is_empty;
    }

    Finding check_child(const WideNode<N>& node, const ChildEnds<N>& ends, int slot,
                        int depth) const {
        const WideReference child = node.child[slot];
        if (child == 0) return {};
        if (!is_leaf(child)) return check_node(child, ends[slot], depth + 1);
        const std::byte* place = memory_ + byte_offset(child);
        const std::size_t bytes = byte_offset(ends[slot]) - byte_offset(child);
        const char* fault =
            parts_.is_compact ? compact_fault(place, bytes) : block_fault(place, bytes);
        return {fault, child & ~kLeafBit};
    }

    bool is_aligned(const std::byte* place, std::size_t alignment) const {
        return static_cast<std::size_t>(place - memory_) % alignment == 0;
    }

    const char* block_fault(const std::byte* place, std::size_t bytes) const {
        if (bytes != sizeof(TriangleBlock<N>) || !is_aligned(place, alignof(TriangleBlock<N>)))
            return "a leaf is not where it can be";
        const auto& block = *reinterpret_cast<const TriangleBlock<N>*>(place);
        for (int i = 0; i < N; ++i) {
            if (block.triangle[i] < parts_.faces) continue;
            bool is_empty = block.triangle[i] == kEmptySlot;
            for (const auto& corner : block.corner) {
                for (const auto& axis : corner) is_empty &= std::isnan(axis[i]);
            }
            if (!is_empty) return "a leaf has a triangle that isn't in the mesh";
        }
        return nullptr;
    }

    const char* compact_fault(const std::byte* place, std::size_t bytes) const {
        if (bytes < 7 * N + 3 * sizeof(float) || !is_aligned(place, alignof(CompactBlock<N>)))
            return "a leaf is not where it can be";
        const auto& block = *reinterpret_cast<const CompactBlock<N>*>(place);
        const std::size_t room = (bytes - 7 * N) / (3 * sizeof(float));
        for (int k = 0; k < 3; ++k) {
            if (!std::isnan(block.vertices()[k])) return "an empty slot has a vertex";
        }
        for (int i = 0; i < N; ++i) {
            bool is_empty = block.triangle[i] == kEmptySlot;
            for (const auto& corner : block.corner) {
                if (corner[i] >= room) return "a leaf has a corner outside of it";
                is_empty &= corner[i] == 0;
            }
            if (block.triangle[i] >= parts_.faces && !is_empty)
                return "a leaf has a triangle that isn't in the mesh";
        }
        return nullptr;
    }

    const WideTreeParts& parts_;
    const std::byte* memory_;
};

/// Precondition: the root is sound.
template <int N>
bool has_root_within_bounds(const WideTreeParts& parts) {
    const auto& root = *reinterpret_cast<const WideNode<N>*>(parts.memory.data());
    bool is_within = true;
    for (int i = 0; i < N; ++i) {
        if (root.child[i] == 0) continue;
        for (int k = 0; k < 3; ++k) {
            is_within &= root.slabs[k].lo[i] >= parts.scale * parts.bounds.lo[k];
            is_within &= root.slabs[k].hi[i] <= parts.scale * parts.bounds.hi[k];
        }
    }
    return is_within;
}

template <int N>
std::optional<std::string> find_fault_of_width(const WideTreeParts& parts) {
    const auto end = static_cast<std::uint32_t>(parts.memory.size() / kReferenceUnit);
    const auto found = FaultFinder<N>(parts).check_node(0, end, 0);
    if (!found.fault && !has_root_within_bounds<N>(parts))
        return "the root has a box outside of the bounds";
    if (found.fault) return fmt::format("{} at byte {}", found.fault, byte_offset(found.place));
    if (found.stack_size != parts.stack_size)
        return fmt::format("a walk needs {} places, expected {}", found.stack_size,
                           parts.stack_size);
    return std::nullopt;
}

}  // namespace

std::optional<std::string> find_fault(const WideTreeParts& parts) {
    const std::size_t bytes = parts.memory.size();
    if (bytes == 0 && parts.bounds.is_empty()) return std::nullopt;
    if (bytes % kReferenceUnit != 0 || bytes / kReferenceUnit >= kLeafBit)
        return fmt::format("a tree can't have {} bytes", bytes);
    switch (lanes(parts.instruction_set)) {
        case 16:
            return find_fault_of_width<16>(parts);
        case 8:
            return find_fault_of_width<8>(parts);
        default:
            return find_fault_of_width<4>(parts);
    }
}

}  // namespace boxwood
