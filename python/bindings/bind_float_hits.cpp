// SPDX-License-Identifier: Apache-2.0
// Rays in float, which are read, and hits written, where their arrays are.
#include "py_scene.h"
#include "ray_arrays.h"
#include "watch.h"

namespace boxwood::python {

using namespace nanobind::literals;

namespace {

void closest_hit(const PyScene& scene, const RayArraysf& arrays, const ValuesOut<float>& t,
                 const ValuesOut<std::int32_t>& triangle, const ValuesOut<std::int32_t>& instance,
                 const RowsOut<float, 2>& uv, const RowsOut<float, 3>& normal,
                 nb::handle progress) {
    check_places(arrays.size(), t, triangle, instance, uv, normal);
    // None is -1 there.
    const HitColumns hits = {arrays.size(),
                             t.data(),
                             reinterpret_cast<std::uint32_t*>(triangle.data()),
                             reinterpret_cast<std::uint32_t*>(instance.data()),
                             uv.data(),
                             normal.data()};
    run_watched(arrays.size(), progress, [&](Watch& watch) {
        const Gate::Query query(scene.gate);
        scene.scene().closest_hits(arrays.columns(), hits, watch.options(arrays.size()));
    });
}

void any_hit(const PyScene& scene, const RayArraysf& arrays, const ValuesOut<bool>& results,
             nb::handle progress) {
    check_places(arrays.size(), results);
    run_watched(arrays.size(), progress, [&](Watch& watch) {
        const Gate::Query query(scene.gate);
        scene.scene().any_hits(arrays.columns(), values_of(results), watch.options(arrays.size()));
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
