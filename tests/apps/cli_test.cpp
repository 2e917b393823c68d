// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "boxwood/image/png.h"
#include "temp_dir.h"

namespace {

namespace fs = std::filesystem;

struct Outcome {
    int exit_code;
    std::string out, err;
};

std::string contents(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

using boxwood::TempDir;

class Cli : public testing::Test {
protected:
    Outcome run(const std::string& arguments) {
        const fs::path out = folder_.path() / "stdout", err = folder_.path() / "stderr";
        const std::string command = "cd '" + folder_.path().string() +
                                    "' && '" BOXWOOD_PROGRAM "' " + arguments + " >stdout 2>stderr";
        const int status = std::system(command.c_str());
        EXPECT_TRUE(WIFEXITED(status)) << command;
        return {WEXITSTATUS(status), contents(out), contents(err)};
    }

    fs::path write(const std::string& name, const std::string& text) {
        const fs::path path = folder_.path() / name;
        std::ofstream(path, std::ios::binary) << text;
        return path;
    }

    void write_scene(const std::string& mesh = "cube.off") {
        run("convert icosphere:80 cube.off");
        write("scene.json", R"({
            "Scene": {"Background": [0, 0, 1], "Ambient": [0.2, 0.2, 0.2]},
            "Camera": {"IsPerspective": true, "Position": [0, 0, 4], "FieldOfView": 0.7,
                       "FocalLength": 2, "LensRadius": 0},
            "Materials": [{"Ambient": [1, 0, 0], "Diffuse": [1, 0, 0], "Specular": [0, 0, 0],
                           "Mirror": [0, 0, 0], "Refraction": [0, 0, 0], "RefractionIndex": 1,
                           "Shininess": 1}],
            "Lights": [{"Position": [5, 5, 5], "Color": [20, 20, 20]}],
            "Objects": [{"Type": "Mesh", "Material": 0, "Path": ")" +
                                mesh + R"("}]})");
    }

    /// One line on stderr with this text, exit code 1, and no picture, whole or partial.
    void expect_failure(const std::string& arguments, const std::string& message) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, 1) << arguments;
        EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        for (const auto& entry : fs::directory_iterator(folder_.path())) {
            const std::string extension = entry.path().extension().string();
            EXPECT_TRUE(extension != ".png" && extension != ".partial") << entry.path();
        }
    }

    TempDir folder_;
};

TEST_F(Cli, render_makes_a_picture_of_the_size_asked_for_and_says_where) {
    write_scene();
    const Outcome outcome = run("render scene.json --size 64x48 -o picture.png");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("picture.png: 64x48 phong"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.err, "");
    const auto picture = boxwood::read_png(folder_.path() / "picture.png");
    EXPECT_EQ(picture.width, 64);
    EXPECT_EQ(picture.height, 48);
    EXPECT_EQ(picture.at(0, 0), (boxwood::Rgba8{0, 0, 255, 255}));
}

TEST_F(Cli, render_writes_raytrace_png_when_not_told_otherwise_and_is_quiet_on_demand) {
    write_scene();
    const Outcome outcome = run("render scene.json --size 8x8 --quiet");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
    EXPECT_TRUE(fs::exists(folder_.path() / "raytrace.png"));
}

TEST_F(Cli, every_integrator_accelerator_and_cost_renders) {
    write_scene();
    for (const char* options :
         {"--integrator phong", "--integrator whitted --samples 4 --seed 7", "--integrator normal",
          "--integrator depth", "--integrator heat", "--accelerator brute", "--accelerator median",
          "--accelerator agglomerative --cost centroid_distance",
          "--accelerator agglomerative --cost volume_increase",
          "--accelerator agglomerative --cost surface_area", "--accelerator binned_sah",
          "--accelerator block_sah", "--accelerator fast", "--accelerator best", "--threads 3"})
        EXPECT_EQ(run("render scene.json --size 16x12 " + std::string(options)).exit_code, 0)
            << options;
}

TEST_F(Cli, the_data_folder_is_searched_after_the_folder_of_the_scene) {
    write_scene("elsewhere.off");
    fs::create_directory(folder_.path() / "data");
    fs::rename(folder_.path() / "cube.off", folder_.path() / "data" / "elsewhere.off");
    expect_failure("render scene.json", "scene.json:$.Objects[0].Path: found \"elsewhere.off\"");
    EXPECT_EQ(run("render scene.json --size 8x8 --data data").exit_code, 0);
}

TEST_F(Cli, demo_needs_no_file) {
    const Outcome outcome = run("demo --size 32x18 --samples 1");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(fs::exists(folder_.path() / "raytrace.png"));
}

TEST_F(Cli, info_tells_counts_bounds_closedness_and_trees) {
    run("convert icosphere:320 ball.off");
    const Outcome outcome = run("info ball.off --json --accelerator median,agglomerative");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["vertices"], 162);
    EXPECT_EQ(json["faces"], 320);
    EXPECT_EQ(json["closed"], true);
    EXPECT_EQ(json["degenerate_faces"], 0);
    ASSERT_EQ(json["trees"].size(), 2);
    EXPECT_EQ(json["trees"][0]["builder"], "median");
    EXPECT_EQ(json["trees"][0]["nodes"], 639);
    EXPECT_EQ(json["trees"][0]["depth"], 9);
    EXPECT_GT(json["trees"][1]["sah_cost"], 1);
    EXPECT_NE(run("info ball.off").out.find("closed            yes"), std::string::npos);
}

TEST_F(Cli, info_tells_all_of_an_ugly_mesh_and_exits_with_0) {
    std::string text =
        "NOFF\n6 15 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 1 0 0 0 1\n"
        "nan 0 0 0 0 1\n9 9 9 0 0 1\n3 0 1 2\n3 2 1 0\n3 0 1 4\n";
    for (int i = 0; i < 12; ++i) text += "2 0 1\n";
    write("ugly.off", text);
    const Outcome outcome = run("info ugly.off --json");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["format"], "Object File Format");
    EXPECT_EQ(json["vertices"], 6);
    EXPECT_EQ(json["faces"], 3);
    EXPECT_EQ(json["nonfinite_vertices"], 1);
    EXPECT_EQ(json["duplicate_vertices"], 1);
    EXPECT_EQ(json["unreferenced_vertices"], 2);
    EXPECT_EQ(json["degenerate_faces"], 1);
    EXPECT_EQ(json["duplicate_faces"], 1);
    EXPECT_EQ(json["components"], 1);
    EXPECT_EQ(json["area"], 1);
    EXPECT_EQ(json["attributes"], nlohmann::json({"normals of vertices"}));
    ASSERT_EQ(json["warnings"].size(), 2);
    EXPECT_EQ(json["warnings"][1]["count"], 12);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 12) << outcome.err;
    EXPECT_NE(outcome.err.find("boxwood: warning: ugly.off:7: vertex 4 is (nan, 0, 0), expected "
                               "finite numbers\n"),
              std::string::npos)
        << outcome.err;
    EXPECT_NE(
        outcome.err.find("boxwood: warning: ... and 2 more: faces of fewer than three corners, "
                         "skipped\n"),
        std::string::npos)
        << outcome.err;
    const std::string table = run("info ugly.off").out;
    for (const char* line : {"format            Object File Format\n",
                             "vertices          6, 1 duplicate, 2 unreferenced, 1 not finite\n",
                             "faces             3, 1 degenerate, 1 duplicate\n",
                             "area              1\n", "attributes        normals of vertices\n"})
        EXPECT_NE(table.find(line), std::string::npos) << table;
}

TEST_F(Cli, info_of_a_closed_mesh_has_a_volume) {
    const auto json = nlohmann::json::parse(run("info icosphere:20480 --json").out);
    EXPECT_NEAR(json["volume"], 4.18879, 0.01);
    EXPECT_EQ(json["format"], nullptr);
    EXPECT_EQ(json["boundary_loops"], 0);
    EXPECT_EQ(nlohmann::json::parse(run("info terrain:100 --json").out)["volume"], nullptr);
}

TEST_F(Cli, repair_does_the_steps_and_tells_what_they_did) {
    run("convert icosphere:320 ball.stl");
    const auto before = nlohmann::json::parse(run("info ball.stl --json").out);
    EXPECT_EQ(before["vertices"], 960);
    EXPECT_EQ(before["duplicate_vertices"], 798);
    EXPECT_FALSE(before.contains("repair"));
    const Outcome outcome = run("info --repair weld,drop-degenerate,orient ball.stl --json");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto after = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(after["vertices"], 162);
    EXPECT_EQ(after["repair"]["welded_vertices"], 798);
    EXPECT_EQ(after["repair"]["flipped_faces"], 0);
    EXPECT_EQ(run("convert ball.stl ball.off --repair weld").out,
              "798 vertices welded, 0 faces dropped, 0 faces turned around\n");
    EXPECT_TRUE(contents(folder_.path() / "ball.off").starts_with("OFF\n162 320 0\n"));
}

TEST_F(Cli, render_repairs_meshes_first) {
    const std::string open_tent = "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 ";
    write("turned.off", open_tent + "1 3\n");
    write("right.off", open_tent + "3 1\n");
    const std::string options = " --integrator normal --size 40x30 --samples 1 -o ";
    EXPECT_EQ(run("render right.off" + options + "right.png").exit_code, 0);
    EXPECT_EQ(run("render turned.off" + options + "turned.png").exit_code, 0);
    EXPECT_EQ(run("render turned.off --repair weld,orient" + options + "mended.png").exit_code, 0);
    const std::string right = contents(folder_.path() / "right.png");
    EXPECT_NE(contents(folder_.path() / "turned.png"), right);
    EXPECT_EQ(contents(folder_.path() / "mended.png"), right);
}

TEST_F(Cli, convert_carries_attributes_over_and_says_which_are_lost) {
    write("mesh.off",
          "CNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0 1\n1 0 0 0 0 1 1 0 0 1\n"
          "0 1 0 0 0 1 1 0 0 1\n3 0 1 2\n");
    const Outcome same = run("convert mesh.off again.off");
    EXPECT_EQ(same.exit_code, 0);
    EXPECT_EQ(same.err, "");
    EXPECT_EQ(contents(folder_.path() / "again.off"), contents(folder_.path() / "mesh.off"));
    const Outcome other = run("convert mesh.off mesh.stl");
    EXPECT_EQ(other.exit_code, 0);
    EXPECT_EQ(
        other.err,
        "boxwood: warning: mesh.stl: left out normals of vertices, which .stl has no place "
        "for\nboxwood: warning: mesh.stl: left out colors of vertices, which .stl has no place "
        "for\n");
}

TEST_F(Cli, every_format_is_written_read_and_rendered_by_itself) {
    for (const char* extension : {"obj", "ply", "stl", "off", "gltf", "glb"}) {
        const std::string file = std::string("ball.") + extension;
        EXPECT_EQ(run("convert icosphere:80 " + file).exit_code, 0) << file;
        const Outcome info = run("info --json " + file);
        EXPECT_EQ(nlohmann::json::parse(info.out)["faces"], 80) << file;
        const Outcome outcome = run("render " + file + " --size 40x30 --samples 1 -o ball.png");
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        const auto picture = boxwood::read_png(folder_.path() / "ball.png");
        EXPECT_NE(picture.at(20, 15), picture.at(0, 0)) << file << ": the ball is in the middle";
    }
}

TEST_F(Cli, convert_says_what_each_format_has_no_place_for) {
    write("mesh.ply",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
          "property float z\nproperty float heat\nelement face 1\n"
          "property list uchar int vertex_indices\nend_header\n0 0 0 1\n1 0 0 2\n0 1 0 3\n"
          "3 0 1 2\n");
    for (const char* extension : {"obj", "off", "stl", "glb"})
        EXPECT_NE(run(std::string("convert mesh.ply mesh2.") + extension)
                      .err.find("left out field heat of vertices"),
                  std::string::npos)
            << extension;
    write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\ng left\nf 1 2 3\n");
    const std::string lost = run("convert mesh.obj other.ply").err;
    EXPECT_NE(lost.find("left out groups"), std::string::npos) << lost;
    EXPECT_NE(lost.find("left out materials"), std::string::npos) << lost;
    EXPECT_EQ(run("convert mesh.ply mesh3.ply").err, "");
    EXPECT_EQ(run("convert mesh.obj mesh3.obj").err, "");
}

TEST_F(Cli, an_upgraded_scene_gives_the_same_picture) {
    write_scene();
    const Outcome outcome = run("scene upgrade scene.json -o new.json");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* options : {"", " --integrator whitted --samples 4"}) {
        run(std::string("render scene.json --size 32x24 -o old.png") + options);
        run(std::string("render new.json --size 32x24 -o new.png") + options);
        EXPECT_EQ(boxwood::read_png(folder_.path() / "new.png").pixels,
                  boxwood::read_png(folder_.path() / "old.png").pixels)
            << options;
    }
}

TEST_F(Cli, help_lists_the_formats_there_are) {
    EXPECT_NE(run("info --help").out.find(".off"), std::string::npos);
    EXPECT_NE(run("convert --help").out.find(".stl"), std::string::npos);
}

TEST_F(Cli, render_warns_of_meshes_unless_it_shall_be_quiet) {
    write_scene();
    write("cube.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n");
    const Outcome outcome = run("render scene.json --size 8x8");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.err.find("cube.off:7: face 1 has 2 corners"), std::string::npos)
        << outcome.err;
    EXPECT_EQ(run("render scene.json --size 8x8 --quiet").err, "");
}

TEST_F(Cli, bench_compares_builders_with_brute_force) {
    const Outcome outcome = run("bench icosphere:500 --rays 200 --json");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(json.size(), 1);
    EXPECT_EQ(json[0]["accelerators"][0]["name"], "brute");
    for (const auto& accelerator : json[0]["accelerators"]) {
        for (const char* kind : {"primary", "ambient occlusion", "random"})
            EXPECT_GT(accelerator["rays"][kind]["seconds_per_ray"], 0) << accelerator;
    }
}

TEST_F(Cli, bench_counts_visits_on_demand_the_same_each_time) {
    const std::string command = "bench icosphere:500 --rays 200 --counters --accelerator fast,best";
    const Outcome outcome = run(command + " --json");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(json.size(), 1);
    ASSERT_EQ(json[0]["accelerators"].size(), 2);
    EXPECT_EQ(json[0]["accelerators"][1]["name"], "best");
    for (const auto& accelerator : json[0]["accelerators"]) {
        for (const char* kind : {"primary", "ambient occlusion", "random"}) {
            for (const char* query : {"closest_hit", "any_hit"}) {
                const auto& counts = accelerator["per_ray"][kind][query];
                EXPECT_GE(counts["nodes"], 1) << accelerator;
                EXPECT_GE(counts["boxes"], counts["nodes"]) << accelerator;
                EXPECT_GE(counts["triangles"], counts["blocks"]) << accelerator;
                EXPECT_GE(counts["lines"], counts["nodes"]) << accelerator;
            }
        }
    }
    EXPECT_EQ(run(command + " --json").out, outcome.out);
    const std::string table = run(command).out;
    for (const char* text : {"boxes", "lines", "ambient occlusion", "any hit"})
        EXPECT_NE(table.find(text), std::string::npos) << table;
}

TEST_F(Cli, bad_files_end_with_one_line_and_no_picture) {
    write_scene();
    expect_failure("render missing.json", "missing.json: No such file or directory");
    expect_failure("render .", ".: found a directory, expected a file");
    write("empty.json", "");
    expect_failure("render empty.json", "empty.json:1: found end of input, expected ");
    write("broken.json", "{\n\"Scene\":\n]}");
    expect_failure("render broken.json", "broken.json:3: found ']', expected ");
    write("cube.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
    expect_failure("render scene.json", "cube.off:6: ");
    write("cube.off", "OFF\n3000000000000000000 1 0\n");
    expect_failure("render scene.json", "cube.off:2: ");
    expect_failure("info nothing.off", "nothing.off: No such file or directory");
    expect_failure("info nothing.xyz", "nothing.xyz");
    expect_failure("info \"$(printf 'two\\nlines.off')\"", "two?lines.off: No such file");
    write_scene("two\\nlines.xyz");
    write("two\nlines.xyz", "");
    expect_failure("render scene.json", "two?lines.xyz: found .xyz, expected a mesh file");
    expect_failure("convert icosphere:20 missing/out.off", "missing/out.off");
}

TEST_F(Cli, an_output_that_cannot_be_written_is_found_out_before_the_work) {
    write_scene();
    fs::create_directory(folder_.path() / "folder");
    expect_failure("render scene.json -o missing/picture.png", "missing/picture.png: No such file");
    expect_failure("render scene.json -o folder", "folder: found a directory");
    expect_failure("demo -o missing/picture.png", "missing/picture.png: No such file");
}

TEST_F(Cli, wrong_usage_exits_with_2) {
    write_scene();
    for (const char* arguments :
         {"", "fly", "render", "render scene.json --size 640", "render scene.json --size 0x5",
          "render scene.json --integrator magic", "render scene.json --accelerator octree",
          "render scene.json --cost none", "render scene.json --samples 0",
          "render scene.json --threads -1", "render scene.json --unknown", "info", "bench",
          "info icosphere:20 --accelerator brute",
          "bench icosphere:20 --counters --accelerator brute", "convert icosphere:20",
          "info icosphere:20 --repair", "convert icosphere:20 a.off --repair polish",
          "render scene.json --repair polish"}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << arguments;
        EXPECT_NE(outcome.err, "") << arguments;
    }
}

TEST_F(Cli, each_subcommand_has_help_with_an_example) {
    for (const char* command : {"render", "demo", "info", "bench", "convert", "scene"}) {
        const Outcome outcome = run(std::string(command) + " --help");
        EXPECT_EQ(outcome.exit_code, 0);
        EXPECT_NE(outcome.out.find(std::string("Example:\n  boxwood ") + command),
                  std::string::npos)
            << outcome.out;
    }
}

}  // namespace
