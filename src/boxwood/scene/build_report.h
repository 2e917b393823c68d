// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace boxwood {

/// What is wrong with a mesh, though it can be borne: triangles by their face indices, in order.
struct MeshFaults {
    /// A corner isn't finite or is beyond the range of float: no query finds these.
    std::vector<std::uint32_t> not_finite;
    /// The corners lie on a line. Rays may hit these only by the rounding of a seam that they fill.
    std::vector<std::uint32_t> zero_area;
};

/// What building a scene came across.
struct BuildReport {
    std::vector<MeshFaults> meshes;  ///< one a mesh

    bool has_faults() const {
        for (const MeshFaults& mesh : meshes)
            if (!mesh.not_finite.empty() || !mesh.zero_area.empty()) return true;
        return false;
    }
};

}  // namespace boxwood
