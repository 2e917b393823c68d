// SPDX-License-Identifier: Apache-2.0
// Rays in float.
#include <algorithm>
#include <array>
#include <cmath>

#include "py_scene.h"
#include "ray_arrays.h"
#include "watch.h"

namespace boxwood::python {

using namespace nanobind::literals;

namespace {

/// As batches in float group their rays by 256.
constexpr std::size_t kPiece = 1024;

template <class Store>
void for_each_rays(const PyScene& scene, const RayArraysf& arrays, nb::handle progress,
                   const Store& store) {
    run_watched(arrays.size(), progress, [&](Watch& watch) {
        const Gate::Query query(scene.gate);
        watch.for_each_piece(kPiece, [&](std::size_t begin, std::size_t end) {
            std::array<Rayf, kPiece> rays;
            const auto piece = std::span(rays).first(end - begin);
            arrays.gather(begin, piece);
            store(begin, piece);
        });
    });
}

void closest_hit(const PyScene& scene, const RayArraysf& arrays, const ValuesOut<float>& t,
                 const ValuesOut<std::int32_t>& triangle, const ValuesOut<std::int32_t>& instance,
                 const RowsOut<float, 2>& uv, const RowsOut<float, 3>& normal,
                 nb::handle progress) {
    check_places(arrays.size(), t, triangle, instance, uv, normal);
    for_each_rays(scene, arrays, progress, [&](std::size_t begin, std::span<Rayf> rays) {
        std::array<Hitf, kPiece> hits;
        scene.scene().closest_hits(rays, std::span(hits).first(rays.size()),
                                   {.on_this_thread = true});
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Hitf& hit = hits[i];
            const std::size_t at = begin + i;
            t.data()[at] = hit.t;
            triangle.data()[at] = static_cast<std::int32_t>(hit.triangle);
            instance.data()[at] = hit.is_hit() ? static_cast<std::int32_t>(hit.instance) : -1;
            uv.data()[2 * at] = hit.u;
            uv.data()[2 * at + 1] = hit.v;
            // In double, where no square of a float is too large or too small.
            const double x = hit.normal[0], y = hit.normal[1], z = hit.normal[2];
            const double squared = x * x + y * y + z * z;
            const double factor = squared > 0 ? 1 / std::sqrt(squared) : 0;
            normal.data()[3 * at] = static_cast<float>(factor * x);
            normal.data()[3 * at + 1] = static_cast<float>(factor * y);
            normal.data()[3 * at + 2] = static_cast<float>(factor * z);
        }
    });
}

void any_hit(const PyScene& scene, const RayArraysf& arrays, const ValuesOut<bool>& results,
             nb::handle progress) {
    check_places(arrays.size(), results);
    for_each_rays(scene, arrays, progress, [&](std::size_t begin, std::span<Rayf> rays) {
        scene.scene().any_hits(rays, std::span(results.data() + begin, rays.size()),
                               {.on_this_thread = true});
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
