// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "boxwood/core/parallel.h"
#include "boxwood/core/random.h"
#include "boxwood/mesh/generate.h"

namespace boxwood {

namespace {

/// By Newton's iteration: the C library's root is not the same on every machine.
double cube_root(double x) {
    double root = 1;
    for (int i = 0; i < 64; ++i) root = (2 * root + x / (root * root)) / 3;
    return root;
}

}  // namespace

TriangleMesh generate_soup(std::size_t triangles, std::uint32_t seed) {
    const std::size_t count = std::max<std::size_t>(1, triangles);
    // Two random points of a cube are 0.66 of its side apart.
    const double side = 1.5 / cube_root(static_cast<double>(count));

    TriangleMesh mesh;
    mesh.vertices.resize(3 * count);
    mesh.faces.resize(count);
    parallel_for(count, 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            std::uint32_t dimension = 0;
            const auto random = [&] { return uniform(seed, i, dimension++); };
            for (int axis = 0; axis < 3; ++axis) {
                const double corner = -1 + (2 - side) * random();
                for (std::size_t k = 0; k < 3; ++k)
                    mesh.vertices[3 * i + k][axis] = corner + side * random();
            }
            const int first = static_cast<int>(3 * i);
            mesh.faces[i] = Vec3i(first, first + 1, first + 2);
        }
    });
    return mesh;
}

}  // namespace boxwood
