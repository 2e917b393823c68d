// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/repair.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "boxwood/core/parallel.h"
#include "boxwood/core/random.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/inspect.h"
#include "mesh/small_meshes.h"

namespace boxwood {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

MeshData data_of(TriangleMesh mesh) {
    MeshData data;
    static_cast<TriangleMesh&>(data) = std::move(mesh);
    return data;
}

/// Two triangles side by side, without a shared vertex.
MeshData two_triangles() {
    return data_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                    {{0, 1, 2}, {3, 4, 5}}});
}

void turn(Vec3i& face) { std::swap(face[1], face[2]); }

TEST(Weld, vertices_at_one_position_become_the_first_of_them) {
    MeshData mesh = two_triangles();
    EXPECT_EQ(weld_vertices(mesh), 2u);
    EXPECT_EQ(mesh.vertices, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
    EXPECT_EQ(mesh.faces, (std::vector<Vec3i>{{0, 1, 2}, {1, 3, 2}}));
    EXPECT_EQ(weld_vertices(mesh), 0u);
}

TEST(Weld, minus_0_is_0_and_positions_that_differ_by_a_bit_differ) {
    MeshData mesh = data_of({{{0, 1, 2}, {-0.0, 1, 2}, {5e-324, 1, 2}}, {{0, 1, 2}}});
    EXPECT_EQ(weld_vertices(mesh), 1u);
    EXPECT_EQ(mesh.faces[0], Vec3i(0, 0, 1));
    EXPECT_FALSE(std::signbit(mesh.vertices[0].x()));
}

TEST(Weld, nan_is_no_position_and_infinity_is_one) {
    MeshData mesh =
        data_of({{{kNaN, 0, 0}, {kNaN, 0, 0}, {kInfinity, 0, 0}, {kInfinity, 0, 0}}, {}});
    EXPECT_EQ(weld_vertices(mesh), 1u);
}

TEST(Weld, values_that_agree_stay_those_of_vertices) {
    MeshData mesh = two_triangles();
    mesh.attributes.normals.values.assign(6, Vec3f(0, 0, 1));
    mesh.attributes.fields = {{"height", ValuesOf::vertices, {0, 1, 2, 1, 4, 2}}};
    weld_vertices(mesh);
    EXPECT_EQ(mesh.attributes.normals.of, ValuesOf::vertices);
    EXPECT_EQ(mesh.attributes.normals.values.size(), 4u);
    EXPECT_EQ(mesh.attributes.fields[0].of, ValuesOf::vertices);
    EXPECT_EQ(mesh.attributes.fields[0].values, (std::vector<double>{0, 1, 2, 4}));
    EXPECT_NO_THROW(check_attributes(mesh, mesh.attributes));
}

TEST(Weld, values_that_differ_become_those_of_corners) {
    MeshData mesh = two_triangles();
    mesh.attributes.fields = {{"height", ValuesOf::vertices, {0, 1, 2, 3, 4, 5}},
                              {"of faces", ValuesOf::faces, {7, 8}}};
    for (int i = 0; i < 6; ++i) {
        const auto x = static_cast<float>(i);
        mesh.attributes.normals.values.emplace_back(x, 0, 0);
        mesh.attributes.texture_coordinates.values.emplace_back(x, 1);
        mesh.attributes.colors.values.emplace_back(x, 1, 1, 1);
    }
    weld_vertices(mesh);
    EXPECT_EQ(mesh.attributes.fields[0].of, ValuesOf::corners);
    EXPECT_EQ(mesh.attributes.fields[0].values, (std::vector<double>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(mesh.attributes.fields[1].values, (std::vector<double>{7, 8}));
    EXPECT_EQ(mesh.attributes.normals.of, ValuesOf::corners);
    EXPECT_EQ(mesh.attributes.texture_coordinates.of, ValuesOf::corners);
    EXPECT_EQ(mesh.attributes.colors.of, ValuesOf::corners);
    EXPECT_EQ(mesh.attributes.normals.values[5], Vec3f(5, 0, 0));
    EXPECT_NO_THROW(check_attributes(mesh, mesh.attributes));
}

TEST(Weld, a_torn_surface_is_whole_again) {
    const TriangleMesh whole = generate_gyroid(20000);
    MeshData mesh = data_of(torn_apart(whole));
    weld_vertices(mesh);
    EXPECT_EQ(mesh.vertices.size(), whole.vertices.size());
    EXPECT_TRUE(inspect(mesh).closed);
}

TEST(DropDegenerate, what_has_no_area_or_no_place_goes_and_the_rest_keeps_what_it_has) {
    MeshData mesh =
        data_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {kNaN, 0, 0}, {1e39, 0, 0}},
                 {{0, 0, 1}, {0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {2, 1, 0}, {0, 2, 5}}});
    mesh.attributes.groups = {{"a", "b"}, {0, 1, 0, 0, 0, 1}};
    mesh.attributes.materials = {{"m", "n"}, {1, 0, 1, 1, 1, 1}};
    mesh.attributes.fields = {{"face", ValuesOf::faces, {0, 1, 2, 3, 4, 5}},
                              {"vertex", ValuesOf::vertices, {0, 1, 2, 3, 4, 5}}};
    mesh.attributes.normals.of = ValuesOf::corners;
    for (int i = 0; i < 18; ++i)
        mesh.attributes.normals.values.emplace_back(static_cast<float>(i), 0, 0);
    EXPECT_EQ(drop_degenerate_faces(mesh), 4u);
    EXPECT_EQ(mesh.faces, (std::vector<Vec3i>{{0, 1, 2}, {2, 1, 0}}));
    EXPECT_EQ(mesh.vertices.size(), 6u);
    EXPECT_EQ(mesh.attributes.groups.of_face, (std::vector<std::uint32_t>{1, 0}));
    EXPECT_EQ(mesh.attributes.materials.of_face, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(mesh.attributes.fields[0].values, (std::vector<double>{1, 4}));
    EXPECT_EQ(mesh.attributes.fields[1].values.size(), 6u);
    EXPECT_EQ(mesh.attributes.normals.values[0], Vec3f(3, 0, 0));
    EXPECT_EQ(mesh.attributes.normals.values[5], Vec3f(14, 0, 0));
    EXPECT_NO_THROW(check_attributes(mesh, mesh.attributes));
    EXPECT_EQ(inspect(mesh).degenerate_faces, 0u);
}

TEST(Orient, a_turned_face_is_turned_back) {
    MeshData mesh = data_of(tetrahedron());
    const std::vector<Vec3i> faces = mesh.faces;
    turn(mesh.faces[0]);
    const RepairReport report = orient_faces(mesh);
    EXPECT_EQ(report.flipped_faces, 1u);
    EXPECT_EQ(report.unorientable_components, 0u);
    EXPECT_EQ(mesh.faces, faces);
}

TEST(Orient, each_closed_component_gets_a_positive_volume) {
    MeshData mesh = data_of(tetrahedron());
    for (const Vec3d& p : tetrahedron().vertices) mesh.vertices.push_back(p + Vec3d(5, 5, 5));
    for (const Vec3i& face : tetrahedron().faces) mesh.faces.push_back(face + Vec3i(4, 4, 4));
    for (std::size_t i = 4; i < 8; ++i) turn(mesh.faces[i]);
    EXPECT_EQ(orient_faces(mesh).flipped_faces, 4u);
    EXPECT_NEAR(inspect(mesh).volume.value(), 1.0 / 3, 1e-12);
}

TEST(Orient, of_an_open_surface_the_fewest_faces_are_turned) {
    MeshData mesh = data_of(generate_terrain(2000));
    const std::vector<Vec3i> faces = mesh.faces;
    for (const std::size_t i : {0, 17, 500}) turn(mesh.faces[i]);
    EXPECT_EQ(orient_faces(mesh).flipped_faces, 3u);
    EXPECT_EQ(mesh.faces, faces);
}

TEST(Orient, faces_meet_where_positions_are_equal_and_corners_keep_their_values) {
    MeshData mesh = two_triangles();
    turn(mesh.faces[1]);
    mesh.attributes.fields = {{"corner", ValuesOf::corners, {0, 1, 2, 3, 5, 4}}};
    EXPECT_EQ(orient_faces(mesh).flipped_faces, 1u);
    EXPECT_EQ(mesh.faces[1], Vec3i(3, 4, 5));
    EXPECT_EQ(mesh.attributes.fields[0].values, (std::vector<double>{0, 1, 2, 3, 4, 5}));
}

TEST(Orient, a_moebius_strip_is_told_to_be_impossible) {
    MeshData mesh;
    constexpr int kParts = 5;  // of two triangles; the last one meets the first upside down
    for (int i = 0; i < kParts; ++i) {
        mesh.vertices.emplace_back(i, i * i, 0);
        mesh.vertices.emplace_back(i, i * i, 1);
    }
    for (int i = 0; i < kParts; ++i) {
        const bool is_last = i + 1 == kParts;
        const int a = 2 * i, b = 2 * i + 1, c = is_last ? 1 : a + 2, d = is_last ? 0 : a + 3;
        mesh.faces.emplace_back(a, c, b);
        mesh.faces.emplace_back(b, c, d);
    }
    EXPECT_EQ(orient_faces(mesh).unorientable_components, 1u);
}

TEST(Orient, a_random_mess_becomes_the_mesh_it_was) {
    const TriangleMesh whole = generate_torus_knot(20000);
    MeshData mesh = data_of(torn_apart(whole));
    const std::vector<Vec3i> faces = mesh.faces;
    std::size_t turned = 0;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        if (uniform(1, i, 0) < 0.5) continue;
        turn(mesh.faces[i]);
        ++turned;
    }
    EXPECT_EQ(orient_faces(mesh).flipped_faces, turned);
    EXPECT_EQ(mesh.faces, faces);
}

TEST(Repair, steps_are_taken_in_order_and_what_they_did_is_told) {
    MeshData mesh = data_of(torn_apart(tetrahedron()));
    mesh.faces.emplace_back(0, 0, 1);
    turn(mesh.faces[2]);
    const RepairStep steps[] = {RepairStep::weld, RepairStep::drop_degenerate, RepairStep::orient};
    const RepairReport report = repair(mesh, steps);
    EXPECT_EQ(report.welded_vertices, 8u);
    EXPECT_EQ(report.dropped_faces, 1u);
    EXPECT_EQ(report.flipped_faces, 1u);
    const MeshReport after = inspect(mesh);
    EXPECT_TRUE(after.closed);
    EXPECT_EQ(after.flipped_edges, 0u);
    EXPECT_EQ(after.duplicate_vertices, 0u);
}

TEST(Repair, nothing_can_be_repaired_too) {
    MeshData mesh;
    const RepairStep steps[] = {RepairStep::orient, RepairStep::drop_degenerate, RepairStep::weld};
    EXPECT_EQ(repair(mesh, steps).welded_vertices, 0u);
    EXPECT_EQ(repair(mesh, {}).flipped_faces, 0u);
}

TEST(Repair, the_result_does_not_depend_on_the_number_of_threads) {
    const auto repaired_with = [](std::size_t threads) {
        const ThreadLimit limit(threads);
        MeshData mesh = data_of(torn_apart(generate_gyroid(30000)));
        for (std::size_t i = 0; i < mesh.vertices.size(); i += 50) mesh.vertices[i] = Vec3d::Zero();
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
            mesh.attributes.normals.values.emplace_back(static_cast<float>(i), 0, 0);
        const RepairStep steps[] = {RepairStep::weld, RepairStep::drop_degenerate,
                                    RepairStep::orient};
        repair(mesh, steps);
        return mesh;
    };
    const MeshData one = repaired_with(1), many = repaired_with(8);
    EXPECT_EQ(one.vertices, many.vertices);
    EXPECT_EQ(one.faces, many.faces);
    EXPECT_EQ(one.attributes.normals.values, many.attributes.normals.values);
}

}  // namespace
}  // namespace boxwood
