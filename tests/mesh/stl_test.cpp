// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/stl.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "boxwood/core/parallel.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/inspect.h"
#include "boxwood/mesh/mesh_file.h"
#include "error_of.h"
#include "mesh/stl_bytes.h"
#include "rounded_to_float.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

const std::vector<Vec3d> kCorners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

MeshData read(std::string_view bytes) { return parse_stl({bytes, "mesh.stl"}); }

TEST(ReadStl, a_binary_file_is_read) {
    const MeshData mesh = read(binary_stl(1, kUpward));
    EXPECT_EQ(mesh.vertices, kCorners);
    EXPECT_EQ(mesh.faces, (std::vector<Vec3i>{{0, 1, 2}}));
    EXPECT_TRUE(mesh.warnings.is_empty());
    EXPECT_TRUE(mesh.attributes.fields.empty());
}

TEST(ReadStl, a_binary_file_may_begin_with_solid) {
    for (const char* header :
         {"solid", "solid part\n", "SOLID ", "solidworks",
          "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 "})
        EXPECT_EQ(read(binary_stl(1, kUpward, header)).vertices, kCorners) << header;
    EXPECT_EQ(read(binary_stl(0, "", "solid")).vertices.size(), 0u);
}

TEST(ReadStl, triangles_share_no_vertices_and_stand_in_the_order_of_the_file) {
    const MeshData mesh = read(binary_stl(2, kUpward + kUpward));
    EXPECT_EQ(mesh.vertices.size(), 6u);
    EXPECT_EQ(mesh.faces, (std::vector<Vec3i>{{0, 1, 2}, {3, 4, 5}}));
}

TEST(ReadStl, attribute_bytes_become_a_field_unless_all_are_0) {
    const std::string with = stl_triangle({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}, 0xABCD);
    const MeshData mesh = read(binary_stl(2, kUpward + with));
    ASSERT_EQ(mesh.attributes.fields.size(), 1u);
    EXPECT_EQ(mesh.attributes.fields[0].name, "attribute");
    EXPECT_EQ(mesh.attributes.fields[0].of, ValuesOf::faces);
    EXPECT_EQ(mesh.attributes.fields[0].values, (std::vector<double>{0, 0xABCD}));
}

TEST(ReadStl, text_is_read) {
    const MeshData mesh = read("solid part\n" + kFacet + kFacet + "endsolid part\n");
    EXPECT_EQ(mesh.vertices.size(), 6u);
    EXPECT_EQ(mesh.faces, (std::vector<Vec3i>{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(mesh.vertices[4], kCorners[1]);
    EXPECT_TRUE(mesh.warnings.is_empty());
    EXPECT_TRUE(mesh.attributes.groups.is_empty()) << "there is one solid";
}

TEST(ReadStl, keywords_are_known_in_any_case_and_lines_may_end_anywhere) {
    const MeshData mesh = read(
        "\xEF\xBB\xBF SOLID\r\n\tFacet NORMAL 0 0\r\n1 Outer Loop Vertex 0 0 0 vertex 1\n0 0 "
        "vertex\n"
        "0 1 0 ENDLOOP endFacet\r\nEndSolid");
    EXPECT_EQ(mesh.vertices, kCorners);
    EXPECT_TRUE(mesh.warnings.is_empty());
}

TEST(ReadStl, numbers_in_text_are_doubles) {
    const MeshData mesh = read(
        "solid\nfacet normal 0 0 0\nouter loop\nvertex 0.1 +1e-3 1.7976931348623157e-300\n"
        "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid");
    EXPECT_EQ(mesh.vertices[0], Vec3d(0.1, 0.001, 1.7976931348623157e-300));
}

TEST(ReadStl, names_of_solids_may_be_anything_and_become_groups) {
    const MeshData mesh =
        read("solid facet normal # 1\n" + kFacet + "endsolid solid\nsolid\n" + kFacet + kFacet +
             "endsolid\nsolid  \xC3\xA9t\xC3\xA9 \r\nendsolid\n");
    EXPECT_EQ(mesh.attributes.groups.names,
              (std::vector<std::string>{"facet normal # 1", "", "\xC3\xA9t\xC3\xA9"}));
    EXPECT_EQ(mesh.attributes.groups.of_face, (std::vector<std::uint32_t>{0, 1, 1}));
    EXPECT_TRUE(mesh.warnings.is_empty());
}

TEST(ReadStl, an_empty_solid_is_an_empty_mesh) {
    EXPECT_EQ(read("solid\nendsolid\n").faces.size(), 0u);
    EXPECT_TRUE(read("solid nothing\nendsolid nothing").warnings.is_empty());
}

TEST(ReadStl, long_text_is_cut_at_facets_only) {
    std::string text = "solid many\n";
    constexpr int kFacets = 20000;
    for (int i = 0; i < kFacets; ++i) {
        if (i == 7777) text += "endsolid many\nsolid more\n";
        text += "facet normal 0 0 1\nouter loop\nvertex " + std::to_string(i) +
                " 0 0\nvertex 0 0 -1\nvertex\n0 1 0\nendloop\nendfacet\n";
    }
    text += "endsolid";
    ASSERT_GT(text.size(), std::size_t{1} << 20) << "so that there are several chunks";
    for (const std::size_t threads : {1, 8}) {
        const ThreadLimit limit(threads);
        const MeshData mesh = read(text);
        ASSERT_EQ(mesh.faces.size(), static_cast<std::size_t>(kFacets));
        for (std::size_t i = 0; i < kFacets; ++i)
            ASSERT_EQ(mesh.vertices[3 * i].x(), static_cast<double>(i));
        EXPECT_EQ(mesh.faces.back(), Vec3i(59997, 59998, 59999));
        EXPECT_EQ(mesh.attributes.groups.of_face[7776], 0u);
        EXPECT_EQ(mesh.attributes.groups.of_face[7777], 1u);
        EXPECT_EQ(mesh.warnings.count("normals that point to the back of their triangles, ignored"),
                  static_cast<std::size_t>(kFacets - 1));
        EXPECT_NE(mesh.warnings.kinds()[0].shown[9].find("mesh.stl:82:"), std::string::npos)
            << mesh.warnings.kinds()[0].shown[9];
    }
}

TEST(ReadStl, megabytes_of_blank_lines_and_of_solids_take_no_time) {
    const MeshData blank =
        read("solid\n" + std::string(std::size_t{8} << 20, '\n') + kFacet + "endsolid");
    EXPECT_EQ(blank.faces.size(), 1u);
    std::string text;
    for (int i = 0; i < 100000; ++i) text += "solid\n";
    const MeshData solids = read(text);
    EXPECT_EQ(solids.warnings.count("solids without an end"), 100000u);
    EXPECT_EQ(solids.attributes.groups.names.size(), 100000u);
}

TEST(WriteStl, what_is_written_reads_back_rounded_to_float) {
    const TempDir dir;
    const TriangleMesh mesh = generate_gyroid(300000);
    write_mesh(dir / "mesh.stl", mesh);
    const std::vector<Vec3d> rounded = rounded_to_float(mesh.vertices);
    for (const std::size_t threads : {1, 8}) {
        const ThreadLimit limit(threads);
        const MeshData again = read_mesh(dir / "mesh.stl");
        EXPECT_TRUE(again.warnings.is_empty());
        ASSERT_EQ(again.faces.size(), mesh.faces.size());
        for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
            for (int k = 0; k < 3; ++k)
                ASSERT_EQ(MeshView(again).corner(i, k),
                          rounded[static_cast<std::size_t>(mesh.faces[i][k])]);
        }
    }
}

TEST(WriteStl, the_bytes_are_those_of_the_format) {
    const TempDir dir;
    MeshData mesh = read(binary_stl(2, kUpward + kUpward));
    mesh.vertices[5] = mesh.vertices[4];  // no area, no normal
    mesh.attributes.fields = {{"attribute", ValuesOf::faces, {513, 65535}}};
    write_mesh(dir / "mesh.stl", mesh, mesh.attributes);
    EXPECT_EQ(content_of(dir / "mesh.stl"),
              binary_stl(2,
                         stl_triangle({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}, 513) +
                             stl_triangle({0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0}, 65535),
                         "binary STL, written by Boxwood"));
}

TEST(WriteStl, a_field_that_fits_no_16_bits_is_left_out) {
    const TempDir dir;
    MeshData mesh = read(binary_stl(1, kUpward));
    for (const double value : {-1.0, 0.5, 65536.0, std::numeric_limits<double>::quiet_NaN()}) {
        mesh.attributes.fields = {{"attribute", ValuesOf::faces, {value}}};
        write_mesh(dir / "mesh.stl", mesh, mesh.attributes);
        EXPECT_TRUE(read_mesh(dir / "mesh.stl").attributes.fields.empty()) << value;
    }
}

TEST(WriteStl, normals_of_thin_tiny_and_large_triangles_agree_with_their_corners) {
    const TempDir dir;
    TriangleMesh mesh = generate_soup(1000);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        mesh.vertices[i] *= i % 9 < 3 ? 1e-38 : i % 9 < 6 ? 1e38 : 1;
    write_mesh(dir / "mesh.stl", mesh);
    EXPECT_TRUE(read_mesh(dir / "mesh.stl").warnings.is_empty());
}

TEST(WriteStl, numbers_that_are_not_finite_read_back) {
    const TempDir dir;
    TriangleMesh mesh = read(binary_stl(1, kUpward));
    mesh.vertices[0].x() = std::numeric_limits<double>::infinity();
    mesh.vertices[1].y() = std::numeric_limits<double>::quiet_NaN();
    write_mesh(dir / "mesh.stl", mesh);
    const MeshData again = read_mesh(dir / "mesh.stl");
    EXPECT_EQ(again.vertices[0], mesh.vertices[0]);
    EXPECT_TRUE(std::isnan(again.vertices[1].y()));
    EXPECT_EQ(again.warnings.count("vertices that aren't finite"), 2u);
}

TEST(WriteStl, indices_out_of_range_are_invalid_input) {
    const TempDir dir;
    EXPECT_EQ(error_of([&] {
                  write_stl(dir / "mesh.stl", TriangleMesh{{{0, 0, 0}}, {{0, 0, 1}}});
              }),
              "InvalidInput face 0 has vertex index 1, expected 0 to 0");
    EXPECT_FALSE(std::filesystem::exists(dir / "mesh.stl"));
}

}  // namespace
}  // namespace boxwood
