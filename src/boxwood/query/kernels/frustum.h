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
/// - kStepsOfOpen: what deciding a pair costs that isn't sure, in steps of Frustum::run();
/// - kStepsOfRayAlone: what a ray takes by itself, in such steps, with 16 lanes;
/// - start(packet): the packet has new rays;
/// - decide_open(packet, code, sure): whether rays of the packet hit that triangle isn't sure.
///   Returns whether that brought what is near closer;
/// - decide_ray(packet, ray, first_code, block, sure): the same for one ray and all triangles of a
///   block, the first of which has that code;
/// - write(sure, answers): the answers of all rays.
template <class S, class Rule>
class Frustum {
public:
    static constexpr int N = S::kWidth;
    static constexpr std::size_t kRays = FrustumRays<S>::kRays;
    /// As code_of() needs it.
    static constexpr std::uint64_t kLargestTree = (std::uint64_t{1} << 32) / N * kReferenceUnit;
    /// What the rays of a group take by themselves. In vectors of fewer lanes a step takes less
    /// time.
    static constexpr std::size_t kStepsAlone = kRays * Rule::kStepsOfRayAlone * 16 / N;

    BOXWOOD_KERNEL explicit Frustum(const WideTreeView& tree) : tree_(tree), rule_(tree, rays_) {}

    /// Takes in kRays rays; false when they can't be a group. Calls meanwhile(first, count)
    /// for some of them after the others.
    template <class Meanwhile>
    BOXWOOD_KERNEL bool load(const Rayf* rays, const Meanwhile& meanwhile) {
        if (!rays_.load(tree_, rays, meanwhile)) return false;
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
    /// step takes about as long as the test of a pair of a packet and a triangle. What its last
    /// leaf takes no longer counts.
    BOXWOOD_KERNEL bool run(std::size_t most_steps) {
        std::size_t steps = kStepsPerNode;
        int size = visit_node(0, 0);
        while (size > 0) {
            const Entry entry = stack_[--size];
            if (entry.enter > farthest_) continue;
            steps += kStepsPerBox;
            if (steps > most_steps) return false;
            const BoxInView box = box_of(entry);
            const unsigned packets = packets_that_see(box);
            if (packets == 0) continue;
            if (!is_leaf(entry.reference)) {
                steps += kStepsPerNode;
                size = visit_node(entry.reference, size);
            } else {
                steps += visit_leaf(entry.reference, box, packets);
            }
        }
        steps_ = steps;
        return true;
    }
    /// What it took. Precondition: run() returned true.
    BOXWOOD_KERNEL std::size_t steps() const { return steps_; }

    template <class Answer>
    BOXWOOD_KERNEL void write(Answer* answers) {
        rule_.write(sure_, answers);
    }

private:
    using Float = typename S::Float;

    // What things cost in steps, by a fit to the times of cameras near and far, with pictures large
    // and small: to look at a node's children, at a box that comes from the stack, which rays of a
    // packet see a leaf, to work out linear functions for a block, to test a ray with a block.
    static constexpr std::size_t kStepsPerNode = 16, kStepsPerBox = 5, kStepsPerPacket = 4,
                                 kStepsPerBlock = 8, kStepsPerRay = 5;
    /// Up to so many rays are tested with a block one by one: as long as that is faster.
    static constexpr int kFewRays = N;
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

    /// One box, as seen from the origin.
    struct BoxInView {
        float near, far;
        Float lo_x, hi_x, lo_y, hi_y;
    };

    BOXWOOD_KERNEL BoxInView box_of(const Entry& entry) const {
        const WideNode<N>& node = tree_.template node<N>(entry.parent);
        const auto& slabs = node.slabs;
        const std::uint32_t i = entry.slot;
        const float far_face =
            rays_.sign > 0 ? slabs[rays_.axis[2]].hi[i] : slabs[rays_.axis[2]].lo[i];
        return {entry.enter,
                (far_face - rays_.origin[2]) * rays_.sign + rays_.rounding,
                S::broadcast(slabs[rays_.axis[0]].lo[i] - (rays_.origin[0] + rays_.rounding)),
                S::broadcast(slabs[rays_.axis[0]].hi[i] - (rays_.origin[0] - rays_.rounding)),
                S::broadcast(slabs[rays_.axis[1]].lo[i] - (rays_.origin[1] + rays_.rounding)),
                S::broadcast(slabs[rays_.axis[1]].hi[i] - (rays_.origin[1] - rays_.rounding))};
    }

    /// Which of N rectangles of slopes it is in.
    BOXWOOD_KERNEL static unsigned are_in(const BoxInView& box, Float from_x, Float to_x,
                                          Float from_y, Float to_y) {
        const Float near = S::broadcast(box.near), far = S::broadcast(box.far);
        return S::less_equal(box.lo_x, most(to_x, near, far)) &
               S::less_equal(least(from_x, near, far), box.hi_x) &
               S::less_equal(box.lo_y, most(to_y, near, far)) &
               S::less_equal(least(from_y, near, far), box.hi_y);
    }

    BOXWOOD_KERNEL unsigned packets_that_see(const BoxInView& box) const {
        return S::less_equal(S::broadcast(box.near), S::load(far_)) &
               are_in(box, S::load(rays_.range_x[0]), S::load(rays_.range_x[1]),
                      S::load(rays_.range_y[0]), S::load(rays_.range_y[1]));
    }

    BOXWOOD_KERNEL unsigned rays_that_see(const BoxInView& box, int packet) const {
        const Float x = S::load(rays_.slope_x[packet]), y = S::load(rays_.slope_y[packet]);
        // So that a NaN, of a ray that ends where it starts, is not too far.
        const unsigned too_far = S::less(S::broadcast(1 + 0x1p-18f),
                                         S::broadcast(box.near) * S::load(sure_.near[packet]));
        return are_in(box, x, x, y, y) & ~too_far;
    }

    /// Returns how many steps it took.
    BOXWOOD_KERNEL std::size_t visit_leaf(WideReference reference, const BoxInView& box,
                                          unsigned packets) {
        unsigned rays[N], seeing = 0;
        int count = 0;
        for (unsigned rest = packets; rest != 0; rest &= rest - 1) {
            const int packet = __builtin_ctz(rest);
            rays[packet] = rays_that_see(box, packet);
            count += __builtin_popcount(rays[packet]);
            seeing |= unsigned{rays[packet] != 0} << packet;
        }
        const std::size_t steps =
            kStepsPerPacket * static_cast<std::size_t>(__builtin_popcount(packets));
        if (count == 0) return steps;
        const TriangleBlock<N>& block = block_at<N>(tree_, reference, room_);
        if (count > kFewRays) return steps + kStepsPerBlock + visit_block(reference, block, seeing);
        unsigned changed = 0;
        const BlockFromOrigin<S> from_origin(block, rays_);
        for (; seeing != 0; seeing &= seeing - 1) {
            const int packet = __builtin_ctz(seeing);
            for (unsigned rest = rays[packet]; rest != 0; rest &= rest - 1) {
                const int ray = __builtin_ctz(rest);
                const bool is_closer =
                    rule_.decide_ray(packet, ray, code_of<N>(reference, 0), from_origin, sure_);
                changed |= unsigned{is_closer} << packet;
            }
        }
        note_changes(changed);
        return steps + kStepsPerRay * static_cast<std::size_t>(count);
    }

    BOXWOOD_KERNEL std::size_t visit_block(WideReference reference, const TriangleBlock<N>& block,
                                           unsigned packets) {
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
        note_changes(changed);
        return static_cast<std::size_t>(view_.pairs + Rule::kStepsOfOpen * opens);
    }

    /// The closest hits of those packets came nearer.
    BOXWOOD_KERNEL void note_changes(unsigned packets) {
        if (packets == 0) return;
        for (; packets != 0; packets &= packets - 1) set_far(__builtin_ctz(packets));
        set_farthest();
    }

    const WideTreeView& tree_;
    FrustumRays<S> rays_;
    BlockInView<S> view_;
    TriangleBlock<N> room_;
    // Of the group and of each packet: the least inverse depth at which a ray looks for hits, and
    // how far along z that is.
    float group_nearest_, farthest_;
    std::size_t steps_ = 0;
    alignas(64) float nearest_[N], far_[N];
    SureHits<S> sure_;
    Rule rule_;
    Entry stack_[kStackSize];
};

}  // namespace boxwood
