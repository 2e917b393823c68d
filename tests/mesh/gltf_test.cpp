// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/gltf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/inspect.h"
#include "boxwood/mesh/mesh_file.h"
#include "boxwood/mesh/split_corners.h"
#include "mesh/gltf_json.h"
#include "rounded_to_float.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

const std::vector<Vec3d> kCorners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<Vec3i> kFaces = {{0, 1, 2}, {0, 2, 3}};

TEST(ReadGltf, a_square_has_its_triangles_and_what_its_vertices_say) {
    const MeshData mesh = parsed(square_gltf());
    EXPECT_EQ(mesh.vertices, kCorners);
    EXPECT_EQ(mesh.faces, kFaces);
    const MeshAttributes& all = mesh.attributes;
    EXPECT_EQ(all.normals.values, std::vector<Vec3f>(4, Vec3f(0, 0, 1)));
    EXPECT_EQ(all.texture_coordinates.values, (std::vector<Vec2f>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    EXPECT_EQ(all.colors.values[1], VertexColor(0, 1, 0, 1));
    EXPECT_EQ(all.colors.values[3], VertexColor(1, 1, 1, 0.2f));
    EXPECT_EQ(all.materials.names, (std::vector<std::string>{"paint", "none"}));
    EXPECT_EQ(all.materials.of_face, (std::vector<std::uint32_t>{0, 0}));
    EXPECT_NO_THROW(check_attributes(mesh, all));
    EXPECT_TRUE(mesh.warnings.is_empty());
}

TEST(ReadGltf, strips_and_fans_face_the_way_of_their_first_triangle) {
    Json json = square_gltf();
    json["meshes"][0]["primitives"][0].erase("indices");
    json["meshes"][0]["primitives"][0]["mode"] = 6;
    EXPECT_EQ(parsed(json).faces, (std::vector<Vec3i>{{0, 1, 2}, {0, 2, 3}}));
    json["meshes"][0]["primitives"][0]["mode"] = 5;
    EXPECT_EQ(parsed(json).faces, (std::vector<Vec3i>{{0, 1, 2}, {1, 3, 2}}));
}

TEST(ReadGltf, without_indices_vertices_are_corners_in_order_and_leftovers_are_told) {
    Json json = square_gltf();
    json["meshes"][0]["primitives"][0].erase("indices");
    const MeshData mesh = parsed(json);
    EXPECT_EQ(mesh.faces, (std::vector<Vec3i>{{0, 1, 2}}));
    EXPECT_EQ(mesh.warnings.count("corners that make no triangle, left out"), 1u);
}

TEST(ReadGltf, points_and_lines_are_left_out_and_counted) {
    for (const int mode : {0, 1, 2, 3}) {
        Json json = square_gltf();
        json["meshes"][0]["primitives"][0]["mode"] = mode;
        const MeshData mesh = parsed(json);
        EXPECT_TRUE(mesh.faces.empty());
        EXPECT_EQ(mesh.warnings.count("primitives that aren't made of triangles, left out"), 1u);
    }
}

TEST(ReadGltf, nodes_place_meshes_by_matrix_or_by_translation_rotation_and_scale) {
    Json json = square_gltf();
    const double half = std::sqrt(0.5);
    json["nodes"] = {{{"children", {1}}, {"translation", {10, 0, 0}}},
                     {{"mesh", 0}, {"rotation", {0, 0, half, half}}, {"scale", {2, 3, 1}}}};
    const MeshData turned = parsed(json);
    // (1, 1) is scaled to (2, 3), turned by a right angle to (-3, 2) and moved.
    EXPECT_TRUE(turned.vertices[2].isApprox(Vec3d(7, 2, 0), 1e-12));

    json["nodes"][1] = {{"mesh", 0}, {"matrix", {0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
    EXPECT_TRUE(parsed(json).vertices[2].isApprox(Vec3d(7, 2, 0), 1e-12));
}

TEST(ReadGltf, a_mirrored_node_keeps_its_front_outside) {
    const TempDir dir;
    write_gltf(dir / "ball.gltf", generate_icosphere(80), {});
    const auto volume = [](const TriangleMesh& mesh) {
        double sum = 0;
        for (const Vec3i& f : mesh.faces)
            sum += mesh.vertices[f[0]].dot(mesh.vertices[f[1]].cross(mesh.vertices[f[2]]));
        return sum;
    };
    Json json = Json::parse(content_of(dir / "ball.gltf"));
    EXPECT_GT(volume(parsed(json)), 0);
    json["nodes"][0]["scale"] = {-1, 1, 1};
    EXPECT_GT(volume(parsed(json)), 0);
}

TEST(ReadGltf, several_nodes_may_show_one_mesh_and_become_groups) {
    Json json = square_gltf();
    json["nodes"] = {{{"mesh", 0}, {"children", {1}}, {"name", "first"}},
                     {{"mesh", 0}, {"translation", {0, 0, 5}}}};
    const MeshData mesh = parsed(json);
    EXPECT_EQ(mesh.vertices.size(), 8u);
    EXPECT_EQ(mesh.faces[2], Vec3i(4, 5, 6));
    EXPECT_EQ(mesh.vertices[4], Vec3d(0, 0, 5));
    EXPECT_EQ(mesh.attributes.groups.names, (std::vector<std::string>{"first", "node 1"}));
    EXPECT_EQ(mesh.attributes.groups.of_face, (std::vector<std::uint32_t>{0, 0, 1, 1}));
}

TEST(ReadGltf, only_the_scene_that_the_file_opens_with_is_seen) {
    Json json = square_gltf();
    json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {7, 0, 0}}}};
    json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
    json["scene"] = 1;
    EXPECT_EQ(parsed(json).vertices[0], Vec3d(7, 0, 0));
    json.erase("scene");
    EXPECT_EQ(parsed(json).vertices[0], Vec3d(0, 0, 0));
    json.erase("scenes");
    EXPECT_EQ(parsed(json).vertices.size(), 8u);
}

TEST(ReadGltf, sparse_accessors_replace_what_lies_there) {
    Json json = square_gltf();
    const std::string places = bytes_of<std::uint8_t>({2, 0});
    const std::string values = bytes_of<float>({5, 6, 7, -1, -2, -3});
    json["buffers"].push_back({{"byteLength", 26}, {"uri", data_uri(places + values)}});
    json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 2}});
    json["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", 2}, {"byteLength", 24}});
    json["accessors"][0]["sparse"] = {{"count", 2},
                                      {"indices", {{"bufferView", 5}, {"componentType", 5121}}},
                                      {"values", {{"bufferView", 6}}}};
    EXPECT_EQ(parsed(json).vertices,
              (std::vector<Vec3d>{{-1, -2, -3}, {1, 0, 0}, {5, 6, 7}, {0, 1, 0}}));
    json["accessors"][0].erase("bufferView");
    EXPECT_EQ(parsed(json).vertices,
              (std::vector<Vec3d>{{-1, -2, -3}, {0, 0, 0}, {5, 6, 7}, {0, 0, 0}}));
}

TEST(ReadGltf, quantized_positions_are_numbers_or_parts_of_one) {
    Json json = square_gltf();
    json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const std::string shorts =
        bytes_of<std::int16_t>({0, 0, 0, 0, 32767, -32768, 5, 0, -32767, 2, 3, 0, 1, 1, 1, 0});
    json["buffers"].push_back({{"byteLength", 32}, {"uri", data_uri(shorts)}});
    json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 32}, {"byteStride", 8}});
    json["accessors"][0] = {
        {"bufferView", 5}, {"componentType", 5122}, {"count", 4}, {"type", "VEC3"}};
    EXPECT_EQ(parsed(json).vertices[1], Vec3d(32767, -32768, 5));
    json["accessors"][0]["normalized"] = true;
    EXPECT_EQ(parsed(json).vertices[1], Vec3d(1, -1, 5.0f / 32767)) << "-1 at the least";
    EXPECT_EQ(parsed(json).vertices[2].x(), -1);
}

TEST(ReadGltf, strides_and_offsets_are_followed) {
    Json json = square_gltf();
    const std::string interleaved = bytes_of<float>({9, 0, 0, 0, 8, 9, 1, 0, 0, 8, 9, 1, 1, 0, 8});
    json["buffers"].push_back({{"byteLength", 60}, {"uri", data_uri(interleaved)}});
    json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 60}, {"byteStride", 20}});
    json["accessors"][0] = {{"bufferView", 5},
                            {"byteOffset", 4},
                            {"componentType", 5126},
                            {"count", 3},
                            {"type", "VEC3"}};
    Json& primitive = json["meshes"][0]["primitives"][0];
    primitive["attributes"] = {{"POSITION", 0}};
    primitive.erase("indices");
    EXPECT_EQ(parsed(json).vertices, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
}

TEST(ReadGltf, vertices_that_are_not_finite_are_read_and_told) {
    Json json = square_gltf();
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const std::string bytes = bytes_of<float>({0, 0, 0, kNan, 0, 0, 1, 1, 0, 0, 1, 0});
    json["buffers"].push_back({{"byteLength", 48}, {"uri", data_uri(bytes)}});
    json["bufferViews"][0] = {{"buffer", 1}, {"byteLength", 48}};
    const MeshData mesh = parsed(json);
    EXPECT_TRUE(std::isnan(mesh.vertices[1].x()));
    EXPECT_EQ(mesh.warnings.count("vertices that aren't finite"), 1u);
}

TEST(ReadGltf, buffers_lie_beside_the_file_with_encoded_names) {
    const TempDir dir;
    Json json = square_gltf();
    const std::string uri = json["buffers"][0]["uri"];
    const auto bytes = base64_decoded(std::string_view(uri).substr(uri.find(',') + 1));
    dir.write("a b.bin", *bytes);
    json["buffers"][0]["uri"] = "a%20b.bin";
    EXPECT_EQ(read_mesh(dir.write("mesh.gltf", json.dump())).vertices, kCorners);
}

TEST(ReadGltf, a_glb_is_the_same_as_its_parts) {
    Json json = square_gltf();
    const std::string uri = json["buffers"][0]["uri"];
    const auto bytes = base64_decoded(std::string_view(uri).substr(uri.find(',') + 1));
    json["buffers"][0].erase("uri");
    const MeshData mesh = parse_gltf({glb_of(json.dump(), *bytes), "mesh.glb"});
    EXPECT_EQ(mesh.vertices, kCorners);
    EXPECT_EQ(mesh.faces, kFaces);
}

TEST(WriteGltf, what_is_written_reads_back_exactly) {
    const TempDir dir;
    MeshData mesh{generate_torus_knot(600), {}, {}};
    mesh.vertices = rounded_to_float(mesh.vertices);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const float x = static_cast<float>(i) / 512;
        mesh.attributes.normals.values.emplace_back(x, 1 - x, 0.25f);
        mesh.attributes.texture_coordinates.values.emplace_back(x, 1 - x);
        mesh.attributes.colors.values.emplace_back(x, 0.5f, 0, 1);
    }
    mesh.attributes.materials.names = {"red", "blue", "none"};
    mesh.attributes.materials.of_face.resize(mesh.faces.size(), 1);
    mesh.attributes.materials.of_face[7] = 0;
    for (const char* name : {"mesh.glb", "mesh.gltf"}) {
        write_mesh(dir / name, mesh, mesh.attributes);
        const MeshData read = read_mesh(dir / name);
        EXPECT_EQ(read.faces, mesh.faces);
        EXPECT_EQ(read.attributes.normals.values, mesh.attributes.normals.values);
        EXPECT_EQ(read.attributes.colors.values, mesh.attributes.colors.values);
        EXPECT_EQ(read.attributes.texture_coordinates.values,
                  mesh.attributes.texture_coordinates.values);
        EXPECT_EQ(read.attributes.materials.of_face, mesh.attributes.materials.of_face);
        // Each primitive has the same vertices.
        EXPECT_EQ(read.vertices, mesh.vertices);
    }
}

TEST(WriteGltf, bounds_are_those_of_the_floats_in_the_file) {
    const TempDir dir;
    write_mesh(dir / "mesh.gltf", generate_torus_knot(600));
    const Json position = Json::parse(content_of(dir / "mesh.gltf"))["accessors"][0];
    const Box3d box = bounds(read_mesh(dir / "mesh.gltf"));
    for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(position["min"][static_cast<std::size_t>(k)].get<double>(), box.lo[k]);
        EXPECT_EQ(position["max"][static_cast<std::size_t>(k)].get<double>(), box.hi[k]);
    }
}

TEST(WriteGltf, an_empty_mesh_is_an_empty_scene) {
    const TempDir dir;
    for (const char* name : {"mesh.glb", "mesh.gltf"}) {
        write_mesh(dir / name, TriangleMesh{});
        EXPECT_TRUE(read_mesh(dir / name).faces.empty()) << name;
        write_mesh(dir / name, TriangleMesh{{{1, 2, 3}}, {}});
        EXPECT_TRUE(read_mesh(dir / name).faces.empty()) << name;
    }
}

TEST(SplitCorners, vertices_are_split_where_their_corners_differ_and_only_there) {
    TriangleMesh mesh{kCorners, kFaces};
    MeshAttributes attributes;
    attributes.texture_coordinates.of = ValuesOf::corners;
    // Vertex 0 has (0, 0) in both faces, vertex 2 differs.
    attributes.texture_coordinates.values = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {0.5, 0.5}, {0, 1}};
    attributes.fields = {{"height", ValuesOf::vertices, {10, 11, 12, 13}}};
    const MeshData split = split_corners(mesh, attributes);
    EXPECT_EQ(split.vertices.size(), 5u);
    EXPECT_EQ(split.attributes.texture_coordinates.of, ValuesOf::vertices);
    EXPECT_NO_THROW(check_attributes(split, split.attributes));
    for (std::size_t corner = 0; corner < 6; ++corner) {
        const auto f = corner / 3;
        const int k = static_cast<int>(corner % 3);
        const auto vertex = static_cast<std::size_t>(split.faces[f][k]);
        EXPECT_EQ(split.vertices[vertex], MeshView(mesh).corner(f, k));
        EXPECT_EQ(split.attributes.texture_coordinates.values[vertex],
                  attributes.texture_coordinates.values[corner]);
        EXPECT_EQ(split.attributes.fields[0].values[vertex], 10 + mesh.faces[f][k]);
    }
}

}  // namespace
}  // namespace boxwood
