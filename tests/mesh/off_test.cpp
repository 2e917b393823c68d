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
#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/inspect.h"
#include "boxwood/mesh/mesh_file.h"
#include "mesh/off_text.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

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

TEST(ReadOff, the_mesh_does_not_depend_on_the_number_of_threads) {
    const TempDir dir;
    const TriangleMesh mesh = generate_gyroid(60000);
    write_off(dir / "mesh.off", mesh);
    for (const std::size_t threads : {1, 2, 8}) {
        const ThreadLimit limit(threads);
        EXPECT_TRUE(same(read_mesh(dir / "mesh.off"), mesh)) << threads;
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

TEST(WriteOff, numbers_that_are_not_finite_read_back) {
    TriangleMesh mesh = parsed(kTriangle);
    mesh.vertices[0] = Vec3d(std::nan(""), std::numeric_limits<double>::infinity(), 1e39);
    mesh.vertices[1].y() = -std::numeric_limits<double>::infinity();
    const TriangleMesh again = parsed(text_of(mesh));
    EXPECT_TRUE(std::isnan(again.vertices[0].x()));
    EXPECT_EQ(again.vertices[0].tail<2>(), mesh.vertices[0].tail<2>());
    EXPECT_EQ(again.vertices[1], mesh.vertices[1]);
}

TEST(WriteOff, indices_out_of_range_are_not_written) {
    const TempDir dir;
    const auto path = dir.write("mesh.off", "as it was");
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
    std::string known;
    for (const MeshFormat& format : mesh_formats())
        known += (known.empty() ? "" : ", ") + std::string(format.extension);
    const std::string of_png = "mesh.PNG: found .PNG, expected a mesh file that ends in " + known;
    const std::string of_none =
        "mesh: found a name without extension, expected a mesh file that ends in " + known;
#ifdef BOXWOOD_WITH_ASSIMP
    const std::string more = " or in what assimp reads";
#else
    const std::string more = " (built with assimp, Boxwood would read more)";
#endif
    EXPECT_EQ(complaint([] { read_mesh("mesh.PNG"); }), of_png + more);
    EXPECT_EQ(complaint([] { read_mesh("mesh"); }), of_none + more);
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
