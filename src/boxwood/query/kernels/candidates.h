// SPDX-License-Identifier: Apache-2.0
// Which triangles might a ray hit? For queries that decide in double precision: the walk of
// closest_hit.h, and at the leaves a test in float that leaves out only what the exact ray cannot
// hit on the exact triangle. What is left, one triangle in most leaves, is for the caller to test.
// Explained in docs/algorithms/certified_hits.md.
#pragma once

#include "boxwood/query/kernels/candidate_error.h"
#include "boxwood/query/kernels/closest_hit.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

/// In each lane a ray and a triangle that are less than `error` off in each sheared coordinate.
template <class S>
class CandidateTest {
public:
    using Float = typename S::Float;

    /// One ray and the triangles of a block.
    BOXWOOD_KERNEL CandidateTest(const TriangleBlock<S::kWidth>& block, const RaySetup& ray,
                                 float error)
        : CandidateTest({block.corner[0], ray}, {block.corner[1], ray}, {block.corner[2], ray},
                        S::broadcast(ray.sz), error) {}

    BOXWOOD_KERNEL CandidateTest(const ShearedCorner<S>& a, const ShearedCorner<S>& b,
                                 const ShearedCorner<S>& c, Float sz, float error)
        : error_(error) {
        u_ = c.x * b.y - c.y * b.x;
        v_ = a.x * c.y - a.y * c.x;
        w_ = b.x * a.y - b.y * a.x;
        least_ = S::min(S::min(u_, v_), w_);
        greatest_ = S::max(S::max(u_, v_), w_);
        const auto size = [](const ShearedCorner<S>& p) {
            return S::max(p.x, -p.x) + S::max(p.y, -p.y);
        };
        const Float largest = S::max(S::max(size(a), size(b)), size(c));
        margin_ = (S::broadcast(2 * error) + S::broadcast(0x1.2p-23f) * largest) * largest +
                  S::broadcast(2 * error * error);
        az_ = sz * a.z;
        bz_ = sz * b.z;
        cz_ = sz * c.z;
        first_ = S::min(S::min(az_, bz_), cz_);
        last_ = S::max(S::max(az_, bz_), cz_);
    }

    /// The lanes that may be hit within [t_min, farthest].
    BOXWOOD_KERNEL unsigned may_be_hit(float t_min, Float farthest) const {
        return (S::less_equal(-margin_, least_) | S::less_equal(greatest_, margin_)) &
               S::less_equal(first_, farthest + S::broadcast(2 * error_)) &
               S::less_equal(S::broadcast(t_min - 2 * error_), last_);
    }

    /// Those that are hit for sure, wherever that is.
    BOXWOOD_KERNEL unsigned is_hit() const {
        return S::less(margin_, least_) | S::less(greatest_, -margin_);
    }

    // A hit is as far as a mean of the corners is.
    BOXWOOD_KERNEL Float nearest() const { return first_ - S::broadcast(2 * error_); }
    BOXWOOD_KERNEL Float farthest() const { return last_ + S::broadcast(2 * error_); }
    /// Closer than farthest(), for lanes that are hit for sure.
    BOXWOOD_KERNEL Float no_farther() const {
        // Weights first, as products of three coordinates might leave the range of float.
        const Float one_by_sum = S::broadcast(1) / ((u_ + v_) + w_);
        const Float t =
            ((u_ * one_by_sum) * az_ + (v_ * one_by_sum) * bz_) + (w_ * one_by_sum) * cz_;
        const Float off = (S::broadcast(3.01f) * margin_) * S::max(one_by_sum, -one_by_sum);
        return t + off * (last_ - first_) + S::broadcast(2 * error_);
    }

    /// Of some lanes those that aren't hit before t_min for sure: a ray that starts on a surface
    /// comes to what is around it first.
    BOXWOOD_KERNEL unsigned not_before(float t_min, unsigned lanes) const {
        const Float start = S::broadcast(t_min);
        if ((lanes & S::less(first_, start)) == 0) return lanes;
        return lanes & ~(is_hit() & S::less(no_farther(), start));
    }

private:
    float error_;
    Float u_, v_, w_;         ///< edge functions
    Float least_, greatest_;  ///< of them
    Float margin_;            ///< beyond which their signs are sure
    Float az_, bz_, cz_;      ///< how far the corners are along the ray
    Float first_, last_;      ///< of them
};

template <class S>
void walk_candidates(const WideTreeView& tree, const Rayf& ray, float extra_rounding,
                     const LeafVisitor& visitor) noexcept {
    constexpr int N = S::kWidth;
    if (!is_traceable<typename S::Quad>(ray)) return;
    RaySetup setup;
    setup.set<typename S::Quad>(ray, tree, extra_rounding);
    const NodeRay<S> node_ray(setup);
    const float error = candidate_error(setup, extra_rounding);
    float farthest = ray.t_max;
    TriangleBlock<N> room;
    walk<S>(tree, setup, node_ray, farthest, [&](WideReference reference) {
        const TriangleBlock<N>& block = block_at<N>(tree, reference, room);
        const CandidateTest<S> test(block, setup, error);
        unsigned mask = test.may_be_hit(ray.t_min, S::broadcast(farthest));
        if (mask == 0) return;
        mask = test.not_before(ray.t_min, mask);
        if (mask == 0) return;
        farthest = visitor.visit(visitor.context, block.triangle, &block.corner[0][0][0], N, mask);
    });
}

}  // namespace boxwood
