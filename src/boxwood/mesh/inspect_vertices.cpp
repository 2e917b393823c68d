// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <vector>

#include "boxwood/core/parallel.h"
#include "boxwood/mesh/inspect_parts.h"
#include "boxwood/mesh/weld.h"

namespace boxwood {

void inspect_vertices(MeshView mesh, PositionNames names, MeshReport& report) {
    constexpr std::size_t kPiece = 4096;
    const std::size_t count = mesh.vertices.size();
    std::vector<std::atomic<bool>> is_referenced(count);
    parallel_for(mesh.faces.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            for (const int index : mesh.faces[i])
                is_referenced[static_cast<std::size_t>(index)].store(true,
                                                                     std::memory_order_relaxed);
        }
    });
    const std::vector<std::uint32_t> firsts = first_at_position(mesh.vertices, names);
    for (std::size_t i = 0; i < count; ++i) {
        report.nonfinite_vertices += !mesh.vertices[i].allFinite();
        report.duplicate_vertices += firsts[i] != i;
        report.unreferenced_vertices += !is_referenced[i].load(std::memory_order_relaxed);
    }
}

}  // namespace boxwood
