// SPDX-License-Identifier: Apache-2.0
// Does a ray hit a triangle? The watertight test: move the ray's origin to 0, shear space so that
// the ray becomes the z axis, and look on which side of each edge the axis passes in the xy plane.
// The shear treats a vertex alike in all its triangles and each edge is decided exactly, so no ray
// slips between two triangles that share an edge or a vertex. Constant time, no epsilon.
// Source: Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013.
// Explained in docs/algorithms/ray_triangle.md.
#pragma once

#include <cmath>
#include <optional>
#include <utility>

#include "boxwood/core/ray.h"
#include "boxwood/core/vec.h"

namespace boxwood {

/// The part of the test that depends on the ray alone; made once a ray.
struct ShearedRay {
    Vec3d origin;
    int kx, ky, kz;     ///< axes, renamed so that |direction[kz]| is largest
    double sx, sy, sz;  ///< the shear

    /// Precondition: is_traceable(ray).
    explicit ShearedRay(const Ray& ray) : origin(ray.origin) {
        ray.direction.cwiseAbs().maxCoeff(&kz);
        kx = (kz + 1) % 3;
        ky = (kz + 2) % 3;
        if (ray.direction[kz] < 0) std::swap(kx, ky);
        sx = ray.direction[kx] / ray.direction[kz];
        sy = ray.direction[ky] / ray.direction[kz];
        sz = 1 / ray.direction[kz];
    }

    Vec3d shear(const Vec3d& vertex) const {
        const Vec3d p = vertex - origin;
        return {p[kx] - sx * p[kz], p[ky] - sy * p[kz], sz * p[kz]};
    }
};

/// a * b - c * d with an error of at most 1.5 units in the last place, so with its exact sign.
/// Source: Jeannerod, Louvet and Muller, "Further analysis of Kahan's algorithm for the accurate
/// computation of 2x2 determinants", Math. Comp. 82, 2013.
inline double difference_of_products(double a, double b, double c, double d) {
    const double cd = c * d;
    const double rounding_of_cd = std::fma(-c, d, cd);
    return std::fma(a, b, -cd) + rounding_of_cd;
}

struct TriangleHit {
    double t, u, v;  ///< as in Hit
};

/// The hit on the triangle (a, b, c), seen from either side, edges and vertices included, with
/// t_min <= t <= t_max. No hit on triangles of zero area, on those that the ray's line lies in the
/// plane of, and where a coordinate is NaN.
inline std::optional<TriangleHit> intersect(const ShearedRay& ray, const Vec3d& vertex_a,
                                            const Vec3d& vertex_b, const Vec3d& vertex_c,
                                            double t_min, double t_max) {
    const Vec3d a = ray.shear(vertex_a);
    const Vec3d b = ray.shear(vertex_b);
    const Vec3d c = ray.shear(vertex_c);

    // Edge functions in plain arithmetic settle nearly all misses: two that surely differ in sign.
    constexpr double kRounding = 0x1p-51;
    bool some_positive = false, some_negative = false;
    const auto look_at_edge = [&](const Vec3d& p, const Vec3d& q) {
        const double pq = p.x() * q.y(), qp = p.y() * q.x();
        const double bound = kRounding * (std::abs(pq) + std::abs(qp));
        some_positive |= pq - qp > bound;
        some_negative |= pq - qp < -bound;
    };
    look_at_edge(c, b);
    look_at_edge(a, c);
    look_at_edge(b, a);
    if (some_positive & some_negative) return std::nullopt;

    const double u = difference_of_products(c.x(), b.y(), c.y(), b.x());
    const double v = difference_of_products(a.x(), c.y(), a.y(), c.x());
    const double w = difference_of_products(b.x(), a.y(), b.y(), a.x());
    const bool inside = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    const double determinant = u + v + w;
    if (!inside || determinant == 0) return std::nullopt;

    // The weights have one sign, so this is a mean of the vertices' distances, not a cancellation.
    const double t = (u * a.z() + v * b.z() + w * c.z()) / determinant;
    if (!(t_min <= t && t <= t_max)) return std::nullopt;
    return TriangleHit{t, v / determinant, w / determinant};
}

}  // namespace boxwood
