// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "boxwood/mesh/triangle_mesh.h"
#include "peers/peer.h"

namespace boxwood::bench {

/// A mesh as benchmarks use it: in float for the peers, and the same numbers in double for the
/// exact answers.
struct BenchMesh {
    std::string name;
    TriangleMesh exact;
    std::vector<float> vertices;
    std::vector<std::uint32_t> faces;

    PlainMesh plain() const {
        return {std::span(vertices).first(3 * exact.vertices.size()), faces};
    }
};

/// A mesh to measure: a file (OFF, or OBJ without anything but triangles and polygons), or a shape
/// and count as in gyroid:100k. With "@k" after it each triangle is cut into k * k.
/// Throws as the readers do.
BenchMesh load_bench_mesh(const std::string& argument);

/// Whether a mesh of that name is a place to be in, with a camera inside, and not a thing to look
/// at.
bool is_scene(std::string_view name);

/// What is measured when nothing is named: the meshes of ./dev data, generated scenes, the atrium
/// below the folder that the environment's BOXWOOD_SHARED names. Files that aren't there are left
/// out, with a line on stderr for each.
std::vector<std::string> default_meshes();

}  // namespace boxwood::bench
