// SPDX-License-Identifier: Apache-2.0
// The cheapest plane to cut space by, by branch and bound. The references that a plane doesn't
// touch are quickly summed up, for all planes at once. They alone give a bound from below on what
// the cut costs, and most planes are out by that. Only for the rest are triangles cut in two, the
// most promising plane first. Boxes made here only rate cuts, so nearest rounding will do; those
// that stay are made by clip.h.
#include "boxwood/build/spatial_bins.h"

#include <algorithm>
#include <array>

namespace boxwood {

namespace {

struct Bin {
    WideBox begun, ended;  ///< of the references whose first, whose last bin it is
    std::uint32_t begun_count = 0, ended_count = 0;
};
using Bins = std::array<Bin, kSpatialBins>;

/// What is left and right of a plane.
struct Sides {
    WideBox left, right;
};

/// A plane to cut by; the boxes are of what it doesn't touch, the counts include what it cuts.
struct Plane {
    float bound;
    int axis, bin;
    Sides untouched;
    std::uint32_t left_count, right_count;
};

struct Planes {
    std::array<Plane, 3 * (kSpatialBins - 1)> planes;
    std::size_t count = 0;
};

void add_planes(const Bins& bins, int axis, const Sah& sah, const Grid& grid,
                std::uint32_t references, std::uint32_t room, float limit, Planes& result) {
    std::array<WideBox, kSpatialBins> right;
    std::array<std::uint32_t, kSpatialBins> right_count;
    WideBox sum;
    std::uint32_t counted = 0;
    for (int i = kSpatialBins - 1; i > 0; --i) {
        sum.extend(bins[i].begun);
        counted += bins[i].ended_count;
        right[i] = sum;
        right_count[i] = counted;
    }
    sum = {};
    counted = 0;
    for (int i = 1; i < kSpatialBins; ++i) {
        sum.extend(bins[i - 1].ended);
        counted += bins[i - 1].begun_count;
        const std::uint32_t cut = counted + right_count[i] - references;
        if (counted == 0 || right_count[i] == 0 || cut > room) continue;
        Sides sides = {sum, right[i]};
        // What is cut reaches the plane from both sides.
        if (cut > 0) {
            const float face = grid.face(axis, i);
            sides.left.hi[axis] = std::max(sides.left.hi[axis], face);
            sides.right.lo[axis] = std::min(sides.right.lo[axis], face);
        }
        const float bound = sah.cost(sides.left, counted) + sah.cost(sides.right, right_count[i]);
        if (bound < limit)
            result.planes[result.count++] = {bound, axis, i, sides, counted, right_count[i]};
    }
}

/// The parts of a triangle on both sides of a plane. Its corner that is alone on one side is the
/// top of one part, and both have the points where the plane cuts the edges from there.
Sides cut_triangle(const std::array<Eigen::Array4f, 3>& corners, int axis, float plane) {
    const int left_corners = (corners[0][axis] < plane) | (corners[1][axis] < plane) << 1 |
                             (corners[2][axis] < plane) << 2;
    if (left_corners == 0 || left_corners == 7) {
        WideBox all;
        for (const Eigen::Array4f& corner : corners) all.extend(corner);
        return {all, all};
    }
    constexpr int kAlone[] = {0, 0, 1, 2, 2, 1, 0, 0};
    constexpr int kNext[] = {1, 2, 0};
    const int top = kAlone[left_corners];
    const Eigen::Array4f &a = corners[top], &b = corners[kNext[top]],
                         &c = corners[kNext[kNext[top]]];
    const Eigen::Array4f ab = a + (b - a) * ((plane - a[axis]) / (b[axis] - a[axis]));
    const Eigen::Array4f ac = a + (c - a) * ((plane - a[axis]) / (c[axis] - a[axis]));
    WideBox section;
    section.lo = ab.min(ac);
    section.hi = ab.max(ac);
    WideBox apex = section, base = section;
    apex.extend(a);
    base.extend(b);
    base.extend(c);
    const bool apex_is_left = (left_corners & (left_corners - 1)) == 0;
    return apex_is_left ? Sides{apex, base} : Sides{base, apex};
}

float exact_cost(MeshView mesh, std::span<const Reference> references, const Sah& sah,
                 const Grid& grid, const Plane& plane) {
    const float face = grid.face(plane.axis, plane.bin);
    Sides sides = plane.untouched;
    for (const Reference& reference : references) {
        const WideBox& box = reference.box();
        const Eigen::Array4i first = grid.bins_of(box.lo);
        const Eigen::Array4i last = grid.last_bins_of(box.hi, first);
        if (first[plane.axis] >= plane.bin || last[plane.axis] < plane.bin) continue;
        std::array<Eigen::Array4f, 3> corners;
        for (int k = 0; k < 3; ++k)
            corners[k] << mesh.corner(reference.primitive(), k).cast<float>().array(), 0;
        Sides parts = cut_triangle(corners, plane.axis, face);
        parts.left.hi[plane.axis] = parts.right.lo[plane.axis] = face;
        sides.left.extend(intersection(parts.left, box));
        sides.right.extend(intersection(parts.right, box));
    }
    return sah.cost(sides.left, plane.left_count) + sah.cost(sides.right, plane.right_count);
}

}  // namespace

SpatialSplit best_spatial_split(MeshView mesh, std::span<const Reference> references,
                                const Sah& sah, const Grid& grid, std::uint32_t room, float limit) {
    std::array<Bins, 3> binned;
    for (const Reference& reference : references) {
        const WideBox& box = reference.box();
        const Eigen::Array4i first = grid.bins_of(box.lo);
        const Eigen::Array4i last = grid.last_bins_of(box.hi, first);
        for (int axis = 0; axis < 3; ++axis) {
            Bin &begun = binned[axis][first[axis]], &ended = binned[axis][last[axis]];
            begun.begun.extend(box);
            ++begun.begun_count;
            ended.ended.extend(box);
            ++ended.ended_count;
        }
    }
    Planes candidates;
    for (int axis = 0; axis < 3; ++axis) {
        if (!grid.is_flat(axis))
            add_planes(binned[axis], axis, sah, grid, static_cast<std::uint32_t>(references.size()),
                       room, limit, candidates);
    }
    const std::span<Plane> planes(candidates.planes.data(), candidates.count);
    SpatialSplit best;
    best.cost = limit;
    for (;;) {
        const auto plane =
            std::min_element(planes.begin(), planes.end(),
                             [](const Plane& a, const Plane& b) { return a.bound < b.bound; });
        if (plane == planes.end() || !(plane->bound < best.cost)) break;
        const float cost = exact_cost(mesh, references, sah, grid, *plane);
        if (cost < best.cost) best = {cost, plane->axis, plane->bin};
        plane->bound = std::numeric_limits<float>::infinity();
    }
    return best;
}

}  // namespace boxwood
