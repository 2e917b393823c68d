// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/generate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

#include "boxwood/core/error.h"

namespace boxwood {

namespace {

// A soup has three vertices a triangle, and all of them are counted by an int.
constexpr std::size_t kMostTriangles = std::numeric_limits<int>::max() / 3;

}  // namespace

const std::vector<std::string_view>& generated_shapes() {
    static const std::vector<std::string_view> kShapes = {
        "icosphere", "torus_knot", "gyroid", "terrain", "soup", "stadium", "interior"};
    return kShapes;
}

TriangleMesh generate(std::string_view shape, std::size_t triangles) {
    if (triangles > kMostTriangles)
        throw InvalidInput(
            fmt::format("found {} triangles, expected at most {}", triangles, kMostTriangles));
    if (shape == "icosphere") return generate_icosphere(triangles);
    if (shape == "torus_knot") return generate_torus_knot(triangles);
    if (shape == "gyroid") return generate_gyroid(triangles);
    if (shape == "terrain") return generate_terrain(triangles);
    if (shape == "soup") return generate_soup(triangles);
    if (shape == "stadium") return generate_stadium(triangles);
    if (shape == "interior") return generate_interior(triangles);
    throw InvalidInput(fmt::format("no shape is called '{}', expected one of {}", shape,
                                   fmt::join(generated_shapes(), ", ")));
}

}  // namespace boxwood
