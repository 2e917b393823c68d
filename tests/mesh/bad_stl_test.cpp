// SPDX-License-Identifier: Apache-2.0
// What is wrong with a file is told with its line or byte, what was found there and what was
// expected.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "boxwood/core/random.h"
#include "boxwood/mesh/stl.h"
#include "cases.h"
#include "mesh/stl_bytes.h"
#include "mesh/verdict.h"

namespace boxwood {
namespace {

using namespace std::string_literals;
using namespace std::string_view_literals;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::string verdict(std::string_view bytes) { return verdict_on(parse_stl, bytes); }

std::string replaced(std::string text, std::string_view what, std::string_view with) {
    return text.replace(text.find(what), what.size(), with);
}

/// A text with one facet, in which something is replaced.
std::string facet_with(std::string_view what, std::string_view with) {
    return "solid\n" + replaced(kFacet, what, with) + "endsolid\n";
}

TEST(ReadStl, what_is_wrong_with_a_binary_file_is_told) {
    const std::string control = binary_stl(1, kUpward, "solid\x01");
    const std::string too_small =
        "and no text that begins with \"solid\", expected at least 84 of a "
        "binary STL file";
    const std::vector<BadFile> files = {
        {"", "the file is empty, expected STL"},
        {"x", "byte 0: found 1 bytes " + too_small},
        {"solidx", "byte 0: found 6 bytes " + too_small},
        {"soli", "byte 0: found 4 bytes " + too_small},
        {std::string(83, '\0'), "byte 0: found 83 bytes " + too_small},
        {"solid\0x"s, "byte 0: found 7 bytes " + too_small},
        {binary_stl(1, ""),
         "byte 80: the header promises 1 triangles, 134 bytes, but the file has 84"},
        {binary_stl(2, kUpward),
         "byte 80: the header promises 2 triangles, 184 bytes, but the file has 134"},
        {binary_stl(1, kUpward.substr(0, 49)),
         "byte 80: the header promises 1 triangles, 134 bytes, but the file has 133"},
        {binary_stl(4294967295U, kUpward),
         "byte 80: the header promises 4294967295 triangles, 214748364834 bytes, but the file has "
         "134"},
        {binary_stl(85899345, ""),
         "byte 80: the header promises 85899345 triangles, 4294967334 bytes, but the file has 84"},
        {binary_stl(0x01000000, kUpward),
         "byte 80: the header promises 16777216 triangles, 838860884 bytes, but the file has 134"},
        {binary_stl(0, kUpward), "byte 80: the header promises 0 triangles, but 50 bytes follow"},
        {binary_stl(0, "x"), "byte 80: the header promises 0 triangles, but 1 bytes follow"},
        {control + "?",
         "bytes after the end of the mesh, ignored (1): byte 134: found 1 bytes after the last "
         "triangle, expected the end of the file"},
        {binary_stl(1, kUpward + kUpward),
         "bytes after the end of the mesh, ignored (1): byte 134: found 50 bytes after the last "
         "triangle, expected the end of the file"},
        {binary_stl(2, kUpward, "solid"),
         "byte 80: the header promises 2 triangles, 184 bytes, but the file has 134"},
        {binary_stl(1, stl_triangle({0, 0, -1, 0, 0, 0, 1, 0, 0, 0, 1, 0})),
         "normals that point to the back of their triangles, ignored (1): byte 84: triangle 0 "
         "turns "
         "clockwise as seen from where its normal points"},
        {binary_stl(3, kUpward + stl_triangle({9, 9, -.1F, 0, 0, 0, 1, 0, 0, 0, 1, 0}) +
                           stl_triangle({0, 0, -kInfinity, 0, 0, 0, 1, 0, 0, 0, 1, 0})),
         "normals that point to the back of their triangles, ignored (2): byte 134: triangle 1 "
         "turns "
         "clockwise as seen from where its normal points"},
        {binary_stl(1, stl_triangle({0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0})), "fine"},
        {binary_stl(1, stl_triangle({kNaN, 0, -1, 0, 0, 0, 1, 0, 0, 0, 1, 0})), "fine"},
        {binary_stl(1, stl_triangle({0, 0, 1, 0, kNaN, 0, 1, 0, 0, 0, 1, 0})),
         "vertices that aren't finite (1): byte 96: vertex 0 is (0, nan, 0), expected finite "
         "numbers"},
        {binary_stl(1, stl_triangle({0, 0, 1, 0, 0, 0, 1, 0, -kInfinity, kNaN, 1, 0})),
         "vertices that aren't finite (2): byte 108: vertex 1 is (1, 0, -inf), expected finite "
         "numbers"},
        {binary_stl(1, stl_triangle({0, 0, 1, 0, 0, 0, kInfinity, 0, 0, -kInfinity, 1, 0})),
         "vertices that aren't finite (2): byte 108: vertex 1 is (inf, 0, 0), expected finite "
         "numbers"},
        {binary_stl(1, stl_triangle({0, -1, 0, 3e38F, 3e38F, 3e38F, 3e38F, 3e38F, 0, 0, 3e38F, 0})),
         "normals that point to the back of their triangles, ignored (1): byte 84: triangle 0 "
         "turns "
         "clockwise as seen from where its normal points"},
    };
    for (const BadFile& file : files) EXPECT_EQ(verdict(file.bytes), file.verdict);
}

TEST(ReadStl, what_is_wrong_with_text_is_told) {
    const std::string unfinished = "solids without an end (1): ";
    const std::vector<BadFile> files = {
        {"solid",
         unfinished + "1: the solid has no end, expected endsolid before the end of the file"},
        {"solid x\n" + kFacet,
         unfinished + "1: the solid has no end, expected endsolid before the end of the file"},
        {"solid a\nendsolid a\n\nsolid b\n" + kFacet,
         unfinished + "4: the solid has no end, expected endsolid before the end of the file"},
        {"solid a\n" + kFacet + "solid b\n" + kFacet + "endsolid",
         unfinished + "1: the solid has no end, expected endsolid before the next one"},
        {"solid a\nendsolid\n" + kFacet + kFacet,
         "facets outside of solids (2): 2: facet 0 comes after the end of its solid, expected "
         "solid "
         "before it"},
        {"solid a\n" + kFacet + "endsolid\n" + kFacet + "solid\nendsolid\n",
         "facets outside of solids (1): 9: facet 1 comes after the end of its solid, expected "
         "solid "
         "before it"},
        {"solid\nendsolid\nendsolid\n",
         "ends of no solid, ignored (1): 3: found endsolid, expected solid before it"},
        {"solid\nfoo\nendsolid\n", "2: found 'foo', expected facet, solid or endsolid"},
        {"solid\n# no comments here\nendsolid\n",
         "2: found '#', expected facet, solid or endsolid"},
        {"solid\nendfacet\n", "2: found 'endfacet', expected facet, solid or endsolid"},
        {"solid\nfacets", "2: found 'facets', expected facet, solid or endsolid"},
        {"solid\nfacet", "2: found the end of the file, expected normal"},
        {"solid\n\n facet vertex", "3: found 'vertex', expected normal"},
        {"solid\nfacet normal", "2: found the end of the file, expected three numbers of a normal"},
        {"solid\nfacet normal 0 0",
         "2: found the end of the file, expected three numbers of a normal"},
        {facet_with("0 0 1", "0 0"), "3: found 'outer', expected three numbers of a normal"},
        {facet_with("0 0 1", "0 0 1 1"), "2: found '1', expected outer"},
        {facet_with("0 0 1", "0 -1.#IND 1"),
         "normals that aren't numbers, ignored (1): 2: found '-1.#IND' in a normal, expected a "
         "number"},
        {facet_with("0 0 1", "a b c"),
         "normals that aren't numbers, ignored (1): 2: found 'a' in a normal, expected a number"},
        {facet_with("0 0 1", "nan nan nan"), "fine"},
        {facet_with("0 0 1", "0 0 0"), "fine"},
        {facet_with("0 0 1", "1 1 -0.1"),
         "normals that point to the back of their triangles, ignored (1): 2: the facet turns "
         "clockwise as seen from where its normal points"},
        {facet_with("outer", "inner"), "3: found 'inner', expected outer"},
        {facet_with("loop", "vertex"), "3: found 'vertex', expected loop"},
        {facet_with("vertex 1 0 0", "vertex 1 0"), "6: found 'vertex', expected a number"},
        {facet_with("vertex 1 0 0", "vertex 1 0 0 0"), "5: found '0', expected vertex or endloop"},
        {facet_with("vertex 1 0 0", "vertex 1 0 0x1"), "5: found '0x1', expected a number"},
        {facet_with("vertex 1 0 0", "vertex 1,0 0"), "5: found '1,0', expected a number"},
        {facet_with("vertex 1 0 0", "vertex 1 0 --1"), "5: found '--1', expected a number"},
        {facet_with("vertex 1 0 0", "vertex 1 0 +-1"), "5: found '+-1', expected a number"},
        {facet_with("vertex 1 0 0", "vertex 1 0 1e"), "5: found '1e', expected a number"},
        {facet_with("vertex 1 0 0", "vertex 1 0 "s + std::string(90, '9') + "x"),
         "5: found '"s + std::string(40, '9') + "...', expected a number"},
        {facet_with("vertex 1 0 0", "vertex 1 0 nan"),
         "vertices that aren't finite (1): 5: the vertex is (1, 0, nan), expected finite numbers"},
        {facet_with("vertex 1 0 0", "vertex 1 -inf 0"),
         "vertices that aren't finite (1): 5: the vertex is (1, -inf, 0), expected finite numbers"},
        {facet_with("vertex 1 0 0", "vertex 1e999 0 0"),
         "vertices that aren't finite (1): 5: the vertex is (inf, 0, 0), expected finite numbers"},
        {facet_with("vertex 1 0 0", "vertex 1 1e39 0"),
         "vertices beyond the range of float (1): 5: the vertex is (1, 1e+39, 0), expected at most "
         "3.4e38 in size"},
        {facet_with("vertex 1 0 0", "vertex"), "6: found 'vertex', expected a number"},
        {facet_with("vertex 1 0 0", "vortex 1 0 0"),
         "5: found 'vortex', expected vertex or endloop"},
        {facet_with("vertex 1 0 0", ""),
         "faces of fewer than three corners, skipped (1): 2: the facet has 2 vertices, expected 3"},
        {"solid\nfacet normal 0 0 1 outer loop endloop endfacet\nendsolid",
         "faces of fewer than three corners, skipped (1): 2: the facet has 0 vertices, expected 3"},
        {facet_with("vertex 1 0 0", "vertex 1 0 0\nvertex 1 1 0"),
         "7: found a fourth vertex, expected three a facet"},
        {facet_with("endloop", ""), "8: found 'endfacet', expected vertex or endloop"},
        {facet_with("endfacet", ""), "9: found 'endsolid', expected endfacet"},
        {facet_with("endfacet", "endfacet!"), "8: found 'endfacet!', expected endfacet"},
        {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0",
         "4: found the end of the file, expected a number"},
        {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
         "5: found the end of the file, expected vertex or endloop"},
        {"solid\n" + kFacet + "facet\x80\xff",
         "9: found 'facet?\?', expected facet, solid or endsolid"},
    };
    for (const BadFile& file : files) EXPECT_EQ(verdict(file.bytes), file.verdict) << file.bytes;
}

TEST(ReadStl, faults_of_a_kind_are_counted_and_ten_are_shown) {
    std::string triangles;
    for (int i = 0; i < 30000; ++i)
        triangles += stl_triangle({0, 0, -1, 0, 0, 0, 1, 0, 0, 0, 1, i % 3 ? 0 : kNaN});
    const MeshData mesh = parse_stl({binary_stl(30000, triangles), "mesh"});
    ASSERT_EQ(mesh.warnings.kinds().size(), 2u);
    EXPECT_EQ(mesh.warnings.kinds()[0].count, 10000u);
    EXPECT_EQ(mesh.warnings.kinds()[1].count, 20000u);
    EXPECT_EQ(mesh.warnings.kinds()[0].shown.size(), 10u);
    EXPECT_EQ(mesh.warnings.kinds()[0].shown[9],
              "mesh:byte 1470: vertex 83 is (0, 1, nan), expected finite numbers");
}

TEST(ReadStl, limits_are_kept) {
    const ReadOptions faces = {.limits = {.max_faces = 1}};
    const ReadOptions vertices = {.limits = {.max_vertices = 5}};
    const std::string text = "solid\n" + kFacet + kFacet + "endsolid";
    for (const ReadOptions& options : {faces, vertices}) {
        EXPECT_EQ(verdict_on(parse_stl, binary_stl(1, kUpward), options), "fine");
        EXPECT_EQ(verdict_on(parse_stl, binary_stl(2, kUpward + kUpward), options),
                  "byte 80: found 2 triangles, expected at most 1");
        EXPECT_EQ(verdict_on(parse_stl, text, options), "found 2 triangles, expected at most 1");
    }
}

TEST(ReadStl, a_binary_file_cut_anywhere_is_an_error) {
    const std::string valid = binary_stl(2, kUpward + kUpward);
    for (std::size_t size = 0; size < valid.size(); ++size)
        EXPECT_THROW(parse_stl({std::string_view(valid).substr(0, size), "mesh"}), ParseError)
            << size;
}

TEST(ReadStl, text_cut_anywhere_is_an_error_or_a_mesh) {
    const std::string valid = "solid a\n" + kFacet + kFacet + "endsolid a\n";
    for (std::size_t size = 0; size < valid.size(); ++size)
        EXPECT_NE(verdict(valid.substr(0, size)), "") << size;
}

TEST(ReadStl, files_with_random_changes_are_an_error_or_a_mesh) {
    const std::string text = "solid a\n" + kFacet + "endsolid a\nsolid b\n" + kFacet + "endsolid\n";
    for (const std::string& valid :
         {text, binary_stl(3, kUpward + kUpward + kUpward), binary_stl(1, kUpward, "solid\n")})
        expect_errors_or_meshes_when_changed(parse_stl, valid,
                                             "0123456789.-+eEnofadclSF \r\n\0\xff"sv, 5000);
}

}  // namespace
}  // namespace boxwood
