// SPDX-License-Identifier: Apache-2.0
// What is wrong with a glTF file is told with its JSON path or byte, what was found there and what
// was expected.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "boxwood/core/random.h"
#include "boxwood/mesh/mesh_file.h"
#include "cases.h"
#include "error_of.h"
#include "mesh/gltf_json.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

std::string complaint_about(const Json& json, const ReadOptions& options = {}) {
    const std::string text = error_of([&] { parsed(json, options); });
    const std::string start = "ParseError mesh.gltf:";
    return text.starts_with(start) ? text.substr(start.size()) : text;
}
std::string complaint_about_bytes(std::string_view bytes) {
    const std::string text = error_of([&] { parse_gltf({bytes, "mesh.glb"}); });
    const std::string start = "ParseError mesh.glb:";
    return text.starts_with(start) ? text.substr(start.size()) : text;
}

struct Case {
    const char* place;  ///< a JSON pointer
    const char* value;  ///< that is put there; nothing takes what is there away
    const char* complaint;
};

constexpr Case kCases[] = {
    {"/asset", "", "$: found an object, expected key 'asset'"},
    {"/asset/version", "\"1.0\"", "$.asset.version: found \"1.0\", expected glTF version 2.0"},
    {"/asset/version", "2", "$.asset.version: found 2, expected a string"},
    {"/asset/minVersion", "\"2.1\"",
     "$.asset.minVersion: found \"2.1\", expected glTF version 2.0"},
    {"/extensionsRequired", "[\"KHR_draco_mesh_compression\"]",
     "$.extensionsRequired[0]: found \"KHR_draco_mesh_compression\", expected one of the "
     "extensions KHR_lights_punctual, KHR_materials_emissive_strength, KHR_materials_unlit, "
     "KHR_mesh_quantization, KHR_texture_transform"},
    {"/extensionsRequired", "7", "$.extensionsRequired: found 7, expected an array"},
    {"/meshes", "{}", "$.meshes: found an object, expected an array"},
    {"/scene", "1", "$.scene: found 1, expected a whole number from 0 to 0"},
    {"/scene", "-1", "$.scene: found -1, expected a whole number from 0 to 0"},
    {"/scene", "0.5", "$.scene: found 0.5, expected a whole number from 0 to 0"},
    {"/scenes", "", "$.scene: found 0, expected nothing, as there is nothing to choose from"},
    {"/scenes/0/nodes/0", "99",
     "$.scenes[0].nodes[0]: found 99, expected a whole number from 0 to 2"},
    {"/nodes/0/mesh", "5", "$.nodes[0].mesh: found 5, expected a whole number from 0 to 0"},
    {"/nodes/0/children/0", "0",
     "$.nodes[0].children[0]: found 0, expected a node with one parent, and no circle of nodes"},
    {"/nodes/0/children", "[1, 1]",
     "$.nodes[0].children[1]: found 1, expected a node with one parent, and no circle of nodes"},
    {"/nodes/1/children", "[0]",
     "$.nodes[1].children[0]: found 0, expected a node with one parent, and no circle of nodes"},
    {"/nodes/0/translation", "[0, 0]",
     "$.nodes[0].translation: found an array of 2, expected an array of 3 numbers"},
    {"/nodes/0/rotation", "[0, 0, 0, 0]",
     "$.nodes[0].rotation: found an array of 4, expected a quaternion that isn't zero"},
    {"/nodes/0/scale", "\"big\"",
     "$.nodes[0].scale: found \"big\", expected an array of 3 numbers"},
    {"/nodes/0/matrix", "[1, 2, 3]",
     "$.nodes[0].matrix: found an array of 3, expected an array of 16 numbers"},
    {"/nodes/0/matrix", "[1,0,0,0.5, 0,1,0,0, 0,0,1,0, 0,0,0,1]",
     "$.nodes[0].matrix: found an array of 16, expected an affine matrix, with 0, 0, 0 and 1 in "
     "its last row"},
    {"/meshes/0/primitives", "", "$.meshes[0]: found an object, expected key 'primitives'"},
    {"/meshes/0/primitives/0/attributes", "",
     "$.meshes[0].primitives[0]: found an object, expected key 'attributes'"},
    {"/meshes/0/primitives/0/mode", "7",
     "$.meshes[0].primitives[0].mode: found 7, expected a whole number from 0 to 6"},
    {"/meshes/0/primitives/0/indices", "9",
     "$.meshes[0].primitives[0].indices: found 9, expected a whole number from 0 to 4"},
    {"/meshes/0/primitives/0/indices", "0",
     "$.accessors[0].componentType: found 5126, expected a type of indices: 5121, 5123 or 5125"},
    {"/meshes/0/primitives/0/material", "1",
     "$.meshes[0].primitives[0].material: found 1, expected a whole number from 0 to 0"},
    {"/meshes/0/primitives/0/attributes/POSITION", "3",
     "$.accessors[3].type: found \"VEC2\", expected VEC3"},
    {"/meshes/0/primitives/0/attributes/POSITION", "-1",
     "$.meshes[0].primitives[0].attributes.POSITION: found -1, expected a whole number from 0 to "
     "4"},
    {"/meshes/0/primitives/0/attributes/NORMAL", "4",
     "$.accessors[4].type: found \"VEC4\", expected VEC3"},
    {"/meshes/0/primitives/0/attributes/COLOR_0", "3",
     "$.accessors[3].type: found \"VEC2\", expected VEC3 or VEC4"},
    {"/accessors/2/count", "3",
     "$.meshes[0].primitives[0].attributes.NORMAL: found 2, expected an accessor of 4 elements, as "
     "there are positions, and not 3"},
    {"/accessors/0/count", "3",
     "$.meshes[0].primitives[0].attributes.NORMAL: found 2, expected an accessor of 3 elements, as "
     "there are positions, and not 4"},
    {"/bufferViews/1/byteOffset", "6",
     "$.accessors[1]: found an object, expected indices below 4, the number of vertices, and not "
     "16256 at place 4"},
    {"/accessors/0/count", "5",
     "$.accessors[0]: found an object, expected at most 4 elements, which its buffer view has room "
     "for"},
    {"/accessors/0/count", "-4",
     "$.accessors[0].count: found -4, expected a whole number from 0 to 2147483647"},
    {"/accessors/0/count", "4294967296",
     "$.accessors[0].count: found 4294967296, expected a whole number from 0 to 2147483647"},
    {"/accessors/0/count", "18446744073709551615",
     "$.accessors[0].count: found 18446744073709551615, expected a whole number from 0 to "
     "2147483647"},
    {"/accessors/0/componentType", "5124",
     "$.accessors[0].componentType: found 5124, expected a component type of glTF: 5120, 5121, "
     "5122, 5123, 5125 or 5126"},
    {"/accessors/0/type", "\"VEC5\"",
     "$.accessors[0].type: found \"VEC5\", expected SCALAR, VEC2, VEC3 or VEC4"},
    {"/accessors/0/type", "\"MAT4\"",
     "$.accessors[0].type: found \"MAT4\", expected SCALAR, VEC2, VEC3 or VEC4"},
    {"/accessors/0/byteOffset", "49",
     "$.accessors[0].byteOffset: found 49, expected a whole number from 0 to 48"},
    {"/accessors/0/byteOffset", "48",
     "$.accessors[0]: found an object, expected at most 0 elements, which its buffer view has room "
     "for"},
    {"/accessors/0/bufferView", "5",
     "$.accessors[0].bufferView: found 5, expected a whole number from 0 to 4"},
    {"/accessors/1/type", "\"VEC2\"", "$.accessors[1].type: found \"VEC2\", expected SCALAR"},
    {"/accessors/0/normalized", "1", "$.accessors[0].normalized: found 1, expected true or false"},
    {"/bufferViews/0/buffer", "1",
     "$.bufferViews[0].buffer: found 1, expected a whole number from 0 to 0"},
    {"/bufferViews/0/byteLength", "157",
     "$.bufferViews[0].byteLength: found 157, expected a whole number from 0 to 156"},
    {"/bufferViews/0/byteLength", "-1",
     "$.bufferViews[0].byteLength: found -1, expected a whole number from 0 to 156"},
    {"/bufferViews/1/byteOffset", "157",
     "$.bufferViews[1].byteOffset: found 157, expected a whole number from 0 to 156"},
    {"/bufferViews/1/byteOffset", "18446744073709551610",
     "$.bufferViews[1].byteOffset: found 18446744073709551610, expected a whole number from 0 to "
     "156"},
    {"/bufferViews/0/byteStride", "0",
     "$.bufferViews[0].byteStride: found 0, expected a whole number from 1 to 255"},
    {"/bufferViews/0/byteStride", "24",
     "$.accessors[0]: found an object, expected at most 2 elements, which its buffer view has room "
     "for"},
    {"/buffers/0/byteLength", "157",
     "$.buffers[0].byteLength: found 157, expected at most 156, the size of its data"},
    {"/buffers/0/byteLength", "1e300",
     "$.buffers[0].byteLength: found 1e+300, expected a whole number from 0 to 274877906944"},
    {"/buffers/0/uri", "",
     "$.buffers[0]: found an object, expected a buffer with a uri, or the first one of a .glb with "
     "a binary chunk"},
    {"/buffers/0/uri", "\"data:text/plain,hello\"",
     "$.buffers[0].uri: found \"data:text/plain,hello\", expected a data URI with base64"},
    {"/buffers/0/uri", "\"data:;base64,AA*A\"",
     "$.buffers[0].uri: found \"data:;base64,AA*A\", expected a data URI with base64"},
    {"/buffers/0/uri", "\"data:;base64,A\"",
     "$.buffers[0].uri: found \"data:;base64,A\", expected a data URI with base64"},
    {"/buffers/0/uri", "\"\"", "$.buffers[0].uri: found \"\", expected a file's name"},
    {"/buffers/0/uri", "\"a%00b\"", "$.buffers[0].uri: found \"a%00b\", expected a file's name"},
    {"/buffers/0/uri", "\"https://example.org/a.bin\"",
     "$.buffers[0].uri: found \"https://example.org/a.bin\", expected the name of a file here, as "
     "nothing is fetched"},
    {"/buffers/0/uri", "\"file:///etc/passwd\"",
     "$.buffers[0].uri: found \"file:///etc/passwd\", expected the name of a file here, as nothing "
     "is fetched"},
    {"/buffers/0/uri", "\"/etc/passwd\"",
     "$.buffers[0].uri: found \"/etc/passwd\", expected a file in the folder of the file that "
     "names it or below"},
    {"/buffers/0/uri", "\"../secret.bin\"",
     "$.buffers[0].uri: found \"../secret.bin\", expected a file in the folder of the file that "
     "names it or below"},
    {"/buffers/0/uri", "\"a/..%2f../secret.bin\"",
     "$.buffers[0].uri: found \"a/..%2f../secret.bin\", expected a file in the folder of the file "
     "that names it or below"},
};

TEST(BadGltf, each_fault_is_told_with_its_place) {
    for (const Case& c : kCases) {
        Json json = square_gltf();
        const Json::json_pointer place(c.place);
        if (*c.value == '\0') {
            json[place.parent_pointer()].erase(place.back());
        } else {
            json[place] = Json::parse(c.value);
        }
        EXPECT_EQ(complaint_about(json), c.complaint) << c.place << " " << c.value;
    }
}

TEST(BadGltf, faults_of_sparse_accessors_are_told) {
    Json json = square_gltf();
    json["accessors"][0]["sparse"] = {{"count", 1},
                                      {"indices", {{"bufferView", 1}, {"componentType", 5123}}},
                                      {"values", {{"bufferView", 0}}}};
    EXPECT_EQ(complaint_about(json), "no error");
    const auto with = [&](const char* place, const Json& value) {
        Json spoiled = json;
        spoiled[Json::json_pointer(place)] = value;
        return complaint_about(spoiled);
    };
    EXPECT_EQ(with("/accessors/0/sparse/count", 5),
              "$.accessors[0].sparse.count: found 5, expected a whole number from 0 to 4");
    EXPECT_EQ(
        with("/accessors/0/sparse/indices/componentType", 5126),
        "$.accessors[0].sparse.indices.componentType: found 5126, expected a type of indices: "
        "5121, 5123 or 5125");
    // Read as 32-bit numbers, the indices 0 and 1 are one of 65536.
    EXPECT_EQ(
        with("/accessors/0/sparse/indices/componentType", 5125),
        "$.accessors[0].sparse.indices: found an object, expected indices below 4, the number "
        "of elements, and not 65536");
    EXPECT_EQ(with("/accessors/0/sparse/values/byteOffset", 40),
              "$.accessors[0].sparse.values: found an object, expected at most 0 elements, which "
              "its buffer view has room for");
}

TEST(BadGltf, zeros_that_nothing_stands_for_are_limited) {
    Json json = square_gltf();
    json["accessors"][0].erase("bufferView");
    json["accessors"][0]["count"] = 2'000'000'000;
    EXPECT_EQ(complaint_about(json),
              "$.accessors[0].count: found 2000000000, expected a whole number from 0 to 16777216");
}

TEST(BadGltf, limits_hold) {
    const Json json = square_gltf();
    EXPECT_EQ(complaint_about(json, {.limits = {.max_vertices = 3}}),
              "$.accessors[0].count: found 4, expected a whole number from 0 to 3");
    EXPECT_EQ(complaint_about(json, {.limits = {.max_vertices = 4, .max_faces = 1}}),
              "$.accessors[1].count: found 6, expected a whole number from 0 to 3");
    EXPECT_EQ(complaint_about(json, {.limits = {.max_bytes = 100}}),
              "$.buffers[0].byteLength: found 156, expected a whole number from 0 to 100");
    EXPECT_EQ(complaint_about(json, {.limits = {.max_depth = 3}}),
              "1: found a value in 4 others, expected at most 3");

    Json chain = square_gltf();
    for (int i = 3; i < 400; ++i) chain["nodes"].push_back({{"children", {i + 1}}});
    chain["nodes"].push_back({{"mesh", 0}});
    chain["nodes"][0]["children"] = {3};
    EXPECT_EQ(complaint_about(chain),
              "$.nodes[257].children[0]: found 258, expected at most 256 nodes in one another");

    Json twice = square_gltf();
    twice["nodes"][1]["mesh"] = 0;
    EXPECT_EQ(
        complaint_about(twice, {.limits = {.max_vertices = 7}}),
        "$.nodes[1]: found an object, expected at most 7 vertices and 2147483647 faces in all");
}

TEST(BadGltf, containers_that_lie_are_errors) {
    const std::string good = glb_of(R"({"asset":{"version":"2.0"}})", "1234");
    EXPECT_EQ(complaint_about_bytes(good), "no error");
    const auto with = [&](std::size_t place, std::string_view bytes) {
        std::string spoiled = good;
        spoiled.replace(place, bytes.size(), bytes);
        return complaint_about_bytes(spoiled);
    };
    EXPECT_EQ(with(4, "\x01"), "byte 4: found version 1, expected 2");
    EXPECT_EQ(with(8, "\xff\xff"),
              "byte 8: found the length 65535, expected 20 to 60, the size of the file");
    EXPECT_EQ(with(8, std::string_view("\x10\0\0\0", 4)),
              "byte 8: found the length 16, expected 20 to 60, the size of the file");
    EXPECT_EQ(with(12, "\xff\xff\xff\x7f"),
              "byte 12: found a chunk of 2147483647 bytes, expected at most 40, all that is left");
    EXPECT_EQ(with(16, "BIN "),
              "byte 16: found another type, expected that the first chunk is JSON");
    EXPECT_EQ(with(48, "\xff"),
              "byte 48: found a chunk of 255 bytes, expected at most 4, all that is left");
    EXPECT_EQ(with(20, "["), "1: found ':', expected ']'");
    for (std::size_t size = 4; size < 20; ++size)
        EXPECT_EQ(complaint_about_bytes(good.substr(0, size)),
                  "byte " + std::to_string(size) +
                      ": the file ends, expected the headers of a .glb, 20 bytes");
    for (std::size_t size = 20; size < good.size(); ++size)
        EXPECT_NE(complaint_about_bytes(good.substr(0, size)), "no error") << size;
}

TEST(BadGltf, a_missing_buffer_file_is_an_io_error) {
    const TempDir dir;
    Json json = square_gltf();
    json["buffers"][0]["uri"] = "missing.bin";
    const auto path = dir.write("mesh.gltf", json.dump());
    EXPECT_EQ(error_of([&] { read_mesh(path); }),
              "IoError " + (dir / "missing.bin").string() + ": No such file or directory");
}

TEST(BadGltf, links_do_not_lead_out_of_the_folder_unless_that_is_allowed) {
    const TempDir outside, dir;
    Json json = square_gltf();
    const std::string uri = json["buffers"][0]["uri"];
    const auto secret = outside.write(
        "secret.bin", *base64_decoded(std::string_view(uri).substr(uri.find(',') + 1)));
    std::filesystem::create_symlink(secret, dir / "link.bin");
    json["buffers"][0]["uri"] = "link.bin";
    const auto path = dir.write("mesh.gltf", json.dump());
    EXPECT_NE(error_of([&] { read_mesh(path); }).find("found \"link.bin\", expected a file in"),
              std::string::npos);
    EXPECT_EQ(read_mesh(path, {.allow_outside_files = true}).vertices.size(), 4u);
}

TEST(BadGltf, files_cut_or_changed_anywhere_are_errors_or_meshes) {
    Json json = square_gltf();
    const std::string uri = json["buffers"][0]["uri"];
    const auto bytes = base64_decoded(std::string_view(uri).substr(uri.find(',') + 1));
    json["buffers"][0].erase("uri");
    const std::string valid = glb_of(json.dump(), *bytes);
    const auto check = [](const std::string& text) {
        try {
            const MeshData mesh =
                parse_gltf({text, "mesh.glb"}, {.limits = {.max_bytes = 1 << 20}});
            EXPECT_NO_THROW(check_indices(mesh));
            EXPECT_NO_THROW(check_attributes(mesh, mesh.attributes));
        } catch (const Error&) {
        }
    };
    for (std::size_t size = 0; size < valid.size(); ++size) check(valid.substr(0, size));
    for (std::uint64_t round = 0; round < cases(5000); ++round) {
        std::uint32_t dimension = 0;
        const auto random = [&](std::size_t count) {
            return static_cast<std::size_t>(static_cast<double>(count) *
                                            uniform(3, round, dimension++));
        };
        std::string text = valid;
        for (std::size_t changes = 1 + random(3); changes > 0; --changes)
            text[random(text.size())] = "0123456789-.,[]{}\"e\0\xff"[random(22)];
        check(text);
    }
}

}  // namespace
}  // namespace boxwood
