// SPDX-License-Identifier: Apache-2.0
// Rays from one point, as a camera sends them: N packets of N rays walk the tree as one. A node is
// compared with the frustum around all of them, one box on the stack with the N frusta around the
// packets, a triangle first with these and then with the rays of the packets that it may be seen
// by. So a box or a triangle is fetched once for many rays. Which triangle a ray sees is mostly
// sure from linear functions (frustum_block.h); what becomes of it, and where it isn't, is up to
// frustum_hits.h and frustum_candidates.h. Explained in docs/algorithms/frustum.md.
// Sources: Reshetov, Soupikov and Hurley, "Multi-Level Ray Tracing Algorithm", SIGGRAPH 2005;
// Overbeck, Ramamoorthi and Mark, "Large Ray Packets for Real-time Whitted Ray Tracing", RT 2008.
#pragma once

#include "boxwood/query/kernels/frustum_block.h"
#include "boxwood/query/kernels/frustum_rays.h"
#include "boxwood/query/kernels/tree_blocks.h"
#include "boxwood/query/kernels/wide_walk.h"

namespace boxwood {

/// Of an inverse depth that is worked out from a t.
constexpr float kDepthRounding = 0x1p-20f;

/// What linear functions tell of the rays of each packet.
template <class S>
struct SureHits {
    static constexpr int N = S::kWidth;

    /// Bounds of the inverse depth of the closest hit.
    alignas(64) float near[N][N], surely_near[N][N];
    /// The place of the triangle that is hit there, of those rays that the mask says.
    alignas(64) std::uint32_t code[N][N];
    unsigned taken[N];
};

/// The place of a triangle in the tree, in 32 bits.
template <int N>
BOXWOOD_KERNEL std::uint32_t code_of(WideReference block, int lane) {
    return (block & ~kLeafBit) * N + static_cast<std::uint32_t>(lane);
}
template <int N>
BOXWOOD_KERNEL BlockTriangle triangle_of_code(const WideTreeView& tree, std::uint32_t code) {
    return triangle_at<N>(tree, code / N, code % N);
}

/// The rule is what becomes of triangles. It has
/// - kIsRounded: whether rays and triangles are those in double, rounded;
/// - kStepsOfOpen: what deciding a pair costs that isn't sure, in tests of pairs;
/// - start(packet): the packet has new rays;
/// - decide_open(packet, code, sure): whether rays of the packet hit that triangle isn't sure.
///   Returns whether that brought what is near closer;
/// - write(sure, answers): the answers of all rays.
template <class S, class Rule>
class Frustum {
public:
    static constexpr int N = S::kWidth;
    static constexpr std::size_t kRays = FrustumRays<S>::kRays;
    /// As code_of() needs it.
    static constexpr std::uint64_t kLargestTree = (std::uint64_t{1} << 32) / N * kReferenceUnit;

    BOXWOOD_KERNEL explicit Frustum(const WideTreeView& tree) : tree_(tree), rule_(tree, rays_) {}

    /// Takes in kRays rays; false when they can't be a group.
    BOXWOOD_KERNEL bool load(const Rayf* rays) {
        if (!rays_.load(tree_, rays)) return false;
        for (int packet = 0; packet < N; ++packet) {
            rule_.start(packet);
            sure_.taken[packet] = 0;
            if (rays_.is_endless) {
                S::store(sure_.near[packet], S::broadcast(0));
                S::store(sure_.surely_near[packet], S::broadcast(0));
                nearest_[packet] = 0;
                far_[packet] = __builtin_inff();
            } else {
                const Float nearest = rays_.inverse_depth(packet, S::load(rays_.t_max[packet]));
                S::store(sure_.near[packet], nearest * S::broadcast(1 - kDepthRounding));
                S::store(sure_.surely_near[packet], nearest * S::broadcast(1 + kDepthRounding));
                set_far(packet);
            }
        }
        set_farthest();
        return true;
    }

    /// Finds the hits; gives up, and returns false, when that takes more steps than the limit. A
    /// step is the test of a pair of a packet and a triangle.
    BOXWOOD_KERNEL bool run(std::size_t most_steps) {
        std::size_t steps = 0;
        WideReference current = 0;
        unsigned packets = FrustumRays<S>::kAll;
        int size = 0;
        for (;;) {
            if (is_leaf(current)) {
                steps += visit_block(current, packets) + kStepsPerBlock;
                if (steps > most_steps) return false;
            } else {
                size = visit_node(current, size);
            }
            do {
                if (size == 0) return true;
                const Entry& entry = stack_[--size];
                current = entry.reference;
                packets = entry.enter <= farthest_ ? packets_that_see(entry) : 0;
            } while (packets == 0);
        }
    }

    template <class Answer>
    BOXWOOD_KERNEL void write(Answer* answers) {
        rule_.write(sure_, answers);
    }

private:
    using Float = typename S::Float;

    static constexpr std::size_t kStepsPerBlock = 8;
    /// A child to visit, and whose child it is.
    struct Entry {
        WideReference reference, parent;
        std::uint32_t slot;
        float enter;  ///< where the frustum enters it, along z
    };

    /// How far along z a packet looks.
    BOXWOOD_KERNEL void set_far(int packet) {
        nearest_[packet] = S::least(FrustumRays<S>::kAll, S::load(sure_.near[packet]));
        far_[packet] = (1 / nearest_[packet]) * (1 + 0x1p-18f);
    }
    BOXWOOD_KERNEL void set_farthest() {
        group_nearest_ = S::least(FrustumRays<S>::kAll, S::load(nearest_));
        farthest_ = S::greatest(S::load(far_));
    }

    /// The largest and the least of s z for s in [lo, hi] and z in [near, far]; 0 <= near.
    BOXWOOD_KERNEL static Float most(Float hi, Float near, Float far) {
        return S::max(hi * near, hi * far);
    }
    BOXWOOD_KERNEL static Float least(Float lo, Float near, Float far) {
        return S::min(lo * near, lo * far);
    }

    /// Puts the children that the frustum of the group meets on the stack, the nearest on top.
    BOXWOOD_KERNEL int visit_node(WideReference reference, int size) {
        const WideNode<N>& node = tree_.template node<N>(reference);
        const Float ox_lo = S::broadcast(rays_.origin[0] + rays_.rounding),
                    ox_hi = S::broadcast(rays_.origin[0] - rays_.rounding);
        const Float oy_lo = S::broadcast(rays_.origin[1] + rays_.rounding),
                    oy_hi = S::broadcast(rays_.origin[1] - rays_.rounding);
        const float* near_face =
            rays_.sign > 0 ? node.slabs[rays_.axis[2]].lo : node.slabs[rays_.axis[2]].hi;
        const float* far_face =
            rays_.sign > 0 ? node.slabs[rays_.axis[2]].hi : node.slabs[rays_.axis[2]].lo;
        const Float oz = S::broadcast(rays_.origin[2]), sign = S::broadcast(rays_.sign);
        const Float rounding = S::broadcast(rays_.rounding), zero = S::broadcast(0);
        const Float near = S::max((S::load(near_face) - oz) * sign - rounding, zero);
        const Float far = (S::load(far_face) - oz) * sign + rounding;
        const Float lo_x = S::load(node.slabs[rays_.axis[0]].lo) - ox_lo;
        const Float hi_x = S::load(node.slabs[rays_.axis[0]].hi) - ox_hi;
        const Float lo_y = S::load(node.slabs[rays_.axis[1]].lo) - oy_lo;
        const Float hi_y = S::load(node.slabs[rays_.axis[1]].hi) - oy_hi;
        unsigned hit = S::less_equal(near, S::min(far, S::broadcast(farthest_))) &
                       S::less_equal(lo_x, most(S::broadcast(rays_.hi_x), near, far)) &
                       S::less_equal(least(S::broadcast(rays_.lo_x), near, far), hi_x) &
                       S::less_equal(lo_y, most(S::broadcast(rays_.hi_y), near, far)) &
                       S::less_equal(least(S::broadcast(rays_.lo_y), near, far), hi_y);
        alignas(64) float enter[N];
        S::store(enter, near);
        const int bottom = size;
        for (; hit != 0; hit &= hit - 1) {
            const int slot = __builtin_ctz(hit);
            const Entry entry = {node.child[slot], reference, static_cast<std::uint32_t>(slot),
                                 enter[slot]};
            prefetch<N>(tree_, entry.reference);
            int place = size++;
            for (; place > bottom && stack_[place - 1].enter < entry.enter; --place)
                stack_[place] = stack_[place - 1];
            stack_[place] = entry;
        }
        return size;
    }

    /// One box against the frusta of all packets.
    BOXWOOD_KERNEL unsigned packets_that_see(const Entry& entry) const {
        const WideNode<N>& node = tree_.template node<N>(entry.parent);
        const std::uint32_t i = entry.slot;
        const float far_face =
            rays_.sign > 0 ? node.slabs[rays_.axis[2]].hi[i] : node.slabs[rays_.axis[2]].lo[i];
        const Float near = S::broadcast(entry.enter);
        const Float far = S::broadcast((far_face - rays_.origin[2]) * rays_.sign + rays_.rounding);
        const Float lo_x =
            S::broadcast(node.slabs[rays_.axis[0]].lo[i] - (rays_.origin[0] + rays_.rounding));
        const Float hi_x =
            S::broadcast(node.slabs[rays_.axis[0]].hi[i] - (rays_.origin[0] - rays_.rounding));
        const Float lo_y =
            S::broadcast(node.slabs[rays_.axis[1]].lo[i] - (rays_.origin[1] + rays_.rounding));
        const Float hi_y =
            S::broadcast(node.slabs[rays_.axis[1]].hi[i] - (rays_.origin[1] - rays_.rounding));
        return S::less_equal(near, S::load(far_)) &
               S::less_equal(lo_x, most(S::load(rays_.range_x[1]), near, far)) &
               S::less_equal(least(S::load(rays_.range_x[0]), near, far), hi_x) &
               S::less_equal(lo_y, most(S::load(rays_.range_y[1]), near, far)) &
               S::less_equal(least(S::load(rays_.range_y[0]), near, far), hi_y);
    }

    BOXWOOD_KERNEL std::size_t visit_block(WideReference reference, unsigned packets) {
        const TriangleBlock<N>& block = block_at<N>(tree_, reference, room_);
        view_.template look<Rule::kIsRounded>(block, rays_, packets, nearest_, group_nearest_);
        // Those that the linear functions leave open, of all pairs.
        std::uint8_t open[N * N + 1];
        int opens = 0;
        unsigned changed = 0;
        for (int i = 0; i < view_.pairs; ++i) {
            const int packet = view_.packet_of[i], j = view_.triangle_of[i];
            const Sight<S> sight = view_.sight(rays_, packet, j);
            const Float near = S::load(sure_.near[packet]),
                        surely_near = S::load(sure_.surely_near[packet]);
            const unsigned maybe = S::less_equal(S::broadcast(view_.least[j]), sight.inside) &
                                   S::less_equal(near, sight.hi);
            const unsigned sure = S::less(S::broadcast(view_.margin[j]), sight.inside) &
                                  S::less(surely_near, sight.lo);
            S::store(sure_.near[packet], S::select(sure, sight.lo, near));
            S::store(sure_.surely_near[packet], S::select(sure, sight.hi, surely_near));
            S::store_masked(sure, sure_.code[packet],
                            S::broadcast_integer(code_of<N>(reference, j)));
            sure_.taken[packet] |= sure;
            changed |= unsigned{sure != 0} << packet;
            open[opens] = static_cast<std::uint8_t>(i);
            opens += (maybe & ~sure) != 0;
        }
        for (int i = 0; i < opens; ++i) {
            const int packet = view_.packet_of[open[i]], j = view_.triangle_of[open[i]];
            const bool is_closer = rule_.decide_open(packet, code_of<N>(reference, j), sure_);
            changed |= unsigned{is_closer} << packet;
        }
        if (changed != 0) {
            for (; changed != 0; changed &= changed - 1) set_far(__builtin_ctz(changed));
            set_farthest();
        }
        return static_cast<std::size_t>(view_.pairs + Rule::kStepsOfOpen * opens);
    }

    const WideTreeView& tree_;
    FrustumRays<S> rays_;
    BlockInView<S> view_;
    TriangleBlock<N> room_;
    // Of the group and of each packet: the least inverse depth at which a ray looks for hits, and
    // how far along z that is.
    float group_nearest_, farthest_;
    alignas(64) float nearest_[N], far_[N];
    SureHits<S> sure_;
    Rule rule_;
    Entry stack_[kStackSize];
};

}  // namespace boxwood
