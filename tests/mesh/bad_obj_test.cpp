// SPDX-License-Identifier: Apache-2.0
// What is wrong with a file is told with its line, what was found there and what was expected.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "boxwood/mesh/obj.h"
#include "mesh/parse.h"

namespace boxwood {
namespace {

using namespace std::string_literals;
using namespace std::string_view_literals;

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(BadObj, files_that_are_none) {
    expect_complaints(
        parse_obj,
        {{"empty", "", "1: the file is empty, expected vertices and faces"},
         {"another format", "\nply\nformat ascii 1.0\n",
          "2: found 'ply', expected v, f or another keyword of OBJ"},
         {"OFF", "OFF\n3 1 0\n0 0 0\n", "1: found 'OFF', expected v, f or another keyword of OBJ"},
         {"a program",
          "\x7f"
          "ELF\x02\x01\x01\0\0"s,
          "1: found '?ELF?\?\?\?\?', expected v, f or another keyword of OBJ"},
         {"a picture", "\x89PNG\r\n\x1a\n",
          "1: found '?PNG', expected v, f or another keyword of OBJ"},
         {"zeros", std::string(300, '\0'),
          "1: found '" + std::string(40, '?') + "...', expected v, f or another keyword of OBJ"},
         {"upper case", "# comment\nV 0 0 0\n",
          "2: found 'V', expected v, f or another keyword of OBJ"},
         {"no blank", "v0 0 0\n", "1: found 'v0', expected v, f or another keyword of OBJ"},
         {"old line ends", "v 0 0 0\rv 1 0 0\rv 0 1 0\r", "1: found 'v', expected a number"}});
}

TEST(BadObj, coordinates) {
    expect_complaints(
        parse_obj,
        {{"none", "v\n", "1: vertex 1 has 0 coordinates, expected 3"},
         {"one", kThree + "v 1\n", "4: vertex 4 has 1 coordinates, expected 3"},
         {"two and a comment", "\nv 1 2 # 3\n", "2: vertex 1 has 2 coordinates, expected 3"},
         {"the file ends", "v 1 2", "1: vertex 1 has 2 coordinates, expected 3"},
         {"joined to nothing", "v 1 2 \\\n", "2: vertex 1 has 2 coordinates, expected 3"},
         {"a word", "v 1 abc 3\n", "1: found 'abc', expected a number"},
         {"a number and more", "v 1 2x 3\n", "1: found '2x', expected a number"},
         {"a comma", "v 1,5 2 3\n", "1: found '1,5', expected a number"},
         {"two signs", "v 1 +-2 3\n", "1: found '+-2', expected a number"},
         {"hexadecimal", "v 1 2 0x10\n", "1: found '0x10', expected a number"},
         {"half an exponent", "v 1e 2 3\n", "1: found '1e', expected a number"},
         {"only a point", "v . 2 3\n", "1: found '.', expected a number"},
         {"a colour that is none", "v 1 2 3 red 0 0\n", "1: found 'red', expected a number"},
         {"on a joined line", "v 1 \\\n2 \\\nx\n", "3: found 'x', expected a number"},
         {"a backslash inside", "v 1 2\\3 4\n", "1: found '2\\3', expected a number"},
         {"Windows' names of no number", "v 1.#XYZ 0 0\n", "1: found '1.', expected a number"},
         {"normal of two", "vn 0 1\n", "1: normal 1 has 2 coordinates, expected 3"},
         {"normal of words", "vn 0 1 up\n", "1: found 'up', expected a number"},
         {"no texture coordinate", "vt\n", "1: texture coordinate 1 has 0 coordinates, expected 1"},
         {"texture coordinate of words", "vt 0 u\n", "1: found 'u', expected a number"}});
}

TEST(BadObj, corners) {
    const std::string expected = "', expected a corner: v, v/vt, v//vn or v/vt/vn";
    std::vector<BadText> bad;
    for (const char* word : {"abc", "1.0", "1.5", "1e0", "1//x", "1/x", "1/1/1/1", "1///1", "/1",
                             "//", "-", "+-1", "1-2", "0x1", "99999999999999999999", "1,2"})
        bad.push_back({word, kThree + "vt 0 0\nvn 0 0 1\nf 1 2 " + word + "\n",
                       "6: found '" + std::string(word) + expected});
    expect_complaints(parse_obj, bad);
    EXPECT_EQ(bad.size(), 16u);
}

TEST(BadObj, indices_out_of_range) {
    expect_complaints(
        parse_obj,
        {{"zero", kThree + "f 0 1 2\n", "4: found vertex index 0, expected 1 to 3 or -3 to -1"},
         {"one too many", kThree + "f 1 2 4\n",
          "4: found vertex index 4, expected 1 to 3 or -3 to -1"},
         {"negative", kThree + "f 1 2 -4\n",
          "4: found vertex index -4, expected 1 to 3 or -3 to -1"},
         {"negative before all vertices", "f 1 2 -1\n" + kThree,
          "1: found vertex index -1, expected 1 to 3"},
         {"beyond 32 bits", kThree + "f 1 2 4294967297\n",
          "4: found vertex index 4294967297, expected 1 to 3 or -3 to -1"},
         {"the least number", kThree + "f 1 2 -9223372036854775808\n",
          "4: found vertex index -9223372036854775808, expected 1 to 3 or -3 to -1"},
         {"no vertices", "f 1 2 3\n", "1: found vertex index 1, but there are no vertices"},
         {"in a face that is skipped", kThree + "f 7\n",
          "4: found vertex index 7, expected 1 to 3 or -3 to -1"},
         {"texture coordinate", kThree + "vt 0 0\nf 1/1 2/2 3/1\n",
          "5: found texture coordinate index 2, expected 1 to 1 or -1 to -1"},
         {"no texture coordinates", kThree + "f 1/1 2/2 3/3\n",
          "4: found texture coordinate index 1, but there are no texture coordinates"},
         {"normal", kThree + "vn 0 0 1\nf 1//1 2//0 3//1\n",
          "5: found normal index 0, expected 1 to 1 or -1 to -1"},
         {"no normals", kThree + "f 1//1 2//1 3//1\n",
          "4: found normal index 1, but there are no normals"},
         {"on a joined line", kThree + "f 1 \\\n2 \\\r\n9\n",
          "6: found vertex index 9, expected 1 to 3 or -3 to -1"}});
}

TEST(BadObj, limits_are_kept) {
    const std::string text = kThree + "vn 0 0 1\nvn 0 1 0\nf 1 2 3\nf 1 2 3\n";
    EXPECT_EQ(complaint_of(parse_obj, text, {.limits = {.max_vertices = 2}}),
              " found 3 vertices, expected at most 2");
    EXPECT_EQ(complaint_of(parse_obj, text, {.limits = {.max_faces = 1}}),
              "7: found more than 1 faces, expected at most that");
    EXPECT_EQ(complaint_of(parse_obj, text, {.limits = {.max_vertices = 3, .max_faces = 2}}),
              "none");
}

TEST(BadObj, of_many_faults_the_first_in_the_file_is_told_whatever_the_threads) {
    std::string text;
    for (int i = 0; i < 100000; ++i) {
        text += "v 0 0 0\n";
        if (i % 30000 == 29999) text += "v bad" + std::to_string(i) + "\n";
    }
    for (const std::size_t threads : {1, 2, 8}) {
        const ThreadLimit limit(threads);
        for (int i = 0; i < 5; ++i)
            EXPECT_EQ(complaint_of(parse_obj, text), "30001: found 'bad29999', expected a number");
    }
}

const std::string kOfAllKinds =
    "mtllib a.mtl b c.mtl\n# comment\nv 0 0 0 1 0 0\nv 1 \\\n 0 0 .5 .5 .5 1\r\nv 1 1 0\nv 0 1 "
    "-1.#IND\n"
    "vt 0 0\nvt 1 0 0\nvn 0 0 1\nvn 0 1 0 \\\n\no thing # one\nusemtl a#b \\\n c\n"
    "f 1/1/1 2/2/1 3/1/2 4/2/2\nf -1//-1 -2//-2 -3//-1\ns 1\ng\nf 1 2 3\nl 1 2 \\\r\n3\n# \\\nf 4 "
    "3 2";

TEST(BadObj, a_file_cut_anywhere_is_an_error_or_a_mesh) {
    expect_errors_or_meshes_when_cut(parse_obj, kOfAllKinds);
}

TEST(BadObj, a_file_with_random_changes_is_an_error_or_a_mesh) {
    ASSERT_EQ(complaint_of(parse_obj, kOfAllKinds), "none");
    expect_errors_or_meshes_when_changed(parse_obj, kOfAllKinds,
                                         "0123456789.-+/\\\\\\\n\n\r vtfgno#e"sv, 20000);
}

}  // namespace
}  // namespace boxwood
