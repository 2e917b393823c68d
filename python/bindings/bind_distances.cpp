// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/string.h>

#include <algorithm>
#include <vector>

#include "py_scene.h"
#include "ray_arrays.h"
#include "watch.h"

namespace boxwood::python {

using namespace nanobind::literals;

namespace {

/// So many points at a time have results in memory besides the arrays.
constexpr std::size_t kAtATime = std::size_t{1} << 17;

/// Calls ask(points, results, options) and store(i, result) for all points.
template <class Result, class Ask, class Store>
void for_each_points(const PyScene& scene, const PackedRows<double>& array, nb::handle progress,
                     const Ask& ask, const Store& store) {
    const std::span<const Vec3d> points = rows_of<const Vec3d>(array);
    run_watched(points.size(), progress, [&](Watch& watch) {
        const Gate::Query query(scene.gate);
        std::vector<Result> results;
        for (std::size_t begin = 0; begin < points.size(); begin += kAtATime) {
            const auto part = points.subspan(begin, std::min(kAtATime, points.size() - begin));
            results.assign(part.size(), Result{});
            ask(part, std::span(results), watch.options(part.size()));
            for (std::size_t i = 0; i < part.size(); ++i) store(begin + i, results[i]);
        }
    });
}

/// Where closest points go.
struct Places {
    ValuesOut<double> distance;
    RowsOut<double, 3> point;
    ValuesOut<std::int32_t> triangle, instance;
    RowsOut<double, 2> uv;

    void store(std::size_t at, double value, const ClosestPoint& closest) const {
        distance.data()[at] = value;
        for (int k = 0; k < 3; ++k)
            point.data()[3 * at + static_cast<std::size_t>(k)] = closest.point[k];
        triangle.data()[at] = static_cast<std::int32_t>(closest.triangle);
        instance.data()[at] = closest.is_found() ? static_cast<std::int32_t>(closest.instance) : -1;
        uv.data()[2 * at] = closest.u;
        uv.data()[2 * at + 1] = closest.v;
    }
};

void closest_point(const PyScene& scene, const PackedRows<double>& points, double max_radius,
                   const ValuesOut<double>& distance, const RowsOut<double, 3>& point,
                   const ValuesOut<std::int32_t>& triangle, const ValuesOut<std::int32_t>& instance,
                   const RowsOut<double, 2>& uv, nb::handle progress) {
    check_places(points.shape(0), distance, point, triangle, instance, uv);
    const Places places = {distance, point, triangle, instance, uv};
    for_each_points<ClosestPoint>(
        scene, points, progress,
        [&](auto part, auto results, const BatchOptions& options) {
            scene.scene().closest_points(part, results, max_radius, options);
        },
        [&](std::size_t i, const ClosestPoint& closest) {
            places.store(i, closest.distance, closest);
        });
}

void signed_distance(const PyScene& scene, const PackedRows<double>& points,
                     const std::string& method, double accuracy, double max_radius,
                     const ValuesOut<double>& distance, const ValuesOut<bool>& is_undefined,
                     const RowsOut<double, 3>& point, const ValuesOut<std::int32_t>& triangle,
                     const ValuesOut<std::int32_t>& instance, const RowsOut<double, 2>& uv,
                     nb::handle progress) {
    check_places(points.shape(0), distance, is_undefined, point, triangle, instance, uv);
    const Places places = {distance, point, triangle, instance, uv};
    for_each_points<SignedDistance>(
        scene, points, progress,
        [&](auto part, auto results, const BatchOptions& options) {
            scene.sign(method, accuracy).signed_distances(part, results, max_radius, options);
        },
        [&](std::size_t i, const SignedDistance& result) {
            places.store(i, result.distance, result.closest);
            is_undefined.data()[i] = result.is_undefined;
        });
}

void winding_number(const PyScene& scene, const PackedRows<double>& points, double accuracy,
                    const ValuesOut<double>& numbers, nb::handle progress) {
    check_places(points.shape(0), numbers);
    for_each_points<double>(
        scene, points, progress,
        [&](auto part, auto results, const BatchOptions& options) {
            scene.sign("winding_number", accuracy).winding_numbers(part, results, options);
        },
        [&](std::size_t i, double number) { numbers.data()[i] = number; });
}

}  // namespace

void bind_distances(nb::class_<PyScene>& scene) {
    scene.def("closest_point", &closest_point, "points"_a.noconvert(), "max_radius"_a,
              "distance"_a.noconvert(), "point"_a.noconvert(), "triangle"_a.noconvert(),
              "instance"_a.noconvert(), "uv"_a.noconvert(), "progress"_a.none());
    scene.def("signed_distance", &signed_distance, "points"_a.noconvert(), "method"_a, "accuracy"_a,
              "max_radius"_a, "distance"_a.noconvert(), "is_undefined"_a.noconvert(),
              "point"_a.noconvert(), "triangle"_a.noconvert(), "instance"_a.noconvert(),
              "uv"_a.noconvert(), "progress"_a.none());
    scene.def("winding_number", &winding_number, "points"_a.noconvert(), "accuracy"_a,
              "numbers"_a.noconvert(), "progress"_a.none());
}

}  // namespace boxwood::python
