// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>

#include "arrays.h"
#include "bindings.h"
#include "boxwood/core/error.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/inspect.h"
#include "boxwood/mesh/mesh_file.h"
#include "boxwood/mesh/repair.h"
#include "choice.h"
#include "unlocked.h"

namespace boxwood::python {

using namespace nanobind::literals;

namespace {

constexpr Named<ValuesOf> kValuesOf[] = {
    {"vertices", ValuesOf::vertices}, {"faces", ValuesOf::faces}, {"corners", ValuesOf::corners}};
constexpr std::span<const Named<ValuesOf>> values_of_choices() { return kValuesOf; }

using Table = nb::ndarray<nb::numpy, const float, nb::ndim<2>, nb::c_contig>;

template <class Value>
void add_values(List& list, const char* name, const MeshValues<Value>& values, nb::handle owner) {
    if (values.is_empty()) return;
    constexpr std::size_t kColumns = Value::RowsAtCompileTime;
    list.append(nb::make_tuple(
        name, std::string(name_of(values_of_choices(), values.of)),
        view_of(values.values.data()->data(), {values.values.size(), kColumns}, owner)));
}

/// Normals, texture coordinates and colors: what they belong to, and views of them.
List attributes(nb::handle self) {
    const MeshAttributes& found = nb::cast<MeshData&>(self).attributes;
    List result;
    add_values(result, "normals", found.normals, self);
    add_values(result, "texture_coordinates", found.texture_coordinates, self);
    add_values(result, "colors", found.colors, self);
    return result;
}

List fields(nb::handle self) {
    List result;
    for (const MeshField& field : nb::cast<MeshData&>(self).attributes.fields)
        result.append(nb::make_tuple(field.name,
                                     std::string(name_of(values_of_choices(), field.of)),
                                     view_of(field.values.data(), {field.values.size()}, self)));
    return result;
}

List labels(nb::handle self) {
    const MeshAttributes& found = nb::cast<MeshData&>(self).attributes;
    List result;
    const auto add = [&](const char* kind, const FaceLabels& labels) {
        if (labels.is_empty()) return;
        result.append(nb::make_tuple(
            kind, labels.names, view_of(labels.of_face.data(), {labels.of_face.size()}, self)));
    };
    add("groups", found.groups);
    add("materials", found.materials);
    return result;
}

template <class Value>
void set_values(MeshValues<Value>& values, ValuesOf of, const Table& table) {
    constexpr std::size_t kColumns = Value::RowsAtCompileTime;
    if (table.shape(1) != kColumns) throw InvalidInput("expected another number of columns");
    values.of = of;
    values.values.resize(table.shape(0));
    std::copy_n(table.data(), table.size(), values.values.data()->data());
}

void set_attribute(MeshData& mesh, const std::string& name, const std::string& of,
                   const Table& table) {
    const ValuesOf value = choice("of", values_of_choices(), of);
    if (table.shape(0) == 0) return;
    if (name == "normals") set_values(mesh.attributes.normals, value, table);
    if (name == "texture_coordinates")
        set_values(mesh.attributes.texture_coordinates, value, table);
    if (name == "colors") set_values(mesh.attributes.colors, value, table);
}

void add_field(MeshData& mesh, const std::string& name, const std::string& of,
               const Values<double>& values) {
    MeshField field = {.name = name, .of = choice("of", values_of_choices(), of), .values = {}};
    for (std::size_t i = 0; i < values.shape(0); ++i) field.values.push_back(values(i));
    mesh.attributes.fields.push_back(std::move(field));
}

void set_labels(MeshData& mesh, const std::string& kind, const std::vector<std::string>& names,
                const Values<std::uint32_t>& of_face) {
    FaceLabels labels = {.names = names, .of_face = {}};
    for (std::size_t i = 0; i < of_face.shape(0); ++i) labels.of_face.push_back(of_face(i));
    (kind == "groups" ? mesh.attributes.groups : mesh.attributes.materials) = std::move(labels);
}

MeshData from_arrays(const PackedRows<double>& vertices, const PackedRows<std::int32_t>& faces) {
    const auto points = rows_of<const Vec3d>(vertices);
    const auto corners = rows_of<const Vec3i>(faces);
    MeshData mesh;
    mesh.vertices.assign(points.begin(), points.end());
    mesh.faces.assign(corners.begin(), corners.end());
    check_indices(mesh);
    return mesh;
}

Dict inspect_mesh(const MeshData& mesh) {
    MeshReport found;
    {
        const Unlocked unlocked;
        found = inspect(mesh);
    }
    Dict result;
    result["vertices"] = found.vertices;
    result["faces"] = found.faces;
    const auto list = [](const Vec3d& p) { return nb::make_tuple(p.x(), p.y(), p.z()); };
    result["bounds"] =
        found.bounds.is_empty()
            ? nb::object(nb::none())
            : nb::object(nb::make_tuple(list(found.bounds.lo), list(found.bounds.hi)));
    result["area"] = found.area;
    result["volume"] = found.volume ? nb::object(nb::float_(*found.volume)) : nb::none();
    result["closed"] = found.closed;
    result["components"] = found.components;
    result["nonfinite_vertices"] = found.nonfinite_vertices;
    result["duplicate_vertices"] = found.duplicate_vertices;
    result["unreferenced_vertices"] = found.unreferenced_vertices;
    result["degenerate_faces"] = found.degenerate_faces;
    result["duplicate_faces"] = found.duplicate_faces;
    result["boundary_edges"] = found.boundary_edges;
    result["boundary_loops"] = found.boundary_loops;
    result["nonmanifold_edges"] = found.nonmanifold_edges;
    result["flipped_edges"] = found.flipped_edges;
    return result;
}

Dict repair_mesh(MeshData& mesh, const std::vector<std::string>& names) {
    std::vector<RepairStep> steps;
    for (const std::string& name : names) steps.push_back(choice("steps", repair_steps(), name));
    RepairReport found;
    {
        const Unlocked unlocked;
        found = repair(mesh, steps);
    }
    Dict result;
    result["welded_vertices"] = found.welded_vertices;
    result["dropped_faces"] = found.dropped_faces;
    result["flipped_faces"] = found.flipped_faces;
    result["unorientable_components"] = found.unorientable_components;
    return result;
}

}  // namespace

void bind_meshes(nb::module_& module) {
    nb::class_<MeshData>(module, "MeshData")
        .def("__init__",
             [](MeshData* self, const PackedRows<double>& vertices,
                const PackedRows<std::int32_t>& faces) {
                 new (self) MeshData(from_arrays(vertices, faces));
             })
        .def_prop_ro("vertices",
                     [](nb::handle_t<MeshData> self) {
                         auto& mesh = nb::cast<MeshData&>(self);
                         return nb::ndarray<nb::numpy, double>(
                             mesh.vertices.empty() ? nullptr : mesh.vertices.data()->data(),
                             {mesh.vertices.size(), 3}, self);
                     })
        .def_prop_ro("faces",
                     [](nb::handle_t<MeshData> self) {
                         const auto& mesh = nb::cast<const MeshData&>(self);
                         return view_of(mesh.faces.empty() ? nullptr : mesh.faces.data()->data(),
                                        {mesh.faces.size(), 3}, self);
                     })
        .def("attributes", [](nb::handle_t<MeshData> self) { return attributes(self); })
        .def("fields", [](nb::handle_t<MeshData> self) { return fields(self); })
        .def("labels", [](nb::handle_t<MeshData> self) { return labels(self); })
        .def_prop_rw(
            "material_files", [](const MeshData& self) { return self.attributes.material_files; },
            [](MeshData& self, std::vector<std::string> files) {
                self.attributes.material_files = std::move(files);
            })
        .def("warnings", [](const MeshData& self) { return list_of(self.warnings); })
        .def("set_attribute", &set_attribute, "name"_a, "of"_a, "table"_a.noconvert())
        .def("add_field", &add_field, "name"_a, "of"_a, "values"_a.noconvert())
        .def("set_labels", &set_labels, "kind"_a, "names"_a, "of_face"_a.noconvert())
        .def("check_attributes",
             [](const MeshData& self) { check_attributes(self, self.attributes); })
        .def("inspect", &inspect_mesh)
        .def("repair", &repair_mesh, "steps"_a)
        .def(
            "write",
            [](const MeshData& self, const std::filesystem::path& path) {
                const Unlocked unlocked;
                write_mesh(path, self, self.attributes);
            },
            "path"_a);

    module.def(
        "read_mesh",
        [](const std::filesystem::path& path, bool allow_outside_files) {
            const Unlocked unlocked;
            return read_mesh(path, {.allow_outside_files = allow_outside_files});
        },
        "path"_a, "allow_outside_files"_a);
    module.def(
        "generate",
        [](const std::string& shape, std::size_t triangles) {
            const Unlocked unlocked;
            return MeshData{generate(shape, triangles), {}, {}};
        },
        "shape"_a, "triangles"_a);
    module.def("generated_shapes", [] {
        std::vector<std::string> names;
        for (const std::string_view name : generated_shapes()) names.emplace_back(name);
        return names;
    });
}

}  // namespace boxwood::python
