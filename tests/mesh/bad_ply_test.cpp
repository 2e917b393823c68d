// SPDX-License-Identifier: Apache-2.0
// What is wrong with a file is told with its line or byte, what was found there and what was
// expected.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "boxwood/mesh/ply.h"
#include "mesh/parse.h"
#include "mesh/ply_text.h"

namespace boxwood {
namespace {

using namespace std::string_literals;
using namespace std::string_view_literals;

const std::string kStart = "ply\nformat ascii 1.0\n";
const std::string kVertex =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFace = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kEnd = "end_header\n";
const std::string kPoints = "0 0 0\n1 0 0\n0 1 0\n";

TEST(BadPly, headers) {
    const std::string least = "expected element, property, comment or end_header";
    expect_complaints(
        parse_ply,
        {{"empty", "", "1: the file is empty, expected the keyword ply"},
         {"another format", "OFF\n3 1 0\n", "1: found 'OFF', expected the keyword ply"},
         {"upper case", "PLY\nformat ascii 1.0\n", "1: found 'PLY', expected the keyword ply"},
         {"blank first line", "\nply\n", "1: found nothing, expected the keyword ply"},
         {"more than the keyword", "ply format\n",
          "1: found 'ply format', expected the keyword ply"},
         {"zeros", std::string(4, '\0'), "1: found '\?\?\?\?', expected the keyword ply"},
         {"a long line", std::string(70000, 'x'),
          "1: found a line of more than 65536 bytes, expected a header"},
         {"only the keyword", "ply", "2: the file ends, expected the format"},
         {"only comments", "ply\ncomment a\n", "3: the file ends, expected the format"},
         {"no format", "ply\nelement vertex 3\n",
          "2: found 'element vertex 3', expected the format"},
         {"no version", "ply\nformat ascii\n", "2: found 'format ascii', expected the format"},
         {"strange format", "ply\nformat binary 1.0\n",
          "2: found the format 'binary', expected ascii, binary_little_endian or "
          "binary_big_endian"},
         {"strange version", "ply\nformat ascii 2.0\n", "2: found version '2.0', expected 1.0"},
         {"two formats", kStart + "format ascii 1.0\n", "3: found 'format', " + least},
         {"no end", kStart + kVertex, "7: the file ends, expected end_header"},
         {"the end and more", kStart + kVertex + "end_header 1\n",
          "7: found 'end_header', " + least},
         {"unknown keyword", kStart + "vertex 3\n", "3: found 'vertex', " + least},
         {"numbers", kStart + "1 2 3\n", "3: found '1', " + least}});
}

TEST(BadPly, elements) {
    const std::string range = " as the count of element 'vertex', expected 0 to 2147483647";
    expect_complaints(
        parse_ply,
        {{"no count", kStart + "element vertex\n",
          "3: found 'element vertex', expected an element's name and count"},
         {"too many words", kStart + "element vertex 3 4\n",
          "3: found 'element vertex 3 4', expected an element's name and count"},
         {"negative", kStart + "element vertex -1\n", "3: found '-1'" + range},
         {"a word", kStart + "element vertex many\n", "3: found 'many'" + range},
         {"a fraction", kStart + "element vertex 1.5\n", "3: found '1.5'" + range},
         {"beyond 32 bits", kStart + "element vertex 4294967299\n",
          "3: found '4294967299'" + range},
         {"beyond 64 bits", kStart + "element vertex 99999999999999999999\n",
          "3: found '99999999999999999999'" + range},
         {"faces beyond 32 bits", kStart + kVertex + "element face 2147483648\n",
          "7: found '2147483648' as the count of element 'face', expected 0 to 2147483647"},
         {"others beyond reason", kStart + "element edge 9223372036854775807\n",
          "3: found '9223372036854775807' as the count of element 'edge', expected 0 to "
          "281474976710656"},
         {"twice", kStart + kVertex + kVertex,
          "7: found the element 'vertex' again, expected it once"},
         {"no vertices", kStart + kEnd, "3: the header has no element vertex, expected one"},
         {"no z",
          kStart + "element vertex 3\nproperty float x\nproperty float y\n" + kEnd + kPoints,
          "3: the element vertex lacks x, y or z, expected them"},
         {"y is a list",
          kStart +
              "element vertex 3\nproperty float x\nproperty list uchar float y\nproperty float "
              "z\n" +
              kEnd,
          "3: the element vertex lacks x, y or z, expected them"},
         {"no indices", kStart + kVertex + "element face 1\nproperty int a\n" + kEnd,
          "7: the element face has no list of vertex_indices, expected one"},
         {"indices that are no list",
          kStart + kVertex + "element face 1\nproperty int vertex_indices\n" + kEnd,
          "7: the element face has no list of vertex_indices, expected one"},
         {"strips without indices", kStart + kVertex + "element tristrips 1\n" + kEnd,
          "7: the element tristrips has no list of vertex_indices, expected one"}});
}

TEST(BadPly, properties) {
    expect_complaints(
        parse_ply,
        {{"before all elements", kStart + "property float x\n",
          "3: found a property, expected an element before it"},
         {"no name", kStart + "element vertex 3\nproperty float\n",
          "4: found 'property float', expected a property's type and name"},
         {"nothing", kStart + "element vertex 3\nproperty\n",
          "4: found 'property', expected a property's type and name"},
         {"two names", kStart + "element vertex 3\nproperty float x y\n",
          "4: found 'property float x y', expected a property's type and name"},
         {"unknown type", kStart + "element vertex 3\nproperty float16 x\n",
          "4: found the type 'float16', expected one such as float"},
         {"a list of one type", kStart + "element vertex 3\nproperty list int x\n",
          "4: found 'property list int x', expected a property's two types and name"},
         {"unknown type of items", kStart + "element vertex 3\nproperty list uchar long x\n",
          "4: found the type 'long', expected one such as float"},
         {"unknown type of counts", kStart + "element vertex 3\nproperty list size int x\n",
          "4: found the type 'size', expected one such as float"},
         {"counts in float", kStart + "element vertex 3\nproperty list float int x\n",
          "4: found 'float' as the type of a list's count, expected a type of whole numbers"},
         {"twice", kStart + "element vertex 3\nproperty float x\nproperty int x\n",
          "5: found the property 'x' again, expected it once"}});
}

TEST(BadPly, bodies_in_text) {
    const std::string all = kStart + kVertex + kFace + kEnd;
    const std::string points = kStart + kVertex + kEnd;
    expect_complaints(
        parse_ply,
        {{"nothing", points,
          "3: the header promises 3 of the element 'vertex', a line each, but the file has 0"},
         {"too few vertices", points + "0 0 0\n1 1 1",
          "3: the header promises 3 of the element 'vertex', a line each, but the file has 2"},
         {"no faces", all + kPoints,
          "7: the header promises 1 of the element 'face', a line each, but the file has 0"},
         {"a count that lies", with_word(points, "vertex 3", "vertex 2147483647") + kPoints,
          "3: the header promises 2147483647 of the element 'vertex', a line each, but the file "
          "has 3"},
         {"another that lies",
          with_word(all, "element face 1", "element face 2147483647") + kPoints + "3 0 1 2\n",
          "7: the header promises 2147483647 of the element 'face', a line each, but the file has "
          "1"},
         {"a third that lies",
          kStart + kVertex + "element edge 200000000000000\nproperty int a\n" + kEnd + kPoints,
          "7: the header promises 200000000000000 of the element 'edge', a line each, but the file "
          "has 0"},
         {"two coordinates", points + "0 0\n1.0 1 1\n2 2 2\n",
          "8: found the end of the line, expected a number"},
         {"four coordinates", points + "0 0 0\n\n1 1 1 7\n2 2 2\n",
          "10: found '7', expected the end of the line"},
         {"a word", points + "0 0 0\n1 x 1\n2 2 2\n", "9: found 'x', expected a number"},
         {"a comma", points + "0 0 0\n1,5 1 1\n2 2 2\n", "9: found '1,5', expected a number"},
         {"corners that are missing", all + kPoints + "3 0 1\n",
          "13: found the end of the line, expected a whole number"},
         {"too many corners", all + kPoints + "3 0 1 2 0\n",
          "13: found '0', expected the end of the line"},
         {"a count that is none", all + kPoints + "three 0 1 2\n",
          "13: found 'three', expected a whole number"},
         {"a negative count", all + kPoints + "-3 0 1 2\n",
          "13: found -3 as the count of a list, expected 0 or more"},
         {"a huge count", all + kPoints + "1000000000000000000 0 1 2\n",
          "13: found the end of the line, expected a whole number"},
         {"an index too large", all + kPoints + "3 0 1 3\n",
          "13: face 0 has vertex index 3, expected 0 to 2"},
         {"a negative index", all + kPoints + "3 0 -1 2\n",
          "13: face 0 has vertex index -1, expected 0 to 2"},
         {"an index beyond 32 bits", all + kPoints + "3 0 1 4294967296\n",
          "13: face 0 has vertex index 4294967296, expected 0 to 2"},
         {"an index beyond 64 bits", all + kPoints + "3 0 1 99999999999999999999\n",
          "13: found '99999999999999999999', expected a whole number"},
         {"a fraction as index", all + kPoints + "3 0 1 1.5\n",
          "13: found '1.5', expected a whole number"},
         {"no vertices", with_word(all, "vertex 3", "vertex 0") + "3 0 1 2\n",
          "10: face 0 has vertex index 0, but there are no vertices"},
         {"a strip's index",
          kStart + kVertex + "element tristrips 1\nproperty list int int vertex_indices\n" + kEnd +
              kPoints + "3 0 1 -2\n",
          "13: strip 0 has vertex index -2, expected -1 to 2"}});
}

/// The text's numbers in binary, but for what the change does to its bytes.
std::string spoilt(const std::string& text, std::size_t bytes_from_end, std::string_view bytes) {
    std::string binary = binary_of(text, false);
    return binary.replace(binary.size() - bytes_from_end, bytes.size(), bytes);
}

TEST(BadPly, bodies_in_binary) {
    const std::string binary = binary_of(kPlyTriangle, false);
    const std::string two =
        binary_of(with_word(kPlyTriangle, "face 1", "face 2") + "4 2 1 0 1\n", false);
    const auto at = [](const std::string& file, std::size_t from_end) {
        return "byte " + std::to_string(file.size() - from_end) + ": ";
    };
    const std::size_t header = binary.size() - 36 - 13;
    const std::string odd_index = binary_of(
        with_word(with_word(kPlyTriangle, "uchar int", "uchar float"), "3 0 1 2", "3 0 1 1.5"),
        false);
    const std::string signed_count = binary_of(
        with_word(with_word(kPlyTriangle, "list uchar", "list char"), "3 0 1 2", "-3"), false);
    const std::string list_before =
        "ply\nformat ascii 1.0\nelement first 1\nproperty list uchar uchar a\n" + kVertex + kEnd +
        "5 1 2 3 4 5\n" + kPoints;
    const std::string cut = binary_of(list_before, false);
    expect_complaints(
        parse_ply,
        {{"nothing", binary.substr(0, header),
          "3: the header promises 3 of the element 'vertex', at least 12 bytes each, but the file "
          "has 0 for them"},
         {"half the vertices", binary.substr(0, header + 18),
          "3: the header promises 3 of the element 'vertex', at least 12 bytes each, but the file "
          "has 18 for them"},
         {"no faces", binary.substr(0, header + 36),
          "7: the header promises 1 of the element 'face', at least 1 bytes each, but the file has "
          "0 for them"},
         {"a count that lies", with_word(binary, "vertex 3", "vertex 2147483647"),
          "3: the header promises 2147483647 of the element 'vertex', at least 12 bytes each, but "
          "the file has 49 for them"},
         {"another that lies", with_word(binary, "face 1", "face 2147483647"),
          "7: the header promises 2147483647 of the element 'face', at least 1 bytes each, but the "
          "file has 13 for them"},
         {"half a face", binary.substr(0, binary.size() - 5),
          at(binary, 13) + "found a list of 3 items, 4 bytes each, but the file has 7 more bytes"},
         {"a list that goes on too far", spoilt(kPlyTriangle, 13, "\xff"),
          at(binary, 13) +
              "found a list of 255 items, 4 bytes each, but the file has 12 more bytes"},
         {"a huge list",
          spoilt(with_word(kPlyTriangle, "list uchar", "list uint"), 16, "\xff\xff\xff\xff"),
          "byte " + std::to_string(header - 1 + 36) +
              ": found a list of 4294967295 items, 4 bytes each, but the file has 12 more bytes"},
         {"a negative list", signed_count,
          at(signed_count, 1) + "found -3 as the count of a list, expected 0 or more"},
         {"an index too large", spoilt(kPlyTriangle, 4, "\x03"),
          at(binary, 4) + "face 0 has vertex index 3, expected 0 to 2"},
         {"a negative index", spoilt(kPlyTriangle, 8, "\xff\xff\xff\xff"),
          at(binary, 8) + "face 0 has vertex index -1, expected 0 to 2"},
         {"a fraction as index", odd_index,
          at(odd_index, 4) + "found 1.5, expected a whole number"},
         {"the second face ends", two.substr(0, two.size() - 1),
          at(two, 17) + "found a list of 4 items, 4 bytes each, but the file has 15 more bytes"},
         {"vertices behind a list", cut.substr(0, cut.size() - 3),
          at(cut, 36) + "found 33 bytes for 3 of the element 'vertex', expected 12 bytes each"}});
}

/// A list of count ones, in text.
std::string ones(std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += " 1";
    return text;
}

TEST(BadPly, numbers_that_would_take_more_memory_than_the_file_is_worth) {
    std::string properties;
    for (int i = 0; i < 1000; ++i) properties += "property uchar p" + std::to_string(i) + "\n";
    std::string points = kStart + kVertex + properties + kEnd;
    EXPECT_EQ(complaint_of(parse_ply, points + kPoints),
              "3: the header promises 3 of the element 'vertex', 1003 numbers each, but the file "
              "has 18 bytes for them");
    const std::string faces = kStart + kVertex + kFace + properties + kEnd + kPoints;
    EXPECT_EQ(complaint_of(parse_ply, faces + "1000" + ones(2000) + "\n"),
              "1013: face 0 has 1000 corners and 1000 numbers, expected fewer of them");
    EXPECT_EQ(complaint_of(parse_ply, faces + "30" + ones(1030) + "\n"), "none");
}

TEST(BadPly, the_wrong_order_of_bytes_is_found_out_by_its_indices) {
    const std::string binary = with_word(binary_of(kPlyTriangle, true), "big", "little");
    EXPECT_EQ(complaint_of(parse_ply, binary),
              "byte " + std::to_string(binary.size() - 8) +
                  ": face 0 has vertex index 16777216, expected 0 to 2");
}

TEST(BadPly, limits_are_kept) {
    EXPECT_EQ(complaint_of(parse_ply, kPlyTriangle, {.limits = {.max_vertices = 2}}),
              "3: found '3' as the count of element 'vertex', expected 0 to 2");
    EXPECT_EQ(complaint_of(parse_ply, kPlyTriangle, {.limits = {.max_faces = 0}}),
              "7: found '1' as the count of element 'face', expected 0 to 0");
    const std::string quad = with_word(kPlyTriangle, "3 0 1 2", "4 0 1 2 1");
    EXPECT_EQ(complaint_of(parse_ply, quad, {.limits = {.max_faces = 1}}),
              "13: found more than 1 triangles, expected at most that");
    EXPECT_EQ(complaint_of(parse_ply, quad, {.limits = {.max_vertices = 3, .max_faces = 2}}),
              "none");
}

TEST(BadPly, of_many_faults_the_first_in_the_file_is_told_whatever_the_threads) {
    std::string text = with_word(kStart + kVertex + kEnd, "vertex 3", "vertex 100000");
    for (int i = 0; i < 100000; ++i)
        text += i % 30000 == 29999 ? "0 bad" + std::to_string(i) + " 0\n" : "0 0 0.000\n";
    for (const std::size_t threads : {1, 2, 8}) {
        const ThreadLimit limit(threads);
        for (int i = 0; i < 5; ++i)
            EXPECT_EQ(complaint_of(parse_ply, text), "30007: found 'bad29999', expected a number");
    }
}

const std::string kOfAllKinds =
    "ply\nformat ascii 1.0\ncomment c\nelement face 3\nproperty list uchar int vertex_indices\n"
    "property list char float texcoord\nproperty uchar red\nproperty uchar green\nproperty uchar "
    "blue\nproperty short part\nelement vertex 4\nproperty float x\nproperty double y\nproperty "
    "int z\nproperty list uint short near\nproperty float nx\nproperty float ny\nproperty float "
    "nz\nproperty float s\nproperty float t\nelement edge 1\nproperty int a\nelement tristrips "
    "1\nproperty list int int vertex_indices\nend_header\n"
    "3 0 1 2 6 0 0 1 0 1 1 255 0 0 5\n4 0 1 2 3 0 9 9 9 1\n2 0 1 0 1 2 3 4\n"
    "0 0 0 0 0 0 1 0 0\n1 0 0 2 7 8 0 0 1 0 0\n1 1 0 0 0 0 1 0 0\n0 1 0 0 0 0 1 0 0\n77\n"
    "6 0 1 2 -1 3 2\n";

const std::string kOneSize =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 2\nproperty list "
    "uchar int vertex_indices\nproperty uchar part\nend_header\n0 0 0 1 2 3\n1 0 0 4 5 6\n0 1 0 7 "
    "8 "
    "9\n3 0 1 2 5\n3 2 1 0 6\n";

TEST(BadPly, a_file_cut_anywhere_is_an_error_or_a_mesh) {
    for (const std::string& text : {kOfAllKinds, kOneSize}) {
        ASSERT_EQ(complaint_of(parse_ply, text), "none");
        expect_errors_or_meshes_when_cut(parse_ply, text);
        for (const bool is_big : {false, true}) {
            ASSERT_EQ(complaint_of(parse_ply, binary_of(text, is_big)), "none");
            expect_errors_or_meshes_when_cut(parse_ply, binary_of(text, is_big));
        }
    }
}

TEST(BadPly, a_file_with_random_changes_is_an_error_or_a_mesh) {
    for (const std::string& text : {kOfAllKinds, kOneSize}) {
        expect_errors_or_meshes_when_changed(parse_ply, text, "0123456789.-+e# \t\r\n\0\xff"sv,
                                             10000);
        for (const bool is_big : {false, true})
            expect_errors_or_meshes_when_changed(parse_ply, binary_of(text, is_big),
                                                 "\0\0\1\2\3\xff\x7f\x80"
                                                 "0123456789 \n"sv,
                                                 10000);
    }
}

}  // namespace
}  // namespace boxwood
