// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/off.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/core/random.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/inspect.h"
#include "boxwood/mesh/mesh_file.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

using namespace std::string_view_literals;

const std::string kTriangle = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

const std::string kTwoFaces =
    "OFF # a square\n"
    "\n"
    "4 2 5\n"
    "0 0 0\n"
    "1.5e0 0 0 # right\n"
    "  # the upper two\n"
    "1.5\t+1 0\r\n"
    "-0 1 .0\n"
    "3  0 1 2\n"
    "3 0 2 3  255 0 0\n";

TriangleMesh parsed(std::string_view text) {
    const TempDir dir;
    return read_off(dir.write("mesh.off", text));
}

/// What is wrong with the text, as "line: message".
std::string complaint_about(std::string_view text) {
    const TempDir dir;
    const auto path = dir.write("mesh.off", text);
    try {
        read_off(path);
    } catch (const ParseError& error) {
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with(path.string() + ":")) << message;
        return message.substr(std::min(message.size(), path.string().size() + 1));
    }
    return "none";
}

bool same(const TriangleMesh& a, const TriangleMesh& b) {
    return a.vertices == b.vertices && a.faces == b.faces;
}

std::string text_of(const TriangleMesh& mesh) {
    const TempDir dir;
    write_off(dir / "mesh.off", mesh);
    return content_of(dir / "mesh.off");
}

/// The text with a line, counted from 1, replaced.
std::string with_line(std::string text, std::size_t line, std::string_view replacement) {
    std::size_t begin = 0;
    for (; line > 1; --line) begin = text.find('\n', begin) + 1;
    return text.replace(begin, text.find('\n', begin) - begin, replacement);
}

TEST(ReadOff, a_triangle_is_read) {
    const TriangleMesh mesh = parsed(kTriangle);
    EXPECT_EQ(mesh.vertices, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.faces, (std::vector<Vec3i>{{0, 1, 2}}));
}

TEST(ReadOff, comments_blank_lines_tabs_and_colours_are_skipped) {
    const TriangleMesh mesh = parsed(kTwoFaces);
    EXPECT_EQ(mesh.vertices, (std::vector<Vec3d>{{0, 0, 0}, {1.5, 0, 0}, {1.5, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.faces, (std::vector<Vec3i>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ReadOff, a_comment_at_the_end_of_a_line_is_skipped) {
    EXPECT_EQ(complaint_about("OFF#x\n3 1#y\n0 0 0#abc\n1 0 0 # abc\n0 1 0\n3 0 1 2#3\n"), "none");
}

TEST(ReadOff, lines_may_end_in_crlf) {
    std::string text;
    for (const char c : kTriangle) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    EXPECT_TRUE(same(parsed(text), parsed(kTriangle)));
}

TEST(ReadOff, the_last_line_needs_no_end) {
    EXPECT_TRUE(same(parsed(kTriangle.substr(0, kTriangle.size() - 1)), parsed(kTriangle)));
}

TEST(ReadOff, comments_and_blank_lines_may_follow_the_last_face) {
    EXPECT_TRUE(same(parsed(kTriangle + "\n# the end\n   "), parsed(kTriangle)));
}

TEST(ReadOff, a_byte_order_mark_is_skipped) {
    EXPECT_TRUE(same(parsed("\xEF\xBB\xBF" + kTriangle), parsed(kTriangle)));
}

TEST(ReadOff, the_counts_may_stand_beside_the_keyword) {
    const std::string rest = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    EXPECT_TRUE(same(parsed("OFF 3 1 0\n" + rest), parsed(kTriangle)));
    EXPECT_TRUE(same(parsed("OFF3 1 0\n" + rest), parsed(kTriangle)));
}

TEST(ReadOff, the_count_of_edges_is_optional_and_ignored) {
    const std::string rest = "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    EXPECT_TRUE(same(parsed("OFF\n3 1" + rest), parsed(kTriangle)));
    EXPECT_TRUE(same(parsed("OFF\n3 1 -77" + rest), parsed(kTriangle)));
}

TEST(ReadOff, normals_colours_and_texture_coordinates_are_ignored) {
    for (const char* keyword : {"COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STCNOFF"}) {
        const std::string text =
            keyword +
            std::string(
                "\n3 1 0\n0 0 0 1 2 3 4\n1 0 0 .5 .5 .5 1\n0 1 0 1e3 0 0 1\n3 0 1 2 1 0 0 0.5\n");
        EXPECT_TRUE(same(parsed(text), parsed(kTriangle))) << keyword;
    }
}

TEST(ReadOff, polygons_become_fans_around_their_first_corner) {
    const TriangleMesh mesh =
        parsed("OFF\n6 2 0\n0 0 0\n1 0 0\n2 1 0\n1 2 0\n0 2 0\n-1 1 0\n6 5 0 1 2 3 4\n4 0 1 2 3\n");
    EXPECT_EQ(mesh.faces, (std::vector<Vec3i>{
                              {5, 0, 1}, {5, 1, 2}, {5, 2, 3}, {5, 3, 4}, {0, 1, 2}, {0, 2, 3}}));
}

TEST(ReadOff, a_mesh_may_have_no_faces_or_nothing_at_all) {
    EXPECT_EQ(parsed("OFF\n1 0 0\n1 2 3").vertices, (std::vector<Vec3d>{{1, 2, 3}}));
    EXPECT_TRUE(same(parsed("OFF\n0 0 0\n"), TriangleMesh{}));
}

TEST(ReadOff, numbers_are_rounded_correctly) {
    const TriangleMesh mesh = parsed(
        "OFF\n2 0\n0.1 1.7976931348623157e-300 123456789012345678901234567890\n"
        "9007199254740993 1e-400 -4.9406564584124654e-324\n");
    EXPECT_EQ(mesh.vertices[0],
              Vec3d(0.1, 1.7976931348623157e-300, 123456789012345678901234567890.0));
    EXPECT_EQ(mesh.vertices[1], Vec3d(9007199254740992, 0, -4.9406564584124654e-324));
}

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

TEST(ReadOff, relatives_of_the_format_are_told_to_be_unsupported) {
    for (const std::string keyword : {"4OFF", "nOFF", "4nOFF", "C4OFF", "STCN4nOFF"})
        EXPECT_EQ(complaint_about(keyword + "\n3 1 0\n"),
                  "1: found '" + keyword + "', expected OFF, for vertices of three coordinates");
    EXPECT_EQ(complaint_about("OFF BINARY\n\x00\x01\x02"sv),
              "1: found 'OFF BINARY', expected OFF as text");
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

TEST(ReadOff, coordinates_that_are_not_finite_are_an_error) {
    for (const std::string word : {"nan", "NaN", "-nan", "inf", "-Infinity"})
        EXPECT_EQ(complaint_about(with_line(kTriangle, 4, "1 0 " + word)),
                  "4: vertex 1: found '" + word + "', expected a finite number");
}

TEST(ReadOff, coordinates_beyond_float_are_an_error) {
    for (const std::string word : {"1e39", "-3.5e38", "1e308", "-1e400", "3.4028236e38"})
        EXPECT_EQ(complaint_about(with_line(kTriangle, 4, "1 " + word + " 0")),
                  "4: vertex 1: found '" + word + "', expected at most 3.4e38 in size");
    EXPECT_EQ(complaint_about(with_line(kTriangle, 4, "1 3.4028234e38 -3.4028234e38")), "none");
}

TEST(ReadOff, faces_of_fewer_than_three_corners_are_an_error) {
    EXPECT_EQ(complaint_about(with_line(kTriangle, 6, "2 0 1")),
              "6: face 0 has 2 corners, expected at least 3");
    EXPECT_EQ(complaint_about(with_line(kTriangle, 6, "-3 0 1 2")),
              "6: face 0 has -3 corners, expected at least 3");
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

TEST(ReadOff, content_after_the_last_face_is_an_error) {
    EXPECT_EQ(complaint_about(kTriangle + "\n3 0 2 1\n"),
              "8: found '3' after the last face, expected the end of the file");
    EXPECT_EQ(complaint_about("OFF\n1 0\n1 2 3\nabc\n"),
              "4: found 'abc' after the last face, expected the end of the file");
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

TEST(ReadOff, the_mesh_does_not_depend_on_the_number_of_threads) {
    const TempDir dir;
    const TriangleMesh mesh = generate_gyroid(60000);
    write_off(dir / "mesh.off", mesh);
    for (const std::size_t threads : {1, 2, 8}) {
        const ThreadLimit limit(threads);
        EXPECT_TRUE(same(read_off(dir / "mesh.off"), mesh)) << threads;
    }
}

TEST(ReadOff, a_line_longer_than_a_chunk_is_read_whole) {
    constexpr int kCorners = 100000;
    std::string text = "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n" + std::to_string(kCorners);
    for (int i = 0; i < kCorners; ++i)
        text += i % 3 == 0 ? " 0   " : i % 3 == 1 ? " 1   " : " 2   ";
    text += "\n3 2 1 0\n";
    const TriangleMesh mesh = parsed(text);
    ASSERT_EQ(mesh.faces.size(), kCorners - 2 + 1u);
    EXPECT_EQ(mesh.faces.back(), Vec3i(2, 1, 0));
}

TEST(ReadOff, a_file_cut_anywhere_is_an_error_or_a_mesh) {
    for (std::size_t size = 0; size <= kTwoFaces.size(); ++size) {
        const TempDir dir;
        const auto path = dir.write("mesh.off", kTwoFaces.substr(0, size));
        try {
            const TriangleMesh mesh = read_off(path);
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
    for (std::uint64_t round = 0; round < 2000; ++round) {
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
            const TriangleMesh mesh = read_off(path);
            EXPECT_NO_THROW(check_indices(mesh)) << round;
            for (const Vec3d& vertex : mesh.vertices) EXPECT_TRUE(vertex.allFinite()) << round;
        } catch (const ParseError&) {
        }
    }
}

TEST(ReadOff, what_is_no_file_is_an_io_error) {
    const TempDir dir;
    EXPECT_THROW(read_off(dir / "missing.off"), IoError);
    EXPECT_THROW(read_off(dir.path()), IoError);
}

TEST(WriteOff, every_number_reads_back_exactly) {
    TriangleMesh mesh = generate_soup(20000);
    mesh.vertices[0] = Vec3d(-0.0, 5e-324, -2.2250738585072014e-308);
    mesh.vertices[1] = Vec3d(std::numeric_limits<float>::max(), 1e-310, 9007199254740993.0);
    mesh.vertices[2] = Vec3d(0.1, 1.0 / 3, 1e22);
    const TriangleMesh again = parsed(text_of(mesh));
    EXPECT_TRUE(same(again, mesh));
    EXPECT_TRUE(std::signbit(again.vertices[0].x()));
}

TEST(WriteOff, the_text_is_the_plainest_there_is) {
    EXPECT_EQ(text_of(parsed(kTwoFaces)),
              "OFF\n4 2 0\n0 0 0\n1.5 0 0\n1.5 1 0\n-0 1 0\n3 0 1 2\n3 0 2 3\n");
    EXPECT_EQ(text_of({}), "OFF\n0 0 0\n");
}

TEST(WriteOff, the_file_does_not_depend_on_the_number_of_threads) {
    const TriangleMesh mesh = generate_gyroid(300000);
    const std::string many = text_of(mesh);
    const ThreadLimit limit(1);
    EXPECT_EQ(text_of(mesh), many);
}

TEST(WriteOff, what_could_not_be_read_again_is_not_written) {
    const TempDir dir;
    const auto path = dir.write("mesh.off", "as it was");
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e39}) {
        TriangleMesh mesh = parsed(kTriangle);
        mesh.vertices[2].y() = bad;
        EXPECT_THROW(write_off(path, mesh), InvalidInput) << bad;
    }
    TriangleMesh mesh = parsed(kTriangle);
    mesh.faces[0][1] = 3;
    EXPECT_THROW(write_off(path, mesh), InvalidInput);
    EXPECT_EQ(content_of(path), "as it was");
}

TEST(WriteOff, a_place_that_can_not_be_written_to_is_an_io_error) {
    const TempDir dir;
    EXPECT_THROW(write_off(dir / "missing/mesh.off", parsed(kTriangle)), IoError);
    EXPECT_THROW(write_off(dir.path(), parsed(kTriangle)), IoError);
}

TEST(WriteOff, nothing_but_the_file_is_left_behind) {
    const TempDir dir;
    write_off(dir / "mesh.off", parsed(kTriangle));
    const std::filesystem::directory_iterator files(dir.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST(MeshFile, the_extension_picks_the_format_in_either_case) {
    const TempDir dir;
    EXPECT_TRUE(same(read_mesh(dir.write("a.off", kTriangle)), parsed(kTriangle)));
    EXPECT_TRUE(same(read_mesh(dir.write("a.b.OFF", kTriangle)), parsed(kTriangle)));
    write_mesh(dir / "b.Off", parsed(kTriangle));
    EXPECT_EQ(content_of(dir / "b.Off"), kTriangle);
}

TEST(MeshFile, an_extension_of_no_format_is_invalid_input) {
    const auto complaint = [](const auto& action) -> std::string {
        try {
            action();
        } catch (const InvalidInput& error) {
            return error.what();
        }
        return "none";
    };
    const std::string of_png = "mesh.PNG: found .PNG, expected a mesh file that ends in .off";
    const std::string of_none =
        "mesh: found a name without extension, expected a mesh file that ends in .off";
    EXPECT_EQ(complaint([] { read_mesh("mesh.PNG"); }), of_png);
    EXPECT_EQ(complaint([] { read_mesh("mesh"); }), of_none);
    EXPECT_EQ(complaint([] { write_mesh("mesh.PNG", {}); }), of_png);
    EXPECT_EQ(complaint([] { write_mesh("mesh", {}); }), of_none);
}

/// A folder of well-known files that is not part of the project.
class SharedFiles : public testing::Test {
protected:
    void SetUp() override {
        const char* shared = std::getenv("BOXWOOD_SHARED");
        if (!shared) GTEST_SKIP() << "BOXWOOD_SHARED names no folder with acceptance/*.off";
        folder_ = std::filesystem::path(shared) / "acceptance";
    }
    std::filesystem::path folder_;
};

TEST_F(SharedFiles, the_cube_is_closed) {
    const MeshReport report = inspect(read_mesh(folder_ / "cube.off"));
    EXPECT_EQ(report.vertices, 8u);
    EXPECT_EQ(report.faces, 12u);
    EXPECT_TRUE(report.closed);
    EXPECT_EQ(report.bounds, (Box3d{{0, 0, 0}, {1, 1, 1}}));
}

TEST_F(SharedFiles, the_bunny_and_the_dodecahedron_are_read_whole) {
    const TriangleMesh bunny = read_mesh(folder_ / "bunny.off");
    EXPECT_EQ(bunny.vertices.size(), 500u);
    EXPECT_EQ(bunny.faces.size(), 996u);
    EXPECT_EQ(bunny.vertices[0], Vec3d(0.179985, -0.01961091, 0.2849799));
    EXPECT_TRUE(inspect(read_mesh(folder_ / "dodeca.off")).closed);
}

}  // namespace
}  // namespace boxwood
