// SPDX-License-Identifier: Apache-2.0
// The triangles of a block as a group of rays from one point sees them. In the plane of slopes the
// edge functions of a triangle are linear, and so is the inverse of its depth: one multiplication
// and addition each way tells where a ray passes. Both come with a bound on all rounding, here and
// in the test that decides, so that most rays need no more. Explained in
// docs/algorithms/frustum.md.
#pragma once

#include "boxwood/core/simd_compress.h"
#include "boxwood/query/kernels/frustum_rays.h"
#include "boxwood/query/wide_node.h"

namespace boxwood {

/// How the rays of a packet see a triangle: by how much each passes inside, and within which bounds
/// its inverse depth is.
template <class S>
struct Sight {
    typename S::Float inside, lo, hi;
};

/// A block's corners from the origin, along the axes of a group and the first two again: from each
/// of the first three on, they are along the axes of a ray.
template <class S>
struct BlockFromOrigin {
    typename S::Float corner[3][5];

    BOXWOOD_KERNEL BlockFromOrigin(const TriangleBlock<S::kWidth>& block,
                                   const FrustumRays<S>& rays) {
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 5; ++k) {
                const int axis = k % 3;
                corner[i][k] =
                    S::load(block.corner[i][rays.axis[axis]]) - S::broadcast(rays.origin[axis]);
            }
        }
    }

    /// As one ray sees it.
    BOXWOOD_KERNEL ShearedCorner<S> sheared(int i, const FrustumRays<S>& rays, int packet,
                                            int ray) const {
        const typename S::Float* along = &corner[i][rays.first_axis(packet, ray)];
        return ShearedCorner<S>(along[0], along[1], along[2], S::broadcast(rays.sx[packet][ray]),
                                S::broadcast(rays.sy[packet][ray]));
    }
};

template <class S>
struct BlockInView {
    static constexpr int N = S::kWidth;
    using Float = typename S::Float;

    /// Of triangle j, functions x[i][j] sx + y[i][j] sy + w[i][j] of the slopes: for i < 3 twice
    /// the edge functions, positive inside, and for i = 3 the inverse of its depth.
    alignas(64) float x[4][N], y[4][N], w[4][N];
    alignas(64) float margin[N];       ///< inside is sure beyond it, outside below its opposite
    alignas(64) float least[N];        ///< what that opposite is, or minus infinity
    alignas(64) float depth_error[N];  ///< of the inverse depth; infinite where nothing is sure
    /// Pairs of a triangle and a packet that may see it.
    int pairs;
    std::uint8_t triangle_of[N * N + 16], packet_of[N * N + 16];

    BOXWOOD_KERNEL Float function(int i, int j, const float* slopes_x,
                                  const float* slopes_y) const {
        return S::multiply_add(
            S::broadcast(x[i][j]), S::load(slopes_x),
            S::multiply_add(S::broadcast(y[i][j]), S::load(slopes_y), S::broadcast(w[i][j])));
    }

    BOXWOOD_KERNEL Sight<S> sight(const FrustumRays<S>& rays, int packet, int j) const {
        const auto at = [&](int k) {
            return function(k, j, rays.slope_x[packet], rays.slope_y[packet]);
        };
        const Float depth = at(3), error = S::broadcast(depth_error[j]);
        return {S::min(S::min(at(0), at(1)), at(2)), depth - error, depth + error};
    }

    /// Looks at the block. Packet p sees nothing of an inverse depth below nearest[p], none of them
    /// below group_nearest. The bounds hold for triangles and rays as they are in float or, with
    /// kIsRounded, for those in double that were rounded.
    template <bool kIsRounded>
    BOXWOOD_KERNEL void look(const TriangleBlock<N>& block, const FrustumRays<S>& rays,
                             unsigned packets, const float* nearest, float group_nearest) {
        Float px[3], py[3], pz[3];
        for (int i = 0; i < 3; ++i) {
            px[i] = S::load(block.corner[i][rays.axis[0]]) - S::broadcast(rays.origin[0]);
            py[i] = S::load(block.corner[i][rays.axis[1]]) - S::broadcast(rays.origin[1]);
            pz[i] = (S::load(block.corner[i][rays.axis[2]]) - S::broadcast(rays.origin[2])) *
                    S::broadcast(rays.sign);
        }
        // Twice the edge function of the corners p, q is e . (sx, sy, 1) with e = (q - p) x (q +
        // p): the difference keeps it accurate where the sum is large.
        const auto size = [](Float a) { return S::max(a, -a); };
        const auto largest = [&](Float a, Float b, Float c) {
            return S::max(S::max(size(a), size(b)), size(c));
        };
        Float d[3][3], e[4][3];
        Float edge_size = S::broadcast(0), corner_size = S::broadcast(0);
        for (int i = 0; i < 3; ++i) {
            const int p = i == 2 ? 0 : i + 1, q = p == 2 ? 0 : p + 1;
            const Float mx = px[q] + px[p], my = py[q] + py[p], mz = pz[q] + pz[p];
            d[i][0] = px[q] - px[p];
            d[i][1] = py[q] - py[p];
            d[i][2] = pz[q] - pz[p];
            cross(d[i][0], d[i][1], d[i][2], mx, my, mz, e[i]);
            edge_size = S::max(edge_size, largest(d[i][0], d[i][1], d[i][2]));
            corner_size = S::max(corner_size, largest(px[i], py[i], pz[i]));
        }
        // The plane n . p = volume gives the inverse depth n . (sx, sy, 1) / volume.
        Float n[3];
        cross(d[1][0], d[1][1], d[1][2], d[2][0], d[2][1], d[2][2], n);
        const Float volume = (px[0] * n[0] + py[0] * n[1]) + pz[0] * n[2];
        const Float area = edge_size * edge_size;
        // The volume is wrong by less than 2^-18 of this.
        const Float reach = corner_size * area;
        // What the rounding of corners and origin adds to that, and to edge functions.
        const Float off = S::broadcast(kIsRounded ? rays.coordinate_rounding : 0);
        const Float volume_off =
            S::broadcast(8) * off * edge_size * (edge_size + S::broadcast(4) * corner_size);
        const Float edge_off = S::broadcast(36) * off * (edge_size + corner_size);
        const Float front = S::min(S::min(pz[0], pz[1]), pz[2]) - S::broadcast(rays.rounding);
        // Below these, products have lost digits to underflow.
        const Float least_area = S::broadcast(0x1p-80f), least_volume = S::broadcast(0x1p-90f);
        unsigned sure =
            S::less(S::max(S::broadcast(0x1p-14f) * reach, least_volume), size(volume)) &
            S::less(least_area, area) & S::less_equal(S::broadcast(rays.least_depth), front);
        if constexpr (kIsRounded)
            sure &= S::less(S::broadcast(16) * volume_off, size(volume)) &
                    S::less(S::broadcast(16) * off, edge_size);
        const Float zero = S::broadcast(0), infinity = S::broadcast(__builtin_inff());
        const Float inverse = S::broadcast(1) / volume;
        for (int k = 0; k < 3; ++k) e[3][k] = S::select(sure, n[k] * inverse, zero);
        // Rays that hit a triangle in front of the origin see it from the side on which the origin
        // lies: that makes the sign of all its edge functions.
        const Float flip = S::select(S::less(zero, volume), S::broadcast(-1), S::broadcast(1));
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) e[i][k] = e[i][k] * flip;
        }
        Float most[4];
        for (int i = 0; i < 4; ++i) {
            S::store(x[i], e[i][0]);
            S::store(y[i], e[i][1]);
            S::store(w[i], e[i][2]);
            most[i] =
                (S::max(e[i][0] * S::broadcast(rays.lo_x), e[i][0] * S::broadcast(rays.hi_x)) +
                 S::max(e[i][1] * S::broadcast(rays.lo_y), e[i][1] * S::broadcast(rays.hi_y))) +
                e[i][2];
        }
        Float edge_error =
            S::max(S::broadcast(0x1p-16f) * edge_size * corner_size, S::broadcast(0x1p-96f));
        if constexpr (kIsRounded) edge_error = edge_error + edge_off;
        const Float lowest = S::select(sure, -edge_error, -infinity);
        const Float nearest_here = S::max(most[3], zero);
        Float plane_error =
            S::broadcast(0x1p-17f) * area + S::broadcast(0x1p-16f) * reach * nearest_here;
        if constexpr (kIsRounded)
            plane_error = plane_error + (S::broadcast(40) * off * edge_size +
                                         S::broadcast(1.1f) * volume_off * nearest_here);
        const Float error = S::select(sure, plane_error * size(inverse), infinity);
        S::store(margin, edge_error);
        S::store(least, lowest);
        S::store(depth_error, error);
        const unsigned triangles = S::less_equal(lowest, most[0]) & S::less_equal(lowest, most[1]) &
                                   S::less_equal(lowest, most[2]) &
                                   S::less_equal(S::broadcast(group_nearest), most[3] + error);
        find_pairs(e, triangles, rays, packets, nearest);
    }

private:
    BOXWOOD_KERNEL static void cross(Float ax, Float ay, Float az, Float bx, Float by, Float bz,
                                     Float (&result)[3]) {
        result[0] = ay * bz - az * by;
        result[1] = az * bx - ax * bz;
        result[2] = ax * by - ay * bx;
    }

    BOXWOOD_KERNEL void find_pairs(const Float (&e)[4][3], unsigned triangles,
                                   const FrustumRays<S>& rays, unsigned packets,
                                   const float* nearest) {
        // A function is largest where the slope is, if it rises with it, else where that is least.
        unsigned rises_x[4], rises_y[4];
        for (int i = 0; i < 4; ++i) {
            rises_x[i] = S::less(S::broadcast(0), e[i][0]);
            rises_y[i] = S::less(S::broadcast(0), e[i][1]);
        }
        int count = 0;
        for (; triangles != 0; triangles &= triangles - 1) {
            const int j = __builtin_ctz(triangles);
            const auto most = [&](int i) {
                return function(i, j, rays.range_x[rises_x[i] >> j & 1],
                                rays.range_y[rises_y[i] >> j & 1]);
            };
            const Float inside = S::min(S::min(most(0), most(1)), most(2));
            const unsigned seen =
                packets & S::less_equal(S::broadcast(least[j]), inside) &
                S::less_equal(S::load(nearest), most(3) + S::broadcast(depth_error[j]));
            count = append(seen, j, count);
        }
        pairs = count;
    }

    /// Adds the pairs of triangle j and the packets of a mask, eight at a time, without a branch.
    /// Returns how many there are then.
    BOXWOOD_KERNEL int append(unsigned packets, int j, int count) {
        constexpr std::uint64_t kEachByte = 0x0101010101010101u;
        const std::uint64_t triangle = static_cast<std::uint64_t>(j) * kEachByte;
        for (std::uint64_t first = 0; first < N; first += 8) {
            const unsigned mask = packets >> first & 255;
            std::uint64_t lanes;
            __builtin_memcpy(&lanes, kCompressLanes.of[mask], sizeof(lanes));
            lanes += first * kEachByte;
            __builtin_memcpy(packet_of + count, &lanes, sizeof(lanes));
            __builtin_memcpy(triangle_of + count, &triangle, sizeof(triangle));
            count += __builtin_popcount(mask);
        }
        return count;
    }
};

}  // namespace boxwood
