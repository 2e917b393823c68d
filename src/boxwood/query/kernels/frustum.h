// SPDX-License-Identifier: Apache-2.0
// Rays from one point, as a camera sends them: N packets of N rays walk the tree as one. A node is
// compared with the frustum around all of them, one box on the stack with the N frusta around the
// packets, a triangle first with these and then with the rays of the packets that it may be seen
// by. So a box or a triangle is fetched once for many rays. Which triangle a ray sees is mostly
// sure from linear functions (frustum_block.h); the test that single rays use decides where it
// isn't, and works out the hits of all rays in the end. Explained in docs/algorithms/frustum.md.
// Sources: Reshetov, Soupikov and Hurley, "Multi-Level Ray Tracing Algorithm", SIGGRAPH 2005;
// Overbeck, Ramamoorthi and Mark, "Large Ray Packets for Real-time Whitted Ray Tracing", RT 2008.
#pragma once

#include "boxwood/query/kernels/frustum_block.h"
#include "boxwood/query/kernels/frustum_rays.h"
#include "boxwood/query/kernels/tree_blocks.h"
#include "boxwood/query/kernels/triangle_block.h"
#include "boxwood/query/kernels/wide_walk.h"

namespace boxwood {

template <class S>
class Frustum {
public:
    static constexpr int N = S::kWidth;
    static constexpr std::size_t kRays = FrustumRays<S>::kRays;
    /// Triangles are remembered by their place in the tree, in 32 bits.
    static constexpr std::uint64_t kLargestTree = (std::uint64_t{1} << 32) / N * kReferenceUnit;

    BOXWOOD_KERNEL explicit Frustum(const WideTreeView& tree) : tree_(tree) {}

    /// Takes in kRays rays; false when they can't be a group.
    BOXWOOD_KERNEL bool load(const Rayf* rays) {
        if (!rays_.load(tree_, rays)) return false;
        for (int packet = 0; packet < N; ++packet) {
            const Float t_max = S::load(rays_.t_max[packet]);
            S::store(t_[packet], t_max);
            S::store_unaligned(triangle_[packet], S::broadcast_integer(Hitf::kNone));
            hit_[packet] = taken_[packet] = 0;
            if (rays_.is_endless) {
                S::store(near_[packet], S::broadcast(0));
                S::store(surely_near_[packet], S::broadcast(0));
                nearest_[packet] = 0;
                far_[packet] = __builtin_inff();
            } else {
                const Float nearest = S::broadcast(1) / (t_max * S::load(rays_.depth[packet]));
                S::store(near_[packet], nearest * S::broadcast(1 - kDepthRounding));
                S::store(surely_near_[packet], nearest * S::broadcast(1 + kDepthRounding));
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

    BOXWOOD_KERNEL void write(Hitf* hits) {
        for (int packet = 0; packet < N; ++packet) {
            if (taken_[packet] != 0) decide_taken(packet);
            write_packet(packet, hits + packet * N);
        }
    }

private:
    using Float = typename S::Float;

    static constexpr std::size_t kStepsPerBlock = 8;
    /// Of an inverse depth that is worked out from a t.
    static constexpr float kDepthRounding = 0x1p-20f;

    /// A child to visit, and whose child it is.
    struct Entry {
        WideReference reference, parent;
        std::uint32_t slot;
        float enter;  ///< where the frustum enters it, along z
    };

    /// How far along z a packet looks.
    BOXWOOD_KERNEL void set_far(int packet) {
        nearest_[packet] = S::least(FrustumRays<S>::kAll, S::load(near_[packet]));
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
        view_.look(block, rays_, packets, nearest_, group_nearest_);
        const std::uint32_t first_code = (reference & ~kLeafBit) * N;
        // Those that the linear functions leave open, of all pairs.
        std::uint8_t open[N * N + 1];
        int opens = 0;
        unsigned changed = 0;
        for (int i = 0; i < view_.pairs; ++i) {
            const int packet = view_.packet_of[i], j = view_.triangle_of[i];
            const auto at = [&](int k) {
                return view_.function(k, j, rays_.slope_x[packet], rays_.slope_y[packet]);
            };
            const Float inside = S::min(S::min(at(0), at(1)), at(2));
            const Float depth = at(3), error = S::broadcast(view_.depth_error[j]);
            const Float lo = depth - error, hi = depth + error;
            const Float near = S::load(near_[packet]), surely_near = S::load(surely_near_[packet]);
            const unsigned maybe =
                S::less_equal(S::broadcast(view_.least[j]), inside) & S::less_equal(near, hi);
            const unsigned sure =
                S::less(S::broadcast(view_.margin[j]), inside) & S::less(surely_near, lo);
            S::store(near_[packet], S::select(sure, lo, near));
            S::store(surely_near_[packet], S::select(sure, hi, surely_near));
            S::store_masked(sure, code_[packet],
                            S::broadcast_integer(first_code + static_cast<std::uint32_t>(j)));
            taken_[packet] |= sure;
            changed |= unsigned{sure != 0} << packet;
            open[opens] = static_cast<std::uint8_t>(i);
            opens += (maybe & ~sure) != 0;
        }
        for (int i = 0; i < opens; ++i)
            changed |=
                decide_open(view_.packet_of[open[i]], first_code + view_.triangle_of[open[i]]);
        if (changed != 0) {
            for (; changed != 0; changed &= changed - 1) set_far(__builtin_ctz(changed));
            set_farthest();
        }
        return static_cast<std::size_t>(view_.pairs);
    }

    /// A triangle in each lane, its corners along the axes of the group.
    struct Triangles {
        Float corner[3][3];
        alignas(64) std::uint32_t index[N];
    };

    BOXWOOD_KERNEL Triangles one_triangle(std::uint32_t code) const {
        const BlockTriangle triangle = triangle_at<N>(tree_, code / N, code % N);
        Triangles result;
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k)
                result.corner[i][k] = S::broadcast(triangle.corner[i][rays_.axis[k]]);
        }
        S::store_unaligned(result.index, S::broadcast_integer(triangle.index));
        return result;
    }

    BOXWOOD_KERNEL Triangles triangles(const std::uint32_t* codes) const {
        alignas(64) float corners[3][3][N];
        Triangles result;
        for (int lane = 0; lane < N; ++lane) {
            const BlockTriangle triangle = triangle_at<N>(tree_, codes[lane] / N, codes[lane] % N);
            for (int i = 0; i < 3; ++i) {
                for (int k = 0; k < 3; ++k) corners[i][k][lane] = triangle.corner[i][k];
            }
            result.index[lane] = triangle.index;
        }
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) result.corner[i][k] = S::load(corners[i][rays_.axis[k]]);
        }
        return result;
    }

    /// The test of single rays for a triangle that the linear functions leave open. Returns the
    /// packet's bit if any of its rays came closer.
    BOXWOOD_KERNEL unsigned decide_open(int packet, std::uint32_t code) {
        const unsigned closer = decide(packet, FrustumRays<S>::kAll, one_triangle(code));
        if (closer == 0) return 0;
        const Float nearest =
            S::broadcast(1) / (S::load(t_[packet]) * S::load(rays_.depth[packet]));
        const auto raise = [&](float* place, float by) {
            const Float old = S::load(place);
            S::store(place, S::select(closer, S::max(nearest * S::broadcast(by), old), old));
        };
        raise(near_[packet], 1 - kDepthRounding);
        raise(surely_near_[packet], 1 + kDepthRounding);
        return 1u << packet;
    }

    /// The same for the triangles that the rays surely hit.
    BOXWOOD_KERNEL void decide_taken(int packet) {
        const unsigned taken = taken_[packet];
        const std::uint32_t code = code_[packet][__builtin_ctz(taken)];
        const unsigned same = S::equal(S::load(code_[packet]), S::broadcast_integer(code));
        if ((taken & ~same) == 0) {
            decide(packet, taken, one_triangle(code));
            return;
        }
        std::uint32_t codes[N];
        for (int lane = 0; lane < N; ++lane)
            codes[lane] = taken >> lane & 1 ? code_[packet][lane] : code;
        decide(packet, taken, triangles(codes));
    }

    /// The same for some of the rays. Keeps the hits that are closer than those there are, and
    /// returns which rays have one.
    BOXWOOD_KERNEL unsigned decide(int packet, unsigned rays, const Triangles& triangles) {
        const auto& corner = triangles.corner;
        const auto sheared = [&](int i) {
            Float from[3];
            for (int k = 0; k < 3; ++k) from[k] = corner[i][k] - S::broadcast(rays_.origin[k]);
            if (rays_.all_along_z[packet])
                return ShearedCorner<S>(from[0], from[1], from[2], S::load(rays_.sx[packet]),
                                        S::load(rays_.sy[packet]));
            return ShearedCorner<S>(rays_.turned(packet, from[1], from[2], from[0]),
                                    rays_.turned(packet, from[2], from[0], from[1]),
                                    rays_.turned(packet, from[0], from[1], from[2]),
                                    S::load(rays_.sx[packet]), S::load(rays_.sy[packet]));
        };
        const ShearedCorner<S> a = sheared(0), b = sheared(1), c = sheared(2);
        const Float t = S::load(t_[packet]);
        const BlockHit<S> hit =
            intersect<S>(a, b, c, S::load(rays_.sz[packet]), S::broadcast(rays_.t_min), t);
        unsigned closer = hit.mask & rays;
        // Equal distances go to the lower triangle.
        for (unsigned ties = closer & S::equal(hit.t, t); ties != 0; ties &= ties - 1) {
            const int lane = __builtin_ctz(ties);
            if (triangle_[packet][lane] < triangles.index[lane]) closer &= ~(1u << lane);
        }
        if (closer == 0) return 0;
        const auto keep = [&](float* place, Float value) { S::store_masked(closer, place, value); };
        keep(t_[packet], hit.t);
        keep(v_[packet], hit.v);
        keep(w_[packet], hit.w);
        keep(determinant_[packet], hit.determinant);
        for (int k = 0; k < 3; ++k) {
            const int i = k == 2 ? 0 : k + 1, j = i == 2 ? 0 : i + 1;
            keep(normal_[rays_.axis[k]][packet],
                 (corner[1][i] - corner[0][i]) * (corner[2][j] - corner[0][j]) -
                     (corner[1][j] - corner[0][j]) * (corner[2][i] - corner[0][i]));
        }
        S::store_masked(closer, triangle_[packet], S::load(triangles.index));
        hit_[packet] |= closer;
        return closer;
    }

    BOXWOOD_KERNEL void write_packet(int packet, Hitf* hits) const {
        const Float zero = S::broadcast(0);
        const unsigned hit = hit_[packet];
        const auto or_zero = [&](Float x) { return S::select(hit, x, zero); };
        const Float determinant = S::load(determinant_[packet]);
        Float field[8] = {
            S::select(hit, S::load(t_[packet]) + zero, S::broadcast(__builtin_inff())),
            or_zero(S::load(v_[packet]) / determinant + zero),
            or_zero(S::load(w_[packet]) / determinant + zero),
            S::as_float(S::load(triangle_[packet])),
            or_zero(S::load(normal_[0][packet])),
            or_zero(S::load(normal_[1][packet])),
            or_zero(S::load(normal_[2][packet])),
            zero};
        S::store_records(&hits->t, field);
    }

    const WideTreeView& tree_;
    FrustumRays<S> rays_;
    BlockInView<S> view_;
    TriangleBlock<N> room_;
    // Of the group and of each packet: the least inverse depth at which a ray looks for hits, and
    // how far along z that is.
    float group_nearest_, farthest_;
    alignas(64) float nearest_[N], far_[N];
    // Of each ray of each packet: bounds of the inverse depth of the closest hit, the place of the
    // triangle that is surely hit, and the closest hit of those that had to be decided.
    alignas(64) float near_[N][N], surely_near_[N][N];
    alignas(64) std::uint32_t code_[N][N];
    alignas(64) float t_[N][N], v_[N][N], w_[N][N], determinant_[N][N], normal_[3][N][N];
    alignas(64) std::uint32_t triangle_[N][N];
    unsigned taken_[N], hit_[N];  ///< of each packet, masks of rays
    Entry stack_[kStackSize];
};

}  // namespace boxwood
