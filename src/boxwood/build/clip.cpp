// SPDX-License-Identifier: Apache-2.0
// The part of a triangle in a slab is a convex polygon. Its corners are the triangle's corners in
// the slab and the points at which edges cross the slab's faces, so its box is the box of these.
// The argument that no rounding loses a point is in docs/algorithms/spatial_split.md.
#include "boxwood/build/clip.h"

#include <cfloat>

namespace boxwood {

namespace {

/// Rounded to float, and past every double that rounds to it: by 2^-22 times itself, and by the two
/// smallest floats where that vanishes.
Eigen::Array4f margin(const Eigen::Array4f& rounded) {
    return rounded.abs() * 0x1p-22f + 2 * FLT_TRUE_MIN;
}

}  // namespace

WideBox clipped_box(MeshView mesh, std::uint32_t triangle, const WideBox& within, int axis,
                    float from, float to) {
    Eigen::Array4d corners[3];
    for (int k = 0; k < 3; ++k) corners[k] << mesh.corner(triangle, k).array(), 0;

    Eigen::Array4d lo = Eigen::Array4d::Constant(DBL_MAX), hi = -lo;
    const auto extend = [&](const Eigen::Array4d& point) {
        lo = lo.min(point);
        hi = hi.max(point);
    };
    for (int k = 0; k < 3; ++k) {
        const Eigen::Array4d &p = corners[k], &q = corners[k == 2 ? 0 : k + 1];
        if (from <= p[axis] && p[axis] <= to) extend(p);
        for (const double face : {from, to}) {
            if ((p[axis] < face && face < q[axis]) || (q[axis] < face && face < p[axis]))
                extend(p + (q - p) * ((face - p[axis]) / (q[axis] - p[axis])));
        }
    }
    const Eigen::Array4d rounding =
        0x1p-48 * corners[0].abs().max(corners[1].abs()).max(corners[2].abs());
    WideBox box;
    box.lo = (lo - rounding).cast<float>();
    box.hi = (hi + rounding).cast<float>();
    box.lo -= margin(box.lo);
    box.hi += margin(box.hi);
    box.lo[axis] = from;
    box.hi[axis] = to;
    return intersection(box, within);
}

}  // namespace boxwood
