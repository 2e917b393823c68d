// SPDX-License-Identifier: Apache-2.0
// Rays in float.
#include <tbb/enumerable_thread_specific.h>

#include <cmath>
#include <memory>

#include "boxwood/query/ray_order.h"
#include "py_scene.h"
#include "ray_arrays.h"
#include "watch.h"

namespace boxwood::python {

using namespace nanobind::literals;

namespace {

/// Calls ask(piece) for pieces of the rays, on all cores: tiles of a camera's, as the batch in C++
/// takes them.
template <class Ask>
void for_each_rays(const PyScene& scene, const RayArraysf& arrays, nb::handle progress,
                   const Ask& ask) {
    const auto ray_at = [&](std::size_t i) { return arrays[i]; };
    const RayOrder order(arrays.size(), row_length(arrays.size(), ray_at));
    tbb::enumerable_thread_specific<RayPiece> pieces;
    run_watched(order.pieces(), progress, [&](Watch& watch) {
        const Gate::Query query(scene.gate);
        watch.for_each_piece(1, [&](std::size_t i, std::size_t) {
            RayPiece& piece = pieces.local();
            piece.take(order, i, ray_at);
            ask(piece);
        });
    });
}

void closest_hit(const PyScene& scene, const RayArraysf& arrays, const ValuesOut<float>& t,
                 const ValuesOut<std::int32_t>& triangle, const ValuesOut<std::int32_t>& instance,
                 const RowsOut<float, 2>& uv, const RowsOut<float, 3>& normal,
                 nb::handle progress) {
    check_places(arrays.size(), t, triangle, instance, uv, normal);
    for_each_rays(scene, arrays, progress, [&](RayPiece& piece) {
        scene.scene().closest_hits(piece.rays, piece.hits, {.on_this_thread = true});
        piece.for_each([&](std::size_t at, std::size_t i) {
            const Hitf& hit = piece.hits[i];
            t.data()[at] = hit.t;
            triangle.data()[at] = static_cast<std::int32_t>(hit.triangle);
            instance.data()[at] = hit.is_hit() ? static_cast<std::int32_t>(hit.instance) : -1;
            uv.data()[2 * at] = hit.u;
            uv.data()[2 * at + 1] = hit.v;
            float* const n = normal.data() + 3 * at;
            n[0] = n[1] = n[2] = 0;
            if (!hit.is_hit()) return;
            // In double, where no square of a float is too large or too small.
            const double x = hit.normal[0], y = hit.normal[1], z = hit.normal[2];
            const double squared = x * x + y * y + z * z;
            const double factor = squared > 0 ? 1 / std::sqrt(squared) : 0;
            n[0] = static_cast<float>(factor * x);
            n[1] = static_cast<float>(factor * y);
            n[2] = static_cast<float>(factor * z);
        });
    });
}

void any_hit(const PyScene& scene, const RayArraysf& arrays, const ValuesOut<bool>& results,
             nb::handle progress) {
    check_places(arrays.size(), results);
    for_each_rays(scene, arrays, progress, [&](RayPiece& piece) {
        const auto found = std::make_unique<bool[]>(piece.rays.size());
        scene.scene().any_hits(piece.rays, std::span(found.get(), piece.rays.size()),
                               {.on_this_thread = true});
        piece.for_each([&](std::size_t at, std::size_t i) { results.data()[at] = found[i]; });
    });
}

}  // namespace

void bind_float_hits(nb::module_& module, nb::class_<PyScene>& scene) {
    nb::class_<RayArraysf>(module, "Raysf")
        .def(nb::init<const Rows<float>&, const Rows<float>&, const Values<float>&,
                      const Values<float>&>(),
             "origins"_a.noconvert(), "directions"_a.noconvert(), "t_min"_a.noconvert(),
             "t_max"_a.noconvert());
    scene.def("closest_hit", &closest_hit, "rays"_a, "t"_a.noconvert(), "triangle"_a.noconvert(),
              "instance"_a.noconvert(), "uv"_a.noconvert(), "normal"_a.noconvert(),
              "progress"_a.none());
    scene.def("any_hit", &any_hit, "rays"_a, "results"_a.noconvert(), "progress"_a.none());
}

}  // namespace boxwood::python
