// SPDX-License-Identifier: Apache-2.0
// Vertices of equal position have one name; each face writes down its three edges by name, and
// after a sort the faces of an edge stand side by side. O(n log n).
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "boxwood/core/parallel.h"
#include "boxwood/mesh/face_edges.h"
#include "boxwood/mesh/inspect_parts.h"
#include "boxwood/mesh/union_find.h"

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
std::uint32_t low_end(Edge edge) { return static_cast<std::uint32_t>(edge >> 32); }
std::uint32_t high_end(Edge edge) { return static_cast<std::uint32_t>(edge) >> 1; }

std::vector<Edge> sorted_edges(MeshView mesh, PositionNames names) {
    std::vector<Edge> edges(3 * mesh.faces.size(), kNoEdge);
    parallel_for(mesh.faces.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (!has_edges(mesh, names, i)) continue;
            const Vec3i& face = mesh.faces[i];
            const std::uint32_t a = names[face[0]], b = names[face[1]], c = names[face[2]];
            edges[3 * i] = edge_between(a, b);
            edges[3 * i + 1] = edge_between(b, c);
            edges[3 * i + 2] = edge_between(c, a);
        }
    });
    tbb::parallel_sort(edges);
    edges.erase(std::lower_bound(edges.begin(), edges.end(), kNoEdge), edges.end());
    return edges;
}

/// How many sets the edges fall into that share no end.
std::size_t connected_sets(const std::vector<Edge>& edges) {
    std::vector<std::uint32_t> ends;
    for (const Edge edge : edges) {
        ends.push_back(low_end(edge));
        ends.push_back(high_end(edge));
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const auto place = [&](std::uint32_t end) {
        return static_cast<std::uint32_t>(std::lower_bound(ends.begin(), ends.end(), end) -
                                          ends.begin());
    };
    UnionFind sets(ends.size());
    std::size_t count = ends.size();
    for (const Edge edge : edges) {
        const std::uint32_t low = sets.find(place(low_end(edge)));
        const std::uint32_t high = sets.find(place(high_end(edge)));
        count -= low != high;
        sets.join(low, high);
    }
    return count;
}

}  // namespace

void inspect_edges(MeshView mesh, PositionNames names, MeshReport& report) {
    const std::vector<Edge> edges = sorted_edges(mesh, names);
    std::vector<Edge> boundary;
    for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
        while (last < edges.size() && edges[last] >> 1 == edges[first] >> 1) ++last;
        const std::size_t faces = last - first;
        if (faces == 1) boundary.push_back(edges[first]);
        report.nonmanifold_edges += faces > 2;
        report.flipped_edges += faces == 2 && edges[first] == edges[first + 1];
    }
    report.boundary_edges = boundary.size();
    report.boundary_loops = connected_sets(boundary);
    report.closed = !edges.empty() && report.boundary_edges == 0 && report.nonmanifold_edges == 0;
}

}  // namespace boxwood
