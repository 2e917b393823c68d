// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/generate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/mesh/inspect.h"

namespace boxwood {
namespace {

double signed_volume(MeshView mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        sum += mesh.corner(i, 0).dot(mesh.corner(i, 1).cross(mesh.corner(i, 2))) / 6;
    return sum;
}

/// FNV-1a over all coordinates and indices.
std::uint64_t fingerprint(MeshView mesh) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](const auto& element) {
        for (const auto value : element) {
            unsigned char bytes[sizeof value];
            std::memcpy(bytes, &value, sizeof value);
            for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
        }
    };
    for (const Vec3d& vertex : mesh.vertices) add(vertex);
    for (const Vec3i& face : mesh.faces) add(face);
    return hash;
}

bool same(const TriangleMesh& a, const TriangleMesh& b) {
    return a.vertices == b.vertices && a.faces == b.faces;
}

std::string complaint_about(std::string_view shape, std::size_t triangles) {
    try {
        generate(shape, triangles);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "none";
}

class GeneratedShape : public testing::TestWithParam<std::string_view> {};

TEST_P(GeneratedShape, is_a_sound_mesh_of_any_size) {
    for (const std::size_t n :
         {0, 1, 2, 3, 5, 8, 13, 21, 50, 100, 200, 500, 1000, 3000, 10000, 12345, 50000}) {
        const TriangleMesh mesh = generate(GetParam(), n);
        ASSERT_FALSE(mesh.faces.empty()) << n;
        ASSERT_NO_THROW(check_indices(mesh)) << n;
        const MeshReport report = inspect(mesh);
        EXPECT_TRUE((Box3d{{-1, -1, -1}, {1, 1, 1}}).contains(report.bounds)) << n;
        EXPECT_EQ(report.degenerate_faces, 0u) << n;
        EXPECT_EQ(report.nonmanifold_edges, 0u) << n;
        EXPECT_EQ(report.flipped_edges, 0u) << n;
    }
}

TEST_P(GeneratedShape, has_about_the_number_of_triangles_asked_for) {
    for (const double n : {10000, 20000, 33333, 100000, 300000}) {
        const auto count =
            static_cast<double>(generate(GetParam(), static_cast<std::size_t>(n)).faces.size());
        EXPECT_NEAR(count / n, 1, n < 20000 ? 0.1 : 0.05) << n;
    }
}

TEST_P(GeneratedShape, does_not_depend_on_the_number_of_threads) {
    const TriangleMesh many = generate(GetParam(), 30000);
    const ThreadLimit limit(1);
    EXPECT_TRUE(same(generate(GetParam(), 30000), many));
}

INSTANTIATE_TEST_SUITE_P(Shapes, GeneratedShape, testing::ValuesIn(generated_shapes()),
                         [](const auto& shape) { return std::string(shape.param); });

class ClosedShape : public testing::TestWithParam<std::string_view> {};

TEST_P(ClosedShape, is_closed_and_has_its_front_outside) {
    for (const std::size_t n : {1, 10, 30, 100, 300, 1000, 3000, 10000, 30000, 100000}) {
        const TriangleMesh mesh = generate(GetParam(), n);
        EXPECT_TRUE(inspect(mesh).closed) << n;
        EXPECT_GT(signed_volume(mesh), 0) << n;
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, ClosedShape, testing::Values("icosphere", "torus_knot", "gyroid"),
                         [](const auto& shape) { return std::string(shape.param); });

TEST(Generate, gives_the_same_bits_on_every_machine) {
    EXPECT_EQ(fingerprint(generate("icosphere", 2000)), 4914643343503054845u);
    EXPECT_EQ(fingerprint(generate("torus_knot", 2000)), 6224122258764526336u);
    EXPECT_EQ(fingerprint(generate("gyroid", 2000)), 1408248423776802360u);
    EXPECT_EQ(fingerprint(generate("terrain", 2000)), 10515815494648717730u);
    EXPECT_EQ(fingerprint(generate("soup", 2000)), 8692860549059084631u);
    EXPECT_EQ(fingerprint(generate("stadium", 2000)), 1540739743061011410u);
    EXPECT_EQ(fingerprint(generate("interior", 10000)), 15998188981795522394u);
}

TEST(Generate, names_the_shapes_there_are_when_asked_for_another) {
    EXPECT_EQ(complaint_about("teapot", 100),
              "no shape is called 'teapot', expected one of icosphere, torus_knot, gyroid, "
              "terrain, soup, stadium, interior");
}

TEST(Generate, rejects_more_triangles_than_an_int_can_index) {
    EXPECT_EQ(complaint_about("soup", 800000000),
              "found 800000000 triangles, expected at most 715827882");
    EXPECT_EQ(complaint_about("gyroid", static_cast<std::size_t>(-1)),
              "found 18446744073709551615 triangles, expected at most 715827882");
}

TEST(Icosphere, has_all_vertices_at_distance_one) {
    for (const Vec3d& vertex : generate_icosphere(5000).vertices)
        EXPECT_NEAR(vertex.norm(), 1, 1e-15);
}

TEST(Icosphere, approaches_the_volume_of_the_ball) {
    EXPECT_NEAR(signed_volume(generate_icosphere(100000)), 4.18879, 0.001);
}

TEST(TorusKnot, is_a_single_tube_of_genus_one) {
    const TriangleMesh mesh = generate_torus_knot(10000);
    // Euler: V - E + F = 2 - 2g, with E = 3 F / 2.
    EXPECT_EQ(2 * mesh.vertices.size(), mesh.faces.size());
}

TEST(Gyroid, walls_fill_about_four_tenths_of_the_ball) {
    EXPECT_NEAR(signed_volume(generate_gyroid(100000)) / 4.18879, 0.365, 0.02);
}

TEST(Terrain, has_mountains_and_its_front_above) {
    const TriangleMesh mesh = generate_terrain(20000);
    EXPECT_GT(inspect(mesh).bounds.extent().z(), 0.3);
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        ASSERT_GT(geometric_normal(mesh, i).z(), 0) << i;
}

TEST(Terrain, has_only_its_rim_as_boundary) {
    EXPECT_EQ(inspect(generate_terrain(20000)).boundary_edges, 400u);
}

TEST(Terrain, is_another_range_for_another_seed) {
    EXPECT_FALSE(same(generate_terrain(1000, 1), generate_terrain(1000, 2)));
    EXPECT_TRUE(same(generate_terrain(1000), generate_terrain(1000, 1)));
}

/// The share of the triangles that lie within that distance of the origin.
double share_within(double radius, MeshView mesh) {
    std::size_t count = 0;
    for (const Vec3d& centroid : triangle_centroids(mesh)) count += centroid.norm() < radius;
    return static_cast<double>(count) / static_cast<double>(mesh.faces.size());
}

/// The share of the triangles whose longest side is ten times their height over it, or more.
double share_of_slivers(MeshView mesh) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const Vec3d a = mesh.corner(i, 0), b = mesh.corner(i, 1), c = mesh.corner(i, 2);
        const double longest =
            std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
        count += longest > 10 * (b - a).cross(c - a).norm();
    }
    return static_cast<double>(count) / static_cast<double>(mesh.faces.size());
}

TEST(Stadium, has_nearly_all_triangles_in_its_middle) {
    EXPECT_GT(share_within(0.04, generate_stadium(100000)), 0.85);
    EXPECT_GT(share_within(0.04, generate_stadium(1000000)), 0.98);
}

TEST(Stadium, is_a_hall_of_long_thin_triangles) {
    EXPECT_GT(share_of_slivers(generate_stadium(10000)), 0.03);
}

TEST(Interior, fills_its_hall_with_triangles_of_all_sizes) {
    const TriangleMesh mesh = generate_interior(100000);
    EXPECT_GT(inspect(mesh).bounds.extent().minCoeff(), 0.7);
    EXPECT_LT(share_within(0.3, mesh), 0.3);
    EXPECT_GT(share_of_slivers(mesh), 0.01);
}

TEST(Soup, has_sides_of_about_one_over_the_cube_root_of_the_count) {
    const TriangleMesh mesh = generate_soup(8000);
    double sum = 0;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        sum += (MeshView(mesh).corner(i, 0) - MeshView(mesh).corner(i, 1)).norm();
    EXPECT_NEAR(sum / 8000, 1.0 / 20, 0.002);
}

TEST(Soup, is_another_one_for_another_seed) {
    EXPECT_FALSE(same(generate_soup(1000, 1), generate_soup(1000, 2)));
}

}  // namespace
}  // namespace boxwood
