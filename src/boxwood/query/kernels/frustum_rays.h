// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/query/kernels/candidate_error.h"
#include "boxwood/query/kernels/triangle_block.h"

namespace boxwood {

/// How far apart, of the spread of the group, the rays of a packet may be on average.
constexpr float kMostPacketSpread = 0.6f;
/// The axis of a group need not be that of each ray's largest coordinate, but almost.
constexpr float kSteepestSlope = 1.5f;

/// N packets of N rays from one point. With z the depth along one axis, a ray is the points
/// (x, y) = z (slope_x, slope_y): what is a frustum in space is a rectangle in the plane of slopes.
template <class S>
struct FrustumRays {
    static constexpr int N = S::kWidth;
    static constexpr std::size_t kRays = std::size_t{N} * N;
    static constexpr unsigned kAll = (1u << N) - 1;  ///< lanes, or packets
    using Float = typename S::Float;

    /// x, y and z of the group: everything here is in this order. z is along most of the rays.
    std::uint32_t axis[3];
    float origin[3], t_min;
    float sign;                                      ///< of the directions along kz
    float rounding;                                  ///< by which boxes are moved outward
    float coordinate_rounding;                       ///< of corners as seen from the origin
    float error;                                     ///< as CandidateTest takes it
    float least_t;                                   ///< what is there lies beyond t_min for sure
    float least_depth;                               ///< what is beyond that is beyond t_min
    float lo_x, hi_x, lo_y, hi_y;                    ///< slopes of the group
    alignas(64) float range_x[2][N], range_y[2][N];  ///< of each packet: the least, the greatest
    // Of each ray of each packet.
    alignas(64) float slope_x[N][N], slope_y[N][N];
    alignas(64) float depth[N][N];  ///< along z, for each unit of t
    alignas(64) float t_max[N][N];
    alignas(64) float sx[N][N], sy[N][N], sz[N][N];  ///< for the triangle test, along its own axes
    bool is_endless;                                 ///< t_max is infinite for all
    bool all_along_z[N];              ///< of each packet: all rays are longest along z
    unsigned along_x[N], along_y[N];  ///< or else which are longest along x, along y

    /// Takes in kRays rays; false when they don't share an origin and t_min >= 0, or go apart.
    /// Calls meanwhile(first, count) for the rays of each packet.
    template <class Meanwhile>
    BOXWOOD_KERNEL bool load(const WideTreeView& tree, const Rayf* rays,
                             const Meanwhile& meanwhile) {
        const Rayf& first = rays[0];
        if (!(first.t_min >= 0) || !is_traceable<typename S::Quad>(first)) return false;
        RaySetup setup;
        setup.template set<typename S::Quad>(first, tree);
        axis[0] = setup.kx;
        axis[1] = setup.ky;
        axis[2] = setup.kz;
        for (int k = 0; k < 3; ++k) origin[k] = first.origin[axis[k]];
        t_min = setup.t_min;
        // More than the bound for single rays: rays are followed here by their slopes, which are
        // rounded.
        rounding = 3 * setup.rounding;
        coordinate_rounding = 0x1p-4f * setup.rounding;
        error = candidate_error(setup);
        least_t = surely_beyond(t_min, error);
        sign = first.direction[axis[2]] < 0 ? -1.0f : 1.0f;

        is_endless = true;
        unsigned fits = kAll;
        for (int packet = 0; packet < N; ++packet) {
            fits &= load_packet(packet, rays + packet * N, first);
            meanwhile(static_cast<std::size_t>(packet) * N, N);
        }
        return fits == kAll && find_ranges();
    }

    /// A corner, given from the origin along the axes of the group, as the rays of a packet see it.
    BOXWOOD_KERNEL ShearedCorner<S> sheared(int packet, Float x, Float y, Float z) const {
        if (all_along_z[packet])
            return ShearedCorner<S>(x, y, z, S::load(sx[packet]), S::load(sy[packet]));
        return ShearedCorner<S>(turned(packet, y, z, x), turned(packet, z, x, y),
                                turned(packet, x, y, z), S::load(sx[packet]), S::load(sy[packet]));
    }

    /// Of x, y and z the one from which on they are the axes of a ray.
    BOXWOOD_KERNEL int first_axis(int packet, int ray) const {
        if (all_along_z[packet]) return 0;
        return static_cast<int>((along_x[packet] >> ray & 1) + 2 * (along_y[packet] >> ray & 1));
    }

    /// What rays of a packet take that are longest along x, along y and along z. Precondition: not
    /// all_along_z.
    BOXWOOD_KERNEL Float turned(int packet, Float by_x, Float by_y, Float by_z) const {
        return S::select(along_x[packet], by_x, S::select(along_y[packet], by_y, by_z));
    }

    /// Of points at t on the rays of a packet.
    BOXWOOD_KERNEL Float inverse_depth(int packet, Float t) const {
        return S::broadcast(1) / (t * S::load(depth[packet]));
    }

private:
    /// Returns which lanes hold rays that fit the first.
    BOXWOOD_KERNEL unsigned load_packet(int packet, const Rayf* rays, const Rayf& first) {
        Float record[8];
        S::load_records(rays[0].origin, record);
        alignas(64) float directions[3][N];
        for (int k = 0; k < 3; ++k) S::store(directions[k], record[4 + k]);
        Float d[3], size[3];
        for (int k = 0; k < 3; ++k) {
            d[k] = S::load(directions[axis[k]]);
            size[k] = S::max(d[k], -d[k]);
        }
        const Float longest = S::max(S::max(size[0], size[1]), size[2]);
        const Float forward = d[2] * S::broadcast(sign);
        unsigned fits = S::equal(record[3], S::broadcast(t_min)) &
                        S::less_equal(record[3], record[7]) &
                        S::less_equal(S::broadcast(kShortestDirection), longest) &
                        S::less_equal(longest, S::broadcast(kLongestDirection)) &
                        S::less_equal(longest, forward * S::broadcast(kSteepestSlope));
        for (int k = 0; k < 3; ++k) fits &= S::equal(record[k], S::broadcast(first.origin[k]));

        const Float inverse = S::broadcast(1) / forward;
        const Float x_slope = d[0] * inverse;
        const Float y_slope = d[1] * inverse;
        S::store(slope_x[packet], x_slope);
        S::store(slope_y[packet], y_slope);
        S::store(depth[packet], forward);
        S::store(t_max[packet], record[7]);
        // Of equally large axes the first counts, as for single rays.
        const auto is_longer = [&](int a, int b) {
            return axis[a] < axis[b] ? kAll & ~S::less(size[a], size[b])
                                     : S::less(size[b], size[a]);
        };
        const unsigned longest_x = is_longer(0, 1) & is_longer(0, 2);
        const unsigned longest_y = is_longer(1, 0) & is_longer(1, 2);
        all_along_z[packet] = (longest_x | longest_y) == 0;
        if (all_along_z[packet]) {
            // The same bits as below.
            S::store(sx[packet], x_slope * S::broadcast(sign));
            S::store(sy[packet], y_slope * S::broadcast(sign));
            S::store(sz[packet], inverse * S::broadcast(sign));
        } else {
            along_x[packet] = longest_x;
            along_y[packet] = longest_y;
            const Float shear_z = S::broadcast(1) / turned(packet, d[0], d[1], d[2]);
            S::store(sx[packet], turned(packet, d[1], d[2], d[0]) * shear_z);
            S::store(sy[packet], turned(packet, d[2], d[0], d[1]) * shear_z);
            S::store(sz[packet], shear_z);
        }
        is_endless &= S::equal(record[7], S::broadcast(__builtin_inff())) == kAll;
        range_x[0][packet] = S::least(kAll, x_slope);
        range_x[1][packet] = S::greatest(x_slope);
        range_y[0][packet] = S::least(kAll, y_slope);
        range_y[1][packet] = S::greatest(y_slope);
        return fits;
    }

    /// Finds the rectangle around all slopes; false when the rays of the packets are no closer
    /// together than those of the group.
    BOXWOOD_KERNEL bool find_ranges() {
        lo_x = S::least(kAll, S::load(range_x[0]));
        hi_x = S::greatest(S::load(range_x[1]));
        lo_y = S::least(kAll, S::load(range_y[0]));
        hi_y = S::greatest(S::load(range_y[1]));
        float spread = 0;
        for (int packet = 0; packet < N; ++packet)
            spread += (range_x[1][packet] - range_x[0][packet]) +
                      (range_y[1][packet] - range_y[0][packet]);
        least_depth = -__builtin_inff();
        if (t_min > 0) {
            for (int packet = 0; packet < N; ++packet) {
                const float z = t_min * S::greatest(S::load(depth[packet])) * (1 + 0x1p-18f);
                if (z > least_depth) least_depth = z;
            }
        }
        const float group_spread = (hi_x - lo_x) + (hi_y - lo_y);
        return spread <= kMostPacketSpread * N * group_spread + 1e-6f;
    }
};

}  // namespace boxwood
