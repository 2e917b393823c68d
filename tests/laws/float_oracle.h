// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>

#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/query/rayf.h"
#include "core/float_fma.h"

namespace boxwood {

/// What queries in float answer, one triangle at a time and with no vector, block, node or box in
/// it: the watertight test in float, its edge functions accurate to 1.5 units in the last place.
/// All coordinates are first multiplied by the scale, a power of two: see WideTree::scale().
class FloatOracle {
public:
    FloatOracle(MeshView mesh, const Rayf& ray, float scale = 1)
        : mesh_(mesh), ray_(ray), scale_(scale) {
        for (float& coordinate : ray_.origin) coordinate *= scale;
        ray_.t_min *= scale;
        ray_.t_max *= scale;
        const auto size = [&](int k) { return std::fabs(ray.direction[k]); };
        kz_ = size(0) >= size(1) && size(0) >= size(2) ? 0 : size(1) >= size(2) ? 1 : 2;
        kx_ = (kz_ + 1) % 3;
        ky_ = (kz_ + 2) % 3;
        sz_ = 1 / ray.direction[kz_];
        sx_ = ray.direction[kx_] * sz_;
        sy_ = ray.direction[ky_] * sz_;
    }

    std::optional<Hitf> closest_hit() const {
        std::optional<Hitf> closest;
        if (!is_traceable()) return closest;
        for (std::uint32_t i = 0; i < mesh_.faces.size(); ++i) {
            const auto hit = intersect(i);
            if (hit && (!closest || hit->t < closest->t)) closest = hit;  // on a tie the lower
        }
        return closest;
    }

private:
    struct Corner {
        float x, y, z;
    };

    bool is_traceable() const {
        float length = 0;
        for (int k = 0; k < 3; ++k) {
            if (!(std::fabs(ray_.origin[k]) <= 0x1p57f) || !std::isfinite(ray_.direction[k]))
                return false;
            length = std::max(length, std::fabs(ray_.direction[k]));
        }
        return length >= 0x1p-40f && length <= 0x1p40f && ray_.t_min <= ray_.t_max;
    }

    float scaled(double coordinate) const { return static_cast<float>(scale_ * coordinate); }

    Corner sheared(const Vec3d& p) const {
        const float z = scaled(p[kz_]) - ray_.origin[kz_];
        return {(scaled(p[kx_]) - ray_.origin[kx_]) - sx_ * z,
                (scaled(p[ky_]) - ray_.origin[ky_]) - sy_ * z, z};
    }

    /// p.x q.y - p.y q.x
    static float edge(const Corner& p, const Corner& q) {
        const float py_qx = p.y * q.x;
        return float_fma(p.x, q.y, -py_qx) + float_fma(-p.y, q.x, py_qx);
    }

    std::optional<Hitf> intersect(std::uint32_t i) const {
        const Vec3d &pa = mesh_.corner(i, 0), &pb = mesh_.corner(i, 1), &pc = mesh_.corner(i, 2);
        for (const Vec3d* p : {&pa, &pb, &pc}) {
            if (!(p->lpNorm<Eigen::Infinity>() <= FLT_MAX)) return std::nullopt;
        }
        const Corner a = sheared(pa), b = sheared(pb), c = sheared(pc);
        const float u = edge(c, b), v = edge(a, c), w = edge(b, a);
        const bool inside = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
        const float determinant = u + v + w;
        if (!inside || !(std::fabs(determinant) >= 0x1p-100f)) return std::nullopt;
        const float t = (u * (sz_ * a.z) + v * (sz_ * b.z) + w * (sz_ * c.z)) / determinant;
        if (!(ray_.t_min <= t && t <= ray_.t_max)) return std::nullopt;
        Hitf hit;
        hit.t = t + 0;  // no -0
        hit.u = v / determinant + 0;
        hit.v = w / determinant + 0;
        hit.triangle = i;
        const auto from_a = [&](const Vec3d& p) {
            return Vec3f(scaled(p.x()) - scaled(pa.x()), scaled(p.y()) - scaled(pa.y()),
                         scaled(p.z()) - scaled(pa.z()));
        };
        const Vec3f ab = from_a(pb), ac = from_a(pc);
        const Vec3f normal = ab.cross(ac);
        const float inverse = 1 / scale_;
        hit.t *= inverse;
        for (int k = 0; k < 3; ++k) hit.normal[k] = normal[k] * inverse * inverse;
        return hit;
    }

    MeshView mesh_;
    Rayf ray_;
    float scale_;
    int kx_, ky_, kz_;
    float sx_, sy_, sz_;
};

}  // namespace boxwood
