// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/mtl.h"

#include <gtest/gtest.h>

#include "boxwood/image/png.h"
#include "error_of.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

MtlLibrary parsed_mtl(std::string_view text) { return parse_mtl({text, "m.mtl"}); }

TEST(Mtl, properties_become_those_of_materials) {
    const MtlLibrary library = parsed_mtl(
        "# by hand\n"
        "newmtl red plastic\r\n"
        "Ka 1 1 1\nKd 0.8 0.1 0.2\nKs 0.5 0.4 0.3\nNs 96\nNi 1.5\nd 0.25\nKe 0 0 2\nillum 2\n"
        "\n  newmtl grey\nKd 0.5\nTr 0.25\n");
    ASSERT_EQ(library.materials.size(), 2u);
    const Material& red = library.materials[0];
    EXPECT_EQ(red.name, "red plastic");
    EXPECT_EQ(red.diffuse, Color(0.8, 0.1, 0.2));
    EXPECT_EQ(red.ambient, red.diffuse);
    EXPECT_EQ(red.specular, Color(0.5, 0.4, 0.3));
    EXPECT_EQ(red.emission, Color(0, 0, 2));
    EXPECT_EQ(red.shininess, 96);
    EXPECT_EQ(red.refraction_index, 1.5);
    EXPECT_EQ(red.opacity, 0.25);
    EXPECT_EQ(library.materials[1].diffuse, Color(0.5, 0.5, 0.5));
    EXPECT_EQ(library.materials[1].opacity, 0.75);
    EXPECT_TRUE(library.warnings.is_empty());
}

TEST(Mtl, textures_are_read_once_and_moved_as_options_say) {
    const TempDir dir;
    std::filesystem::create_directory(dir / "tex");
    write_png(dir / "tex/wood grain.png", Rgba8Image(2, 2, {}));
    const std::string text =
        "newmtl a\nmap_Kd -s 2 3 1 -o 0.5 0.25 0 -clamp on tex/wood grain.png\n"
        "newmtl b\nKd 0 0 0\nmap_Kd tex\\wood grain.png\n"
        "newmtl c\nKd 0.5 0.5 0.5\nmap_Kd tex/wood grain.png\n";
    const MtlLibrary library = parse_mtl({text, dir / "m.mtl"});
    EXPECT_EQ(library.textures.size(), 1u);
    ASSERT_TRUE(library.materials[0].color_texture);
    // (u, v) goes to (2 u + 0.5, 3 v + 0.25), counted from the lower left corner.
    EXPECT_TRUE(
        library.materials[0].color_texture->place({0.25, 0.5}).isApprox(Vec2d(1, 1 - 1.75)));
    EXPECT_EQ(library.materials[1].diffuse, Color(1, 1, 1));
    EXPECT_EQ(library.materials[2].diffuse, Color(0.5, 0.5, 0.5));
    EXPECT_TRUE(library.warnings.is_empty());
}

TEST(Mtl, what_cannot_be_read_is_told) {
    const MtlLibrary library = parsed_mtl(
        "newmtl a\nbump stones.png\nmap_Kd missing.png\nmap_Kd ../outside.png\nmap_Kd "
        "http://x.org/a.png\nsubsurface 1\n");
    EXPECT_EQ(library.warnings.count("material properties that aren't read"), 2u);
    EXPECT_EQ(library.warnings.count("textures that can't be read, left out"), 3u);
    EXPECT_FALSE(library.materials[0].color_texture);
}

TEST(Mtl, faults_are_told_with_their_lines) {
    const auto complaint = [](std::string_view text) {
        return error_of([&] { parsed_mtl(text); });
    };
    EXPECT_EQ(complaint("Kd 1 1 1\n"), "ParseError m.mtl:1: found 'Kd', expected newmtl first");
    EXPECT_EQ(complaint("newmtl a\nKd 1 1\n"),
              "ParseError m.mtl:2: found nothing, expected a number");
    EXPECT_EQ(complaint("newmtl a\n\nKd 1 x 1\n"),
              "ParseError m.mtl:3: found 'x', expected a number");
    EXPECT_EQ(complaint("newmtl a\nNs nan\n"),
              "ParseError m.mtl:2: found 'nan', expected a number");
    EXPECT_EQ(complaint("newmtl a\nd\n"), "ParseError m.mtl:2: found nothing, expected a number");
    EXPECT_EQ(complaint(""), "no error");
}

}  // namespace
}  // namespace boxwood
