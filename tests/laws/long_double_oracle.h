// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "boxwood/core/ray.h"
#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// What a ray does with a triangle, found in long double and by another way than the library: by
/// the volumes that its direction spans with the edges. Unsure where moving each corner and the ray
/// by `off` times the largest coordinate may change the answer.
struct Judgement {
    enum Verdict { misses, hits, unsure } verdict = unsure;
    long double t = 0;
    long double t_error = std::numeric_limits<long double>::infinity();
};

inline Judgement judge(const Ray& ray, const Vec3d& a, const Vec3d& b, const Vec3d& c,
                       long double off) {
    using Real = long double;
    using Vec = Eigen::Matrix<Real, 3, 1>;
    const Vec o = ray.origin.cast<Real>(), d = ray.direction.cast<Real>();
    const Vec corner[3] = {a.cast<Real>() - o, b.cast<Real>() - o, c.cast<Real>() - o};
    Real size = o.cwiseAbs().maxCoeff();
    for (const Vec& p : corner) size = std::max(size, p.norm());
    const Real moved = off * size;

    Judgement judgement;
    Real determinant = 0, margins = 0;
    bool all_positive = true, all_negative = true, some_positive = false, some_negative = false;
    for (int i = 0; i < 3; ++i) {
        const Vec &p = corner[(i + 1) % 3], &q = corner[(i + 2) % 3];
        const Real volume = d.dot(q.cross(p));
        const Real margin = 2 * d.norm() * moved * (p.norm() + q.norm() + 2 * moved);
        determinant += volume;
        margins += margin;
        all_positive = all_positive && volume > margin;
        all_negative = all_negative && volume < -margin;
        some_positive = some_positive || volume > margin;
        some_negative = some_negative || volume < -margin;
    }
    const bool is_inside = all_positive || all_negative;
    if (some_positive && some_negative) judgement.verdict = Judgement::misses;
    if (!is_inside) return judgement;

    const Vec normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const Real along = d.dot(normal);
    judgement.t = corner[0].dot(normal) / along;
    // The plane moves, and it turns about the triangle's long side: weights of corners change.
    const Real longest = std::max((corner[1] - corner[0]).norm(), (corner[2] - corner[0]).norm());
    judgement.t_error = 8 * moved * normal.norm() / std::abs(along) +
                        4 * longest / d.norm() * margins / std::abs(determinant);
    if (judgement.t - judgement.t_error > ray.t_max || judgement.t + judgement.t_error < ray.t_min)
        judgement.verdict = Judgement::misses;
    else if (judgement.t + judgement.t_error < ray.t_max &&
             judgement.t - judgement.t_error > ray.t_min)
        judgement.verdict = Judgement::hits;
    return judgement;
}

}  // namespace boxwood
