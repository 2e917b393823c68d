// SPDX-License-Identifier: Apache-2.0
#include "laws/ray_families.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "laws/random.h"

namespace boxwood {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class RayMaker {
public:
    RayMaker(MeshView mesh, std::uint64_t seed) : mesh_(mesh), random_(seed) {
        for (const Vec3d& vertex : mesh.vertices) {
            if (vertex.allFinite() && vertex.lpNorm<Eigen::Infinity>() < 1e39)
                bounds_.extend(vertex);
        }
        if (bounds_.is_empty()) bounds_ = {Vec3d::Constant(-1), Vec3d::Constant(1)};
        size_ = std::max(bounds_.extent().maxCoeff(), 1e-300);
    }

    Ray make() {
        Ray ray = with_line();
        set_limits(ray);
        return ray;
    }

private:
    Ray with_line() {
        switch (random_.index(10)) {
            case 0:
                return {.origin = around(1), .direction = random_.direction()};
            case 1:
                return {.origin = far_out(), .direction = (around(0.5) - ray_origin_)};
            case 2:
                return at(vertex());
            case 3:
                return at(on_edge());
            case 4:
                return at(inside_triangle());
            case 5:
                return along_edge();
            case 6:
                return {.origin = vertex(), .direction = random_.direction()};
            case 7:
                return parallel_to_axis();
            case 8:
                return parallel_to_plane();
            default:
                return from_box_face();
        }
    }

    /// A point in the bounds made larger by some of their size.
    Vec3d around(double margin) {
        const Vec3d p = random_.point(-margin, 1 + margin);
        return bounds_.lo + p.cwiseProduct(Vec3d::Constant(size_));
    }
    Vec3d far_out() {
        ray_origin_ =
            bounds_.centroid() + std::pow(10, random_.number(0, 6)) * size_ * random_.direction();
        return ray_origin_;
    }
    std::size_t face() { return random_.index(mesh_.faces.size()); }
    /// A corner of a face where there is one.
    Vec3d vertex() {
        if (mesh_.faces.empty()) return around(0);
        const Vec3d p = mesh_.corner(face(), static_cast<int>(random_.index(3)));
        return p.allFinite() ? p : around(0);
    }
    Vec3d on_edge() {
        if (mesh_.faces.empty()) return around(0);
        const auto k = static_cast<int>(random_.index(3));
        const std::size_t f = face();
        const double s = random_.number() < 0.5 ? 0.5 : random_.number();
        return (1 - s) * mesh_.corner(f, k) + s * mesh_.corner(f, (k + 1) % 3);
    }
    Vec3d inside_triangle() {
        if (mesh_.faces.empty()) return around(0);
        const std::size_t f = face();
        const double s = random_.number(), t = random_.number() * (1 - s);
        return (1 - s - t) * mesh_.corner(f, 0) + s * mesh_.corner(f, 1) + t * mesh_.corner(f, 2);
    }

    Ray at(const Vec3d& target) {
        Vec3d origin;
        switch (random_.index(4)) {
            case 0:
                origin = vertex();
                break;
            case 1:
                origin = far_out();
                break;
            case 2:
                origin = Vec3d::Zero();
                break;
            default:
                origin = around(1);
        }
        const Vec3d towards = target - origin;
        return {.origin = origin, .direction = random_.number() < 0.5 ? towards : 2 * towards};
    }
    Ray along_edge() {
        if (mesh_.faces.empty()) return at(around(0));
        const auto k = static_cast<int>(random_.index(3));
        const std::size_t f = face();
        const Vec3d a = mesh_.corner(f, k), b = mesh_.corner(f, (k + 1) % 3);
        const double back = std::floor(random_.number(-1, 4)) / 2;
        return {.origin = a - back * (b - a), .direction = b - a};
    }
    double zero() { return random_.number() < 0.5 ? 0.0 : -0.0; }
    Ray parallel_to_axis() {
        const auto axis = static_cast<int>(random_.index(3));
        Ray ray = {.origin = random_.number() < 0.3 ? on_edge() : vertex(),
                   .direction = {zero(), zero(), zero()}};
        ray.direction[axis] = random_.number() < 0.5 ? 1 : -1;
        ray.origin[axis] -= std::floor(random_.number(-1, 3)) * size_ * ray.direction[axis];
        return ray;
    }
    Ray parallel_to_plane() {
        const auto axis = static_cast<int>(random_.index(3));
        const Vec3d target = vertex();
        Ray ray = at(target);
        ray.origin[axis] = target[axis];
        ray.direction = target - ray.origin;
        if (random_.number() < 0.5) ray.direction[axis] = zero();
        // So small that its inverse overflows or nearly does.
        if (random_.number() < 0.3) ray.direction[axis] = std::pow(10, random_.number(-320, -200));
        return ray;
    }
    /// From a point in a face, on an edge or at a corner of a triangle's float box.
    Ray from_box_face() {
        if (mesh_.faces.empty()) return at(around(0));
        const std::size_t f = face();
        const std::vector<Vec3i> one = {mesh_.faces[f]};
        const Box3f box = triangle_boxes({mesh_.vertices, one})[0];
        if (box.is_empty()) return at(around(0));
        Vec3d origin = inside_triangle();
        for (int k = 0; k < 3; ++k) {
            const std::size_t side = random_.index(3);
            if (side < 2) origin[k] = side == 0 ? box.lo[k] : box.hi[k];
        }
        Ray ray = {.origin = origin, .direction = random_.direction()};
        if (random_.number() < 0.5) ray.direction = vertex() - origin;
        if (random_.number() < 0.5) ray.direction[static_cast<int>(random_.index(3))] = zero();
        return ray;
    }

    void set_limits(Ray& ray) {
        const double length = ray.direction.norm();
        switch (random_.index(12)) {
            case 0:
                ray.t_max = random_.number(0, 2);
                break;
            case 1:
                ray.t_min = random_.number(0, 2);
                break;
            case 2:
                ray.t_max = 1;
                break;  // where many of these rays aim
            case 3:
                ray.t_min = 1;
                break;
            case 4:
                ray.t_min = -kInfinity;
                break;
            case 5:
                ray.t_min = -random_.number();
                ray.t_max = random_.number();
                break;
            case 6:
                ray.t_min = ray.t_max = std::floor(random_.number(0, 2));
                break;
            case 7:
                ray.direction *= std::pow(10, random_.number(-140, 140)) / length;
                break;
            default:
                break;
        }
        if (random_.number() < 0.2 && !mesh_.faces.empty())
            ray.skip = {0, static_cast<std::uint32_t>(face())};
    }

    MeshView mesh_;
    Random random_;
    Box3d bounds_;
    double size_ = 1;
    Vec3d ray_origin_ = Vec3d::Zero();
};

}  // namespace

Ray random_ray(MeshView mesh, std::uint64_t seed) { return RayMaker(mesh, seed).make(); }

}  // namespace boxwood
