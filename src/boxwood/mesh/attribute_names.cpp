// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/attribute_names.h"

namespace boxwood {

std::string AttributeName::text() const {
    switch (of) {
        case ValuesOf::vertices:
            return what + " of vertices";
        case ValuesOf::faces:
            return what + " of faces";
        case ValuesOf::corners:
            return what + " of corners";
    }
    return what;
}

std::vector<AttributeName> attribute_names(const MeshAttributes& attributes) {
    std::vector<AttributeName> names;
    const auto add_if = [&](bool is_there, std::string what, ValuesOf of) {
        if (is_there) names.push_back({std::move(what), of});
    };
    add_if(!attributes.normals.is_empty(), "normals", attributes.normals.of);
    add_if(!attributes.texture_coordinates.is_empty(), "texture coordinates",
           attributes.texture_coordinates.of);
    add_if(!attributes.colors.is_empty(), "colors", attributes.colors.of);
    for (const MeshField& field : attributes.fields) add_if(true, "field " + field.name, field.of);
    add_if(!attributes.groups.is_empty(), "groups", ValuesOf::faces);
    add_if(!attributes.materials.is_empty(), "materials", ValuesOf::faces);
    add_if(!attributes.material_files.empty(), "material files", ValuesOf::faces);
    return names;
}

}  // namespace boxwood
