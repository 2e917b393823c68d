// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/ply/ply_faces.h"

namespace boxwood {

void PlyFaceBatch::add(const PlyPolygon& polygon, std::span<const std::size_t> properties,
                       bool has_texture_coordinates) {
    const std::size_t triangles = polygon.corners.size() - 2;
    if (triangles > 1)
        fans.push_back({faces.size(), static_cast<std::uint32_t>(polygon.corners.size())});
    for (std::size_t k = 0; k < triangles; ++k)
        faces.emplace_back(polygon.corners[0], polygon.corners[k + 1], polygon.corners[k + 2]);

    if (has_texture_coordinates) {
        const std::size_t first = texture_coordinates.size();
        for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
            const bool has_one = polygon.texture_coordinates.size() == 2 * polygon.corners.size();
            texture_coordinates.push_back(has_one ? Vec2f(polygon.texture_coordinates[2 * k],
                                                          polygon.texture_coordinates[2 * k + 1])
                                                  : Vec2f(0, 0));
        }
        for (std::size_t k = 0; k < triangles; ++k)
            texture_faces.push_back(
                (Vec3i(0, 1, 2) + Vec3i(0, 1, 1) * static_cast<int>(k)).array() +
                static_cast<int>(first));
    }
    numbers.resize(properties.size());
    for (std::size_t i = 0; i < properties.size(); ++i)
        numbers[i].insert(numbers[i].end(), triangles, polygon.numbers[properties[i]]);
}

std::size_t PlyFaceBatch::add_strip(std::span<const int> indices) {
    std::size_t left_out = 0;
    std::size_t start = 0;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] < 0) {
            start = i + 1;
            continue;
        }
        if (i < start + 2) continue;
        const int a = indices[i - 2], b = indices[i - 1], c = indices[i];
        if (a == b || b == c || a == c) {
            ++left_out;
        } else if ((i - start) % 2 == 0) {
            faces.emplace_back(a, b, c);
        } else {
            faces.emplace_back(b, a, c);
        }
    }
    return left_out;
}

}  // namespace boxwood
