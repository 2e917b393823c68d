// SPDX-License-Identifier: Apache-2.0
// CGAL's AABB tree, over triangles in double precision: what geometry processing uses.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <optional>

#include "peer.h"

namespace boxwood::bench {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 origin_of(const PlainRay& ray) { return {ray.ox, ray.oy, ray.oz}; }
Kernel::Vector_3 direction_of(const PlainRay& ray) { return {ray.dx, ray.dy, ray.dz}; }

class CgalTree : public Accelerator {
public:
    void build(const PlainMesh& mesh, Quality) override {
        const auto corner = [&](std::size_t i) {
            const float* p = &mesh.vertices[3 * mesh.faces[i]];
            return Kernel::Point_3(p[0], p[1], p[2]);
        };
        triangles_.reserve(mesh.face_count());
        for (std::size_t i = 0; i < mesh.faces.size(); i += 3)
            triangles_.emplace_back(corner(i), corner(i + 1), corner(i + 2));
        tree_.insert(triangles_.begin(), triangles_.end());
        tree_.build();
        tree_.accelerate_distance_queries();
    }

    /// Its rays have no far end, and none of ours has one either.
    void closest_hits(Mode, std::span<const PlainRay> rays, PlainHit* hits) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            hits[i].triangle = kNoTriangle;
            const Kernel::Ray_3 ray(origin_of(rays[i]), direction_of(rays[i]));
            const auto hit = tree_.first_intersection(ray);
            if (!hit) continue;
            // A ray within a triangle's plane meets it in a segment: we report its start.
            const auto* segment = boost::get<Kernel::Segment_3>(&hit->first);
            const Kernel::Point_3 point =
                segment ? segment->source() : boost::get<Kernel::Point_3>(hit->first);
            hits[i] = hit_at(rays[i], point, hit->second);
        }
    }

    void any_hits(Mode, std::span<const PlainRay> rays, std::uint8_t* hits) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const PlainRay& ray = rays[i];
            const auto from = origin_of(ray);
            hits[i] = std::isinf(ray.t_max)
                          ? tree_.do_intersect(Kernel::Ray_3(from, direction_of(ray)))
                          : tree_.do_intersect(Kernel::Segment_3(
                                from, from + static_cast<double>(ray.t_max) * direction_of(ray)));
        }
    }

    bool tells_distances() const override { return true; }

    /// It has no signs of its own for triangles without a common mesh: an odd number of crossings
    /// is inside.
    void nearest(Mode, bool signs, std::span<const PlainPoint> points,
                 PlainNearest* results) override {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Kernel::Point_3 point(points[i].x, points[i].y, points[i].z);
            const auto [place, triangle] = tree_.closest_point_and_primitive(point);
            double distance = std::sqrt(CGAL::squared_distance(point, place));
            if (signs && is_inside(point)) distance = -distance;
            results[i] = {{place.x(), place.y(), place.z()},
                          distance,
                          static_cast<std::uint32_t>(triangle - triangles_.begin())};
        }
    }

private:
    bool is_inside(const Kernel::Point_3& point) const {
        const CGAL::Bbox_3 box = tree_.bbox();
        const bool outside = point.x() < box.xmin() || point.x() > box.xmax() ||
                             point.y() < box.ymin() || point.y() > box.ymax() ||
                             point.z() < box.zmin() || point.z() > box.zmax();
        if (outside) return false;
        const Kernel::Ray_3 ray(point, Kernel::Vector_3(0.0123, 0.0241, 1));
        return tree_.number_of_intersected_primitives(ray) % 2 == 1;
    }

    PlainHit hit_at(const PlainRay& ray, const Kernel::Point_3& point,
                    Triangles::const_iterator triangle) const {
        const Kernel::Vector_3 direction = direction_of(ray);
        const Kernel::Vector_3 e1 = (*triangle)[1] - (*triangle)[0],
                               e2 = (*triangle)[2] - (*triangle)[0], p = point - (*triangle)[0];
        const Kernel::Vector_3 normal = CGAL::cross_product(e1, e2);
        const double area = normal.squared_length();
        return {
            static_cast<float>((point - origin_of(ray)) * direction / direction.squared_length()),
            static_cast<float>(CGAL::cross_product(p, e2) * normal / area),
            static_cast<float>(CGAL::cross_product(e1, p) * normal / area),
            static_cast<std::uint32_t>(triangle - triangles_.begin()),
            static_cast<float>(normal.x()),
            static_cast<float>(normal.y()),
            static_cast<float>(normal.z()),
            0};
    }

    Triangles triangles_;
    Tree tree_;
};

class Cgal : public Peer {
public:
    std::string library() const override { return "cgal"; }
    std::string name() const override { return "cgal"; }
    std::vector<Quality> qualities() const override { return {Quality::medium}; }
    std::unique_ptr<Accelerator> make(int) const override { return std::make_unique<CgalTree>(); }
};

}  // namespace

}  // namespace boxwood::bench

extern "C" void boxwood_bench_add_peers(boxwood::bench::Peers& peers) {
    peers.push_back(std::make_unique<boxwood::bench::Cgal>());
}
