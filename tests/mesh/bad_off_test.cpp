// SPDX-License-Identifier: Apache-2.0
// What is wrong with a file is told with its line, what was found there and what was expected.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "boxwood/core/error.h"
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

TEST(ReadOff, an_empty_file_is_an_error) {
    EXPECT_EQ(complaint_about(""), "1: the file is empty, expected the keyword OFF");
    EXPECT_EQ(complaint_about("\n# nothing\n"), "3: the file is empty, expected the keyword OFF");
}

TEST(ReadOff, another_keyword_is_an_error) {
    EXPECT_EQ(complaint_about("ply\n"), "1: found 'ply', expected the keyword OFF");
    EXPECT_EQ(complaint_about("8 12 0\n"), "1: found '8', expected the keyword OFF");
    EXPECT_EQ(complaint_about("\n\noff\n3 1 0\n"), "3: found 'off', expected the keyword OFF");
    EXPECT_EQ(complaint_about("OFFSET\n"),
              "1: found 'SET' as the count of vertices, expected 0 to 2147483647");
}

TEST(ReadOff, strange_words_are_cut_and_cleaned_in_messages) {
    EXPECT_EQ(complaint_about("\x7f"
                              "ELF\x02\xff\n"),
              "1: found '?ELF?\?', expected the keyword OFF");
    EXPECT_EQ(complaint_about(std::string(1000, 'x')),
              "1: found '" + std::string(40, 'x') + "...', expected the keyword OFF");
    EXPECT_EQ(complaint_about(std::string(5, '\0')),
              "1: found '?\?\?\?\?', expected the keyword OFF");
}

TEST(ReadOff, missing_counts_are_an_error) {
    EXPECT_EQ(complaint_about("OFF"),
              "2: the file ends, expected the counts of vertices and faces");
    EXPECT_EQ(complaint_about("OFF\n# no counts\n"),
              "3: the file ends, expected the counts of vertices and faces");
    EXPECT_EQ(complaint_about("OFF\n8\n12\n"),
              "2: found nothing as the count of faces, expected 0 to 2147483647");
}

TEST(ReadOff, counts_that_are_no_counts_are_an_error) {
    for (const std::string word : {"abc", "-1", "1.5", "1e3", "2147483648", "1000000000000000000",
                                   "99999999999999999999999999", "nan", "0x10", "+-1", "-"}) {
        EXPECT_EQ(complaint_about("OFF\n" + word + " 12 0\n"),
                  "2: found '" + word + "' as the count of vertices, expected 0 to 2147483647");
        EXPECT_EQ(complaint_about("OFF\n\n8 " + word + " 0\n"),
                  "3: found '" + word + "' as the count of faces, expected 0 to 2147483647");
    }
    EXPECT_EQ(complaint_about("OFF\n8 12 edges\n"), "2: found 'edges', expected a number");
}

TEST(ReadOff, a_file_with_fewer_lines_than_promised_is_an_error) {
    EXPECT_EQ(complaint_about("OFF\n8 12 0\n0 0 0\n1 0 0\n\n# 1 1 0\n"),
              "2: the header promises 8 vertices and 12 faces, 20 lines, but the file has 2");
    EXPECT_EQ(complaint_about("OFF\n8 12 0"),
              "2: the header promises 8 vertices and 12 faces, 20 lines, but the file has 0");
}

TEST(ReadOff, counts_that_lie_enormously_are_found_out_before_memory_is_spent_on_them) {
    EXPECT_EQ(complaint_about("OFF\n2147483647 2147483647 0\n0 0 0\n"),
              "2: the header promises 2147483647 vertices and 2147483647 faces, 4294967294 lines, "
              "but the file has 1");
}

TEST(ReadOff, too_few_coordinates_are_an_error) {
    EXPECT_EQ(complaint_about(with_line(kTriangle, 5, "0 1")),
              "5: vertex 2 has 2 coordinates, expected 3");
    EXPECT_EQ(complaint_about(with_line(kTriangle, 3, "0 # 0 0")),
              "3: vertex 0 has 1 coordinates, expected 3");
}

TEST(ReadOff, words_that_are_no_numbers_are_an_error) {
    for (const std::string word : {"abc", "1.0abc", "1,5", "--1", "+-1", "1e", "0x1p3", "."}) {
        EXPECT_EQ(complaint_about(with_line(kTriangle, 4, "1 " + word + " 0")),
                  "4: found '" + word + "', expected a number");
        EXPECT_EQ(complaint_about(with_line(kTriangle, 4, "1 0 0 255 " + word)),
                  "4: found '" + word + "', expected a number");
        EXPECT_EQ(complaint_about(with_line(kTriangle, 6, "3 0 1 2 " + word)),
                  "6: found '" + word + "', expected a number");
    }
}

TEST(ReadOff, coordinates_that_are_not_finite_are_kept_and_warned_of) {
    const std::pair<const char*, const char*> cases[] = {{"nan", "nan"},        {"NaN", "nan"},
                                                         {"-nan", "-nan"},      {"inf", "inf"},
                                                         {"-Infinity", "-inf"}, {"-1e400", "-inf"}};
    for (const auto& [word, value] : cases) {
        const std::string text = with_line(kTriangle, 4, std::string("1 0 ") + word);
        EXPECT_EQ(verdict_on(parse_off, text),
                  std::string("vertices that aren't finite (1): 4: vertex 1 is (1, 0, ") + value +
                      "), expected finite numbers");
        EXPECT_FALSE(std::isfinite(parsed(text).vertices[1].z()));
    }
}

TEST(ReadOff, coordinates_beyond_float_are_kept_and_warned_of) {
    for (const std::string word : {"1e+39", "-3.5e+38", "1e+308", "3.4028236e+38"}) {
        const std::string text = with_line(kTriangle, 4, "1 " + word + " 0");
        EXPECT_EQ(verdict_on(parse_off, text),
                  "vertices beyond the range of float (1): 4: vertex 1 is (1, " + word +
                      ", 0), expected at most 3.4e38 in size");
        EXPECT_EQ(parsed(text).vertices[1].y(), std::stod(word));
    }
    EXPECT_EQ(verdict_on(parse_off, with_line(kTriangle, 4, "1 3.4028234e38 -3.4028234e38")),
              "fine");
}

TEST(ReadOff, faces_of_fewer_than_three_corners_are_skipped_and_warned_of) {
    const std::string kind = "faces of fewer than three corners, skipped (1): 6: face 0 has ";
    EXPECT_EQ(verdict_on(parse_off, with_line(kTriangle, 6, "2 0 1")),
              kind + "2 corners, expected at least 3");
    EXPECT_EQ(verdict_on(parse_off, with_line(kTriangle, 6, "0")),
              kind + "0 corners, expected at least 3");
    EXPECT_EQ(complaint_about(with_line(kTriangle, 6, "-3 0 1 2")),
              "6: face 0 has -3 corners, expected at least 3");
    EXPECT_EQ(complaint_about(with_line(kTriangle, 6, "2 0 3")),
              "6: face 0 has vertex index 3, expected 0 to 2");
}

TEST(ReadOff, faces_with_too_few_indices_are_an_error) {
    EXPECT_EQ(complaint_about(with_line(kTriangle, 6, "3 0 1")),
              "6: face 0 has 2 vertex indices, expected 3");
    EXPECT_EQ(complaint_about(with_line(kTriangle, 6, "1000000000000000000 0 1 2")),
              "6: face 0 has 3 vertex indices, expected 1000000000000000000");
}

TEST(ReadOff, indices_out_of_range_are_an_error) {
    EXPECT_EQ(complaint_about(with_line(kTriangle, 6, "3 0 1 3")),
              "6: face 0 has vertex index 3, expected 0 to 2");
    EXPECT_EQ(complaint_about(with_line(kTwoFaces, 10, "3 0 -1 3")),
              "10: face 1 has vertex index -1, expected 0 to 3");
    EXPECT_EQ(complaint_about(with_line(kTriangle, 6, "3 0 1 4294967297")),
              "6: face 0 has vertex index 4294967297, expected 0 to 2");
    EXPECT_EQ(complaint_about("OFF\n0 1 0\n3 0 1 2\n"),
              "3: face 0 has vertex index 0, but there are no vertices");
}

TEST(ReadOff, indices_that_are_no_whole_numbers_are_an_error) {
    for (const std::string word : {"abc", "1.0", "1e0", "99999999999999999999"}) {
        EXPECT_EQ(complaint_about(with_line(kTriangle, 6, "3 0 " + word + " 2")),
                  "6: found '" + word + "', expected a whole number");
        EXPECT_EQ(complaint_about(with_line(kTriangle, 6, word + " 0 1 2")),
                  "6: found '" + word + "', expected a whole number");
    }
}

TEST(ReadOff, lines_after_the_last_face_are_ignored_and_counted) {
    EXPECT_EQ(verdict_on(parse_off, kTriangle + "\n3 0 2 1\n# end\n\nabc 1\n"),
              "lines after the end of the mesh, ignored (2): 8: found '3' after the last face, "
              "expected the end of the file");
    EXPECT_EQ(verdict_on(parse_off, "OFF\n1 0\n1 2 3\nabc\n"),
              "lines after the end of the mesh, ignored (1): 4: found 'abc' after the last face, "
              "expected the end of the file");
    EXPECT_TRUE(same(parse_off({kTriangle + "\n3 0 2 1\n", "mesh.off"}),
                     parse_off({kTriangle, "mesh.off"})));
}

TEST(ReadOff, of_many_faults_the_first_in_the_file_is_reported_whatever_the_threads) {
    std::string text = text_of(generate_icosphere(100000));
    ASSERT_GT(text.size(), std::size_t{4} << 20) << "so that there are several chunks";
    for (const std::size_t line : {120000, 90000, 40007, 20003, 8009})
        text = with_line(std::move(text), line, "bad" + std::to_string(line));
    for (const std::size_t threads : {1, 2, 8}) {
        const ThreadLimit limit(threads);
        for (int i = 0; i < 5; ++i)
            EXPECT_EQ(complaint_about(text), "8009: found 'bad8009', expected a number");
    }
}

TEST(ReadOff, a_file_cut_anywhere_is_an_error_or_a_mesh) {
    for (std::size_t size = 0; size <= kTwoFaces.size(); ++size) {
        const TempDir dir;
        const auto path = dir.write("mesh.off", kTwoFaces.substr(0, size));
        try {
            const TriangleMesh mesh = read_mesh(path);
            EXPECT_EQ(mesh.vertices.size(), 4u) << size;
            EXPECT_NO_THROW(check_indices(mesh)) << size;
        } catch (const ParseError&) {
        }
    }
}

TEST(ReadOff, a_file_with_random_changes_is_an_error_or_a_mesh) {
    const TempDir dir;
    const std::string valid = text_of(generate_torus_knot(300));
    const std::string_view spice = "0123456789.-+eE#nif \t\r\n\0\xff,"sv;
    for (std::uint64_t round = 0; round < cases(2000); ++round) {
        std::uint32_t dimension = 0;
        const auto random = [&](std::size_t count) {
            return static_cast<std::size_t>(static_cast<double>(count) *
                                            uniform(1, round, dimension++));
        };
        std::string text = valid.substr(0, random(4) == 0 ? random(valid.size()) : valid.npos);
        for (std::size_t changes = random(4); changes > 0 && !text.empty(); --changes)
            text[random(random(2) == 0 ? std::min<std::size_t>(12, text.size()) : text.size())] =
                spice[random(spice.size())];
        const auto path = dir.write("mesh.off", text);
        try {
            const TriangleMesh mesh = read_mesh(path);
            EXPECT_NO_THROW(check_indices(mesh)) << round;
        } catch (const ParseError&) {
        }
    }
}

TEST(ReadOff, what_is_no_file_is_an_io_error) {
    const TempDir dir;
    EXPECT_THROW(read_mesh(dir / "missing.off"), IoError);
    EXPECT_THROW(
        (std::filesystem::create_directory(dir / "folder.off"), read_mesh(dir / "folder.off")),
        IoError);
}

}  // namespace
}  // namespace boxwood
