// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/ply/ply_columns.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "boxwood/core/huge_pages.h"

namespace boxwood {

namespace {

/// Properties that have a meaning only together, but for those beyond the needed ones.
struct KnownNames {
    PlyRole role;
    std::size_t needed;
    std::vector<std::string_view> names;
};

const std::vector<KnownNames>& known_names() {
    static const std::vector<KnownNames> kKnown = {
        {PlyRole::position, 3, {"x", "y", "z"}},
        {PlyRole::normal, 3, {"nx", "ny", "nz"}},
        {PlyRole::color, 3, {"red", "green", "blue", "alpha"}},
        {PlyRole::color, 3, {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}},
        {PlyRole::color, 3, {"r", "g", "b", "a"}},
        {PlyRole::texture_coordinate, 2, {"s", "t"}},
        {PlyRole::texture_coordinate, 2, {"u", "v"}},
        {PlyRole::texture_coordinate, 2, {"texture_u", "texture_v"}},
        {PlyRole::texture_coordinate, 2, {"texture_s", "texture_t"}}};
    return kKnown;
}

std::optional<std::size_t> find_number(const PlyElement& element, std::string_view name) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (!element.properties[i].is_list && element.properties[i].name == name) return i;
    }
    return std::nullopt;
}

double divisor_of(PlyRole role, PlyType type) {
    if (role != PlyRole::color || is_floating(type)) return 1;
    return type == PlyType::uint16 ? 65535 : 255;
}

}  // namespace

std::vector<PlyColumn> ply_columns(const PlyElement& element,
                                   const std::vector<PlyRole>& taken_roles) {
    std::vector<PlyColumn> columns(element.properties.size());
    std::vector<PlyRole> taken = taken_roles;
    for (const KnownNames& known : known_names()) {
        if (std::find(taken.begin(), taken.end(), known.role) != taken.end()) continue;
        std::vector<std::optional<std::size_t>> found;
        for (const std::string_view name : known.names) found.push_back(find_number(element, name));
        if (std::find(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(known.needed),
                      std::nullopt) != found.begin() + static_cast<std::ptrdiff_t>(known.needed))
            continue;
        taken.push_back(known.role);
        for (std::size_t k = 0; k < found.size(); ++k) {
            if (!found[k]) continue;
            PlyColumn& column = columns[*found[k]];
            column.role = known.role;
            column.component = static_cast<int>(k);
            column.divisor = divisor_of(known.role, element.properties[*found[k]].type);
        }
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i].role == PlyRole::none && !element.properties[i].is_list)
            columns[i].role = PlyRole::field;
    }
    return columns;
}

bool has_role(const std::vector<PlyColumn>& columns, PlyRole role) {
    return std::any_of(columns.begin(), columns.end(),
                       [&](const PlyColumn& column) { return column.role == role; });
}

void bind_columns(std::vector<PlyColumn>& columns, const PlyElement& element, ValuesOf of,
                  std::size_t count, MeshData& mesh) {
    MeshAttributes& attributes = mesh.attributes;
    if (has_role(columns, PlyRole::position)) resize_on_huge_pages(mesh.vertices, count);
    if (has_role(columns, PlyRole::normal)) {
        attributes.normals.of = of;
        resize_on_huge_pages(attributes.normals.values, count);
    }
    if (has_role(columns, PlyRole::texture_coordinate)) {
        attributes.texture_coordinates.of = of;
        resize_on_huge_pages(attributes.texture_coordinates.values, count);
    }
    if (has_role(columns, PlyRole::color)) {
        attributes.colors.of = of;
        attributes.colors.values.assign(count, VertexColor::Ones());
    }
    const auto point_to = [](PlyColumn& column, auto& values) {
        constexpr auto kStride = std::decay_t<decltype(values[0])>::SizeAtCompileTime;
        column.stride = static_cast<std::size_t>(kStride);
        return values.empty() ? nullptr : values[0].data() + column.component;
    };
    for (std::size_t i = 0; i < columns.size(); ++i) {
        PlyColumn& column = columns[i];
        switch (column.role) {
            case PlyRole::none:
                break;
            case PlyRole::position:
                column.doubles = point_to(column, mesh.vertices);
                break;
            case PlyRole::normal:
                column.floats = point_to(column, attributes.normals.values);
                break;
            case PlyRole::texture_coordinate:
                column.floats = point_to(column, attributes.texture_coordinates.values);
                break;
            case PlyRole::color:
                column.floats = point_to(column, attributes.colors.values);
                break;
            case PlyRole::field:
                attributes.fields.push_back(
                    {element.properties[i].name, of, std::vector<double>(count)});
                column.doubles = attributes.fields.back().values.data();
                break;
        }
    }
}

}  // namespace boxwood
