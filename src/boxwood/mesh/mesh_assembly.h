// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "boxwood/core/limits.h"
#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/placement.h"

namespace boxwood {

/// Puts meshes, where they stand, one behind another into one. Each becomes a group. What they have
/// belongs to vertices, materials aside, whose names are the same in all of them.
class MeshAssembly {
public:
    /// Whether the mesh can be added without going beyond the limits.
    bool has_room_for(const MeshData& part, const Limits& limits) const;

    /// Precondition: there is room. Warnings stay behind.
    void add(const MeshData& part, const AffineMap& to_world, const std::string& name);

    /// All of them. Vertices of meshes without normals, texture coordinates or colours that others
    /// have get zeros, or white. A single group or material is none.
    MeshData finish();

private:
    void add_attributes(const MeshAttributes& part, const AffineMap& to_world, bool is_moved);
    template <class Value>
    void append(MeshValues<Value>& all, const MeshValues<Value>& part, const Value& none);

    MeshData mesh_;
    std::size_t vertices_ = 0;  ///< before the part at hand
};

}  // namespace boxwood
