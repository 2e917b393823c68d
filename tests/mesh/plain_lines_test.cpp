// SPDX-License-Identifier: Apache-2.0
// Lines as most programs write them are read by a shorter way than others. Nobody can tell.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/obj.h"
#include "boxwood/mesh/off.h"
#include "boxwood/mesh/ply.h"
#include "boxwood/mesh/stl.h"
#include "mesh/parse.h"

namespace boxwood {
namespace {

/// Enough that files are read in several chunks.
constexpr std::size_t kTriangles = 20000;

/// Lines of numbers, three corners a face, each line with the given words in front.
std::string lines_of(MeshView mesh, const std::string& vertex, const std::string& face,
                     int first_index) {
    std::string text;
    for (const Vec3d& p : mesh.vertices) {
        text += vertex;
        for (int k = 0; k < 3; ++k) text += (k > 0 ? " " : "") + std::to_string(p[k]);
        text += "\n";
    }
    for (const Vec3i& f : mesh.faces) {
        text += face;
        for (int k = 0; k < 3; ++k) text += (k > 0 ? " " : "") + std::to_string(f[k] + first_index);
        text += "\n";
    }
    return text;
}

std::string facets_of(MeshView mesh) {
    std::string text = "solid\n";
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (int k = 0; k < 3; ++k) {
            text += "vertex";
            for (const double x : mesh.corner(i, k)) text += " " + std::to_string(x);
            text += "\n";
        }
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid\n";
}

struct Sample {
    const char* format;
    Parse parse;
    std::string header, body;
};

std::vector<Sample> samples() {
    const TriangleMesh mesh = generate_gyroid(kTriangles);
    const std::string vertices = std::to_string(mesh.vertices.size());
    const std::string faces = std::to_string(mesh.faces.size());
    const std::string body = lines_of(mesh, "", "3 ", 0);
    return {{"OFF", parse_off, "OFF\n" + vertices + " " + faces + " 0\n", body},
            {"PLY", parse_ply,
             "ply\nformat ascii 1.0\nelement vertex " + vertices +
                 "\nproperty double x\nproperty double y\nproperty float z\nelement face " + faces +
                 "\nproperty list uchar int vertex_indices\nend_header\n",
             body},
            {"OBJ", parse_obj, "", lines_of(mesh, "v ", "f ", 1)},
            {"STL", parse_stl, "", facets_of(mesh)}};
}

std::string replaced(const std::string& text, const std::string& from, const std::string& to) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        if (text.compare(at, from.size(), from) == 0) {
            result += to;
            at += from.size();
        } else {
            result += text[at++];
        }
    }
    return result;
}

MeshData read(const Sample& sample, const std::string& body) {
    const std::string text = sample.header + body;
    return sample.parse({text, "mesh"}, {});
}

void expect_same_mesh(const MeshData& other, const MeshData& mesh) {
    EXPECT_TRUE(other.vertices == mesh.vertices);
    EXPECT_TRUE(other.faces == mesh.faces);
    EXPECT_TRUE(other.attributes.colors.values == mesh.attributes.colors.values);
}

TEST(PlainLines, are_read_as_lines_with_other_blanks_are) {
    for (const Sample& sample : samples()) {
        SCOPED_TRACE(sample.format);
        const MeshData mesh = read(sample, sample.body);
        EXPECT_EQ(mesh.faces.size(), generate_gyroid(kTriangles).faces.size());
        std::vector<std::pair<std::string, std::string>> changes = {
            {" ", "  "},    {" ", "\t"},   {"\n", " \n"},   {"\n", "\r\n"},
            {"\n", "\n\n"}, {"\n", "\n "}, {" 0.", " +0."}, {"3\n", "3 \n"}};
        if (sample.parse != parse_stl)
            for (const char* comment : {"\n#\n", "\n# 1 2\n# 3 4\n# 5 6\n# 7 8\n",
                                        "\n# 1.000000000 2.000000000000\n", "\n# 1\n\n#\n"})
                changes.emplace_back("\n", comment);
        for (const auto& [from, to] : changes) {
            SCOPED_TRACE(from + " by " + to);
            const MeshData other = read(sample, replaced(sample.body, from, to));
            expect_same_mesh(other, mesh);
            EXPECT_TRUE(other.warnings.is_empty());
        }
    }
}

/// The body with some of its triangles, one in so many, replaced by faces of other kinds.
std::string with_other_faces(const std::string& body, const std::string& face, std::size_t one_in,
                             const std::vector<std::string>& others) {
    std::string result;
    std::mt19937 engine(1);
    for (std::size_t at = 0; at < body.size();) {
        const std::size_t end = body.find('\n', at) + 1;
        const std::string line = body.substr(at, end - at);
        result += line.starts_with(face) && engine() % one_in == 0
                      ? others[engine() % others.size()] + "\n"
                      : line;
        at = end;
    }
    return result;
}

TEST(PlainLines, may_have_any_others_between_them) {
    for (const Sample& sample : samples()) {
        SCOPED_TRACE(sample.format);
        std::vector<std::string> others;
        if (sample.parse == parse_off)
            others = {"4 0 1 2 3", "2 0 1", "0", "3 4 5 6 1 0 0", "5 0 1 2 3 4", "3 7 8 +9"};
        if (sample.parse == parse_ply) others = {"4 0 1 2 3", "2 0 1", "0", "5 0 1 2 3 4"};
        if (sample.parse == parse_obj)
            others = {"f 1 2 3 4", "f 1 2", "f -1 -2 -3", "f 1/ 2/ 3/", "g x", "vn 0 0 1"};
        if (others.empty()) continue;
        for (const std::size_t one_in : {1, 3, 1000, 30000}) {
            const std::string body = with_other_faces(
                sample.body, sample.parse == parse_obj ? "f " : "3 ", one_in, others);
            const MeshData mesh = read(sample, body);
            // No line of this one is plain.
            const MeshData other = read(sample, replaced(body, " ", " \t"));
            expect_same_mesh(mesh, other);
            EXPECT_EQ(mesh.warnings.kinds().size(), other.warnings.kinds().size());
        }
    }
}

TEST(PlainLines, of_ply_may_have_faces_first_and_strips_behind_them) {
    const TriangleMesh mesh = generate_gyroid(kTriangles);
    const std::string body = lines_of(mesh, "", "3 ", 0);
    const std::size_t faces_at = body.find("\n3 ", body.find("\n3 ")) + 1;
    const auto element = [](const char* name, std::size_t count, const char* properties) {
        return "element " + std::string(name) + " " + std::to_string(count) + "\n" + properties;
    };
    const std::string vertex = element("vertex", mesh.vertices.size(),
                                       "property float x\nproperty float y\nproperty float z\n");
    const std::string face =
        element("face", mesh.faces.size(), "property list uchar int vertex_indices\n");
    const std::string strips = element("tristrips", 1, "property list int int vertex_indices\n");
    const auto read_ply = [](const std::string& header, const std::string& rest) {
        const std::string text = "ply\nformat ascii 1.0\n" + header + "end_header\n" + rest;
        return parse_ply({text, "mesh"}, {});
    };
    const std::string vertices = body.substr(0, faces_at), faces = body.substr(faces_at);
    ASSERT_EQ(static_cast<std::size_t>(std::count(faces.begin(), faces.end(), '\n')),
              mesh.faces.size());

    const MeshData first = read_ply(face + vertex, faces + vertices);
    EXPECT_TRUE(first.faces == mesh.faces);
    EXPECT_EQ(first.vertices.size(), mesh.vertices.size());

    std::vector<Vec3i> expected = mesh.faces;
    expected.insert(expected.end(), {{0, 1, 2}, {2, 1, 3}});
    for (const auto& [header, rest] : {std::pair(vertex + face + strips, body + "4 0 1 2 3\n"),
                                       {strips + vertex + face, "4 0 1 2 3\n" + body}}) {
        const MeshData with_strips = read_ply(header, rest);
        EXPECT_TRUE(with_strips.faces == expected);
        EXPECT_TRUE(with_strips.vertices == first.vertices);
    }
}

}  // namespace
}  // namespace boxwood
