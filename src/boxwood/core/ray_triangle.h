// SPDX-License-Identifier: Apache-2.0
// Does a ray hit a triangle? The watertight test: move the ray's origin to 0, shear space so that
// the ray becomes the z axis, and look on which side of each edge the axis passes in the xy plane.
// The shear treats a vertex alike in all its triangles and each edge is decided exactly, so no ray
// slips between two triangles that share an edge or a vertex. Constant time, no epsilon.
// Source: Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013.
// Explained in docs/algorithms/ray_triangle.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "boxwood/core/ray.h"
#include "boxwood/core/vec.h"

namespace boxwood {

/// Axes, renamed so that |direction[kz]| is largest and triangles keep their orientation.
struct ShearAxes {
    int kx, ky, kz;

    /// By arithmetic, as nobody could predict the branches.
    explicit ShearAxes(const Vec3d& direction) {
        const Vec3d size = direction.cwiseAbs();
        const int y = size[1] > size[0], z = size[2] > std::max(size[0], size[1]);
        kz = (y & ~z) + 2 * z;
        // Those that follow kz, two bits each.
        const int next = 0b00'10'01 >> (2 * kz) & 3, last = 0b01'00'10 >> (2 * kz) & 3;
        const int swapped = (next ^ last) & -static_cast<int>(direction[kz] < 0);
        kx = next ^ swapped;
        ky = last ^ swapped;
    }
};

/// The part of the test that depends on the ray alone; made once a ray.
struct ShearedRay : ShearAxes {
    Vec3d origin;
    double sx, sy, sz;  ///< the shear

    /// Precondition: is_traceable(ray).
    explicit ShearedRay(const Ray& ray)
        : ShearAxes(ray.direction),
          origin(ray.origin),
          sx(ray.direction[kx] / ray.direction[kz]),
          sy(ray.direction[ky] / ray.direction[kz]),
          sz(1 / ray.direction[kz]) {}

    // The coordinates of a vertex in the sheared space; p[k] is one that it has.
    template <class Point>
    double x(const Point& p) const {
        return (p[kx] - origin[kx]) - sx * (p[kz] - origin[kz]);
    }
    template <class Point>
    double y(const Point& p) const {
        return (p[ky] - origin[ky]) - sy * (p[kz] - origin[kz]);
    }
    template <class Point>
    double z(const Point& p) const {
        return sz * (p[kz] - origin[kz]);
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

/// Whether a triangle lies to one side of the ray, which is 0 in x and in y, as most do. Which side
/// nobody can predict, so there is one branch on both.
inline bool on_one_side(double a, double b, double c) {
    const int above = std::min(std::min(a, b), c) > 0;
    const int below = std::max(std::max(a, b), c) < 0;
    return above | below;
}

struct TriangleHit {
    double t, u, v;   ///< as in Hit
    bool from_front;  ///< the ray comes from where a, b, c turn counter-clockwise
};

/// A triangle in the sheared space, where the ray is 0 in x and in y.
struct ShearedTriangle {
    double ax, ay, az, bx, by, bz, cx, cy, cz;
    double at_a, at_b, at_c;  ///< edge functions: the weights of the corners, but for their sum
    double least, most;       ///< of these

    template <class Point>
    ShearedTriangle(const ShearedRay& ray, const Point& a, const Point& b, const Point& c)
        : ax(ray.x(a)),
          ay(ray.y(a)),
          az(ray.z(a)),
          bx(ray.x(b)),
          by(ray.y(b)),
          bz(ray.z(b)),
          cx(ray.x(c)),
          cy(ray.y(c)),
          cz(ray.z(c)),
          at_a(difference_of_products(cx, by, cy, bx)),
          at_b(difference_of_products(ax, cy, ay, cx)),
          at_c(difference_of_products(bx, ay, by, ax)),
          least(std::min(std::min(at_a, at_b), at_c)),
          most(std::max(std::max(at_a, at_b), at_c)) {}

    double determinant() const { return at_a + at_b + at_c; }

    /// Where the ray meets it, given that it does. Nothing where a coordinate is NaN.
    std::optional<TriangleHit> hit(double t_min, double t_max) const {
        const double sum = determinant();
        // The weights have one sign, so this is a mean of the vertices' distances, not a
        // cancellation.
        const double t = (at_a * az + at_b * bz + at_c * cz) / sum;
        if (!(t_min <= t && t <= t_max)) return std::nullopt;
        return TriangleHit{t, at_b / sum, at_c / sum, sum > 0};
    }
};

/// The hit on the triangle (a, b, c), seen from either side, edges and vertices included, with
/// t_min <= t <= t_max. No hit where a coordinate is NaN, nor on triangles that float boxes
/// couldn't tell from a point. A ray that runs in the plane of a triangle, or aims at one of zero
/// area, may hit it or not, by the rounding of the shear; it does the same every time. A Point is
/// what has coordinates as point[k].
template <class Point = Vec3d>
std::optional<TriangleHit> intersect(const ShearedRay& ray, const Point& a, const Point& b,
                                     const Point& c, double t_min, double t_max) {
    const double ax = ray.x(a), bx = ray.x(b), cx = ray.x(c);
    if (on_one_side(ax, bx, cx)) return std::nullopt;
    const double ay = ray.y(a), by = ray.y(b), cy = ray.y(c);
    if (on_one_side(ay, by, cy)) return std::nullopt;

    // Edge functions in plain arithmetic settle nearly all other misses: two surely differ in sign.
    constexpr double kRounding = 0x1p-51;
    bool some_positive = false, some_negative = false;
    const auto look_at_edge = [&](double px, double py, double qx, double qy) {
        const double pq = px * qy, qp = py * qx;
        const double bound = kRounding * (std::abs(pq) + std::abs(qp));
        some_positive |= pq - qp > bound;
        some_negative |= pq - qp < -bound;
    };
    look_at_edge(cx, cy, bx, by);
    look_at_edge(ax, ay, cx, cy);
    look_at_edge(bx, by, ax, ay);
    if (some_positive & some_negative) return std::nullopt;

    const ShearedTriangle triangle(ray, a, b, c);
    // Products of coordinates that small lose their digits to underflow.
    constexpr double kLeastDeterminant = 1e-100;
    const bool is_inside = triangle.least >= 0 || triangle.most <= 0;
    if (!is_inside || std::abs(triangle.determinant()) < kLeastDeterminant) return std::nullopt;
    return triangle.hit(t_min, t_max);
}

/// Edge functions beyond it are so far from 0 that no product lost its digits to underflow: their
/// signs say what intersect() finds.
constexpr double kSureEdge = 1e-90;

/// The same, faster where the ray is likely to hit the triangle. Nobody can predict from which
/// side, so there is one branch on both.
template <class Point = Vec3d>
std::optional<TriangleHit> intersect_likely(const ShearedRay& ray, const Point& a, const Point& b,
                                            const Point& c, double t_min, double t_max) {
    const ShearedTriangle triangle(ray, a, b, c);
    const int in_front = triangle.least > kSureEdge, behind = triangle.most < -kSureEdge;
    if ((in_front | behind) != 0) return triangle.hit(t_min, t_max);
    if (triangle.least < -kSureEdge && triangle.most > kSureEdge) return std::nullopt;
    return intersect(ray, a, b, c, t_min, t_max);
}

}  // namespace boxwood
