// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/mesh_data.h"

#include <fmt/format.h>

#include <string_view>

#include "boxwood/core/error.h"

namespace boxwood {

namespace {

void check_size(const MeshView& mesh, std::string_view name, ValuesOf of, std::size_t size) {
    const auto [expected, what] = [&]() -> std::pair<std::size_t, const char*> {
        switch (of) {
            case ValuesOf::vertices:
                return {mesh.vertices.size(), "vertex"};
            case ValuesOf::faces:
                return {mesh.faces.size(), "face"};
            case ValuesOf::corners:
                return {3 * mesh.faces.size(), "corner"};
        }
        return {0, "nothing"};
    }();
    if (size != expected)
        throw InvalidInput(fmt::format("{}: found {} values, expected {}, one for each {}", name,
                                       size, expected, what));
}

template <class Value>
void check_values(const MeshView& mesh, std::string_view name, const MeshValues<Value>& values) {
    if (!values.is_empty()) check_size(mesh, name, values.of, values.values.size());
}

void check_labels(const MeshView& mesh, std::string_view name, const FaceLabels& labels) {
    if (labels.is_empty()) return;
    check_size(mesh, name, ValuesOf::faces, labels.of_face.size());
    for (std::size_t i = 0; i < labels.of_face.size(); ++i) {
        if (labels.of_face[i] >= labels.names.size())
            throw InvalidInput(fmt::format("{} of face {}: found {}, expected less than {}", name,
                                           i, labels.of_face[i], labels.names.size()));
    }
}

}  // namespace

void check_attributes(MeshView mesh, const MeshAttributes& attributes) {
    check_values(mesh, "normals", attributes.normals);
    check_values(mesh, "texture coordinates", attributes.texture_coordinates);
    check_values(mesh, "colors", attributes.colors);
    for (const MeshField& field : attributes.fields)
        check_size(mesh, "field " + field.name, field.of, field.values.size());
    check_labels(mesh, "groups", attributes.groups);
    check_labels(mesh, "materials", attributes.materials);
}

}  // namespace boxwood
