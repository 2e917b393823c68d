// SPDX-License-Identifier: Apache-2.0
// What may be the closest hits of a group of rays in double: the triangle that linear functions are
// sure of, and those that they aren't. Explained in docs/algorithms/certified_hits.md.
#pragma once

#include "boxwood/query/kernels/candidates.h"
#include "boxwood/query/kernels/frustum.h"

namespace boxwood {

/// A rule of Frustum.
template <class S>
class FrustumCandidates {
public:
    static constexpr int N = S::kWidth;
    static constexpr bool kIsRounded = true;
    static constexpr int kStepsOfOpen = 12;
    static constexpr std::size_t kStepsOfRayAlone = 32;

    BOXWOOD_KERNEL FrustumCandidates(const WideTreeView& tree, const FrustumRays<S>& rays)
        : tree_(tree), rays_(rays) {}

    BOXWOOD_KERNEL void start(int packet) {
        for (Noted& noted : noted_[packet]) noted.count = 0;
    }

    BOXWOOD_KERNEL bool decide_open(int packet, std::uint32_t code, SureHits<S>& sure) {
        const BlockTriangle triangle = triangle_of_code<N>(tree_, code);
        const auto sheared = [&](int corner) {
            Float from[3];
            for (int k = 0; k < 3; ++k)
                from[k] = S::broadcast(triangle.corner[corner][rays_.axis[k]] - rays_.origin[k]);
            return rays_.sheared(packet, from[0], from[1], from[2]);
        };
        const CandidateTest<S> test(sheared(0), sheared(1), sheared(2), S::load(rays_.sz[packet]),
                                    rays_.error);
        const Float near = S::load(sure.near[packet]);
        const Float farthest = S::broadcast(1 + 0x1p-18f) / (near * S::load(rays_.depth[packet]));
        const unsigned taken =
            sure.taken[packet] & S::equal(S::load(sure.code[packet]), S::broadcast_integer(code));
        unsigned open = test.may_be_hit(rays_.t_min, farthest) & ~taken;
        if (open == 0) return false;
        const Float first = test.nearest();
        const Float depth = S::load(rays_.depth[packet]);
        const Float nearest = greatest_inverse_depth(first, depth);
        alignas(64) float greatest[N];
        S::store(greatest, nearest);
        for (unsigned rest = open; rest != 0; rest &= rest - 1) {
            const int lane = __builtin_ctz(rest);
            noted_[packet][lane].add(code, greatest[lane], sure.near[packet][lane]);
        }
        const unsigned hit =
            open & test.is_hit() & S::less_equal(S::broadcast(rays_.least_t), first);
        if (hit == 0) return false;
        const Float farthest_hit = least_inverse_depth(test.no_farther(), depth);
        const unsigned closer = hit & S::less(near, farthest_hit);
        S::store(sure.near[packet], S::select(closer, farthest_hit, near));
        S::store(sure.surely_near[packet],
                 S::select(closer, S::max(nearest, S::load(sure.surely_near[packet])),
                           S::load(sure.surely_near[packet])));
        return closer != 0;
    }

    BOXWOOD_KERNEL bool decide_ray(int packet, int ray, std::uint32_t first_code,
                                   const BlockFromOrigin<S>& block, SureHits<S>& sure) {
        const auto sheared = [&](int i) { return block.sheared(i, rays_, packet, ray); };
        const CandidateTest<S> test(sheared(0), sheared(1), sheared(2),
                                    S::broadcast(rays_.sz[packet][ray]), rays_.error);
        float& near = sure.near[packet][ray];
        const float depth = rays_.depth[packet][ray];
        unsigned open = test.may_be_hit(rays_.t_min, S::broadcast((1 + 0x1p-18f) / (near * depth)));
        // The triangle that is noted as taken is no other.
        if ((sure.taken[packet] >> ray & 1) && sure.code[packet][ray] - first_code < N)
            open &= ~(1u << (sure.code[packet][ray] - first_code));
        if (open == 0) return false;
        const Float first = test.nearest();
        alignas(64) float nearest[N], farthest_hit[N];
        S::store(nearest, greatest_inverse_depth(first, S::broadcast(depth)));
        for (unsigned rest = open; rest != 0; rest &= rest - 1) {
            const int lane = __builtin_ctz(rest);
            noted_[packet][ray].add(first_code + static_cast<std::uint32_t>(lane), nearest[lane],
                                    near);
        }
        unsigned hit = open & test.is_hit() & S::less_equal(S::broadcast(rays_.least_t), first);
        if (hit == 0) return false;
        S::store(farthest_hit, least_inverse_depth(test.no_farther(), S::broadcast(depth)));
        bool is_closer = false;
        for (; hit != 0; hit &= hit - 1) {
            const int lane = __builtin_ctz(hit);
            if (!(near < farthest_hit[lane])) continue;
            near = farthest_hit[lane];
            float& surely_near = sure.surely_near[packet][ray];
            if (surely_near < nearest[lane]) surely_near = nearest[lane];
            is_closer = true;
        }
        return is_closer;
    }

    BOXWOOD_KERNEL void write(const SureHits<S>& sure, Candidates* candidates) {
        for (int packet = 0; packet < N; ++packet) {
            for (int lane = 0; lane < N; ++lane)
                write_ray(sure, packet, lane, candidates[packet * N + lane]);
        }
    }

private:
    using Float = typename S::Float;

    /// Of what is at t or beyond, given the depth for each unit of t.
    BOXWOOD_KERNEL static Float greatest_inverse_depth(Float t, Float depth) {
        return S::select(S::less(S::broadcast(0), t),
                         S::broadcast(1) / (t * depth) * S::broadcast(1 + kDepthRounding),
                         S::broadcast(__builtin_inff()));
    }
    /// Of what is at t or before.
    BOXWOOD_KERNEL static Float least_inverse_depth(Float t, Float depth) {
        return S::broadcast(1) / (t * depth) * S::broadcast(1 - kDepthRounding);
    }

    /// The places of triangles that a ray may hit.
    struct Noted {
        static constexpr std::uint32_t kMost = Candidates::kMost - 1;

        std::uint32_t count;  ///< more than kMost: there were too many
        std::uint32_t code[kMost];
        float nearest[kMost];  ///< the greatest inverse depth

        BOXWOOD_KERNEL void add(std::uint32_t place, float inverse_depth, float near) {
            if (count == kMost) drop_hidden(near);
            if (count < kMost) {
                code[count] = place;
                nearest[count++] = inverse_depth;
            } else {
                count = kMost + 1;
            }
        }

        /// Drops those that are farther than what is hit for sure.
        BOXWOOD_KERNEL void drop_hidden(float near) {
            std::uint32_t kept = 0;
            for (std::uint32_t i = 0; i < count; ++i) {
                code[kept] = code[i];
                nearest[kept] = nearest[i];
                kept += near <= nearest[i];
            }
            count = kept;
        }
    };

    BOXWOOD_KERNEL void write_ray(const SureHits<S>& sure, int packet, int lane,
                                  Candidates& candidates) {
        Noted& noted = noted_[packet][lane];
        if (noted.count > Noted::kMost) {
            candidates.count = Candidates::kTooMany;
            return;
        }
        if (noted.count > 0) noted.drop_hidden(sure.near[packet][lane]);
        candidates.count = 0;
        const auto write = [&](std::uint32_t code) {
            candidates.triangle[candidates.count++] = triangle_of_code<N>(tree_, code).index;
        };
        if (sure.taken[packet] >> lane & 1) write(sure.code[packet][lane]);
        for (std::uint32_t i = 0; i < noted.count; ++i) write(noted.code[i]);
    }

    const WideTreeView& tree_;
    const FrustumRays<S>& rays_;
    Noted noted_[N][N];
};

}  // namespace boxwood
