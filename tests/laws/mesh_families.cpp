// SPDX-License-Identifier: Apache-2.0
#include "laws/mesh_families.h"

#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "boxwood/mesh/generate.h"
#include "laws/random.h"
#include "rounded_to_float.h"

namespace boxwood {

namespace {

void add_triangle(TriangleMesh& mesh, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const auto first = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.faces.emplace_back(first, first + 1, first + 2);
}

/// Triangles of length 1 and the given width, in random places.
TriangleMesh thin_triangles(double width, std::uint64_t seed) {
    Random random(seed);
    TriangleMesh mesh;
    for (int i = 0; i < 300; ++i) {
        const Vec3d a = random.point(-1, 1), along = random.direction();
        add_triangle(mesh, a, a + along, a + 0.5 * along + width * random.direction());
    }
    return mesh;
}

TriangleMesh soup() { return generate_soup(500); }
TriangleMesh large_soup() { return generate_soup(2000, 7); }
TriangleMesh icosphere() { return generate_icosphere(1280); }
TriangleMesh torus_knot() { return generate_torus_knot(2000); }
TriangleMesh grid() { return flat_grid(16); }
TriangleMesh cube() { return subdivided_cube(8); }
TriangleMesh needles() { return thin_triangles(1e-6, 11); }
TriangleMesh slivers() { return thin_triangles(1e-14, 12); }
TriangleMesh nothing() { return {}; }
TriangleMesh unused_vertices() { return {.vertices = {{0, 0, 0}, {1, 2, 3}}, .faces = {}}; }

TriangleMesh one_triangle() {
    return {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .faces = {{0, 1, 2}}};
}

TriangleMesh two_triangles() {
    return {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
            .faces = {{0, 1, 2}, {2, 1, 3}}};
}

TriangleMesh duplicates() {
    return {.vertices = {{0.1, 0.2, 0.3}, {1.1, 0.1, 0.4}, {0.2, 1.3, 0.7}},
            .faces = std::vector<Vec3i>(200, Vec3i(0, 1, 2))};
}

/// As duplicates, but each corner has its turn to be the first, and both sides are in front.
TriangleMesh turned_duplicates() {
    TriangleMesh mesh = duplicates();
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const int k = static_cast<int>(i % 3);
        mesh.faces[i] =
            i % 2 ? Vec3i(k, (k + 1) % 3, (k + 2) % 3) : Vec3i((k + 2) % 3, (k + 1) % 3, k);
    }
    return mesh;
}

/// Overlapping triangles in a few tilted planes.
TriangleMesh coplanar_clusters() {
    Random random(21);
    TriangleMesh mesh;
    for (int cluster = 0; cluster < 8; ++cluster) {
        const Vec3d center = random.point(-4, 4), u = random.direction();
        const Vec3d v = u.cross(random.direction()).normalized();
        const auto point = [&]() -> Vec3d {
            const double s = random.number(-1, 1), t = random.number(-1, 1);
            return center + s * u + t * v;
        };
        for (int i = 0; i < 40; ++i) {
            const Vec3d a = point(), b = point(), c = point();
            add_triangle(mesh, a, b, c);
        }
    }
    return mesh;
}

/// Triangles in planes x, y or z = a whole number: all boxes are flat, and many share a face.
TriangleMesh flat_boxes() {
    Random random(22);
    TriangleMesh mesh;
    for (int i = 0; i < 400; ++i) {
        const auto axis = static_cast<int>(random.index(3));
        const double plane = std::floor(random.number(0, 5));
        Vec3d corners[3];
        for (Vec3d& corner : corners) {
            corner = random.point(0, 5).array().floor();
            corner[axis] = plane;
        }
        add_triangle(mesh, corners[0], corners[1], corners[2]);
    }
    return mesh;
}

/// Coordinates are whole and sum to 0 in each triangle, so that centroids agree to the last bit.
TriangleMesh equal_centroids() {
    Random random(23);
    TriangleMesh mesh;
    for (int i = 0; i < 300; ++i) {
        const Vec3d a = random.point(-1000, 1000).array().floor();
        const Vec3d b = random.point(-1000, 1000).array().floor();
        add_triangle(mesh, a, b, -(a + b));
    }
    return mesh;
}

/// Boxes, too, have equal centres: one triangle, turned about the middle of its box.
TriangleMesh concentric() {
    TriangleMesh mesh;
    for (int i = 0; i < 200; ++i) {
        const double r = 1 + i % 40;
        const Vec3d a(-r, -r, -r), b(r, r, r), c(r, -r, i % 2 ? r : -r);
        add_triangle(mesh, a, b, c);
    }
    return mesh;
}

TriangleMesh with_degenerate_ones() {
    TriangleMesh mesh = generate_soup(300, 3);
    for (std::size_t i = 0; i < mesh.faces.size(); i += 3) {
        Vec3i& face = mesh.faces[i];
        switch (i % 4) {
            case 0:
                face = {face[0], face[0], face[0]};
                break;
            case 1:
                face = {face[0], face[1], face[0]};
                break;
            case 2:
                face = {face[0], face[1], face[1]};
                break;
            default:
                mesh.vertices[face[2]] =
                    0.5 * mesh.vertices[face[0]] + 0.5 * mesh.vertices[face[1]];
        }
    }
    return mesh;
}

TriangleMesh all_degenerate() {
    Random random(24);
    TriangleMesh mesh;
    for (int i = 0; i < 100; ++i) {
        const Vec3d a = random.point(-1, 1);
        add_triangle(mesh, a, a, i % 2 ? a : random.point(-1, 1));
    }
    return mesh;
}

TriangleMesh with_bad_vertices() {
    TriangleMesh mesh = generate_soup(300, 4);
    constexpr double kBad[] = {std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(), 1e39, -1e300};
    for (std::size_t i = 0; i < mesh.faces.size(); i += 4)
        mesh.vertices[mesh.faces[i][i % 3]][static_cast<int>(i / 3 % 3)] = kBad[i / 4 % 5];
    return mesh;
}

TriangleMesh only_nan() {
    TriangleMesh mesh = generate_soup(50, 5);
    for (Vec3d& vertex : mesh.vertices) vertex.setConstant(std::nan(""));
    return mesh;
}

TriangleMesh one_spans_everything() {
    TriangleMesh mesh = generate_soup(300, 6);
    add_triangle(mesh, {-100, -90, -80}, {110, 90, 70}, {-60, 100, 50});
    return mesh;
}

/// What is worth a look lies in a millionth of the width of all.
TriangleMesh one_far_away() {
    TriangleMesh mesh = generate_soup(300, 8);
    add_triangle(mesh, {1e7, 2e7, -1e7}, {1e7 + 1, 2e7, -1e7}, {1e7, 2e7 + 1, -1e7});
    return mesh;
}

TriangleMesh exponential_sizes() {
    Random random(25);
    TriangleMesh mesh;
    for (int i = 0; i < 200; ++i) {
        const double size = std::ldexp(1.0, i / 2 - 40);
        const Vec3d a = random.point(-size, size), b = random.point(-size, size);
        const Vec3d c = random.point(-size, size);
        add_triangle(mesh, a, b, c);
    }
    return mesh;
}

/// Each triangle beyond all those before, at twice their distance: top-down trees want to be
/// chains.
TriangleMesh exponential_places() {
    Random random(26);
    TriangleMesh mesh;
    for (int i = 0; i < 200; ++i) {
        const double place = std::ldexp(1.0, i / 2 - 60);
        const Vec3d a = random.point(0.1, 1), b = random.point(0.1, 1), c = random.point(0.1, 1);
        add_triangle(mesh, place * a, place * b, place * c);
    }
    return mesh;
}

TriangleMesh tiny() { return moved(soup(), 1e-6, Vec3d::Zero()); }
TriangleMesh huge() { return moved(soup(), 1e8, Vec3d::Zero()); }
TriangleMesh atomic() { return moved(soup(), 1e-30, Vec3d::Zero()); }
TriangleMesh cosmic() { return moved(soup(), 1e30, Vec3d::Zero()); }
TriangleMesh far_away() { return moved(soup(), 1, {1e8, -1e8, 1e7}); }
TriangleMesh tiny_and_far_away() { return moved(soup(), 1e-6, {1e4, 0, -1e8}); }
TriangleMesh far_along_one_axis() { return moved(icosphere(), 1, {0, 1e8, 0}); }
/// Below the least normal float, where boxes round outward by much.
TriangleMesh subnormal() { return moved(soup(), 1e-41, Vec3d::Zero()); }
TriangleMesh largest_floats() { return moved(soup(), 3e38, Vec3d::Zero()); }

// As most files have them: leaves of trees then hold the very same corners.
TriangleMesh in_float(TriangleMesh mesh) {
    mesh.vertices = rounded_to_float(mesh.vertices);
    return mesh;
}
TriangleMesh soup_in_float() { return in_float(soup()); }
TriangleMesh far_away_in_float() { return in_float(moved(torus_knot(), 1, {0, 1e5, 0})); }
TriangleMesh bad_vertices_in_float() { return in_float(with_bad_vertices()); }

}  // namespace

TriangleMesh flat_grid(int n) {
    TriangleMesh mesh;
    for (int y = 0; y <= n; ++y) {
        for (int x = 0; x <= n; ++x) mesh.vertices.emplace_back(x, y, 0);
    }
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const int i = y * (n + 1) + x;
            mesh.faces.emplace_back(i, i + 1, i + n + 2);
            mesh.faces.emplace_back(i, i + n + 2, i + n + 1);
        }
    }
    return mesh;
}

TriangleMesh subdivided_cube(int n) {
    TriangleMesh mesh;
    std::map<std::tuple<double, double, double>, int> index_of;
    const auto index = [&](const Vec3d& p) {
        const auto [place, is_new] =
            index_of.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(mesh.vertices.size()));
        if (is_new) mesh.vertices.push_back(p);
        return place->second;
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            const auto corner = [&](int i, int j) {
                Vec3d p;
                p[axis] = side;
                p[(axis + 1) % 3] = static_cast<double>(side ? i : j) / n;
                p[(axis + 2) % 3] = static_cast<double>(side ? j : i) / n;
                return index(p);
            };
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j) {
                    const int a = corner(i, j), b = corner(i + 1, j);
                    const int c = corner(i + 1, j + 1), d = corner(i, j + 1);
                    mesh.faces.emplace_back(a, b, c);
                    mesh.faces.emplace_back(a, c, d);
                }
            }
        }
    }
    return mesh;
}

TriangleMesh moved(TriangleMesh mesh, double scale, const Vec3d& offset) {
    for (Vec3d& vertex : mesh.vertices) vertex = scale * vertex + offset;
    return mesh;
}

const std::vector<MeshFamily>& mesh_families() {
    static const std::vector<MeshFamily> kFamilies = {
        {"soup", soup},
        {"large_soup", large_soup},
        {"icosphere", icosphere},
        {"torus_knot", torus_knot},
        {"grid", grid},
        {"cube", cube},
        {"needles", needles},
        {"slivers", slivers},
        {"nothing", nothing},
        {"unused_vertices", unused_vertices},
        {"one_triangle", one_triangle},
        {"two_triangles", two_triangles},
        {"duplicates", duplicates},
        {"turned_duplicates", turned_duplicates},
        {"coplanar_clusters", coplanar_clusters},
        {"flat_boxes", flat_boxes},
        {"equal_centroids", equal_centroids},
        {"concentric", concentric},
        {"with_degenerate_ones", with_degenerate_ones},
        {"all_degenerate", all_degenerate},
        {"with_bad_vertices", with_bad_vertices},
        {"only_nan", only_nan},
        {"one_spans_everything", one_spans_everything},
        {"one_far_away", one_far_away},
        {"exponential_sizes", exponential_sizes},
        {"exponential_places", exponential_places},
        {"tiny", tiny},
        {"huge", huge},
        {"atomic", atomic},
        {"cosmic", cosmic},
        {"far_away", far_away},
        {"tiny_and_far_away", tiny_and_far_away},
        {"far_along_one_axis", far_along_one_axis},
        {"subnormal", subnormal},
        {"largest_floats", largest_floats},
        {"soup_in_float", soup_in_float},
        {"far_away_in_float", far_away_in_float},
        {"bad_vertices_in_float", bad_vertices_in_float},
    };
    return kFamilies;
}

}  // namespace boxwood
