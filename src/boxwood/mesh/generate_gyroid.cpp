// SPDX-License-Identifier: Apache-2.0
// Marching tetrahedra: a grid of cubes, each cut into six tetrahedra around its diagonal, and in
// each tetrahedron the one or two triangles that part the corners inside the solid from those
// outside. Neighbours cut their common face alike, so the surface is closed and without branches.
// Only two layers of the grid are held at a time. Time O(n^1.5): most of the grid is empty.
// Sources: Schoen, "Infinite periodic minimal surfaces without self-intersections", NASA TN D-5541,
// 1970; Doi and Koide, "An efficient method of triangulating equi-valued surfaces by using
// tetrahedral cells", IEICE Trans. E74, 1991.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "boxwood/core/turns.h"
#include "boxwood/mesh/generate.h"

namespace boxwood {

namespace {

constexpr double kPeriods = 2;      ///< of the gyroid, across the ball
constexpr double kThickness = 0.6;  ///< the walls are where the gyroid's function is this small
constexpr double kRadius = 0.99;    ///< of the ball

// Corners of a cube are numbered by their bits: 1 for x, 2 for y, 4 for z. Each tetrahedron has
// its corners in the order that makes its volume positive, and all its edges lead from a corner
// to one with more bits.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {
    {{0, 1, 3, 7}, {0, 5, 1, 7}, {0, 2, 6, 7}, {0, 3, 2, 7}, {0, 4, 5, 7}, {0, 6, 4, 7}}};

// For each set of corners that are inside, an even permutation of the corners that puts the lone
// corner, or else the two inside, in front.
constexpr std::array<std::array<int, 4>, 16> kFrontCorners = {{{},
                                                               {0, 1, 2, 3},
                                                               {1, 0, 3, 2},
                                                               {0, 1, 2, 3},
                                                               {2, 0, 1, 3},
                                                               {0, 2, 3, 1},
                                                               {1, 2, 0, 3},
                                                               {3, 0, 2, 1},
                                                               {3, 0, 2, 1},
                                                               {0, 3, 1, 2},
                                                               {1, 3, 2, 0},
                                                               {2, 0, 1, 3},
                                                               {2, 3, 0, 1},
                                                               {1, 0, 3, 2},
                                                               {0, 1, 2, 3},
                                                               {}}};

/// About how far a point is outside the solid, from what its gyroid function and its distance from
/// the centre are. The edge between wall and ball is rounded off: no grid could follow a sharp one.
double distance_outside(double gyroid, double radius) {
    constexpr double kSteepness = 9;  // of the gyroid's function, about
    constexpr double kRounding = 0.03;
    const double from_wall = (std::abs(gyroid) - kThickness) / kSteepness;
    const double from_ball = radius - kRadius;
    const double apart = from_wall - from_ball;
    return 0.5 * (from_wall + from_ball + std::sqrt(apart * apart + kRounding * kRounding));
}

/// How far along an edge the surface is, the distance taken as linear on the edge; off the corners,
/// where the vertices of several edges would be the same point.
double crossing(double start, double end) {
    return std::clamp(start / (start - end), 0.001, 0.999);
}

class GyroidMesher {
public:
    /// The cubes have sides of 2 / resolution, and all points at the border are outside the ball.
    /// Room is made for that many triangles.
    GyroidMesher(double resolution, std::size_t triangles)
        : points_(static_cast<int>(resolution) + 2) {
        mesh_.vertices.reserve(triangles / 2 + triangles / 20);
        mesh_.faces.reserve(triangles + triangles / 10);
        for (int i = 0; i < points_; ++i) {
            const double x = (2 * i - (points_ - 1)) / resolution;
            coordinate_.push_back(x);
            sine_.push_back(sin_turns(kPeriods / 2 * x));
            cosine_.push_back(cos_turns(kPeriods / 2 * x));
        }
        const auto layer = static_cast<std::size_t>(points_) * points_;
        for (int k = 0; k < 2; ++k) {
            samples_[k].resize(layer);
            cubes_[k].resize(layer);
        }
    }

    TriangleMesh run() {
        fill_samples(0);
        for (int z = 0; z + 1 < points_; ++z) {
            fill_samples(z + 1);
            add_vertices(z);
            if (z > 0) add_faces(z - 1);
        }
        // No edge that starts in the last layer of points meets the surface.
        add_faces(points_ - 2);
        return std::move(mesh_);
    }

private:
    /// A cube, and the edges that start at its corner 0.
    struct Cube {
        unsigned inside = 0;          ///< a bit a corner
        std::array<int, 8> vertex{};  ///< on the edge to each other corner, where there is one
    };

    std::size_t at(int x, int y) const { return static_cast<std::size_t>(y) * points_ + x; }

    void fill_samples(int z) {
        std::vector<double>& samples = samples_[z & 1];
        const auto square = [](double x) { return x * x; };
        for (int y = 0; y < points_; ++y) {
            for (int x = 0; x < points_; ++x) {
                samples[at(x, y)] = distance_outside(
                    sine_[x] * cosine_[y] + sine_[y] * cosine_[z] + sine_[z] * cosine_[x],
                    std::sqrt(square(coordinate_[x]) + square(coordinate_[y]) +
                              square(coordinate_[z])));
            }
        }
    }

    double sample(int x, int y, int z, int corner) const {
        return samples_[(z + (corner >> 2)) & 1][at(x + (corner & 1), y + (corner >> 1 & 1))];
    }
    const Cube& cube(int x, int y, int z, int corner) const {
        return cubes_[(z + (corner >> 2)) & 1][at(x + (corner & 1), y + (corner >> 1 & 1))];
    }

    void add_vertices(int z) {
        for (int y = 0; y + 1 < points_; ++y) {
            for (int x = 0; x + 1 < points_; ++x) {
                Cube& here = cubes_[z & 1][at(x, y)];
                here.inside = 0;
                for (int corner = 0; corner < 8; ++corner)
                    here.inside |= unsigned{sample(x, y, z, corner) < 0} << corner;
                if (here.inside == 0 || here.inside == 255) continue;
                for (int corner = 1; corner < 8; ++corner) {
                    if ((here.inside >> corner & 1) == (here.inside & 1)) continue;
                    here.vertex[corner] = static_cast<int>(mesh_.vertices.size());
                    mesh_.vertices.push_back(vertex_on_edge(x, y, z, corner));
                }
            }
        }
    }

    Vec3d vertex_on_edge(int x, int y, int z, int corner) const {
        const double t = crossing(sample(x, y, z, 0), sample(x, y, z, corner));
        const auto coordinate = [&](int i, bool moves) {
            return moves ? coordinate_[i] + t * (coordinate_[i + 1] - coordinate_[i])
                         : coordinate_[i];
        };
        return {coordinate(x, corner & 1), coordinate(y, corner & 2), coordinate(z, corner & 4)};
    }

    void add_faces(int z) {
        for (int y = 0; y + 1 < points_; ++y) {
            for (int x = 0; x + 1 < points_; ++x) {
                const unsigned inside = cubes_[z & 1][at(x, y)].inside;
                if (inside == 0 || inside == 255) continue;
                for (const auto& tetrahedron : kTetrahedra) add_faces(x, y, z, inside, tetrahedron);
            }
        }
    }

    void add_faces(int x, int y, int z, unsigned inside, const std::array<int, 4>& corners) {
        unsigned set = 0;
        for (int k = 0; k < 4; ++k) set |= (inside >> corners[k] & 1) << k;
        if (set == 0 || set == 15) return;

        const auto& [i, j, k, l] = kFrontCorners[set];
        const int a = corners[i], b = corners[j], c = corners[k], d = corners[l];
        const auto on_edge = [&](int from, int to) {
            const int start = std::min(from, to);
            return cube(x, y, z, start).vertex[from ^ to];
        };
        const int ac = on_edge(a, c), ad = on_edge(a, d);
        const bool a_is_inside = inside >> a & 1, b_is_inside = inside >> b & 1;
        if (a_is_inside && b_is_inside) {
            const int bc = on_edge(b, c), bd = on_edge(b, d);
            mesh_.faces.emplace_back(ac, ad, bd);
            mesh_.faces.emplace_back(ac, bd, bc);
        } else if (a_is_inside) {
            mesh_.faces.emplace_back(on_edge(a, b), ac, ad);
        } else {
            mesh_.faces.emplace_back(on_edge(a, b), ad, ac);
        }
    }

    int points_;
    std::vector<double> coordinate_, sine_, cosine_;  ///< by index along any axis
    std::array<std::vector<double>, 2> samples_;      ///< distances, of the layers z and z + 1
    std::array<std::vector<Cube>, 2> cubes_;
    TriangleMesh mesh_;
};

}  // namespace

TriangleMesh generate_gyroid(std::size_t triangles) {
    // Measured: a resolution of r gives about 60.5 r^2 - 120 r triangles.
    const double n = static_cast<double>(triangles);
    const double resolution = (120 + std::sqrt(120.0 * 120.0 + 4 * 60.5 * n)) / (2 * 60.5);
    return GyroidMesher(resolution, triangles).run();
}

}  // namespace boxwood
