// SPDX-License-Identifier: Apache-2.0
// What tests ask of every reader: what it complains of, what it warns of, and that it takes
// anything for an error or a mesh.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/core/random.h"
#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/mesh_source.h"
#include "cases.h"

namespace boxwood {

using Parse = MeshData (*)(const MeshSource& source, const ReadOptions& options);

/// A text with what is wrong with it, as "line: message".
struct BadText {
    const char* name;
    std::string text;
    std::string complaint;
};

/// The message without the file's name, or "none".
inline std::string complaint_of(Parse parse, std::string_view text,
                                const ReadOptions& options = {}) {
    constexpr std::string_view kName = "mesh:";
    try {
        parse({text, "mesh"}, options);
    } catch (const ParseError& error) {
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with(kName)) << message;
        return message.substr(std::min(message.size(), kName.size()));
    }
    return "none";
}

inline void expect_complaints(Parse parse, const std::vector<BadText>& bad) {
    for (const BadText& each : bad)
        EXPECT_EQ(complaint_of(parse, each.text), each.complaint) << each.name;
}

/// "kind (count): first" for each kind.
inline std::vector<std::string> warnings_of(const MeshData& mesh) {
    std::vector<std::string> result;
    for (const Warning& warning : mesh.warnings.kinds())
        result.push_back(warning.kind + " (" + std::to_string(warning.count) +
                         "): " + warning.shown.at(0));
    return result;
}

/// Equal but for NaN, which is equal to itself here.
inline bool same_values(const auto& a, const auto& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return (x.array() == y.array() || (x.array().isNaN() && y.array().isNaN())).all();
    });
}

inline std::vector<std::string> label_of_faces(const FaceLabels& labels) {
    std::vector<std::string> result;
    for (const std::uint32_t label : labels.of_face) result.push_back(labels.names.at(label));
    return result;
}

inline void expect_same(const MeshData& a, const MeshData& b) {
    EXPECT_TRUE(same_values(a.vertices, b.vertices));
    EXPECT_TRUE(a.faces == b.faces);
    const auto expect_same_values = [](const auto& x, const auto& y, const char* what) {
        if (!x.is_empty() || !y.is_empty()) EXPECT_EQ(x.of, y.of) << what;
        EXPECT_TRUE(same_values(x.values, y.values)) << what;
    };
    const MeshAttributes &left = a.attributes, &right = b.attributes;
    expect_same_values(left.normals, right.normals, "normals");
    expect_same_values(left.texture_coordinates, right.texture_coordinates, "texture coordinates");
    expect_same_values(left.colors, right.colors, "colors");
    EXPECT_EQ(label_of_faces(left.groups), label_of_faces(right.groups));
    EXPECT_EQ(label_of_faces(left.materials), label_of_faces(right.materials));
    EXPECT_EQ(left.material_files, right.material_files);
    ASSERT_EQ(left.fields.size(), right.fields.size());
    for (std::size_t i = 0; i < left.fields.size(); ++i) {
        EXPECT_EQ(left.fields[i].name, right.fields[i].name);
        EXPECT_EQ(left.fields[i].of, right.fields[i].of);
        EXPECT_EQ(left.fields[i].values, right.fields[i].values);
    }
    EXPECT_EQ(warnings_of(a), warnings_of(b));
}

inline void expect_error_or_mesh(Parse parse, std::string_view text) {
    // Memory of its own, so that a sanitizer sees a step over its end.
    const std::vector<char> copy(text.begin(), text.end());
    try {
        const MeshData mesh = parse({{copy.data(), copy.size()}, "mesh"}, {});
        EXPECT_NO_THROW(check_indices(mesh));
        EXPECT_NO_THROW(check_attributes(mesh, mesh.attributes));
    } catch (const ParseError&) {
    }
}

inline void expect_errors_or_meshes_when_cut(Parse parse, std::string_view text) {
    for (std::size_t size = 0; size <= text.size(); ++size) {
        SCOPED_TRACE(size);
        expect_error_or_mesh(parse, text.substr(0, size));
    }
}

/// With up to four bytes changed, half of the time to one that the format often has.
inline void expect_errors_or_meshes_when_changed(Parse parse, const std::string& valid,
                                                 std::string_view spice, std::uint64_t rounds) {
    for (std::uint64_t round = 0; round < cases(rounds); ++round) {
        SCOPED_TRACE(round);
        std::uint32_t dimension = 0;
        const auto random = [&](std::size_t count) {
            return static_cast<std::size_t>(static_cast<double>(count) *
                                            uniform(1, round, dimension++));
        };
        std::string text = valid.substr(0, random(8) == 0 ? random(valid.size()) : valid.npos);
        for (std::size_t changes = random(5); changes > 0 && !text.empty(); --changes)
            text[random(text.size())] =
                random(2) == 0 ? spice[random(spice.size())] : static_cast<char>(random(256));
        expect_error_or_mesh(parse, text);
    }
}

inline void expect_same_on_any_threads(Parse parse, std::string_view text) {
    const ThreadLimit one(1);
    const MeshData expected = parse({text, "mesh"}, {});
    for (const std::size_t threads : {2, 8}) {
        SCOPED_TRACE(threads);
        const ThreadLimit limit(threads);
        expect_same(parse({text, "mesh"}, {}), expected);
    }
}

}  // namespace boxwood
