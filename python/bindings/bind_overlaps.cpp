// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "py_scene.h"
#include "ray_arrays.h"
#include "watch.h"

namespace boxwood::python {

using namespace nanobind::literals;

namespace {

/// So many shapes at a time are in memory besides their arrays.
constexpr std::size_t kAtATime = std::size_t{1} << 16;

/// What ask(shapes, options) finds for the shapes that shape(i) makes: offsets of each one's list
/// in the arrays of triangles and instances.
template <class Shape, class MakeShape, class Ask>
Dict lists_of(const PyScene& scene, std::size_t count, nb::handle progress,
              const MakeShape& make_shape, const Ask& ask) {
    std::vector<std::int64_t> offsets = {0};
    std::vector<std::int32_t> triangles, instances;
    run_watched(count, progress, [&](Watch& watch) {
        const Gate::Query query(scene.gate);
        std::vector<Shape> shapes;
        for (std::size_t begin = 0; begin < count; begin += kAtATime) {
            shapes.clear();
            for (std::size_t i = begin; i < std::min(begin + kAtATime, count); ++i)
                shapes.push_back(make_shape(i));
            const TriangleLists<TriangleId> part = ask(shapes, watch.options(shapes.size()));
            const auto before = static_cast<std::int64_t>(triangles.size());
            for (std::size_t i = 1; i < part.offsets.size(); ++i)
                offsets.push_back(before + static_cast<std::int64_t>(part.offsets[i]));
            for (const TriangleId& id : part.triangles) {
                triangles.push_back(static_cast<std::int32_t>(id.triangle));
                instances.push_back(static_cast<std::int32_t>(id.instance));
            }
        }
    });
    Dict result;
    result["offsets"] = array_of(std::move(offsets));
    result["triangle"] = array_of(std::move(triangles));
    result["instance"] = array_of(std::move(instances));
    return result;
}

Dict box_overlap(const PyScene& scene, const PackedRows<double>& lower,
                 const PackedRows<double>& upper, nb::handle progress) {
    check_places(lower.shape(0), upper);
    const auto lo = rows_of<const Vec3d>(lower), hi = rows_of<const Vec3d>(upper);
    return lists_of<Box3d>(
        scene, lo.size(), progress,
        [&](std::size_t i) {
            return Box3d{lo[i], hi[i]};
        },
        [&](const std::vector<Box3d>& boxes, const BatchOptions& options) {
            return scene.scene().box_overlaps(boxes, options);
        });
}

Dict sphere_overlap(const PyScene& scene, const PackedRows<double>& centers,
                    const Values<double>& radii, nb::handle progress) {
    check_places(centers.shape(0), radii);
    const auto points = rows_of<const Vec3d>(centers);
    return lists_of<Sphere3d>(
        scene, points.size(), progress,
        [&](std::size_t i) {
            return Sphere3d{points[i], radii(i)};
        },
        [&](const std::vector<Sphere3d>& spheres, const BatchOptions& options) {
            return scene.scene().sphere_overlaps(spheres, options);
        });
}

void triangle_overlap(const PyScene& scene, const PackedRows<double>& corners,
                      const ValuesOut<bool>& results, nb::handle progress) {
    const auto points = rows_of<const Vec3d>(corners);
    const std::size_t count = points.size() / 3;
    check_places(count, results);
    run_watched(count, progress, [&](Watch& watch) {
        const Gate::Query query(scene.gate);
        watch.for_each_piece(256, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                results.data()[i] = scene.scene().triangle_overlap(
                    {points[3 * i], points[3 * i + 1], points[3 * i + 2]});
        });
    });
}

}  // namespace

void bind_overlaps(nb::class_<PyScene>& scene) {
    scene.def("box_overlap", &box_overlap, "lower"_a.noconvert(), "upper"_a.noconvert(),
              "progress"_a.none());
    scene.def("sphere_overlap", &sphere_overlap, "centers"_a.noconvert(), "radii"_a.noconvert(),
              "progress"_a.none());
    scene.def("triangle_overlap", &triangle_overlap, "corners"_a.noconvert(),
              "results"_a.noconvert(), "progress"_a.none());
}

}  // namespace boxwood::python
