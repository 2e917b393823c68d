// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/inspect.h"

#include "boxwood/mesh/inspect_parts.h"
#include "boxwood/mesh/weld.h"

namespace boxwood {

MeshReport inspect(MeshView mesh) {
    MeshReport report;
    report.vertices = mesh.vertices.size();
    report.faces = mesh.faces.size();
    report.bounds = bounds(mesh);
    const std::vector<std::uint32_t> names = weld(mesh.vertices);
    inspect_vertices(mesh, names, report);
    inspect_faces(mesh, names, report);
    inspect_edges(mesh, names, report);
    measure(mesh, report);
    return report;
}

bool is_closed(MeshView mesh) {
    MeshReport report;
    inspect_edges(mesh, weld(mesh.vertices), report);
    return report.closed;
}

}  // namespace boxwood
