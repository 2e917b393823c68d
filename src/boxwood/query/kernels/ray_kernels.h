// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "boxwood/core/simd.h"
#include "boxwood/query/ray_columns.h"
#include "boxwood/query/rayf.h"
#include "boxwood/query/wide_counts.h"
#include "boxwood/query/wide_node.h"

namespace boxwood {

/// What a walk calls with triangles that can't be left out, those that the mask names. Returns the
/// distance beyond which nothing is of interest any more; minus infinity ends the walk.
struct CandidateVisitor {
    void* context;
    float (*visit)(void* context, const std::uint32_t* triangles, unsigned mask) noexcept;
};

/// What a walk along a ray calls with those triangles of a leaf that can't be left out, which the
/// mask names: their indices and corners as in query/wide_node.h, for a leaf of that width.
struct LeafVisitor {
    void* context;
    float (*visit)(void* context, const std::uint32_t* triangles, const float* corners, int width,
                   unsigned mask) noexcept;
};

/// Rays in double as the tree sees them: see near_ray.h. Arrays that are equally long.
struct CandidateRays {
    const Rayf* ray;
    const float* extra_rounding;  ///< how far off it may be besides its own rounding
    const std::uint32_t* skip;    ///< a triangle that it doesn't see

    BOXWOOD_KERNEL CandidateRays from(std::size_t begin) const {
        return {ray + begin, extra_rounding + begin, skip + begin};
    }
};

/// Triangles one of which is the answer, or none, decided in double; some may be there twice.
struct Candidates {
    static constexpr std::uint32_t kMost = 7;
    static constexpr std::uint32_t kTooMany = kMost + 1;  ///< what the triangles are isn't told
    static constexpr std::uint32_t kSureHit = kMost + 2;  ///< the ray hits something for sure

    std::uint32_t count;
    std::uint32_t triangle[kMost];
};

/// A point near which walk_near_triangles() looks for triangles.
struct PointQuery {
    float point[3];
    float margin;    ///< a bound on what rounding of coordinates does to two distances
    float reach;     ///< a bound on the coordinates of what is seen from the point
    float farthest;  ///< how near one is known to be, or must be; at most 2^60
    /// How many times as far as another a triangle has to be to be farther for sure, where
    /// distances are meant in other coordinates than the tree's.
    float spread = 1;
};

/// A box that walk_overlaps() looks for triangles in, rounded outward.
struct BoxQuery {
    float lo[3], hi[3];
};

/// The kernels of one instruction set.
struct RayKernels {
    void (*closest_hit)(const WideTreeView& tree, const Rayf& ray, Hitf& result) noexcept;
    bool (*any_hit)(const WideTreeView& tree, const Rayf& ray) noexcept;
    void (*closest_hits)(const WideTreeView& tree, const Rayf* rays, Hitf* hits,
                         std::size_t count) noexcept;
    void (*any_hits)(const WideTreeView& tree, const Rayf* rays, bool* hits,
                     std::size_t count) noexcept;
    void (*closest_hits_in_columns)(const WideTreeView& tree, const RayColumns& rays,
                                    const HitColumns& hits) noexcept;
    void (*any_hits_in_columns)(const WideTreeView& tree, const RayColumns& rays,
                                bool* hits) noexcept;
    void (*walk_candidates)(const WideTreeView& tree, const Rayf& ray, float extra_rounding,
                            const LeafVisitor& visitor) noexcept;
    /// What may be the closest hits of rays, and what may be any hits, or surely is one.
    /// Precondition: the tree needs no more than kWavefrontStack places.
    void (*closest_candidates)(const WideTreeView& tree, const CandidateRays& rays,
                               Candidates* candidates, std::size_t count) noexcept;
    void (*any_candidates)(const WideTreeView& tree, const CandidateRays& rays,
                           Candidates* candidates, std::size_t count) noexcept;
    /// Visits each triangle that may be the nearest to the point and no farther than
    /// query.farthest. A visit returns the distance of the nearest so far, or beyond which nothing
    /// is of interest.
    void (*walk_near_triangles)(const WideTreeView& tree, const PointQuery& query,
                                const CandidateVisitor& visitor) noexcept;
    /// Visits each triangle that may touch the box, until a visit returns less than 0.
    void (*walk_overlaps)(const WideTreeView& tree, const BoxQuery& box,
                          const CandidateVisitor& visitor) noexcept;
    void (*closest_hit_counted)(const WideTreeView& tree, const Rayf& ray, Hitf& result,
                                WideCounts& counts) noexcept;
    bool (*any_hit_counted)(const WideTreeView& tree, const Rayf& ray, WideCounts& counts) noexcept;
};

// One of these a source file, compiled for that instruction set alone.
const RayKernels& scalar_kernels();
const RayKernels& sse4_kernels();
const RayKernels& avx2_kernels();
const RayKernels& avx512_kernels();
const RayKernels& neon_kernels();
const RayKernels& wasm_kernels();

/// Precondition: is_supported(set).
const RayKernels& ray_kernels(InstructionSet set);

}  // namespace boxwood
