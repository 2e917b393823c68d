// SPDX-License-Identifier: Apache-2.0
// What OFF files may hold besides plain vertices and faces, as text and in binary.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "boxwood/core/parallel.h"
#include "boxwood/core/random.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/mesh_file.h"
#include "cases.h"
#include "mesh/off_text.h"
#include "mesh/verdict.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

using namespace std::string_view_literals;

MeshData data_of(std::string_view text) { return parse_off({text, "mesh"}); }

std::string verdict(std::string_view text) { return verdict_on(parse_off, text); }

/// Numbers as binary OFF has them.
std::string big(std::int32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(static_cast<std::uint32_t>(value) >> shift & 0xff);
    return bytes;
}
std::string big(float value) {
    std::int32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return big(bits);
}
template <class Number>
std::string all_big(std::initializer_list<Number> numbers) {
    std::string bytes;
    for (const Number number : numbers) bytes += big(number);
    return bytes;
}

const std::string kBinaryTriangle = "OFF BINARY\n" + all_big({3, 1, 3}) +
                                    all_big({0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) +
                                    all_big({3, 0, 1, 2}) + big(0);

TEST(OffVariants, normals_colours_and_texture_coordinates_come_in_this_order) {
    const MeshData mesh = data_of(
        "STCNOFF\n3 1 0\n0 0 0  0 0 1  255 0 0  0.25 0.5\n1 0 0  0 1 0  0 51 0 255  1 2\n"
        "0 1 0  1 0 0  0 0 255 0  3 4\n3 0 1 2\n");
    EXPECT_TRUE(same(mesh, parsed(kTriangle)));
    EXPECT_EQ(mesh.attributes.normals.values,
              (std::vector<Vec3f>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
    EXPECT_EQ(mesh.attributes.colors.values,
              (std::vector<VertexColor>{{1, 0, 0, 1}, {0, 0.2F, 0, 1}, {0, 0, 1, 0}}));
    EXPECT_EQ(mesh.attributes.texture_coordinates.values,
              (std::vector<Vec2f>{{0.25, 0.5}, {1, 2}, {3, 4}}));
    EXPECT_TRUE(mesh.warnings.is_empty());
}

TEST(OffVariants, colours_below_2_are_taken_as_from_0_to_1) {
    const MeshData mesh = data_of("COFF\n2 0 0\n0 0 0 0.5 1 0 1\n0 0 0 0.25 1.5 0 0.75\n");
    EXPECT_EQ(mesh.attributes.colors.values,
              (std::vector<VertexColor>{{0.5, 1, 0, 1}, {0.25, 1, 0, 0.75}}));
}

TEST(OffVariants, a_fourth_coordinate_divides_the_others) {
    EXPECT_EQ(data_of("4OFF\n1 0 0\n2 4 6 2\n").vertices[0], Vec3d(1, 2, 3));
    EXPECT_EQ(data_of("4nOFF 3\n1 0 0\n2 4 6 -2\n").vertices[0], Vec3d(-1, -2, -3));
}

TEST(OffVariants, a_dimension_of_3_is_taken) {
    for (const char* header : {"nOFF\n3\n1 0 0\n", "nOFF 3\n1 0 0\n", "nOFF 3 1 0 0\n"})
        EXPECT_EQ(data_of(header + std::string("1 2 3\n")).vertices[0], Vec3d(1, 2, 3)) << header;
}

TEST(OffVariants, colours_of_all_faces_are_kept_through_the_cutting_of_polygons) {
    const MeshData mesh = data_of(
        "OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n3 0 1 2 0 255 0 51\n2 0 1\n");
    EXPECT_EQ(mesh.faces.size(), 3u);
    EXPECT_EQ(mesh.attributes.colors.of, ValuesOf::faces);
    EXPECT_EQ(mesh.attributes.colors.values,
              (std::vector<VertexColor>{{1, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 0.2F}}));
}

TEST(OffVariants, concave_polygons_are_cut_by_their_ears) {
    const MeshData mesh = data_of("OFF\n4 1 0\n0 0 0\n4 -1 0\n1 0 0\n4 1 0\n4 1 2 3 0\n");
    for (std::size_t i = 0; i < 2; ++i) EXPECT_GT(geometric_normal(mesh, i).z(), 0) << i;
}

TEST(OffVariants, binary_files_are_the_same_mesh) {
    EXPECT_TRUE(same(data_of(kBinaryTriangle), parsed(kTriangle)));
    const MeshData mesh = data_of("STCN4nOFF BINARY\r\n" + all_big({3, 3, 1, 0}) +
                                  all_big({2.F, 4.F, 6.F, 2.F}) + all_big({0.F, 0.F, 1.F}) +
                                  all_big({1.F, 0.5F, 0.F, 1.F}) + all_big({0.25F, 0.75F}) +
                                  std::string(std::size_t{2} * 13 * 4, '\0')
                                      .replace(12, 4, big(1.F))
                                      .replace(64, 4, big(1.F)) +
                                  all_big({3, 0, 1, 2}) + big(1) + big(7.F));
    EXPECT_EQ(mesh.vertices[0], Vec3d(1, 2, 3));
    EXPECT_EQ(mesh.attributes.normals.values[0], Vec3f(0, 0, 1));
    EXPECT_EQ(mesh.attributes.colors.values[0], VertexColor(1, 0.5, 0, 1));
    EXPECT_EQ(mesh.attributes.texture_coordinates.values[0], Vec2f(0.25, 0.75));
    EXPECT_EQ(mesh.faces, (std::vector<Vec3i>{{0, 1, 2}}));
}

TEST(OffVariants, binary_faces_have_colours_too) {
    const std::string text =
        kBinaryTriangle.substr(0, kBinaryTriangle.size() - 4) + big(3) + all_big({0.5F, 0.F, 1.F});
    const MeshData mesh = data_of(text);
    EXPECT_EQ(mesh.attributes.colors.values, (std::vector<VertexColor>{{0.5, 0, 1, 1}}));
}

TEST(OffVariants, what_is_written_reads_back_exactly) {
    const TempDir dir;
    MeshData mesh;
    static_cast<TriangleMesh&>(mesh) = generate_soup(20000);
    std::uint64_t round = 0;
    const auto random = [&] { return static_cast<float>(uniform(1, ++round, 0)); };
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        mesh.attributes.normals.values.emplace_back(random() - 0.5F, random() * 1e-20F, random());
        mesh.attributes.texture_coordinates.values.emplace_back(random() * 9, -random());
        mesh.attributes.colors.values.emplace_back(random(), random(), random() * 1e-3F, random());
    }
    write_mesh(dir / "all.off", mesh, mesh.attributes);
    EXPECT_TRUE(content_of(dir / "all.off").starts_with("STCNOFF\n"));
    const MeshData again = read_mesh(dir / "all.off");
    EXPECT_TRUE(same(again, mesh));
    EXPECT_EQ(again.attributes.normals.values, mesh.attributes.normals.values);
    EXPECT_EQ(again.attributes.texture_coordinates.values,
              mesh.attributes.texture_coordinates.values);
    EXPECT_EQ(again.attributes.colors.values, mesh.attributes.colors.values);

    MeshAttributes of_faces;
    of_faces.colors.of = ValuesOf::faces;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        of_faces.colors.values.emplace_back(random(), 1, 0, random());
    write_mesh(dir / "faces.off", mesh, of_faces);
    EXPECT_EQ(read_mesh(dir / "faces.off").attributes.colors.values, of_faces.colors.values);
}

TEST(OffVariants, colours_beyond_0_to_1_are_written_as_the_nearest) {
    const TempDir dir;
    MeshData mesh = data_of("COFF\n1 0 0\n0 0 0 1 0 0 1\n");
    mesh.attributes.colors.values[0] = {7, -1, std::nanf(""), 0.5};
    write_mesh(dir / "mesh.off", mesh, mesh.attributes);
    EXPECT_EQ(read_mesh(dir / "mesh.off").attributes.colors.values[0], VertexColor(1, 0, 0, 0.5));
}

TEST(OffVariants, the_mesh_does_not_depend_on_the_number_of_threads) {
    std::string text = "COFF\n30000 30000 0\n";
    for (int i = 0; i < 30000; ++i)
        text += std::to_string(i) + " 0 " + (i % 7 == 0 ? "nan " : "1 ") + std::to_string(i % 256) +
                " 1 2\n";
    for (int i = 0; i < 30000; ++i)
        text += (i % 2 ? "4 0 1 2 " : "2 0 ") + std::to_string(i) + (i % 3 ? " 1 0 0\n" : "\n");
    const auto read_with = [&](std::size_t threads) {
        const ThreadLimit limit(threads);
        return data_of(text);
    };
    const MeshData one = read_with(1), many = read_with(8);
    EXPECT_EQ(one.faces, many.faces);
    EXPECT_EQ(one.attributes.colors.values, many.attributes.colors.values);
    ASSERT_EQ(one.warnings.kinds().size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(one.warnings.kinds()[i].kind, many.warnings.kinds()[i].kind);
        EXPECT_EQ(one.warnings.kinds()[i].count, many.warnings.kinds()[i].count);
        EXPECT_EQ(one.warnings.kinds()[i].shown, many.warnings.kinds()[i].shown);
    }
}

TEST(OffVariants, what_is_wrong_is_told) {
    const std::string two = "\n2 0 0\n0 0 0\n0 0 0\n";
    const std::string triangle = "\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2";
    const auto binary = [](std::initializer_list<std::int32_t> numbers) {
        return "OFF BINARY\n" + all_big(numbers);
    };
    const std::string one_vertex = "OFF BINARY\n" + all_big({1, 1, 0}) + std::string(12, '\0');
    const std::vector<BadFile> files = {
        {"nOFF", "2: the file ends, expected the dimension"},
        {"nOFF\n4\n1 0 0\n1 2 3 4\n",
         "2: found '4' as the dimension, expected 3, for vertices of three coordinates"},
        {"nOFF x\n",
         "1: found 'x' as the dimension, expected 3, for vertices of three coordinates"},
        {"4nOFF 2\n",
         "1: found '2' as the dimension, expected 3, for vertices of three coordinates"},
        {"nOFF 3\n", "2: the file ends, expected the counts of vertices and faces"},
        {"n4OFF 3\n", "1: found 'n4OFF', expected the keyword OFF"},
        {"4STOFF\n", "1: found '4STOFF', expected the keyword OFF"},
        {"TSOFF\n", "1: found 'TSOFF', expected the keyword OFF"},
        {"4OFF" + two, "3: vertex 0 has 3 coordinates, expected 4"},
        {"4OFF\n1 0 0\n1 2 3 0\n",
         "3: vertex 0 has 0 as its fourth coordinate, expected a number to divide the others by"},
        {"4OFF\n1 0 0\n1 2 3 -0.0\n",
         "3: vertex 0 has 0 as its fourth coordinate, expected a number to divide the others by"},
        {"4OFF\n1 0 0\n1 2 3 nan\n",
         "vertices that aren't finite (1): 3: vertex 0 is (nan, nan, nan), expected finite "
         "numbers"},
        {"4OFF\n1 0 0\n8e50 2 3 2\n",
         "vertices beyond the range of float (1): 3: vertex 0 is (4e+50, 1, 1.5), "
         "expected "
         "at most 3.4e38 in size"},
        {"NOFF" + two, "3: vertex 0 has 0 numbers of a normal, expected 3"},
        {"NOFF\n1 0 0\n1 2 3 4 5\n", "3: vertex 0 has 2 numbers of a normal, expected 3"},
        {"NOFF\n1 0 0\n1 2 3 4 5 x\n", "3: found 'x', expected a number"},
        {"COFF" + two, "3: vertex 0 has 0 numbers of a colour, expected 3 or 4"},
        {"COFF\n1 0 0\n1 2 3 4 5\n", "3: vertex 0 has 2 numbers of a colour, expected 3 or 4"},
        {"COFF\n1 0 0\n1 2 3 4 5 red\n", "3: found 'red', expected a number"},
        {"STOFF" + two, "3: vertex 0 has 0 numbers of texture coordinates, expected 2"},
        {"STCOFF\n1 0 0\n1 2 3 1 1 1 0\n",
         "3: vertex 0 has 4 numbers of colour and texture coordinates, expected 5 or 6"},
        {"COFF\n1 0 0\n1 2 3 1 1 1 1 7 7\n",
         "vertices with more numbers than the keyword says, ignored (1): 3: vertex 0 has 2 numbers "
         "more than expected"},
        {"OFF\n1 0 0\n1 2 3 255 0 0\n",
         "vertices with more numbers than the keyword says, ignored (1): 3: vertex 0 has 3 numbers "
         "more than expected"},
        {"STOFF\n1 0 0\n1 2 3 0 0 0\n",
         "vertices with more numbers than the keyword says, ignored (1): 3: vertex 0 has 1 numbers "
         "more than expected"},
        {"COFF\n1 0 0\n1 2 3 -1 256 nan\n",
         "colours beyond 0 to 255, held to that range (1): 3: found the colour -1.000000 "
         "256.000000 "
         "nan, expected 0 to 255"},
        {"OFF" + triangle + " 3\n",
         "colours of faces, skipped (1): 6: face 0 has 1 numbers for its colour, expected 3 or 4 "
         "for "
         "each face and none for vertices"},
        {"OFF" + triangle + " 3 4\n",
         "colours of faces, skipped (1): 6: face 0 has 2 numbers for its colour, expected 3 or 4 "
         "for "
         "each face and none for vertices"},
        {"OFF" + triangle + " 1 2 3 4 5\n",
         "colours of faces, skipped (1): 6: face 0 has 5 numbers for its colour, expected 3 or 4 "
         "for "
         "each face and none for vertices"},
        {"OFF" + triangle + " 1 2 300\n",
         "colours beyond 0 to 255, held to that range (1): 6: found the colour 1.000000 2.000000 "
         "300.000000, expected 0 to 255"},
        {"OFF BINARY", "byte 10: the file ends, expected the count of vertices"},
        {"OFF BINARY\n\x01"sv.data(), "byte 11: the file ends, expected the count of vertices"},
        {binary({3}), "byte 15: the file ends, expected the count of faces"},
        {binary({3, 1}), "byte 19: the file ends, expected the count of edges"},
        {binary({-1, 1, 0}),
         "byte 11: found -1 as the count of vertices, expected 0 to 2147483647"},
        {binary({0, -7, 0}), "byte 15: found -7 as the count of faces, expected 0 to 2147483647"},
        {binary({3, 1, 0}),
         "byte 23: the header promises 3 vertices, 36 bytes, but the file has 0"},
        {binary({2147483647, 2147483647, 0}),
         "byte 23: the header promises 2147483647 vertices, 25769803764 bytes, but the file has 0"},
        {binary({0, 2147483647, 0}),
         "byte 23: the header promises 2147483647 faces, at least 17179869176 bytes, but the file "
         "has 0"},
        {"nOFF BINARY\n" + all_big({4, 0, 0, 0}),
         "byte 12: found 4 as the dimension, expected 3, for vertices of three coordinates"},
        {"nOFF BINARY\n", "byte 12: the file ends, expected the dimension"},
        {one_vertex + all_big({2, 0}) + big(0),
         "byte 47: the file ends, expected the numbers of a colour of face 0"},
        {binary({0, 1, 0, 1, 0, 0}),
         "byte 27: face 0 has vertex index 0, but there are no vertices"},
        {one_vertex + all_big({1, 1}) + big(0),
         "byte 39: face 0 has vertex index 1, expected 0 to 0"},
        {one_vertex + all_big({1, -1}) + big(0),
         "byte 39: face 0 has vertex index -1, expected 0 to 0"},
        {one_vertex + all_big({-1, 0}),
         "byte 35: face 0 has -1 corners, expected 0 to 1, what the file has room for"},
        {one_vertex + all_big({2147483647, 0}),
         "byte 35: face 0 has 2147483647 corners, expected 0 to 1, what the file has room for"},
        {one_vertex + all_big({1, 0}),
         "byte 43: the file ends, expected the numbers of a colour of face 0"},
        {one_vertex + all_big({1, 0, 5}),
         "byte 43: face 0 has 5 numbers of a colour, expected 0 to 0, what the file has room for"},
        {one_vertex + all_big({1, 0, 0}),
         "faces of fewer than three corners, skipped (1): byte 35: face 0 has 1 corners, expected "
         "at "
         "least 3"},
        {kBinaryTriangle + "tail",
         "bytes after the end of the mesh, ignored (1): byte 79: found 4 bytes after the last "
         "face, "
         "expected the end of the file"},
        {"4OFF BINARY\n" + all_big({1, 0, 0}) + std::string(16, '\0'),
         "byte 24: vertex 0 has 0 as its fourth coordinate, expected a number to divide the others "
         "by"},
    };
    for (const BadFile& file : files) EXPECT_EQ(verdict(file.bytes), file.verdict) << file.bytes;
}

TEST(OffVariants, limits_are_kept) {
    const ReadOptions options = {.limits = {.max_vertices = 4, .max_faces = 2}};
    const std::string four = "\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    EXPECT_EQ(verdict_on(parse_off, "OFF\n4 1 0" + four + "4 0 1 2 3\n", options), "fine");
    EXPECT_EQ(verdict_on(parse_off, "OFF\n5 1 0" + four, options),
              "2: found '5' as the count of vertices, expected 0 to 4");
    EXPECT_EQ(verdict_on(parse_off, "OFF\n4 1 0" + four + "5 0 1 2 3 0\n", options),
              "found 3 triangles, expected at most 2");
}

TEST(OffVariants, a_binary_file_cut_anywhere_is_an_error) {
    for (std::size_t size = 0; size < kBinaryTriangle.size(); ++size)
        EXPECT_THROW(data_of(kBinaryTriangle.substr(0, size)), ParseError) << size;
}

TEST(OffVariants, files_with_random_changes_are_an_error_or_a_mesh) {
    const std::string text =
        "STCNOFF\n4 2 0\n0 0 0 0 0 1 255 0 0 1 0 0\n1 0 0 0 0 1 255 0 0 0 1\n"
        "1 1 0 0 0 1 255 0 0 0 1\n0 1 0 0 0 1 2 0 0 0 1\n3 0 1 2 1 0 0\n4 0 1 2 3 1 1 1\n";
    for (const std::string& valid : {text, kBinaryTriangle})
        expect_errors_or_meshes_when_changed(parse_off, valid, "0123456789.-+eE#nCSTF \n\0\xff"sv,
                                             5000);
}

}  // namespace
}  // namespace boxwood
