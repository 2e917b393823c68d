// SPDX-License-Identifier: Apache-2.0
// A ray in double precision finds its candidates in float. First it is brought near the scene: its
// origin is moved along it to where the scene is, in double, so that float can tell things there
// apart; its direction is scaled by a power of two, so that float holds it. Both are undone exactly
// or within a bound that the boxes are moved outward by. Explained in
// docs/algorithms/certified_hits.md.
#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <limits>

#include "boxwood/core/box.h"
#include "boxwood/core/float_bits.h"
#include "boxwood/core/ray.h"
#include "boxwood/core/round_outward.h"
#include "boxwood/core/vectors.h"
#include "boxwood/mesh/placed_mesh.h"
#include "boxwood/query/kernels/ray_kernels.h"
#include "boxwood/query/mesh_ray.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {

/// The ray as the tree sees it.
class NearRay {
public:
    /// The ray may be off by so much.
    explicit NearRay(const WideTree& tree, const Ray& ray, double off = 0) {
        const Vec3d size = ray.direction.cwiseAbs();
        const int exponent = exponent_of(std::max(std::max(size[0], size[1]), size[2]));
        const double shrink = power_of_two(-exponent), scale = tree.scale();
        double origin[3], direction[3];
        for (int k = 0; k < 3; ++k) {
            origin[k] = ray.origin[k];
            direction[k] = shrink * ray.direction[k];
        }
        const Vec3d away = (tree.middle() - ray.origin).cwiseAbs();
        const bool is_near = std::max(std::max(away[0], away[1]), away[2]) <= tree.near_size();
        double shift = 0;
        if (!is_near || off != 0) {
            const double off_by_shift = is_near ? 0 : move(tree, direction, origin, shift);
            extra_rounding_ = rounded_up((off_by_shift + off) * scale);
        }
        to_tree_ = power_of_two(exponent) * scale;
        beyond_ = extra_rounding_ - shift * scale;
        // From -t_min up and from t_max up.
        const Double2 ends = {(extra_rounding_ + shift * scale) - ray.t_min * to_tree_,
                              ray.t_max * to_tree_ + beyond_};
        const Float4 outward = rounded({ends, ends}, 1);
        // Stored as the vectors that they are read as: else readers wait until memory has them.
        const Float4 start = {static_cast<float>(scale * origin[0]),
                              static_cast<float>(scale * origin[1]),
                              static_cast<float>(scale * origin[2]), -outward[0]};
        const Float4 way = {static_cast<float>(direction[0]), static_cast<float>(direction[1]),
                            static_cast<float>(direction[2]), outward[1]};
        std::memcpy(ray_.origin, &start, sizeof start);
        std::memcpy(ray_.direction, &way, sizeof way);
    }

    /// From so far away that moving the origin loses all digits, no triangle can be left out.
    bool can_leave_out() const { return extra_rounding_ <= kMostRounding; }
    const Rayf& ray() const { return ray_; }
    float extra_rounding() const { return extra_rounding_; }

    /// A distance no hit at t is beyond, a unit or two in the last place from the least.
    /// Precondition: t is more than minus infinity.
    float farthest(double t) const {
        const auto nearest = static_cast<float>(t * to_tree_ + beyond_);
        return nearest + (0x1p-23f * std::abs(nearest) + FLT_MIN);
    }

private:
    /// Brings the origin near where it is far, and returns what it may be off by then. Not for most
    /// rays, so out of their way.
    __attribute__((noinline)) static double move(const WideTree& tree, const double (&direction)[3],
                                                 double (&origin)[3], double& shift) {
        // The scene is less than a diagonal away from the middle of its bounds.
        const Vec3d lo = tree.bounds().lo.cast<double>(), hi = tree.bounds().hi.cast<double>();
        const double diagonal = (hi - lo).norm();
        const Vec3d from(origin[0], origin[1], origin[2]);
        const Vec3d way(direction[0], direction[1], direction[2]);
        const double to_middle = (0.5 * lo + 0.5 * hi - from).dot(way) / way.squaredNorm();
        if (!(std::abs(to_middle) > 4 * diagonal)) return 0;
        shift = to_middle - std::copysign(2 * diagonal, to_middle);
        for (int k = 0; k < 3; ++k) origin[k] += shift * direction[k];
        return 0x1p-50 * (from.lpNorm<Eigen::Infinity>() + 2 * std::abs(shift));
    }

    static constexpr float kMostRounding = 0x1p57f;

    Rayf ray_;
    double to_tree_, beyond_;  ///< what is at t is at to_tree_ t + beyond_ in the tree, or before
    float extra_rounding_ = 0;
};

/// The ray as the tree of the mesh sees it.
inline NearRay near_ray(const MeshView& /*mesh*/, const WideTree& tree, const Ray& ray) {
    return NearRay(tree, ray);
}
/// A ray of the world as the tree of a mesh sees it that stands somewhere there.
inline NearRay near_ray(const PlacedMesh& placed, const WideTree& tree, const Ray& ray) {
    const Ray local = local_ray(*placed.placement, ray);
    constexpr double kTooFar = std::numeric_limits<double>::infinity();
    if (!is_traceable(local)) return NearRay(tree, {}, kTooFar);
    return NearRay(tree, local,
                   placed.placement->rounding(ray.origin, largest_coordinate(tree.bounds())));
}

/// What a walk calls with a Visit as its context.
template <class Visit, bool kExactCorners>
float visit_each(void* context, const std::uint32_t* triangles, const float* corners, int width,
                 unsigned mask) noexcept {
    Visit& visit = *static_cast<Visit*>(context);
    float farthest = 0;
    for (; mask != 0; mask &= mask - 1) {
        const int lane = __builtin_ctz(mask);
        farthest =
            visit(Candidate{triangles[lane], kExactCorners ? corners + lane : nullptr, width});
    }
    return farthest;
}

#if defined(__x86_64__)
// For machines whose fused multiply-add is an instruction: else it is a call to the C library. Both
// round once, so the answers are the same.

inline bool has_fused(InstructionSet set) {
    return set == InstructionSet::avx2 || set == InstructionSet::avx512;
}

/// visit_each(), and all that it calls.
template <class Visit, bool kExactCorners>
__attribute__((target("avx2,fma"), flatten)) float visit_each_fused(void* context,
                                                                    const std::uint32_t* triangles,
                                                                    const float* corners, int width,
                                                                    unsigned mask) noexcept {
    return visit_each<Visit, kExactCorners>(context, triangles, corners, width, mask);
}

/// Does some work, and all that it calls.
template <class Work>
__attribute__((target("avx2,fma"), flatten)) void work_fused(const Work& work) noexcept {
    work();
}
#endif

/// Does some work, with fused multiply-adds where the instruction set has them.
template <class Work>
void run_fused(InstructionSet set, const Work& work) noexcept {
#if defined(__x86_64__)
    if (has_fused(set)) return work_fused(work);
#endif
    (void)set;
    work();
}

template <class Visit, bool kExactCorners>
LeafVisitor leaf_visitor(InstructionSet set, Visit& visit) {
#if defined(__x86_64__)
    if (has_fused(set)) return {&visit, visit_each_fused<Visit, kExactCorners>};
#endif
    (void)set;
    return {&visit, visit_each<Visit, kExactCorners>};
}

/// Calls visit(candidate) for each triangle that the ray may hit, some twice where a builder splits
/// triangles. It returns near.farthest() of what is of interest yet; minus infinity ends the walk.
template <class Visit>
void visit_candidates(const WideTree& tree, const NearRay& near, Visit& visit) noexcept {
    const InstructionSet set = tree.instruction_set();
    const LeafVisitor visitor = tree.has_exact_corners() ? leaf_visitor<Visit, true>(set, visit)
                                                         : leaf_visitor<Visit, false>(set, visit);
    ray_kernels(set).walk_candidates(tree.view(), near.ray(), near.extra_rounding(), visitor);
}

}  // namespace boxwood
