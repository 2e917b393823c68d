// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "boxwood/mesh/mesh_data.h"

namespace boxwood {

/// Where a solid of an STL text begins or ends.
struct StlMark {
    std::size_t facet;  ///< how many are before it
    std::size_t line;
    bool is_begin;
    std::string_view name;
};

/// Gives the mesh, which has its faces, a group for each solid, if there are several, and warnings
/// of what is wrong with how solids begin and end. Marks are in the order of the file.
void read_stl_solids(std::span<const StlMark> marks, const std::string& file, MeshData& mesh);

}  // namespace boxwood
