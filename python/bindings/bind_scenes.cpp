// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "bindings.h"
#include "boxwood/core/simd.h"
#include "py_scene.h"
#include "ray_arrays.h"
#include "unlocked.h"

namespace boxwood::python {

using namespace nanobind::literals;

namespace {

template <class Row, class Scalar>
nb::object rows_view(std::span<const Row> rows, nb::handle owner) {
    return nb::cast(view_of(reinterpret_cast<const Scalar*>(rows.data()), {rows.size(), 3}, owner));
}

/// The vertices as they were given, and the faces, of each mesh.
List meshes(nb::handle self) {
    List result;
    for (const SceneMesh& mesh : nb::cast<PyScene&>(self).scene().given_meshes()) {
        if (const auto* precise = std::get_if<MeshView>(&mesh.geometry))
            result.append(nb::make_tuple(rows_view<Vec3d, double>(precise->vertices, self),
                                         rows_view<Vec3i, std::int32_t>(precise->faces, self),
                                         mesh.culls_back_faces));
        else if (const auto* single = std::get_if<MeshViewf>(&mesh.geometry))
            result.append(nb::make_tuple(rows_view<Vec3f, float>(single->vertices, self),
                                         rows_view<Vec3i, std::int32_t>(single->faces, self),
                                         mesh.culls_back_faces));
    }
    return result;
}

/// Mesh, transform (16 numbers, row by row) and visibility of each instance.
List instances(const PyScene& scene) {
    List result;
    for (const Instance& instance : scene.scene().instances()) {
        std::vector<double> numbers;
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column)
                numbers.push_back(row == 3 ? column == 3 : instance.to_world(row, column));
        result.append(nb::make_tuple(instance.mesh, numbers, instance.visibility));
    }
    return result;
}

List report(const PyScene& scene) {
    List result;
    for (const MeshFaults& faults : scene.scene().report().meshes)
        result.append(nb::make_tuple(array_of(faults.not_finite), array_of(faults.zero_area)));
    return result;
}

List statistics(const PyScene& scene) {
    List result;
    for (const WideTree& tree : scene.scene().wide_trees()) {
        Dict entry;
        entry["width"] = tree.width();
        entry["instruction_set"] = std::string(name_of(instruction_sets(), tree.instruction_set()));
        entry["bytes"] = tree.bytes();
        entry["is_compact"] = tree.is_compact();
        entry["cost"] = tree.cost();
        result.append(entry);
    }
    return result;
}

void geometric_normal(const PyScene& scene, const Values<std::int32_t>& triangle,
                      const Values<std::int32_t>& instance, const RowsOut<double, 3>& normal) {
    check_places(triangle.shape(0), instance, normal);
    const Unlocked unlocked;
    const Gate::Query query(scene.gate);
    const Scene& asked = scene.scene();
    for (std::size_t i = 0; i < triangle.shape(0); ++i) {
        const auto id = TriangleId{static_cast<std::uint32_t>(instance(i)),
                                   static_cast<std::uint32_t>(triangle(i))};
        Vec3d n = Vec3d::Zero();
        if (triangle(i) >= 0) {
            if (id.instance >= asked.instances().size())
                throw InvalidInput("instance: found " + std::to_string(instance(i)) +
                                   ", expected one of the scene's " +
                                   std::to_string(asked.instances().size()));
            const std::size_t faces =
                asked.meshes()[asked.instances()[id.instance].mesh].faces.size();
            if (id.triangle >= faces)
                throw InvalidInput("triangle: found " + std::to_string(triangle(i)) +
                                   ", expected one of the mesh's " + std::to_string(faces));
            n = asked.geometric_normal(id);
        }
        for (int k = 0; k < 3; ++k) normal.data()[3 * i + static_cast<std::size_t>(k)] = n[k];
    }
}

}  // namespace

void bind_scenes(nb::module_& module) {
    nb::class_<PyScene> scene(module, "Scene");
    scene
        .def(nb::init<const List&, const List&, const std::vector<bool>&,
                      const Values<std::uint32_t>&, const Transforms&, const Values<std::uint32_t>&,
                      const std::string&, const std::optional<std::string>&, const std::string&,
                      bool>(),
             "vertices"_a, "faces"_a, "culls_back_faces"_a, "mesh_of_instance"_a.noconvert(),
             "transforms"_a.noconvert(), "visibilities"_a.noconvert(), "preset"_a,
             "method"_a.none(), "cost"_a, "brute_force"_a)
        .def(nb::init<const std::filesystem::path&, bool>(), "path"_a, "trust"_a)
        .def("save", &PyScene::save, "path"_a)
        .def("refit", &PyScene::refit)
        .def("set_instances", &PyScene::set_instances, "mesh_of_instance"_a.noconvert(),
             "transforms"_a.noconvert(), "visibilities"_a.noconvert())
        .def("meshes", [](nb::handle_t<PyScene> self) { return meshes(self); })
        .def("instances", &instances)
        .def("report", &report)
        .def("statistics", &statistics)
        .def("geometric_normal", &geometric_normal, "triangle"_a.noconvert(),
             "instance"_a.noconvert(), "normal"_a.noconvert())
        .def(
            "is_sign_trustworthy",
            [](const PyScene& self, const std::string& method) {
                const Unlocked unlocked;
                const Gate::Query query(self.gate);
                return self.sign(method, WindingOptions{}.accuracy).is_trustworthy();
            },
            "method"_a);
    bind_hits(module, scene);
    bind_float_hits(module, scene);
    bind_distances(scene);
    bind_overlaps(scene);
}

}  // namespace boxwood::python
