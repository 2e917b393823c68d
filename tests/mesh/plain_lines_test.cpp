// SPDX-License-Identifier: Apache-2.0
// Lines as most programs write them are read by a shorter way than others. Nobody can tell.
#include <gtest/gtest.h>

#include <string>

#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/obj.h"
#include "boxwood/mesh/off.h"
#include "boxwood/mesh/ply.h"
#include "boxwood/mesh/stl.h"
#include "mesh/parse.h"

namespace boxwood {
namespace {

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
    const TriangleMesh mesh = generate_gyroid(3000);
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

TEST(PlainLines, are_read_as_lines_with_other_blanks_are) {
    for (const Sample& sample : samples()) {
        SCOPED_TRACE(sample.format);
        const auto read = [&](const std::string& body) {
            const std::string text = sample.header + body;
            return sample.parse({text, "mesh"}, {});
        };
        const MeshData mesh = read(sample.body);
        EXPECT_EQ(mesh.faces.size(), generate_gyroid(3000).faces.size());
        for (const auto& [from, to] : {std::pair<std::string, std::string>{" ", "  "},
                                       {" ", "\t"},
                                       {"\n", " \n"},
                                       {"\n", "\r\n"},
                                       {"\n", "\n\n"},
                                       {"\n", "\n "},
                                       {" 0.", " +0."},
                                       {"3\n", "3 \n"}}) {
            SCOPED_TRACE(from + " by " + to);
            const MeshData other = read(replaced(sample.body, from, to));
            EXPECT_TRUE(other.vertices == mesh.vertices);
            EXPECT_TRUE(other.faces == mesh.faces);
            EXPECT_TRUE(other.warnings.is_empty());
        }
    }
}

}  // namespace
}  // namespace boxwood
