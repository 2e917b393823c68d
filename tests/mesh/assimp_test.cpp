// SPDX-License-Identifier: Apache-2.0
// Formats that Boxwood reads by way of assimp, in a library that is built with it.
#include "boxwood/mesh/assimp.h"

#include <gtest/gtest.h>

#include <string>

#include "boxwood/core/error.h"
#include "boxwood/mesh/mesh_file.h"
#include "error_of.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

/// A Collada file with a square, with normals and texture coordinates, in nodes that move it.
std::string square_dae() {
    return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="square"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 1 1 0 0 1 0</float_array>
<technique_common><accessor source="#pa" count="4" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source>
<source id="n"><float_array id="na" count="3">0 0 1</float_array>
<technique_common><accessor source="#na" count="1" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source>
<source id="t"><float_array id="ta" count="8">0 0 1 0 1 1 0 1</float_array>
<technique_common><accessor source="#ta" count="4" stride="2">
<param name="S" type="float"/><param name="T" type="float"/>
</accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="1"><input semantic="VERTEX" source="#v" offset="0"/>
<input semantic="NORMAL" source="#n" offset="1"/>
<input semantic="TEXCOORD" source="#t" offset="2" set="0"/>
<vcount>4</vcount><p>0 0 0 1 0 1 2 0 2 3 0 3</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="scene">
<node id="a" name="a"><translate>10 0 0</translate>
<node id="b" name="b"><rotate>1 0 0 90</rotate><scale>2 2 2</scale>
<instance_geometry url="#square"/></node></node>
<node id="c" name="c"><instance_geometry url="#square"/></node>
</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#scene"/></scene></COLLADA>
)";
}

TEST(ReadByAssimp, meshes_stand_where_their_nodes_do_with_what_they_have) {
    const TempDir dir;
    const MeshData mesh = read_mesh(dir.write("square.DAE", square_dae()));
    ASSERT_EQ(mesh.faces.size(), 4u);
    ASSERT_EQ(mesh.vertices.size(), 8u);
    EXPECT_TRUE(mesh.warnings.is_empty());
    const MeshView view = mesh;
    double area = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3d cross =
            (view.corner(i, 1) - view.corner(i, 0)).cross(view.corner(i, 2) - view.corner(i, 0));
        area += cross.norm() / 2;
        EXPECT_LT((cross.normalized() - Vec3d(0, -1, 0)).norm(), 1e-6);
    }
    EXPECT_NEAR(area, 4, 1e-5);
    EXPECT_NEAR(view.corner(0, 0).x(), 10, 1e-5);
    const MeshAttributes& attributes = mesh.attributes;
    ASSERT_EQ(attributes.normals.values.size(), 8u);
    EXPECT_LT((attributes.normals.values[0] - Vec3f(0, -1, 0)).norm(), 1e-6f);
    EXPECT_LT((attributes.normals.values[7] - Vec3f(0, 0, 1)).norm(), 1e-6f);
    ASSERT_EQ(attributes.texture_coordinates.values.size(), 8u);
    EXPECT_EQ(attributes.texture_coordinates.values[2], Vec2f(1, 1));
    EXPECT_EQ(attributes.groups.names, (std::vector<std::string>{"b", "c"}));
    EXPECT_NO_THROW(check_attributes(mesh, attributes));
    EXPECT_EQ(mesh_format_of("square.dae").write, nullptr);
}

TEST(ReadByAssimp, what_it_cannot_read_is_an_error_that_says_why) {
    const TempDir dir;
    for (const char* name : {"bad.dae", "bad.3ds", "bad.x", "bad.fbx", "bad.blend"}) {
        const std::string error =
            error_of([&] { read_mesh(dir.write(name, "nothing of the kind")); });
        EXPECT_TRUE(error.starts_with("ParseError " + (dir / name).string() +
                                      ": found what assimp can't read ("))
            << error;
    }
    const std::string dae = square_dae();
    EXPECT_NE(error_of([&] { read_mesh(dir.write("cut.dae", dae.substr(0, dae.size() / 2))); }),
              "");
}

TEST(ReadByAssimp, limits_hold) {
    const TempDir dir;
    const auto path = dir.write("square.dae", square_dae());
    for (const Limits& limits :
         {Limits{.max_bytes = 100}, Limits{.max_vertices = 3}, Limits{.max_vertices = 7},
          Limits{.max_faces = 3}, Limits{.max_depth = 1}})
        EXPECT_THROW(read_mesh(path, {.limits = limits}), ParseError);
}

TEST(ReadByAssimp, other_files_are_opened_only_beside_it) {
    const TempDir dir;
    std::filesystem::create_directory(dir / "scene");
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    dir.write("scene/part.obj", obj);
    dir.write("outside.obj", obj);
    const auto read_scene_of = [&](const std::string& name, const ReadOptions& options = {}) {
        return read_mesh(
            dir.write("scene/scene.lws", "LWSC\n3\n\nLoadObjectLayer 1 " + name + "\n"), options);
    };
    EXPECT_EQ(read_scene_of("part.obj").faces.size(), 1u);
    EXPECT_TRUE(read_scene_of("part.obj").warnings.is_empty());
    EXPECT_TRUE(read_scene_of("missing.obj").faces.empty());
    for (const std::string& name : {std::string("../outside.obj"), std::string("..\\outside.obj"),
                                    (dir / "outside.obj").string()}) {
        const MeshData mesh = read_scene_of(name);
        EXPECT_TRUE(mesh.faces.empty()) << name;
        EXPECT_GE(mesh.warnings.count("files that may not be opened, done without"), 1u) << name;
    }
    EXPECT_EQ(read_scene_of("../outside.obj", {.allow_outside_files = true}).faces.size(), 1u);
}

}  // namespace
}  // namespace boxwood
