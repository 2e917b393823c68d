// SPDX-License-Identifier: Apache-2.0
#include "laws/point_families.h"

#include <cmath>

#include "laws/random.h"

namespace boxwood {

Vec3d random_point(MeshView mesh, std::uint64_t seed) {
    Random random(seed + 7000);
    const Box3d box = bounds(mesh);
    if (mesh.faces.empty() || box.is_empty()) return random.point(-1, 1);
    // Halved first: a box may be as wide as doubles go.
    const Vec3d center = box.centroid(), half = 0.5 * box.hi - 0.5 * box.lo;
    const auto in_box = [&](double size) -> Vec3d {
        return center + half.cwiseProduct(random.point(-size, size));
    };
    const std::size_t face = random.index(mesh.faces.size());
    const int k = static_cast<int>(random.index(3));
    const Vec3d &a = mesh.corner(face, k), &b = mesh.corner(face, (k + 1) % 3),
                &c = mesh.corner(face, (k + 2) % 3);
    const double s = random.number(), t = random.number(0, 1 - s);
    const Vec3d inside = (1 - s - t) * a + s * b + t * c;
    const double size = (b - a).norm() + (c - a).norm();
    switch (seed % 10) {
        case 0:
            return in_box(1);
        case 1:
            return in_box(3);
        case 2:
            return a;
        case 3:
            return 0.5 * a + 0.5 * b;
        case 4:
            return (1 - s) * a + s * b;
        case 5:
            return inside;
        case 6:
            return inside +
                   size * std::ldexp(1.0, -static_cast<int>(random.index(50))) * random.direction();
        case 7:
            return a + size * random.direction();
        case 8:
            return in_box(1) +
                   std::ldexp(half.norm(), static_cast<int>(random.index(60))) * random.direction();
        default:
            return random.index(4) == 0 ? Vec3d(0, 0, 0) : Vec3d(center + size * Vec3d::Unit(k));
    }
}

}  // namespace boxwood
