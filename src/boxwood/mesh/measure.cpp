// SPDX-License-Identifier: Apache-2.0
// Sums of fixed blocks, added in order, so that rounding doesn't depend on who adds what.
#include <algorithm>
#include <vector>

#include "boxwood/core/parallel.h"
#include "boxwood/mesh/inspect_parts.h"

namespace boxwood {

namespace {

struct Sums {
    double area = 0;
    double volume = 0;
};

/// Tetrahedra from the origin to each face add up to the volume.
Sums sums_of(MeshView mesh, const Vec3d& origin, std::size_t begin, std::size_t end) {
    Sums sums;
    for (std::size_t i = begin; i < end; ++i) {
        if (!is_in_float_range(mesh, i)) continue;
        const Vec3d a = mesh.corner(i, 0) - origin, b = mesh.corner(i, 1) - origin,
                    c = mesh.corner(i, 2) - origin;
        sums.area += (b - a).cross(c - a).norm() / 2;
        sums.volume += a.dot(b.cross(c)) / 6;
    }
    return sums;
}

}  // namespace

void measure(MeshView mesh, MeshReport& report) {
    constexpr std::size_t kBlock = 8192;
    const std::size_t count = mesh.faces.size();
    // From the middle, for the tetrahedra to be small.
    const Vec3d origin = report.bounds.is_empty()
                             ? Vec3d(Vec3d::Zero())
                             : Vec3d((report.bounds.lo + report.bounds.hi) / 2);
    std::vector<Sums> blocks((count + kBlock - 1) / kBlock);
    parallel_for(blocks.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            blocks[i] = sums_of(mesh, origin, i * kBlock, std::min(count, (i + 1) * kBlock));
    });
    Sums all;
    for (const Sums& block : blocks) {
        all.area += block.area;
        all.volume += block.volume;
    }
    report.area = all.area;
    if (report.closed && report.flipped_edges == 0) report.volume = all.volume;
}

}  // namespace boxwood
