// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

// Meshes made from formulas: demos, tests and benchmarks need no files. Each has about the number
// of triangles asked for (within a few per cent for large counts, roughly for small ones, and never
// fewer than its coarsest form), fits the cube [-1, 1]^3, has no triangle of zero area, is the same
// on every machine, and takes O(n) time but where it says so. Precondition: at most 700 million
// triangles, so that an int can count the vertices.

/// A sphere of radius 1: a subdivided icosahedron, so that all triangles are alike. Closed.
TriangleMesh generate_icosphere(std::size_t triangles);

/// A tube along the (2, 3) torus knot. Closed.
TriangleMesh generate_torus_knot(std::size_t triangles);

/// The gyroid, a triply periodic minimal surface, with walls of some thickness, cut by a ball and
/// meshed by marching tetrahedra. Closed. O(n^1.5), as it looks at the whole grid.
TriangleMesh generate_gyroid(std::size_t triangles);

/// A mountain range over the square x, y in [-1, 1], z up: fractal noise on a grid. Open.
TriangleMesh generate_terrain(std::size_t triangles, std::uint32_t seed = 1);

/// Triangles of random place and shape with sides of about 1 / cbrt(n): the builders' worst enemy.
TriangleMesh generate_soup(std::size_t triangles, std::uint32_t seed = 1);

/// A hall of few large, long and thin triangles, with a teapot in its middle that has nearly all of
/// them: z up, the floor at 0, the teapot 0.02 across at the origin. Open.
TriangleMesh generate_stadium(std::size_t triangles);

/// A hall with a vault, windows, columns, arches, stairs and things that stand about: z up, the
/// floor at 0, the longer side along x. Open.
TriangleMesh generate_interior(std::size_t triangles);

/// The names that generate() knows, in the order above.
const std::vector<std::string_view>& generated_shapes();

/// The shape of that name. Throws InvalidInput, naming the shapes there are, on any other name, and
/// on more triangles than 32-bit indices can count.
TriangleMesh generate(std::string_view shape, std::size_t triangles);

}  // namespace boxwood
