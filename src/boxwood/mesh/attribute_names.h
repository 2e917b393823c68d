// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "boxwood/mesh/mesh_data.h"

namespace boxwood {

/// What an attribute is called: "normals", "texture coordinates", "colors", "field NAME", "groups",
/// "materials" or "material files".
struct AttributeName {
    std::string what;
    ValuesOf of = ValuesOf::vertices;

    /// "normals of vertices".
    std::string text() const;
};

/// The attributes that are there.
std::vector<AttributeName> attribute_names(const MeshAttributes& attributes);

}  // namespace boxwood
