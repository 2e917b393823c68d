// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "boxwood/mesh/mesh_source.h"

namespace boxwood {

/// Whether the content is a .glb, the container of glTF, as its first bytes tell.
bool is_glb(const MeshSource& source);

/// The JSON of a .glb, or all of the content when it isn't one. Throws ParseError with the byte.
std::string_view glb_json(const MeshSource& source);

/// The binary chunk of a .glb, if it has one.
std::optional<std::string_view> glb_binary(const MeshSource& source);

}  // namespace boxwood
