// SPDX-License-Identifier: Apache-2.0
#include <numeric>

#include "boxwood/core/parallel.h"
#include "boxwood/mesh/repair.h"

namespace boxwood {

namespace {

/// Leaves those that are kept, of so many each.
template <class Values>
void keep(const std::vector<char>& is_kept, std::size_t each, Values& values) {
    if (values.empty()) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < is_kept.size(); ++i) {
        if (!is_kept[i]) continue;
        for (std::size_t k = 0; k < each; ++k) values[kept++] = values[each * i + k];
    }
    values.resize(kept);
}

template <class Values>
void keep_values(const std::vector<char>& is_kept, ValuesOf of, Values& values) {
    if (of != ValuesOf::vertices) keep(is_kept, of == ValuesOf::faces ? 1 : 3, values);
}

}  // namespace

std::size_t drop_degenerate_faces(MeshData& mesh) {
    const std::size_t before = mesh.faces.size();
    std::vector<char> is_kept(before);
    const MeshView view = mesh;
    parallel_for(before, 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            is_kept[i] = is_in_float_range(view, i) && !has_zero_area(view, i) ? 1 : 0;
    });

    MeshAttributes& attributes = mesh.attributes;
    keep_values(is_kept, attributes.normals.of, attributes.normals.values);
    keep_values(is_kept, attributes.texture_coordinates.of, attributes.texture_coordinates.values);
    keep_values(is_kept, attributes.colors.of, attributes.colors.values);
    for (MeshField& field : attributes.fields) keep_values(is_kept, field.of, field.values);
    keep(is_kept, 1, attributes.groups.of_face);
    keep(is_kept, 1, attributes.materials.of_face);
    keep(is_kept, 1, mesh.faces);
    return before - mesh.faces.size();
}

}  // namespace boxwood
