// SPDX-License-Identifier: Apache-2.0
// Rays from one point, as a camera sends them: N packets of N rays walk the tree as one. A node is
// compared with the frustum around all of them, one box on the stack with the N frusta around the
// packets, a triangle first with these and then, with the test that single rays use, with the rays
// of the packets that it may be seen by. So a box or a triangle is fetched once for many rays.
// With z the depth along the largest axis of direction, a ray is the points (x, y) = z (sx, sy),
// and (sx, sy) is the shear of the triangle test: what is a frustum in space is a rectangle there,
// and the edge functions of a triangle are linear in it. All bounds have room for all rounding.
// Explained in docs/algorithms/frustum.md. Sources: Reshetov, Soupikov and Hurley, "Multi-Level Ray
// Tracing Algorithm", SIGGRAPH 2005; Overbeck, Ramamoorthi and Mark, "Large Ray Packets for
// Real-time Whitted Ray Tracing", RT 2008.
#pragma once

#include "boxwood/core/simd_compress.h"
#include "boxwood/query/kernels/hit_record.h"
#include "boxwood/query/kernels/triangle_block.h"
#include "boxwood/query/kernels/wide_walk.h"

namespace boxwood {

/// How far apart, of the spread of the group, the rays of a packet may be on average.
constexpr float kMostPacketSpread = 0.6f;

template <class S>
class Frustum {
public:
    static constexpr int N = S::kWidth;
    static constexpr std::size_t kRays = std::size_t{N} * N;

    BOXWOOD_KERNEL explicit Frustum(const WideTreeView& tree) : tree_(tree) {}

    /// Takes in kRays rays; false when they don't share an origin, t_min >= 0 and the axis and sign
    /// of their largest coordinate, or are scattered.
    BOXWOOD_KERNEL bool load(const Rayf* rays) {
        const Rayf& first = rays[0];
        if (!(first.t_min >= 0) || !is_traceable(first)) return false;
        RaySetup setup;
        setup.template set<typename S::Quad>(first, tree_);
        kx_ = setup.kx;
        ky_ = setup.ky;
        kz_ = setup.kz;
        ox_ = setup.ox;
        oy_ = setup.oy;
        oz_ = setup.oz;
        t_min_ = setup.t_min;
        // Twice the bound for single rays: rays are followed here by their shear, which is rounded.
        rounding_ = 2 * setup.rounding;
        sign_ = first.direction[kz_] < 0 ? -1.0f : 1.0f;

        unsigned fits = kAllLanes;
        for (int packet = 0; packet < N; ++packet)
            fits &= load_packet(packet, rays + packet * N, first);
        return fits == kAllLanes && bound_packets();
    }

    /// Returns how many pairs of a packet and a triangle had to be tested.
    BOXWOOD_KERNEL std::size_t run() {
        std::size_t pairs = 0;
        WideReference current = 0;
        unsigned packets = kAllPackets;
        int size = 0;
        for (;;) {
            if (is_leaf(current)) {
                pairs += visit_block(tree_.template block<N>(current), packets);
            } else {
                size = visit_node(current, size);
            }
            do {
                if (size == 0) return pairs;
                const Entry& entry = stack_[--size];
                current = entry.reference;
                packets = entry.enter <= farthest_ ? packets_that_see(entry) : 0;
            } while (packets == 0);
        }
    }

    BOXWOOD_KERNEL void write(Hitf* hits) const {
        const Float zero = S::broadcast(0);
        for (int packet = 0; packet < N; ++packet) {
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
            S::store_records(&hits[packet * N].t, field);
        }
    }

private:
    using Float = typename S::Float;

    static constexpr unsigned kAllLanes = (1u << N) - 1;
    static constexpr unsigned kAllPackets = kAllLanes;
    static constexpr int kFrustumStack = kStackSize;

    /// A child to visit, and whose child it is.
    struct Entry {
        WideReference reference, parent;
        std::uint32_t slot;
        float enter;  ///< where the frustum enters it, along z
    };

    /// Returns which lanes hold rays that fit the first.
    BOXWOOD_KERNEL unsigned load_packet(int packet, const Rayf* rays, const Rayf& first) {
        Float record[8];
        S::load_records(rays[0].origin, record);
        alignas(64) float direction[3][N];
        for (int k = 0; k < 3; ++k) S::store(direction[k], record[4 + k]);
        const Float x = S::load(direction[kx_]), y = S::load(direction[ky_]),
                    z = S::load(direction[kz_]);
        const Float sign = S::broadcast(sign_), depth = z * sign;
        unsigned fits =
            S::equal(record[3], S::broadcast(t_min_)) & S::less_equal(record[3], record[7]);
        for (int k = 0; k < 3; ++k) fits &= S::equal(record[k], S::broadcast(first.origin[k]));
        // Equally large axes: the first of them counts, as for single rays.
        const auto fits_beside = [&](Float other, bool comes_first) {
            const Float size = S::max(other, -other);
            return comes_first ? S::less(size, depth) : S::less_equal(size, depth);
        };
        fits &= fits_beside(x, kx_ < kz_) & fits_beside(y, ky_ < kz_) &
                S::less_equal(S::broadcast(kShortestDirection), depth) &
                S::less_equal(depth, S::broadcast(kLongestDirection));

        const Float sz = S::broadcast(1) / z;
        S::store(sx_[packet], x * sz);
        S::store(sy_[packet], y * sz);
        S::store(sz_[packet], sz);
        S::store(depth_[packet], depth);
        S::store(t_[packet], record[7]);
        for (int lane = 0; lane < N; ++lane) triangle_[packet][lane] = Hitf::kNone;
        hit_[packet] = 0;
        return fits;
    }

    /// Finds the rectangles around the shears, of the packets and of all; false when the rays of
    /// the packets are no closer together than those of the group.
    BOXWOOD_KERNEL bool bound_packets() {
        const Float sign = S::broadcast(sign_);
        for (int packet = 0; packet < N; ++packet) {
            const Float x = S::load(sx_[packet]) * sign, y = S::load(sy_[packet]) * sign;
            S::store(slope_x_[packet], x);
            S::store(slope_y_[packet], y);
            range_x_[0][packet] = S::least(kAllLanes, x);
            range_x_[1][packet] = S::greatest(x);
            range_y_[0][packet] = S::least(kAllLanes, y);
            range_y_[1][packet] = S::greatest(y);
            set_far(packet);
        }
        group_lo_x_ = S::least(kAllPackets, S::load(range_x_[0]));
        group_hi_x_ = S::greatest(S::load(range_x_[1]));
        group_lo_y_ = S::least(kAllPackets, S::load(range_y_[0]));
        group_hi_y_ = S::greatest(S::load(range_y_[1]));
        farthest_ = S::greatest(S::load(far_));
        float spread = 0;
        for (int packet = 0; packet < N; ++packet)
            spread += (range_x_[1][packet] - range_x_[0][packet]) +
                      (range_y_[1][packet] - range_y_[0][packet]);
        const float group_spread = (group_hi_x_ - group_lo_x_) + (group_hi_y_ - group_lo_y_);
        return spread <= kMostPacketSpread * N * group_spread + 1e-6f;
    }

    /// How far along z a packet looks.
    BOXWOOD_KERNEL void set_far(int packet) {
        const Float z = S::load(t_[packet]) * S::load(depth_[packet]);
        far_[packet] = S::greatest(z) * (1 + 0x1p-18f);
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
        const Float ox_lo = S::broadcast(ox_ + rounding_), ox_hi = S::broadcast(ox_ - rounding_);
        const Float oy_lo = S::broadcast(oy_ + rounding_), oy_hi = S::broadcast(oy_ - rounding_);
        const float* near_face = sign_ > 0 ? node.slabs[kz_].lo : node.slabs[kz_].hi;
        const float* far_face = sign_ > 0 ? node.slabs[kz_].hi : node.slabs[kz_].lo;
        const Float oz = S::broadcast(oz_), sign = S::broadcast(sign_);
        const Float rounding = S::broadcast(rounding_), zero = S::broadcast(0);
        const Float near = S::max((S::load(near_face) - oz) * sign - rounding, zero);
        const Float far = (S::load(far_face) - oz) * sign + rounding;
        const Float lo_x = S::load(node.slabs[kx_].lo) - ox_lo;
        const Float hi_x = S::load(node.slabs[kx_].hi) - ox_hi;
        const Float lo_y = S::load(node.slabs[ky_].lo) - oy_lo;
        const Float hi_y = S::load(node.slabs[ky_].hi) - oy_hi;
        unsigned hit = S::less_equal(near, S::min(far, S::broadcast(farthest_))) &
                       S::less_equal(lo_x, most(S::broadcast(group_hi_x_), near, far)) &
                       S::less_equal(least(S::broadcast(group_lo_x_), near, far), hi_x) &
                       S::less_equal(lo_y, most(S::broadcast(group_hi_y_), near, far)) &
                       S::less_equal(least(S::broadcast(group_lo_y_), near, far), hi_y);
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
        const float far_face = sign_ > 0 ? node.slabs[kz_].hi[i] : node.slabs[kz_].lo[i];
        const Float near = S::broadcast(entry.enter);
        const Float far = S::broadcast((far_face - oz_) * sign_ + rounding_);
        const Float lo_x = S::broadcast(node.slabs[kx_].lo[i] - (ox_ + rounding_));
        const Float hi_x = S::broadcast(node.slabs[kx_].hi[i] - (ox_ - rounding_));
        const Float lo_y = S::broadcast(node.slabs[ky_].lo[i] - (oy_ + rounding_));
        const Float hi_y = S::broadcast(node.slabs[ky_].hi[i] - (oy_ - rounding_));
        return S::less_equal(near, S::load(far_)) &
               S::less_equal(lo_x, most(S::load(range_x_[1]), near, far)) &
               S::less_equal(least(S::load(range_x_[0]), near, far), hi_x) &
               S::less_equal(lo_y, most(S::load(range_y_[1]), near, far)) &
               S::less_equal(least(S::load(range_y_[0]), near, far), hi_y);
    }

    /// The corners of the triangles of a block from the origin.
    struct Corners {
        alignas(64) float x[3][N], y[3][N], z[3][N];
    };

    /// What the edge functions of the triangles of a block are in the plane of slopes: twice that
    /// of edge i of triangle j is x[i][j] sx + y[i][j] sy + w[i][j], and for a ray that hits the
    /// triangle not less than least[j].
    struct Edges {
        alignas(64) float x[3][N], y[3][N], w[3][N], least[N];
        alignas(64) float nearest[N];  ///< depth of the triangle
    };

    BOXWOOD_KERNEL std::size_t visit_block(const TriangleBlock<N>& block, unsigned packets) {
        Corners from;
        Float x[3], y[3], z[3];
        for (int i = 0; i < 3; ++i) {
            x[i] = S::load(block.corner[i][kx_]) - S::broadcast(ox_);
            y[i] = S::load(block.corner[i][ky_]) - S::broadcast(oy_);
            z[i] = S::load(block.corner[i][kz_]) - S::broadcast(oz_);
            S::store(from.x[i], x[i]);
            S::store(from.y[i], y[i]);
            S::store(from.z[i], z[i]);
        }
        // Pairs of a triangle and a packet that may see it.
        std::uint8_t triangle_of[N * N + 16], packet_of[N * N + 16];
        for (int i = 0; i < 3; ++i) z[i] = z[i] * S::broadcast(sign_);
        Edges edges;
        const int pairs = find_pairs(x, y, z, packets, edges, triangle_of, packet_of);
        unsigned changed = 0;
        for (int i = 0; i < pairs; ++i)
            changed |= visit_pair(block, from, edges, triangle_of[i], packet_of[i]);
        if (changed == 0) return static_cast<std::size_t>(pairs);
        for (; changed != 0; changed &= changed - 1) set_far(__builtin_ctz(changed));
        farthest_ = S::greatest(S::load(far_));
        return static_cast<std::size_t>(pairs);
    }

    /// The corners' places from the origin, their depths z positive in front of it.
    BOXWOOD_KERNEL int find_pairs(const Float (&x)[3], const Float (&y)[3], const Float (&z)[3],
                                  unsigned packets, Edges& edges, std::uint8_t* triangle_of,
                                  std::uint8_t* packet_of) const {
        // Twice the edge function of the corners p, q at (sx, sy) is ex sx + ey sy + ew, with
        // e = (q - p) x (q + p): the difference keeps it accurate where the sum is large.
        Float edge_size = S::broadcast(0), corner_size = S::broadcast(0);
        const auto size = [](Float a) { return S::max(a, -a); };
        Float e[3][3];
        for (int i = 0; i < 3; ++i) {
            const int p = i == 2 ? 0 : i + 1, q = p == 2 ? 0 : p + 1;
            const Float dx = x[q] - x[p], dy = y[q] - y[p], dz = z[q] - z[p];
            const Float mx = x[q] + x[p], my = y[q] + y[p], mz = z[q] + z[p];
            e[i][0] = dy * mz - dz * my;
            e[i][1] = dz * mx - dx * mz;
            e[i][2] = dx * my - dy * mx;
            edge_size = S::max(edge_size, S::max(S::max(size(dx), size(dy)), size(dz)));
            corner_size = S::max(corner_size, S::max(S::max(size(x[i]), size(y[i])), size(z[i])));
        }
        // Rays that hit a triangle in front of the origin see it from the side on which the origin
        // lies: that makes the sign of all its edge functions.
        const Float volume = (x[0] * e[0][0] + y[0] * e[0][1]) + z[0] * e[0][2];
        const Float margin = S::broadcast(0x1p-16f) * edge_size * corner_size;
        // The volume is wrong by less than this; where its sign isn't sure, nothing is left out.
        const Float doubt = S::broadcast(0x1p-17f) * edge_size * corner_size * corner_size;
        const unsigned sure = S::less(doubt, size(volume));
        const unsigned positive = S::less(S::broadcast(0), volume);
        const Float front = S::min(S::min(z[0], z[1]), z[2]) - S::broadcast(rounding_);
        const Float least = S::select(sure, -margin, S::broadcast(-__builtin_inff()));
        const Float flip = S::select(positive, S::broadcast(1), S::broadcast(-1));
        S::store(edges.nearest, front);
        S::store(edges.least, least);
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) e[i][k] = e[i][k] * flip;
            S::store(edges.x[i], e[i][0]);
            S::store(edges.y[i], e[i][1]);
            S::store(edges.w[i], e[i][2]);
        }
        const auto most_over = [](Float a, Float b, Float c, Float lo_x, Float hi_x, Float lo_y,
                                  Float hi_y) {
            return (S::max(a * lo_x, a * hi_x) + S::max(b * lo_y, b * hi_y)) + c;
        };
        unsigned triangles = S::less_equal(front, S::broadcast(farthest_));
        for (int i = 0; i < 3; ++i) {
            const Float most = most_over(e[i][0], e[i][1], e[i][2], S::broadcast(group_lo_x_),
                                         S::broadcast(group_hi_x_), S::broadcast(group_lo_y_),
                                         S::broadcast(group_hi_y_));
            triangles &= S::less_equal(least, most);
        }
        // An edge function is largest where x is, if it rises with it, else where x is least.
        unsigned rises_x[3], rises_y[3];
        for (int i = 0; i < 3; ++i) {
            rises_x[i] = S::less(S::broadcast(0), e[i][0]);
            rises_y[i] = S::less(S::broadcast(0), e[i][1]);
        }
        int pairs = 0;
        for (; triangles != 0; triangles &= triangles - 1) {
            const int j = __builtin_ctz(triangles);
            unsigned seen = packets & S::less_equal(S::broadcast(edges.nearest[j]), S::load(far_));
            for (int i = 0; i < 3; ++i) {
                const float* x_most = range_x_[rises_x[i] >> j & 1];
                const float* y_most = range_y_[rises_y[i] >> j & 1];
                seen &= S::less_equal(S::broadcast(edges.least[j]),
                                      edge_function(edges, i, j, x_most, y_most));
            }
            pairs = append(seen, j, pairs, triangle_of, packet_of);
        }
        return pairs;
    }

    BOXWOOD_KERNEL static Float edge_function(const Edges& edges, int i, int j, const float* x,
                                              const float* y) {
        return S::multiply_add(
            S::broadcast(edges.x[i][j]), S::load(x),
            S::multiply_add(S::broadcast(edges.y[i][j]), S::load(y), S::broadcast(edges.w[i][j])));
    }

    /// Adds the pairs of triangle j and the packets of a mask, eight at a time, without a branch.
    BOXWOOD_KERNEL static int append(unsigned packets, int j, int pairs, std::uint8_t* triangle_of,
                                     std::uint8_t* packet_of) {
        constexpr std::uint64_t kEachByte = 0x0101010101010101u;
        const std::uint64_t triangle = static_cast<std::uint64_t>(j) * kEachByte;
        for (std::uint64_t first = 0; first < N; first += 8) {
            const unsigned mask = packets >> first & 255;
            std::uint64_t lanes;
            __builtin_memcpy(&lanes, kCompressLanes.of[mask], sizeof(lanes));
            lanes += first * kEachByte;
            __builtin_memcpy(packet_of + pairs, &lanes, sizeof(lanes));
            __builtin_memcpy(triangle_of + pairs, &triangle, sizeof(triangle));
            pairs += __builtin_popcount(mask);
        }
        return pairs;
    }

    /// All rays of a packet against one triangle. Returns the packet's bit if any came closer.
    BOXWOOD_KERNEL unsigned visit_pair(const TriangleBlock<N>& block, const Corners& from,
                                       const Edges& edges, int j, int packet) {
        const auto edge = [&](int i) {
            return edge_function(edges, i, j, slope_x_[packet], slope_y_[packet]);
        };
        const Float inside = S::min(S::min(edge(0), edge(1)), edge(2));
        if (S::less_equal(S::broadcast(edges.least[j]), inside) == 0) return 0;

        const Float sx = S::load(sx_[packet]), sy = S::load(sy_[packet]);
        const auto corner = [&](int i) {
            return ShearedCorner<S>(S::broadcast(from.x[i][j]), S::broadcast(from.y[i][j]),
                                    S::broadcast(from.z[i][j]), sx, sy);
        };
        const Float t = S::load(t_[packet]);
        const BlockHit<S> hit = intersect<S, true>(corner(0), corner(1), corner(2),
                                                   S::load(sz_[packet]), S::broadcast(t_min_), t);
        if (hit.mask == 0) return 0;
        const std::uint32_t triangle = block.triangle[j];
        unsigned closer = hit.mask;
        // Equal distances go to the lower triangle.
        for (unsigned ties = hit.mask & S::equal(hit.t, t); ties != 0; ties &= ties - 1) {
            const int lane = __builtin_ctz(ties);
            if (triangle_[packet][lane] < triangle) closer &= ~(1u << lane);
        }
        S::store(t_[packet], S::select(closer, hit.t, t));
        const auto keep = [&](float* place, Float value) { S::store_masked(closer, place, value); };
        keep(v_[packet], hit.v);
        keep(w_[packet], hit.w);
        keep(determinant_[packet], hit.determinant);
        float ab[3], ac[3];
        for (int k = 0; k < 3; ++k) {
            ab[k] = block.corner[1][k][j] - block.corner[0][k][j];
            ac[k] = block.corner[2][k][j] - block.corner[0][k][j];
        }
        for (int k = 0; k < 3; ++k) {
            const int a = k == 2 ? 0 : k + 1, b = a == 2 ? 0 : a + 1;
            keep(normal_[k][packet], S::broadcast(ab[a] * ac[b] - ab[b] * ac[a]));
        }
        S::store_masked(closer, triangle_[packet], triangle);
        hit_[packet] |= closer;
        return closer != 0 ? 1u << packet : 0;
    }

    BOXWOOD_KERNEL static float smaller(float a, float b) { return a < b ? a : b; }
    BOXWOOD_KERNEL static float larger(float a, float b) { return a < b ? b : a; }

    const WideTreeView& tree_;
    std::uint32_t kx_, ky_, kz_;
    float ox_, oy_, oz_, t_min_, rounding_, sign_;
    float group_lo_x_, group_hi_x_, group_lo_y_, group_hi_y_;
    float farthest_;  ///< how far along z any ray looks
    // Of each packet.
    alignas(64) float range_x_[2][N], range_y_[2][N];  ///< of slopes: the least, the greatest
    alignas(64) float far_[N];
    // Of each ray of each packet.
    alignas(64) float sx_[N][N], sy_[N][N], sz_[N][N], t_[N][N];
    alignas(64) float slope_x_[N][N], slope_y_[N][N];  ///< sx and sy against depth
    alignas(64) float depth_[N][N];                    ///< along z, for each unit of t
    alignas(64) float v_[N][N], w_[N][N], determinant_[N][N], normal_[3][N][N];
    alignas(64) std::uint32_t triangle_[N][N];
    unsigned hit_[N];  ///< of each packet: which rays hit something
    Entry stack_[kFrustumStack];
};

}  // namespace boxwood
