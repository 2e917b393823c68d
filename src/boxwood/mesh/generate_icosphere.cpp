// SPDX-License-Identifier: Apache-2.0
// Each face of an icosahedron becomes a triangular lattice whose points are pushed out to the
// sphere. Points on edges and corners are numbered once, so faces share them.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "boxwood/mesh/generate.h"

namespace boxwood {

namespace {

constexpr std::array<std::array<int, 3>, 20> kFaces = {
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

Vec3d on_sphere(const Vec3d& p) {
    // The order of the additions is written out: Eigen's depends on the instruction set.
    return p / std::sqrt(p.x() * p.x() + p.y() * p.y() + p.z() * p.z());
}

std::array<Vec3d, 12> icosahedron_corners() {
    const double g = (1 + std::sqrt(5.0)) / 2;
    return {Vec3d(-1, g, 0), Vec3d(1, g, 0), Vec3d(-1, -g, 0), Vec3d(1, -g, 0),
            Vec3d(0, -1, g), Vec3d(0, 1, g), Vec3d(0, -1, -g), Vec3d(0, 1, -g),
            Vec3d(g, 0, -1), Vec3d(g, 0, 1), Vec3d(-g, 0, -1), Vec3d(-g, 0, 1)};
}

class Subdivision {
public:
    /// Each edge of the icosahedron is cut into that many pieces.
    explicit Subdivision(int pieces) : n_(pieces), corners_(icosahedron_corners()) {
        const auto n = static_cast<std::size_t>(pieces);
        mesh_.vertices.reserve(10 * n * n + 2);
        mesh_.faces.reserve(20 * n * n);
        for (const Vec3d& corner : corners_) mesh_.vertices.push_back(on_sphere(corner));
        for (const auto& [a, b, c] : kFaces) {
            // Each edge is run through once in each direction, once of them upward.
            if (a < b) add_edge(a, b);
            if (b < c) add_edge(b, c);
            if (c < a) add_edge(c, a);
        }
        for (const auto& [a, b, c] : kFaces) add_face(a, b, c);
    }

    TriangleMesh mesh() { return std::move(mesh_); }

private:
    int vertex_count() const { return static_cast<int>(mesh_.vertices.size()); }

    void add_edge(int a, int b) {
        first_on_edge_[a][b] = vertex_count();
        for (int i = 1; i < n_; ++i)
            mesh_.vertices.push_back(on_sphere((n_ - i) * corners_[a] + i * corners_[b]));
    }

    /// The vertex i steps from corner a toward corner b.
    int on_edge(int a, int b, int i) const {
        if (i == 0) return a;
        if (i == n_) return b;
        return a < b ? first_on_edge_[a][b] + i - 1 : first_on_edge_[b][a] + n_ - i - 1;
    }

    void add_face(int a, int b, int c) {
        // Row j runs from the edge (a, c) to the edge (b, c), and holds n - j + 1 points.
        std::vector<int> row, next;
        for (int i = 0; i <= n_; ++i) next.push_back(on_edge(a, b, i));
        for (int j = 1; j <= n_; ++j) {
            row.swap(next);
            next.clear();
            next.push_back(on_edge(a, c, j));
            for (int i = 1; i < n_ - j; ++i) {
                next.push_back(vertex_count());
                mesh_.vertices.push_back(
                    on_sphere((n_ - i - j) * corners_[a] + i * corners_[b] + j * corners_[c]));
            }
            if (j < n_) next.push_back(on_edge(b, c, j));
            for (int i = 0; i <= n_ - j; ++i) {
                mesh_.faces.emplace_back(row[i], row[i + 1], next[i]);
                if (i < n_ - j) mesh_.faces.emplace_back(row[i + 1], next[i + 1], next[i]);
            }
        }
    }

    int n_;
    std::array<Vec3d, 12> corners_;
    std::array<std::array<int, 12>, 12> first_on_edge_ = {};
    TriangleMesh mesh_;
};

}  // namespace

TriangleMesh generate_icosphere(std::size_t triangles) {
    const double pieces = std::round(std::sqrt(static_cast<double>(triangles) / 20));
    return Subdivision(std::max(1, static_cast<int>(pieces))).mesh();
}

}  // namespace boxwood
