// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "boxwood/core/box.h"
#include "boxwood/core/round_outward.h"
#include "boxwood/core/vec.h"

namespace boxwood {

/// Triangles over arrays that somebody else owns. A face holds the indices of its corners a, b, c;
/// its front is the side from which they turn counter-clockwise.
struct MeshView {
    std::span<const Vec3d> vertices;
    std::span<const Vec3i> faces;

    const Vec3d& corner(std::size_t face, int k) const { return vertices[faces[face][k]]; }
};

/// The same with vertices in float.
struct MeshViewf {
    std::span<const Vec3f> vertices;
    std::span<const Vec3i> faces;
};

/// The same vertices in double. O(n), all cores.
std::vector<Vec3d> in_double(std::span<const Vec3f> vertices);

/// Whether rounding to float would change no vertex, and all coordinates are 0 or in the normal
/// range of float, those aside that are not finite. O(n), all cores; O(1) for most meshes that
/// aren't in float.
bool are_floats(std::span<const Vec3d> vertices);

/// An indexed triangle mesh.
struct TriangleMesh {
    std::vector<Vec3d> vertices;
    std::vector<Vec3i> faces;

    operator MeshView() const { return {vertices, faces}; }
};

/// Throws InvalidInput, naming the face, when a face has an index outside [0, vertices).
void check_indices(MeshView mesh);

/// Whether boxes of floats can hold the triangle: its corners are finite and within their range.
/// Else it has no place in a tree, and no query finds it.
inline bool is_in_float_range(const MeshView& mesh, std::size_t face) {
    bool is_in_range = true;
    for (int corner = 0; corner < 3; ++corner) {
        const Vec3d& p = mesh.corner(face, corner);
        for (int k = 0; k < 3; ++k) is_in_range &= std::abs(p[k]) <= FLT_MAX;
    }
    return is_in_range;
}

/// Whether the three corners lie on a line, so that the triangle covers no area.
bool has_zero_area(MeshView mesh, std::size_t face);

/// The box of a triangle, rounded outward to float: empty when a corner is not finite or beyond the
/// range of float, so that no query visits the triangle.
inline VectorBox triangle_vector_box(MeshView mesh, std::size_t face) {
    const Pairs a(mesh.corner(face, 0)), b(mesh.corner(face, 1)), c(mesh.corner(face, 2));
    // min and max may hide a NaN. A sum keeps it, and overflows only beyond the range of float.
    const Pairs sum = {a.xy + b.xy + c.xy, a.yz + b.yz + c.yz};
    return rounded_outward(a.min(b).min(c), a.max(b).max(c), sum);
}
inline Box3f triangle_box(MeshView mesh, std::size_t face) {
    return triangle_vector_box(mesh, face).box();
}

/// The triangle_box() of each triangle. O(n), all cores.
std::vector<Box3f> triangle_boxes(MeshView mesh);

/// Likewise, in memory of at least that size that nothing else is in: for speed, as nobody touches
/// it before.
std::span<const Box3f> triangle_boxes(MeshView mesh, std::span<std::byte> memory);

/// Asks for the vertices of a triangle some places ahead, as they lie anywhere in memory.
inline void fetch_vertices_ahead(MeshView mesh, std::size_t face) {
    constexpr std::size_t kAhead = 24;
    const std::size_t ahead = std::min(face + kAhead, mesh.faces.size() - 1);
    for (int k = 0; k < 3; ++k) __builtin_prefetch(&mesh.corner(ahead, k));
}

/// The mean of each triangle's corners. O(n), all cores.
std::vector<Vec3d> triangle_centroids(MeshView mesh);

/// The box of all vertices that are finite.
Box3d bounds(MeshView mesh);

/// normalize((b - a) x (c - a)); zero for a triangle of zero area.
Vec3d geometric_normal(MeshView mesh, std::size_t face);

}  // namespace boxwood
