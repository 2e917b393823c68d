// SPDX-License-Identifier: Apache-2.0
// Vertices of equal position get one name, by sorting; each face then writes down its three edges
// by name, and after another sort the faces of an edge stand side by side. O(n log n).
#include "boxwood/mesh/inspect.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>
#include <vector>

#include "boxwood/core/parallel.h"
#include "boxwood/mesh/weld.h"

namespace boxwood {

namespace {

constexpr std::size_t kPiece = 4096;

/// An edge of a face: the names of its ends, the smaller one first, then which way the face runs
/// through it. Sorting brings the faces of an edge together.
using Edge = std::uint64_t;
constexpr Edge kNoEdge = std::numeric_limits<Edge>::max();

Edge edge_between(std::uint32_t from, std::uint32_t to) {
    const auto [low, high] = std::minmax(from, to);
    return Edge{low} << 32 | Edge{high} << 1 | Edge{from > to};
}

/// Writes the degenerate faces' count into the report, and returns all edges in order.
std::vector<Edge> sorted_edges(MeshView mesh, MeshReport& report) {
    const std::vector<std::uint32_t> names = weld(mesh.vertices);
    std::vector<Edge> edges(3 * mesh.faces.size(), kNoEdge);
    std::atomic<std::size_t> degenerate = 0;
    parallel_for(mesh.faces.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        std::size_t degenerate_here = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const bool placed = is_in_float_range(mesh, i);
            if (!placed || has_zero_area(mesh, i)) ++degenerate_here;

            const Vec3i& face = mesh.faces[i];
            const std::uint32_t a = names[face[0]], b = names[face[1]], c = names[face[2]];
            if (!placed || a == b || b == c || c == a) continue;
            edges[3 * i] = edge_between(a, b);
            edges[3 * i + 1] = edge_between(b, c);
            edges[3 * i + 2] = edge_between(c, a);
        }
        degenerate += degenerate_here;
    });
    report.degenerate_faces = degenerate;

    tbb::parallel_sort(edges);
    edges.erase(std::lower_bound(edges.begin(), edges.end(), kNoEdge), edges.end());
    return edges;
}

}  // namespace

MeshReport inspect(MeshView mesh) {
    MeshReport report;
    report.vertices = mesh.vertices.size();
    report.faces = mesh.faces.size();
    report.bounds = bounds(mesh);

    const std::vector<Edge> edges = sorted_edges(mesh, report);
    for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
        while (last < edges.size() && edges[last] >> 1 == edges[first] >> 1) ++last;
        const std::size_t faces = last - first;
        report.boundary_edges += faces == 1;
        report.nonmanifold_edges += faces > 2;
        report.flipped_edges += faces == 2 && edges[first] == edges[first + 1];
    }
    report.closed = !edges.empty() && report.boundary_edges == 0 && report.nonmanifold_edges == 0;
    return report;
}

}  // namespace boxwood
