// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/mesh_file.h"
#include "boxwood/mesh/ply.h"
#include "mesh/parse.h"
#include "mesh/ply_text.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

using Strings = std::vector<std::string>;

MeshData parsed_ply(std::string_view text) { return parse_ply({text, "mesh"}); }

MeshData reread(const MeshData& mesh) {
    const TempDir dir;
    write_mesh(dir / "mesh.ply", mesh, mesh.attributes);
    return read_mesh(dir / "mesh.ply");
}

/// One of everything that PLY has a place for.
MeshData full_mesh(std::size_t triangles) {
    MeshData mesh;
    static_cast<TriangleMesh&>(mesh) = generate_torus_knot(triangles);
    MeshAttributes& attributes = mesh.attributes;
    const std::size_t vertices = mesh.vertices.size();
    for (std::size_t i = 0; i < vertices; ++i) {
        const auto x = static_cast<float>(i);
        attributes.normals.values.emplace_back(x / 3, -x, 1e-30f);
        attributes.texture_coordinates.values.emplace_back(x / 7, 0.1f);
        attributes.colors.values.emplace_back(static_cast<float>(i % 256) / 255, 0, 1, 1);
    }
    attributes.fields = {{"heat", ValuesOf::vertices, std::vector<double>(vertices, 0.1)},
                         {"part", ValuesOf::faces, std::vector<double>(mesh.faces.size(), 3)}};
    return mesh;
}

TEST(WritePly, everything_reads_back_exactly) {
    MeshData mesh = full_mesh(20000);
    expect_same(reread(mesh), mesh);

    MeshAttributes& attributes = mesh.attributes;
    attributes.colors.values[5] = VertexColor(.1f, 2, -1, .5);
    attributes.texture_coordinates = {ValuesOf::corners, {}};
    for (std::size_t i = 0; i < 3 * mesh.faces.size(); ++i)
        attributes.texture_coordinates.values.emplace_back(static_cast<float>(i) / 7, 0.1f);
    attributes.normals = {ValuesOf::faces, std::vector<Vec3f>(mesh.faces.size(), {0, .1f, 1})};
    expect_same(reread(mesh), mesh);

    attributes.colors = {ValuesOf::faces,
                         std::vector<VertexColor>(mesh.faces.size(), {0, 1, 51 / 255.f, 0})};
    expect_same(reread(mesh), mesh);
}

TEST(WritePly, coordinates_of_every_kind_read_back_exactly) {
    MeshData mesh;
    static_cast<TriangleMesh&>(mesh) = generate_soup(100);
    mesh.vertices[0] = Vec3d(-0.0, 5e-324, std::nan(""));
    mesh.vertices[1] = Vec3d(0.1, 1e300, -HUGE_VAL);
    MeshData again = reread(mesh);
    EXPECT_TRUE(std::signbit(again.vertices[0].x()));
    EXPECT_EQ(again.warnings.count("vertices that aren't finite"), 2u);
    again.warnings = {};
    expect_same(again, mesh);
}

TEST(WritePly, numbers_take_no_more_room_than_they_need) {
    const TempDir dir;
    MeshData mesh = parsed_ply(kPlyTriangle);
    const auto size_and_type = [&](const char* type, std::size_t bytes) {
        write_ply(dir / "mesh.ply", mesh, mesh.attributes);
        const std::string content = content_of(dir / "mesh.ply");
        const std::string end = "end_header\n";
        return content.find(type) != content.npos &&
               content.size() - (content.find(end) + end.size()) == bytes;
    };
    EXPECT_TRUE(size_and_type("property float x", 3 * 12 + 13));
    mesh.attributes.colors.values.assign(3, VertexColor(1, 0, .2f, 1));
    EXPECT_TRUE(size_and_type("property uchar blue", 3 * 15 + 13));
    mesh.attributes.colors.values[1].x() = .3f;
    EXPECT_TRUE(size_and_type("property float blue", 3 * 24 + 13));
    mesh.vertices[1].x() = 0.1;
    EXPECT_TRUE(size_and_type("property double x", 3 * 36 + 13));
}

TEST(WritePly, names_of_fields_can_not_break_the_file_nor_be_taken_for_something_else) {
    MeshData mesh = parsed_ply(kPlyTriangle);
    for (const char* name : {"a b\nc", "x", "", "red", "green", "blue", "nx", "heat", "heat"})
        mesh.attributes.fields.push_back({name, ValuesOf::vertices, {1, 2, 3}});
    for (const char* name : {"vertex_indices", "x", "red", "green", "blue"})
        mesh.attributes.fields.push_back({name, ValuesOf::faces, {4}});
    const MeshData again = reread(mesh);
    EXPECT_EQ(again.vertices, mesh.vertices);
    EXPECT_EQ(again.faces, mesh.faces);
    EXPECT_TRUE(again.attributes.colors.is_empty());
    Strings names;
    for (const MeshField& field : again.attributes.fields) names.push_back(field.name);
    EXPECT_EQ(names, (Strings{"a_b_c", "x_", "_", "red", "green", "blue_", "nx", "heat", "heat_",
                              "vertex_indices_", "x", "red", "green", "blue_"}));
}

TEST(WritePly, points_and_nothing_at_all_read_back) {
    MeshData points = full_mesh(100);
    points.faces.clear();
    points.attributes.fields.pop_back();
    expect_same(reread(points), points);
    expect_same(reread({}), {});
}

TEST(WritePly, bad_indices_are_not_written) {
    const TempDir dir;
    MeshData mesh = parsed_ply(kPlyTriangle);
    mesh.faces[0][1] = 4;
    EXPECT_THROW(write_ply(dir / "mesh.ply", mesh), InvalidInput);
    EXPECT_FALSE(std::filesystem::exists(dir / "mesh.ply"));
}

}  // namespace
}  // namespace boxwood
