// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/ply.h"

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
#include "mesh/parse.h"
#include "mesh/ply_text.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

using Faces = std::vector<Vec3i>;
using Strings = std::vector<std::string>;

MeshData parsed_ply(std::string_view text) { return parse_ply({text, "mesh"}); }

/// The file in text, and what the same numbers are in each binary format.
void expect_in_all_formats(const std::string& text, const MeshData& expected) {
    expect_same(parsed_ply(text), expected);
    for (const bool is_big : {false, true}) {
        SCOPED_TRACE(is_big);
        expect_same(parsed_ply(binary_of(text, is_big)), expected);
    }
}

TEST(ReadPly, a_triangle_is_read_in_all_formats) {
    const MeshData mesh = parsed_ply(kPlyTriangle);
    EXPECT_EQ(mesh.vertices, (std::vector<Vec3d>{{0, 0, 0}, {1.5, 0, -20}, {0, 1, 0}}));
    EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}}));
    EXPECT_TRUE(mesh.warnings.is_empty());
    EXPECT_TRUE(mesh.attributes.fields.empty());
    expect_in_all_formats(kPlyTriangle, mesh);
}

TEST(ReadPly, numbers_in_double_are_kept) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty float64 y\n"
        "property double z\nend_header\n0.1 1e-300 9007199254740993\n";
    EXPECT_EQ(parsed_ply(text).vertices[0], Vec3d(0.1, 1e-300, 9007199254740992.0));
    expect_in_all_formats(text, parsed_ply(text));
}

TEST(ReadPly, every_type_has_two_names) {
    const char* names[][2] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                              {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                              {"float", "float32"}, {"double", "float64"}};
    for (const auto& [old_name, name] : names) {
        for (const std::string type : {old_name, name}) {
            SCOPED_TRACE(type);
            const std::string text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty " + type +
                                     " x\nproperty " + type + " y\nproperty " + type +
                                     " z\nproperty " + type +
                                     " heat\nelement face 1\nproperty list uchar " + type +
                                     " vertex_index\nproperty " + type +
                                     " part\nend_header\n1 2 3 4\n5 6 7 8\n9 10 11 127\n"
                                     "3 2 1 0 100\n";
            const MeshData mesh = parsed_ply(text);
            EXPECT_EQ(mesh.vertices, (std::vector<Vec3d>{{1, 2, 3}, {5, 6, 7}, {9, 10, 11}}));
            EXPECT_EQ(mesh.faces, (Faces{{2, 1, 0}}));
            ASSERT_EQ(mesh.attributes.fields.size(), 2u);
            EXPECT_EQ(mesh.attributes.fields[0].name, "heat");
            EXPECT_EQ(mesh.attributes.fields[0].values, (std::vector<double>{4, 8, 127}));
            EXPECT_EQ(mesh.attributes.fields[1].of, ValuesOf::faces);
            EXPECT_EQ(mesh.attributes.fields[1].values, std::vector<double>{100});
            expect_in_all_formats(text, mesh);
        }
    }
}

TEST(ReadPly, counts_of_lists_may_have_any_whole_type) {
    for (const std::string type : {"char", "uchar", "short", "ushort", "int", "uint"}) {
        SCOPED_TRACE(type);
        const std::string text = with_word(kPlyTriangle, "list uchar", "list " + type);
        expect_in_all_formats(text, parsed_ply(kPlyTriangle));
    }
}

TEST(ReadPly, signs_and_sizes_of_whole_numbers_are_kept_in_all_formats) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty char x\nproperty short y\nproperty int "
        "z\nproperty uchar a1\nproperty ushort a2\nproperty uint a3\nend_header\n"
        "-128 -32768 -2147483648 255 65535 4294967295\n-1 -2 -3 1 2 3\n";
    const MeshData mesh = parsed_ply(text);
    EXPECT_EQ(mesh.vertices[0], Vec3d(-128, -32768, -2147483648.0));
    EXPECT_EQ(mesh.attributes.fields[2].values, (std::vector<double>{4294967295.0, 3}));
    expect_in_all_formats(text, mesh);
}

TEST(ReadPly, comments_blanks_and_crlf_in_the_header_are_skipped) {
    const std::string text =
        "ply\r\ncomment before the format\r\nformat ascii 1.0\r\ncomment TextureFile a.png\r\n"
        "obj_info anything\r\nelement  vertex 3\r\n\r\nproperty float x\r\ncomment inside\r\n"
        "property float y \r\nproperty\tfloat z\r\nelement face 1\r\n"
        "property list uchar int vertex_indices\r\nend_header\r\n0 0 0\r\n\r\n1.5 0 -2e1 \r\n"
        "0 1 0\r\n3 0 1 2\r\n";
    expect_in_all_formats(text, parsed_ply(kPlyTriangle));
}

TEST(ReadPly, elements_may_come_in_any_order_and_others_are_skipped) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement nothing 5\nelement camera 1\nproperty float fov\n"
        "property list int double path\nelement face 1\nproperty list uchar int vertex_indices\n"
        "element edge 2\nproperty int a\nproperty short b\nelement vertex 3\nproperty float z\n"
        "property float y\nproperty float x\nend_header\n"
        "60 2 1.5 2.5\n3 0 1 2\n1 2\n3 4\n0 0 0\n-20 0 1.5\n0 1 0\n";
    MeshData expected = parsed_ply(kPlyTriangle);
    expected.warnings.add("elements of other kinds, skipped", "mesh", 3,
                          "found 5 of the element 'nothing'");
    expected.warnings.add("elements of other kinds, skipped", "mesh", 4,
                          "found 1 of the element 'camera'");
    expected.warnings.add("elements of other kinds, skipped", "mesh", 9,
                          "found 2 of the element 'edge'");
    expect_in_all_formats(text, expected);
}

TEST(ReadPly, points_are_a_mesh_without_faces) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty "
        "float z\nend_header\n1 2 3\n4 5 6\n";
    const MeshData mesh = parsed_ply(text);
    EXPECT_EQ(mesh.vertices.size(), 2u);
    EXPECT_TRUE(mesh.faces.empty());
    expect_in_all_formats(text, mesh);
}

TEST(ReadPly, no_faces_need_no_indices) {
    EXPECT_EQ(parsed_ply("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty "
                         "float y\nproperty float z\nelement face 0\nend_header\n1 2 3\n")
                  .vertices[0],
              Vec3d(1, 2, 3));
}

TEST(ReadPly, normals_texture_coordinates_and_colours_of_vertices_are_told_by_name) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty "
        "float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty float "
        "nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\nproperty "
        "double quality\nend_header\n1 2 3 255 0 51 0 0 1 .5 .25 7\n4 5 6 0 1 2 1 0 0 0 1 8\n";
    const MeshData mesh = parsed_ply(text);
    const MeshAttributes& attributes = mesh.attributes;
    EXPECT_EQ(attributes.colors.of, ValuesOf::vertices);
    EXPECT_EQ(attributes.colors.values[0], VertexColor(1, 0, .2f, 1));
    EXPECT_EQ(attributes.colors.values[1], VertexColor(0, 1 / 255.f, 2 / 255.f, 1));
    EXPECT_EQ(attributes.normals.values, (std::vector<Vec3f>{{0, 0, 1}, {1, 0, 0}}));
    EXPECT_EQ(attributes.texture_coordinates.values, (std::vector<Vec2f>{{.5, .25}, {0, 1}}));
    ASSERT_EQ(attributes.fields.size(), 1u);
    EXPECT_EQ(attributes.fields[0].name, "quality");
    EXPECT_TRUE(mesh.warnings.is_empty());
    expect_in_all_formats(text, mesh);
}

TEST(ReadPly, colours_may_have_other_names_and_types) {
    const auto colors_of = [](const std::string& prefix, const std::string& type,
                              const std::string& numbers) {
        std::string text =
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty "
            "float y\nproperty float z\n";
        for (const char* part : {"red", "green", "blue", "alpha"})
            text += "property " + type + " " +
                    (prefix == "r" ? std::string(1, part[0]) : prefix + part) + "\n";
        return parsed_ply(text + "end_header\n0 0 0 " + numbers + "\n").attributes.colors.values;
    };
    using Colors = std::vector<VertexColor>;
    EXPECT_EQ(colors_of("", "uchar", "0 255 0 51"), (Colors{{0, 1, 0, .2f}}));
    EXPECT_EQ(colors_of("diffuse_", "ushort", "0 65535 13107 0"), (Colors{{0, 1, .2f, 0}}));
    EXPECT_EQ(colors_of("r", "float", "0 1 .25 .5"), (Colors{{0, 1, .25, .5}}));
    EXPECT_EQ(colors_of("r", "int", "0 255 51 255"), (Colors{{0, 1, .2f, 1}}));
}

TEST(ReadPly, names_that_mean_something_only_together_are_fields_when_alone) {
    const MeshData mesh = parsed_ply(
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty "
        "float z\nproperty float nx\nproperty float red\nproperty float green\nproperty float "
        "u\nend_header\n0 0 0 1 2 3 4\n");
    EXPECT_TRUE(mesh.attributes.normals.is_empty() && mesh.attributes.colors.is_empty());
    ASSERT_EQ(mesh.attributes.fields.size(), 4u);
    EXPECT_EQ(mesh.attributes.fields[3].name, "u");
    EXPECT_EQ(mesh.attributes.fields[3].values, std::vector<double>{4});
}

/// Six vertices: a square in the plane, and an arrow head with its dent at vertex 4.
const std::string kPolygons =
    "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float "
    "z\nelement face 4\nproperty uchar part\nproperty list uchar int vertex_indices\nproperty list "
    "uchar float texcoord\nproperty uchar red\nproperty uchar green\nproperty uchar "
    "blue\nend_header\n0 0 0\n4 4 0\n8 0 0\n4 8 0\n4 4 9\n-4 4 0\n"
    "7 4 0 2 3 1 8 0 0 1 0 1 1 .5 .5 255 0 0\n"
    "8 3 0 1 2 0 0 255 0\n"
    "9 2 0 1 4 9 9 9 9 1 2 3\n"
    "1 3 2 1 0 6 1 2 3 4 5 6 0 0 255\n";

TEST(ReadPly, polygons_become_triangles_with_all_that_faces_have) {
    const MeshData mesh = parsed_ply(kPolygons);
    // Only the cut through vertex 1, the dent, covers the first polygon.
    ASSERT_EQ(mesh.faces.size(), 4u);
    const std::vector<Vec2f> of_first = {{0, 0}, {.5, .5}, {1, 0}, {1, 1}};
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_TRUE((mesh.faces[i].array() == 1).any() && (mesh.faces[i].array() == 2).any());
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(mesh.attributes.texture_coordinates.values[3 * i + k],
                      of_first[mesh.faces[i][k]]);
    }
    EXPECT_EQ(mesh.faces[2], Vec3i(0, 1, 2));
    EXPECT_EQ(mesh.faces[3], Vec3i(2, 1, 0));
    EXPECT_EQ(mesh.attributes.texture_coordinates.of, ValuesOf::corners);
    EXPECT_EQ(mesh.attributes.texture_coordinates.values[6], Vec2f(0, 0));
    EXPECT_EQ(mesh.attributes.texture_coordinates.values[11], Vec2f(5, 6));
    EXPECT_EQ(mesh.attributes.colors.of, ValuesOf::faces);
    EXPECT_EQ(mesh.attributes.colors.values,
              (std::vector<VertexColor>{{1, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}}));
    ASSERT_EQ(mesh.attributes.fields.size(), 1u);
    EXPECT_EQ(mesh.attributes.fields[0].values, (std::vector<double>{7, 7, 8, 1}));
    EXPECT_EQ(warnings_of(mesh),
              (Strings{"faces without texture coordinates, given zeros (1): mesh:22: face 1 has 0 "
                       "numbers for texture coordinates, expected 6",
                       "faces of fewer than three corners, skipped (1): mesh:23: face 2 has 2 "
                       "corners, expected at least 3"}));
}

TEST(ReadPly, polygons_are_the_same_in_all_formats) {
    MeshData expected = parsed_ply(kPolygons);
    EXPECT_EQ(expected.warnings.kinds().size(), 2u);
    for (const bool is_big : {false, true}) {
        MeshData mesh = parsed_ply(binary_of(kPolygons, is_big));
        EXPECT_EQ(mesh.warnings.count("faces without texture coordinates, given zeros"), 1u);
        EXPECT_EQ(mesh.warnings.count("faces of fewer than three corners, skipped"), 1u);
        mesh.warnings = expected.warnings;  // which tell bytes, not lines
        expect_same(mesh, expected);
    }
}

TEST(ReadPly, triangles_of_one_size_keep_what_stands_around_their_indices) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float z\nelement face 2\nproperty short before\nproperty list ushort uint vertex_indices\n"
        "property double after\nend_header\n0 0 0\n1 0 0\n0 1 0\n-5 3 0 1 2 .5\n6 3 2 1 0 .25\n";
    const MeshData mesh = parsed_ply(text);
    EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}, {2, 1, 0}}));
    EXPECT_EQ(mesh.attributes.fields[0].values, (std::vector<double>{-5, 6}));
    EXPECT_EQ(mesh.attributes.fields[1].values, (std::vector<double>{.5, .25}));
    expect_in_all_formats(text, mesh);
}

TEST(ReadPly, strips_turn_around_alternately) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty "
        "float z\nelement tristrips 2\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 "
        "0 "
        "0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n9 0 1 2 3 4 -1 5 4 3\n5 0 1 1 2 3\n";
    const MeshData mesh = parsed_ply(text);
    EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {5, 4, 3}, {1, 2, 3}}));
    EXPECT_EQ(warnings_of(mesh), Strings{"strips with triangles of two equal corners, left out "
                                         "(1): mesh:17: strip 1 has 2 of them"});
}

TEST(ReadPly, strips_come_behind_faces) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
        "float z\nelement tristrips 1\nproperty list int int vertex_indices\nelement face "
        "1\nproperty list uchar int vertex_indices\nproperty float part\nend_header\n0 0 0\n1 0 "
        "0\n0 1 0\n1 1 0\n4 0 1 2 3\n3 3 2 1 .5\n";
    const MeshData mesh = parsed_ply(text);
    EXPECT_EQ(mesh.faces, (Faces{{3, 2, 1}, {0, 1, 2}, {2, 1, 3}}));
    EXPECT_EQ(mesh.attributes.fields[0].values[0], .5);
    EXPECT_TRUE(std::isnan(mesh.attributes.fields[0].values[2]));
    const MeshData binary = parsed_ply(binary_of(text, false));
    EXPECT_EQ(binary.faces, mesh.faces);
    EXPECT_EQ(binary.attributes.fields[0].values.size(), 3u);
}

TEST(ReadPly, lists_that_nobody_knows_are_skipped_and_counted) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty list uchar int near\nproperty float "
        "x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int "
        "vertex_indices\nproperty list uchar short flags\nend_header\n2 7 7 0 0 0\n0 1.5 0 -20\n1 "
        "5 "
        "0 1 0\n3 0 1 2 2 1 1\n";
    MeshData expected = parsed_ply(kPlyTriangle);
    expected.warnings.add("properties without a use, skipped", "mesh", 4,
                          "found the list 'near' of the element 'vertex'");
    expected.warnings.add("properties without a use, skipped", "mesh", 10,
                          "found the list 'flags' of the element 'face'");
    expect_in_all_formats(text, expected);
}

TEST(ReadPly, vertices_that_are_not_finite_are_read_and_counted) {
    const std::string text = with_word(with_word(kPlyTriangle, "1.5", "nan"), "-2e1", "-inf");
    const MeshData mesh = parsed_ply(text);
    EXPECT_TRUE(std::isnan(mesh.vertices[1].x()));
    EXPECT_EQ(mesh.vertices[1].z(), -HUGE_VAL);
    EXPECT_EQ(warnings_of(mesh), Strings{"vertices that aren't finite (1): mesh: vertex 1: found "
                                         "(nan, 0, -inf), expected finite numbers"});
    expect_in_all_formats(text, mesh);
}

TEST(ReadPly, what_follows_the_last_element_is_ignored_and_counted) {
    EXPECT_EQ(
        warnings_of(parsed_ply(kPlyTriangle + "3 0 1 2\n\nx\n")),
        Strings{"lines after the end of the mesh, ignored (2): mesh:14: found '3', expected the "
                "end of the file"});
    const std::string binary = binary_of(kPlyTriangle, false);
    EXPECT_EQ(
        warnings_of(parsed_ply(binary + "\n ")),
        Strings{"bytes after the end of the mesh, ignored (1): mesh:byte " +
                std::to_string(binary.size()) + ": found 2 bytes, expected the end of the file"});
}

TEST(ReadPly, the_mesh_does_not_depend_on_the_number_of_threads) {
    const TriangleMesh mesh = generate_gyroid(60000);
    for (const bool has_quads : {false, true}) {
        SCOPED_TRACE(has_quads);
        std::string text =
            "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
            "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
            std::to_string(mesh.faces.size()) +
            "\nproperty list uchar int vertex_indices\nproperty int number\n"
            "end_header\n";
        for (const Vec3d& v : mesh.vertices)
            text += std::to_string(v.x()) + " " + std::to_string(v.y()) + " 0.125\n";
        for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
            const Vec3i& f = mesh.faces[i];
            text += (has_quads && i % 3 == 0 ? "4 0 " : "3 ") + std::to_string(f.x()) + " " +
                    std::to_string(f.y()) + " " + std::to_string(f.z()) + " " + std::to_string(i) +
                    "\n";
        }
        ASSERT_GT(text.size(), std::size_t{1} << 20) << "so that there are several chunks";
        expect_same_on_any_threads(parse_ply, text);
        expect_in_all_formats(text, parsed_ply(text));
        EXPECT_EQ(parsed_ply(text).faces.back(), mesh.faces.back());
    }
}

}  // namespace
}  // namespace boxwood
