// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "boxwood/mesh/gltf/document.h"
#include "boxwood/mesh/placement.h"

namespace boxwood {

/// Calls visit(node, to_world) for each node of the file's scene, parents first: of the scene that
/// it opens with, else of the first one, else for all nodes that are no child. Throws ParseError on
/// nodes that are their own descendants or have two parents, and on more depth than the limits
/// allow.
void for_each_gltf_node(const GltfDocument& document,
                        const std::function<void(const JsonReader& node, const AffineMap&)>& visit);

}  // namespace boxwood
