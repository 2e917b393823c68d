// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/obj.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/mesh_file.h"
#include "mesh/parse.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

MeshData parsed_obj(std::string_view text) { return parse_obj({text, "mesh"}); }

MeshData reread(const MeshData& mesh) {
    const TempDir dir;
    write_mesh(dir / "mesh.obj", mesh, mesh.attributes);
    return read_mesh(dir / "mesh.obj");
}

using Faces = std::vector<Vec3i>;
using Strings = std::vector<std::string>;

TEST(ReadObj, a_triangle_is_read) {
    const MeshData mesh = parsed_obj("v 0 0 0\nv 1.5 0 -2e1\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(mesh.vertices, (std::vector<Vec3d>{{0, 0, 0}, {1.5, 0, -20}, {0, 1, 0}}));
    EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}}));
    EXPECT_TRUE(mesh.warnings.is_empty());
    EXPECT_TRUE(mesh.attributes.normals.is_empty());
    EXPECT_TRUE(mesh.attributes.groups.is_empty());
}

TEST(ReadObj, comments_blank_lines_tabs_and_crlf_are_skipped) {
    const MeshData mesh = parsed_obj(
        "\xEF\xBB\xBF# a triangle\r\n\r\n  v\t0 0 0 # first\r\nv 1 0 0#second\r\n  \t \r\n"
        "v +0 1.0e0 .0\r\nf 1 2 3 # the only one\r\n# the end");
    EXPECT_EQ(mesh.vertices, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}}));
    EXPECT_TRUE(mesh.warnings.is_empty());
}

TEST(ReadObj, numbers_are_kept_in_double_and_rounded_correctly) {
    const MeshData mesh = parsed_obj("v 0.1 9007199254740993 1e-400\n");
    EXPECT_EQ(mesh.vertices[0], Vec3d(0.1, 9007199254740992.0, 0));
}

TEST(ReadObj, a_file_of_comments_is_an_empty_mesh) {
    const MeshData mesh = parsed_obj("# nothing\n");
    EXPECT_TRUE(mesh.vertices.empty() && mesh.faces.empty());
}

TEST(ReadObj, negative_indices_count_back_from_the_face) {
    const MeshData mesh = parsed_obj(kSquare + "f -4 -3 -2\nv 5 5 5\nf -5 -3 -1\nf 1 -2 3\n");
    EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}, {0, 2, 4}, {0, 3, 2}}));
}

TEST(ReadObj, faces_may_name_vertices_that_come_later) {
    EXPECT_EQ(parsed_obj("f 1 2 3\n" + kSquare).faces, (Faces{{0, 1, 2}}));
}

TEST(ReadObj, polygons_become_fans_and_concave_ones_are_cut_so_that_they_are_covered) {
    EXPECT_EQ(parsed_obj(kSquare + "f 1 2 3 4\n").faces, (Faces{{0, 1, 2}, {0, 2, 3}}));
    // An arrow head whose dent is at its third corner: only the cut from there covers it.
    const MeshData arrow = parsed_obj(
        "v 0 0 0\nv 4 4 0\nv 0 1 0\nv -4 4 0\nvt 0 0\nvt 1 0\nvt 2 0\nvt 3 0\nvt 4 0\n"
        "f 2/2 3/3 4/4 1/1\n");
    ASSERT_EQ(arrow.faces.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3i& face = arrow.faces[i];
        EXPECT_TRUE((face.array() == 0).any() && (face.array() == 2).any()) << i;
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(arrow.attributes.texture_coordinates.values[3 * i + k].x(),
                      static_cast<float>(face[k]));
    }
}

TEST(ReadObj, concave_polygons_too_large_to_be_cut_well_are_counted) {
    std::string star, face = "f";
    for (int i = 0; i < 1200; ++i) {
        const double angle = i * 3.14159265358979 / 600, radius = i % 2 == 0 ? 1 : 0.5;
        star += "v " + std::to_string(radius * std::cos(angle)) + " " +
                std::to_string(radius * std::sin(angle)) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    const MeshData mesh = parsed_obj(star + face + "\n");
    EXPECT_EQ(mesh.faces.size(), 1198u);
    EXPECT_EQ(warnings_of(mesh), Strings{"concave polygons of too many corners, cut into fans (1): "
                                         "mesh: found a concave polygon of more than 1024 "
                                         "corners"});
}

TEST(ReadObj, corners_may_have_texture_coordinates_and_normals) {
    const std::string values =
        "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 .5\nvt 9 9\nvn 0 0 1\nvn 0 1 0\n" + kSquare;
    const MeshData both = parsed_obj(values + "f 1/5/2 2/1/1 3/-2/-1\n");
    EXPECT_EQ(both.attributes.texture_coordinates.of, ValuesOf::corners);
    EXPECT_EQ(both.attributes.texture_coordinates.values,
              (std::vector<Vec2f>{{9, 9}, {0, 0}, {0, .5}}));
    EXPECT_EQ(both.attributes.normals.of, ValuesOf::corners);
    EXPECT_EQ(both.attributes.normals.values,
              (std::vector<Vec3f>{{0, 1, 0}, {0, 0, 1}, {0, 1, 0}}));

    const MeshData normals = parsed_obj(values + "f 1//1 2//1 3//2\n");
    EXPECT_TRUE(normals.attributes.texture_coordinates.is_empty());
    EXPECT_EQ(normals.attributes.normals.values,
              (std::vector<Vec3f>{{0, 0, 1}, {0, 0, 1}, {0, 1, 0}}));
    EXPECT_EQ(warnings_of(normals),
              Strings{"texture coordinates, none of them used, skipped (5): mesh: texture "
                      "coordinate 1 belongs to no face"});

    const MeshData slashes = parsed_obj(kSquare + "f 1/ 2// 3\n");
    EXPECT_EQ(slashes.faces, (Faces{{0, 1, 2}}));
    EXPECT_TRUE(slashes.attributes.texture_coordinates.is_empty());
}

TEST(ReadObj, values_whose_indices_are_those_of_the_vertices_belong_to_vertices) {
    const std::string normals = "vn 0 0 1\nvn 0 1 0\nvn 1 0 0\nvn 0 0 -1\n";
    const MeshData mesh = parsed_obj(kSquare + normals + "f 1//1 2//2 3//3\nf -4//-4 3//3 4//4\n");
    EXPECT_EQ(mesh.attributes.normals.of, ValuesOf::vertices);
    EXPECT_EQ(mesh.attributes.normals.values,
              (std::vector<Vec3f>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}}));
    // One normal more, and they can't be those of the vertices.
    EXPECT_EQ(parsed_obj(kSquare + normals + "vn 1 1 1\nf 1//1 2//2 3//3\n").attributes.normals.of,
              ValuesOf::corners);
    // Points have nothing that could name their normals.
    EXPECT_EQ(parsed_obj(kSquare + normals).attributes.normals.values.size(), 4u);
}

TEST(ReadObj, corners_without_what_others_have_are_given_zeros_and_counted) {
    const MeshData mesh = parsed_obj(kSquare + "vt 1 2\nf 1 2 3\nf 1/1 2/1 3/1\nf 1/1 2 3/1\n");
    EXPECT_EQ(mesh.attributes.texture_coordinates.values,
              (std::vector<Vec2f>{
                  {0, 0}, {0, 0}, {0, 0}, {1, 2}, {1, 2}, {1, 2}, {1, 2}, {0, 0}, {1, 2}}));
    EXPECT_EQ(warnings_of(mesh),
              Strings{"faces without texture coordinates, given zeros (2): mesh:face 0: found no "
                      "texture coordinate, expected one a corner"});
}

TEST(ReadObj, texture_coordinates_may_be_one_two_or_three_numbers) {
    const MeshData mesh =
        parsed_obj(kSquare + "vt .5\nvt 1 2\nvt 3 4 0\nvt 5 6 7\nf 1/1 2/2 3/3\n");
    EXPECT_EQ(mesh.attributes.texture_coordinates.values,
              (std::vector<Vec2f>{{.5, 0}, {1, 2}, {3, 4}, {5, 6}}));
    EXPECT_EQ(warnings_of(mesh), Strings{"third texture coordinates, skipped (1): mesh:8: found 7, "
                                         "expected 0 or nothing"});
}

TEST(ReadObj, numbers_behind_the_coordinates_are_colours_or_a_weight) {
    const MeshData mesh = parsed_obj("v 0 0 0 1 .5 0\nv 1 0 0 0 0 1 .25\nv 0 1 0\nv 1 1 1 2\n");
    EXPECT_EQ(mesh.attributes.colors.of, ValuesOf::vertices);
    EXPECT_EQ(
        mesh.attributes.colors.values,
        (std::vector<VertexColor>{{1, .5, 0, 1}, {0, 0, 1, .25}, {1, 1, 1, 1}, {1, 1, 1, 1}}));
    EXPECT_EQ(warnings_of(mesh),
              (Strings{"weights of vertices, skipped (1): mesh:4: vertex 4: found weight 2, "
                       "expected 1",
                       "vertices without a colour, made white (2): mesh: vertex 3: found no "
                       "colour, expected one"}));
    EXPECT_TRUE(parsed_obj("v 0 0 0 1\n").warnings.is_empty());
    EXPECT_EQ(warnings_of(parsed_obj("v 0 0 0 255 0 0\n")),
              Strings{"colours outside of 0 to 1 (1): mesh:1: vertex 1: found 255, expected 0 to "
                      "1"});
    EXPECT_EQ(warnings_of(parsed_obj("v 0 0 0 1 2\nvn 0 0 1 4\n")),
              Strings{"numbers that mean nothing, skipped (2): mesh:1: found more numbers than "
                      "expected"});
}

TEST(ReadObj, groups_and_objects_label_faces) {
    const MeshData mesh = parsed_obj(kSquare +
                                     "f 1 2 3\ng left  arm # of two\nf 1 2 3 4\no body\ng a#1\n"
                                     "f 2 3 4\ng\nf 3 4 1\ng left  arm\r\nf 1 3 4\ng unused\n");
    EXPECT_EQ(mesh.attributes.groups.names, (Strings{"", "left  arm", "a#1"}));
    EXPECT_EQ(mesh.attributes.groups.of_face, (std::vector<std::uint32_t>{0, 1, 1, 2, 0, 1}));
    EXPECT_TRUE(mesh.attributes.materials.is_empty());
}

TEST(ReadObj, materials_and_the_files_that_define_them_are_named) {
    const MeshData mesh =
        parsed_obj("mtllib a.mtl my own.mtl  sub/b.MTL\nmtllib no extension\n" + kSquare +
                   "usemtl red brick\nf 1 2 3\nusemtl b\nf 1 2 4\n"
                   "mtllib a.mtl\n");
    EXPECT_EQ(label_of_faces(mesh.attributes.materials), (Strings{"red brick", "b"}));
    EXPECT_EQ(mesh.attributes.material_files,
              (Strings{"a.mtl", "my own.mtl", "sub/b.MTL", "no extension"}));
}

TEST(ReadObj, a_backslash_joins_lines) {
    const MeshData mesh = parsed_obj(
        "v 0 \\\n0 0\nv 1 0\\\r\n 0\nv 0 1 0\\\n\n# no vertex: \\\nv 7 7 7\nf 1 \\\n2 \\\n\\\n 3 "
        "4\n"
        "g two \\\n words\nf 1 2 3\nl 1 \\\n2\n");
    EXPECT_EQ(mesh.vertices, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 7, 7}}));
    EXPECT_EQ(mesh.faces.size(), 3u);
    EXPECT_EQ(label_of_faces(mesh.attributes.groups), (Strings{"", "", "two words"}));
    EXPECT_EQ(warnings_of(mesh), Strings{"lines, skipped (1): mesh:16: found 'l'"});
}

TEST(ReadObj, what_is_skipped_is_counted_by_its_kind) {
    const MeshData mesh = parsed_obj(
        kSquare + "s 1\ns off\np 1\nl 1 2\nl 2 3\ncstype bezier\nend\nlod 3\nfoo bar\nV 1 2 3\n");
    EXPECT_EQ(
        warnings_of(mesh),
        (Strings{"points, skipped (1): mesh:7: found 'p'", "lines, skipped (2): mesh:8: found 'l'",
                 "statements of curves and surfaces, skipped (2): mesh:10: found 'cstype'",
                 "display settings, skipped (1): mesh:12: found 'lod'",
                 "statements of unknown keywords, skipped (2): mesh:13: found 'foo'"}));
}

TEST(ReadObj, faces_of_fewer_than_three_corners_are_skipped_and_counted) {
    const MeshData mesh = parsed_obj(kSquare + "f 1 2\nf\nf 1 2 3\nf 4\n");
    EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}}));
    EXPECT_EQ(warnings_of(mesh), Strings{"faces of fewer than three corners, skipped (3): mesh:5: "
                                         "found a face of 2 corners, expected at least 3"});
}

TEST(ReadObj, vertices_that_are_not_finite_are_read_and_counted) {
    const MeshData read = parsed_obj(
        "v nan 0 0\nv 1.#QNAN -1.#IND 1.#INF\nv -inf 0 -1.#INF00\n"
        "v 1e39 0 0\nf 1 2 3\n");
    ASSERT_EQ(read.vertices.size(), 4u);
    EXPECT_TRUE(std::isnan(read.vertices[0].x()));
    EXPECT_TRUE(std::isnan(read.vertices[1].x()) && std::isnan(read.vertices[1].y()));
    EXPECT_EQ(read.vertices[1].z(), HUGE_VAL);
    EXPECT_EQ(read.vertices[2], Vec3d(-HUGE_VAL, 0, -HUGE_VAL));
    EXPECT_EQ(read.vertices[3].x(), 1e39);
    EXPECT_EQ(warnings_of(read), Strings{"vertices that aren't finite (3): mesh:1: vertex 1: found "
                                         "(nan, 0, 0), expected finite numbers"});
}

/// Many statements of all kinds, in more than one chunk, with joined lines wherever those may be
/// cut.
std::string long_obj() {
    std::string text;
    for (int i = 0; i < 20000; ++i) {
        const std::string n = std::to_string(i);
        text += "v " + n + " \\\n 0 \\\r\n 0.5" + (i % 5000 == 0 ? " 1 0 0" : "") + "\nvt 0." + n +
                " 1\nvn 0 0 " + n + "\n";
        if (i % 100 == 0) text += "g group " + std::to_string(i % 7) + "\nfoo\n";
        if (i % 1000 == 0) text += "usemtl m" + n + "\n";
        if (i < 4) continue;
        if (i > 10000) {
            text += "f -1/-1/-2 -2/-2/-1 \\\n -3/-3/-4 -4/-4/-1\n";
        } else {
            text += "f -1 -2 -3\n";
        }
    }
    return text;
}

TEST(ReadObj, the_mesh_does_not_depend_on_the_number_of_threads) {
    const std::string text = long_obj();
    ASSERT_GT(text.size(), std::size_t{1} << 20) << "so that there are several chunks";
    expect_same_on_any_threads(parse_obj, text);
    const MeshData mesh = parsed_obj(text);
    ASSERT_EQ(mesh.vertices.size(), 20000u);
    EXPECT_EQ(mesh.vertices[12345], Vec3d(12345, 0, 0.5));
    EXPECT_EQ(mesh.faces.front(), Vec3i(4, 3, 2));
    EXPECT_EQ(mesh.faces.size(), 9997u + 2 * 9999u);
    EXPECT_EQ(mesh.attributes.normals.values.back().z(), 19999.0f);
}

TEST(WriteObj, everything_reads_back_exactly) {
    MeshData mesh;
    static_cast<TriangleMesh&>(mesh) = generate_soup(3000);
    mesh.vertices[0] = Vec3d(-0.0, 5e-324, std::nan(""));
    mesh.vertices[1] = Vec3d(0.1, 1e300, -HUGE_VAL);
    MeshAttributes& attributes = mesh.attributes;
    for (const ValuesOf of : {ValuesOf::vertices, ValuesOf::corners}) {
        const std::size_t count =
            of == ValuesOf::vertices ? mesh.vertices.size() : 3 * mesh.faces.size();
        attributes.normals = {of, std::vector<Vec3f>(count)};
        attributes.texture_coordinates = {of, std::vector<Vec2f>(count)};
        for (std::size_t i = 0; i < count; ++i) {
            const auto x = static_cast<float>(i);
            attributes.normals.values[i] = Vec3f(x / 7, 1e-30f * x, kNan);
            attributes.texture_coordinates.values[i] = Vec2f(-x / 3, 0.1f);
        }
        MeshData again = reread(mesh);
        EXPECT_EQ(again.warnings.count("vertices that aren't finite"), 2u);
        again.warnings = {};
        expect_same(again, mesh);
    }
}

TEST(WriteObj, colours_labels_and_names_read_back) {
    MeshData mesh = parsed_obj(kSquare + "f 1 2 3\nf 1 3 4\nf 1 2 4\n");
    MeshAttributes& attributes = mesh.attributes;
    attributes.colors.values = {{0, .1f, 1, 1}, {0, 0, 0, 1}, {1, 1, 1, 1}, {.5, 2, 0, 1}};
    attributes.groups = {{"unused", "", "a b"}, {1, 2, 1}};
    attributes.materials = {{"x", "y #1"}, {0, 0, 1}};
    attributes.material_files = {"one file.mtl", "b.mtl"};
    MeshData again = reread(mesh);
    again.warnings = {};
    attributes.materials.names[1] = "y _1";
    expect_same(again, mesh);

    attributes.colors.values[2].w() = .25;
    again = reread(mesh);
    again.warnings = {};
    expect_same(again, mesh);
}

TEST(WriteObj, names_can_not_break_the_file) {
    MeshData mesh = parsed_obj(kSquare + "f 1 2 3\nf 1 3 4\nf 1 2 4\n");
    mesh.attributes.groups = {{"a\nv 1 2 3", "#b", " c\\"}, {0, 1, 2}};
    mesh.attributes.material_files = {"x\r\nf 1 2 3"};
    const MeshData again = reread(mesh);
    EXPECT_EQ(again.vertices, mesh.vertices);
    EXPECT_EQ(again.faces, mesh.faces);
    EXPECT_EQ(label_of_faces(again.attributes.groups), (Strings{"a_v 1 2 3", "_b", "_c_"}));
    EXPECT_EQ(again.attributes.material_files, Strings{"x__f 1 2 3"});
}

TEST(WriteObj, values_of_faces_become_those_of_corners) {
    MeshData mesh = parsed_obj(kSquare + "f 1 2 3\nf 1 3 4\n");
    mesh.attributes.normals = {ValuesOf::faces, {{0, 0, 1}, {0, 1, 0}}};
    EXPECT_EQ(
        reread(mesh).attributes.normals.values,
        (std::vector<Vec3f>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}}));
}

TEST(WriteObj, points_and_nothing_at_all_read_back) {
    MeshData points = parsed_obj(kSquare);
    points.attributes.normals.values.assign(4, Vec3f(0, 0, 1));
    expect_same(reread(points), points);
    expect_same(reread({}), {});
}

TEST(WriteObj, bad_indices_are_not_written) {
    const TempDir dir;
    MeshData mesh = parsed_obj(kSquare + "f 1 2 3\n");
    mesh.faces[0][1] = 4;
    EXPECT_THROW(write_obj(dir / "mesh.obj", mesh), InvalidInput);
    EXPECT_FALSE(std::filesystem::exists(dir / "mesh.obj"));
}

}  // namespace
}  // namespace boxwood
