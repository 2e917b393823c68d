// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/patches.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "boxwood/core/parallel.h"
#include "boxwood/core/turns.h"

namespace boxwood {

namespace {

std::size_t triangle_count(const std::vector<Patch>& patches) {
    std::size_t count = 0;
    for (const Patch& patch : patches)
        count += 2 * static_cast<std::size_t>(patch.columns) * static_cast<std::size_t>(patch.rows);
    return count;
}

}  // namespace

int pieces(double detail, double scale, int least, double phase) {
    return std::max(least, static_cast<int>(std::floor(scale * detail + phase)));
}

std::vector<Patch> with_triangles(const PatchScene& scene, std::size_t triangles) {
    double low = 0, high = 1;
    while (triangle_count(scene(high)) < triangles) high *= 2;
    for (int step = 0; step < 40; ++step) {
        const double middle = (low + high) / 2;
        (triangle_count(scene(middle)) < triangles ? low : high) = middle;
    }
    return scene(low);
}

TriangleMesh tessellated(const std::vector<Patch>& patches) {
    std::vector<std::size_t> first_vertex, first_face;
    std::size_t vertices = 0, faces = 0;
    for (const Patch& patch : patches) {
        const auto columns = static_cast<std::size_t>(patch.columns),
                   rows = static_cast<std::size_t>(patch.rows);
        first_vertex.push_back(vertices);
        first_face.push_back(faces);
        vertices += (columns + 1) * (rows + 1);
        faces += 2 * columns * rows;
    }

    TriangleMesh mesh;
    mesh.vertices.resize(vertices);
    mesh.faces.resize(faces);
    parallel_for(patches.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            const Patch& patch = patches[p];
            Vec3d* vertex = &mesh.vertices[first_vertex[p]];
            for (int j = 0; j <= patch.rows; ++j)
                for (int i = 0; i <= patch.columns; ++i)
                    *vertex++ = patch.point(static_cast<double>(i) / patch.columns,
                                            static_cast<double>(j) / patch.rows);
            Vec3i* face = &mesh.faces[first_face[p]];
            for (int j = 0; j < patch.rows; ++j) {
                for (int i = 0; i < patch.columns; ++i) {
                    const int a = static_cast<int>(first_vertex[p]) + j * (patch.columns + 1) + i;
                    const int d = a + patch.columns + 1;
                    *face++ = Vec3i(a, a + 1, d + 1);
                    *face++ = Vec3i(a, d + 1, d);
                }
            }
        }
    });
    return mesh;
}

Patch flat_patch(const Vec3d& o, const Vec3d& a, const Vec3d& b, int columns, int rows) {
    // The far corners are sums in one order, so that patches that meet there agree to the bit.
    return {columns, rows, [=](double u, double v) -> Vec3d { return (o + u * a) + v * b; }};
}

void add_box(const Vec3d& o, const Vec3d& a, const Vec3d& b, const Vec3d& c,
             std::vector<Patch>& patches) {
    const auto corner = [=](int i, int j, int k) -> Vec3d { return ((o + i * a) + j * b) + k * c; };
    // Each side by its corners, counter-clockwise from outside.
    const auto add_side = [&](const Vec3d& p, const Vec3d& q, const Vec3d& r, const Vec3d& s) {
        patches.push_back({1, 1, [=](double u, double v) -> Vec3d {
                               return v == 0 ? (u == 0 ? p : q) : (u == 0 ? s : r);
                           }});
    };
    add_side(corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0));
    add_side(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
    add_side(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
    add_side(corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0));
    add_side(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
    add_side(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
}

Patch turned_patch(const Vec3d& base, int columns, int rows,
                   std::function<Vec2d(double v)> profile) {
    return {columns, rows, [base, profile = std::move(profile)](double u, double v) -> Vec3d {
                const Vec2d at = profile(v);
                // A full turn is the same place to the bit.
                const double turn = u == 1 ? 0 : u;
                return base + Vec3d(at.x() * cos_turns(turn), at.x() * sin_turns(turn), at.y());
            }};
}

Patch tube_patch(int columns, int rows, std::function<Vec3d(double v)> curve,
                 std::function<Vec3d(double v)> normal, const Vec3d& binormal,
                 std::function<double(double v)> radius) {
    return {columns, rows,
            [binormal, curve = std::move(curve), normal = std::move(normal),
             radius = std::move(radius)](double u, double v) -> Vec3d {
                const double turn = u == 1 ? 0 : u;
                return curve(v) +
                       radius(v) * (cos_turns(turn) * normal(v) + sin_turns(turn) * binormal);
            }};
}

}  // namespace boxwood
