// SPDX-License-Identifier: Apache-2.0
// The JSON Schemas that ship with Boxwood and the readers of scene files agree on what a scene is.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/image/png.h"
#include "boxwood/world/read_world.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Pointer = json::json_pointer;

const fs::path kRoot = BOXWOOD_SOURCE_DIR;

json read_json(const fs::path& path) { return json::parse(content_of(path)); }

class Schema {
public:
    explicit Schema(const std::string& file) : text_(read_json(kRoot / "schemas" / file)) {
        valijson::SchemaParser(valijson::SchemaParser::kDraft7)
            .populateSchema(valijson::adapters::NlohmannJsonAdapter(text_), schema_);
    }

    bool accepts(const json& scene) const {
        valijson::Validator validator(valijson::Validator::kStrongTypes);
        return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(scene), nullptr);
    }

private:
    json text_;
    valijson::Schema schema_;
};

/// Has a folder with the files that its scenes name.
class Reader {
public:
    Reader() {
        folder_.write("mesh.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
        folder_.write("more.json", R"({"boxwood": 2})");
        write_png(folder_ / "paint.png", Rgba8Image(2, 2, {}));
    }

    bool accepts(const json& scene) const {
        // Some file systems wait for the disk when a file is written over.
        fs::remove(folder_ / "scene.json");
        try {
            read_world(folder_.write("scene.json", scene.dump()));
            return true;
        } catch (const ParseError&) {
            return false;
        }
    }

private:
    TempDir folder_;
};

/// A version of the scene file: its schema, and a scene with every section, every key and every
/// type of object. What a schema can't know is what names and indices stand for, and what files
/// there are.
struct Format {
    const char* name;
    const char* schema;
    json valid;
    bool (*is_beyond_a_schema)(const std::string& place, const json& replacement);
};

/// With four materials, so that the index 3 that the mutations put in is in range.
Format classic() {
    json scene = json::parse(R"({
        "Scene": {"Background": [0, 0.5, 1], "Ambient": [0.2, 0.2, 0.2]},
        "Camera": {"IsPerspective": true, "Position": [0, 0, 2], "FieldOfView": 0.8,
                   "FocalLength": 2, "LensRadius": 0.1},
        "Lights": [{"Position": [1, 5, 2], "Color": [9, 9, 9]}],
        "Objects": [
            {"Type": "Sphere", "Material": 0, "Position": [0, 1, 0], "Radius": 0.5},
            {"Type": "Parallelogram", "Material": 1,
             "Origin": [-1, 0, 0], "U": [2, 0, 0], "V": [0, 0, 2]},
            {"Type": "Mesh", "Material": 2, "Path": "mesh.off"}]
    })");
    const json material = json::parse(R"({
        "Ambient": [0.1, 0.1, 0.1], "Diffuse": [0.5, 0.5, 0.5], "Specular": [0.2, 0.2, 0.2],
        "Mirror": [0, 0, 0], "Refraction": [0, 0, 0], "RefractionIndex": 1.5, "Shininess": 20})");
    scene["Materials"] = {material, material, material, material};
    return {"classic", "classic-scene.schema.json", scene,
            [](const std::string& place, const json& replacement) {
                return (place == "/Materials" && replacement == json::array()) ||
                       (place == "/Objects/2/Path" && replacement.is_string());
            }};
}

Format version_2() {
    return {"version 2", "scene-2.schema.json", json::parse(R"({
        "boxwood": 2,
        "include": ["more.json"],
        "film": {"width": 64, "height": 48, "encoding": "srgb"},
        "integrator": {"type": "whitted", "bounces": 3},
        "sampler": {"samples": 4, "seed": 1},
        "background": [0, 0.5, 1], "ambient": [0.2, 0.2, 0.2],
        "camera": {"type": "perspective", "from": [0, 0, 9], "to": [0, 1, 0], "up": [0, 2, 1],
                   "field_of_view": 40, "focus_distance": 9, "lens_radius": 0.1,
                   "pixel_spread": 1},
        "materials": {
            "paint": {"type": "phong", "ambient": [0.1, 0.1, 0.1], "diffuse": [0.5, 0.5, 0.5],
                      "specular": [0.2, 0.2, 0.2], "mirror": [0, 0, 0], "refraction": [0, 0, 0],
                      "refraction_index": 1.5, "shininess": 20, "emission": [0, 0, 0],
                      "opacity": 1, "two_sided": true,
                      "color_texture": {"file": "paint.png", "wrap": "clamp", "smooth": false,
                                        "scale": [2, 2], "offset": [0, 0.5]}},
            "print": {"color_texture": "paint.png"}},
        "meshes": {
            "file": {"file": "mesh.off", "repair": ["weld", "drop-degenerate", "orient"]},
            "shape": {"shape": "icosphere", "triangles": 20, "repair": ["weld"]},
            "floor": {"parallelogram": {"origin": [-1, 0, 0], "u": [2, 0, 0], "v": [0, 0, 2]},
                      "repair": []},
            "inline": {"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
                       "faces": [[0, 1, 2], [0, 1, 3]], "repair": ["orient"]}},
        "objects": [
            {"mesh": "file", "material": "paint",
             "transform": [{"translate": [1, 0, 0]}, {"rotate": {"axis": [0, 1, 0], "angle": 90}},
                           {"scale": 2}, {"scale": [1, 2, 3]},
                           {"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}]},
            {"mesh": "shape", "transform": {"translate": [1, 0, 0]}},
            {"sphere": {"center": [0, 1, 0], "radius": 0.5}, "material": "print"}],
        "lights": [
            {"type": "point", "position": [1, 5, 2], "color": [9, 9, 9]},
            {"type": "directional", "direction": [0, -1, 0], "color": [1, 1, 1]},
            {"type": "spot", "position": [1, 5, 2], "direction": [0, -1, 0], "color": [9, 9, 9],
             "inner_angle": 2, "outer_angle": 30}]
    })"),
            [](const std::string& place, const json& replacement) {
                const bool is_name = replacement.is_string() || place == "/materials" ||
                                     place == "/meshes" || place == "/meshes/inline/vertices";
                const bool may_be_singular = place.find("/transform") != place.npos;
                const bool is_index = place.find("/faces") != place.npos;
                return is_name || may_be_singular || is_index || place == "/lights/2/inner_angle" ||
                       place == "/lights/2/outer_angle" || place == "/camera/up" ||
                       place.find("/direction") != place.npos;
            }};
}

std::vector<Format> formats() { return {classic(), version_2()}; }

void append_places(const json& value, const Pointer& place, std::vector<Pointer>& result) {
    result.push_back(place);
    if (!value.is_structured()) return;
    for (const auto& item : value.items()) {
        const Pointer below =
            value.is_array() ? place / std::stoul(item.key()) : place / item.key();
        append_places(item.value(), below, result);
    }
}

/// Where the values of a document are, the document itself first.
std::vector<Pointer> places(const json& document) {
    std::vector<Pointer> result;
    append_places(document, Pointer(), result);
    return result;
}

const json kReplacements =
    json::parse(R"([null, true, "x", -1, 0, 0.5, 3, [], [1, 2], [1, 2, 3], {}, 1e300])");

class SchemaOf : public testing::TestWithParam<Format> {
protected:
    testing::AssertionResult agree(const json& scene) {
        const bool by_schema = schema_.accepts(scene), by_reader = reader_.accepts(scene);
        if (by_schema == by_reader) return testing::AssertionSuccess();
        return testing::AssertionFailure() << (by_schema ? "only the schema" : "only the reader")
                                           << " accepts " << scene.dump();
    }

    const json valid_ = GetParam().valid;
    const Schema schema_{GetParam().schema};
    const Reader reader_;
};

INSTANTIATE_TEST_SUITE_P(Formats, SchemaOf, testing::ValuesIn(formats()), [](const auto& test) {
    std::string name = test.param.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

TEST(Schemas, shipped_examples_are_valid) {
    const Schema classic("classic-scene.schema.json"), version_2("scene-2.schema.json");
    std::size_t scenes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / "examples")) {
        if (entry.path().extension() != ".json") continue;
        const json scene = read_json(entry.path());
        EXPECT_TRUE((scene.contains("boxwood") ? version_2 : classic).accepts(scene))
            << entry.path();
        EXPECT_NO_THROW(read_world(entry.path())) << entry.path();
        ++scenes;
    }
    EXPECT_GE(scenes, 2u);
}

TEST_P(SchemaOf, scene_that_the_mutations_start_from_is_valid) {
    EXPECT_TRUE(schema_.accepts(valid_));
    EXPECT_TRUE(agree(valid_));
}

TEST_P(SchemaOf, agrees_with_the_reader_on_missing_keys) {
    for (const Pointer& place : places(valid_)) {
        if (place.empty() || !valid_[place.parent_pointer()].is_object()) continue;
        // Without their names, objects name nothing.
        const std::string parent = place.parent_pointer().to_string();
        if (parent == "/meshes" || parent == "/materials" || place.to_string() == "/meshes" ||
            place.to_string() == "/materials")
            continue;
        json mutated = valid_;
        mutated[place.parent_pointer()].erase(place.back());
        EXPECT_TRUE(agree(mutated)) << place;
    }
}

TEST_P(SchemaOf, agrees_with_the_reader_on_unknown_keys) {
    for (const Pointer& place : places(valid_)) {
        if (!valid_[place].is_object()) continue;
        if (place.to_string() == "/meshes" || place.to_string() == "/materials") continue;
        json mutated = valid_;
        mutated[place]["Extra"] = 1;
        EXPECT_FALSE(schema_.accepts(mutated)) << place;
        EXPECT_TRUE(agree(mutated)) << place;
    }
}

TEST_P(SchemaOf, agrees_with_the_reader_on_replaced_values) {
    std::size_t accepted = 0, rejected = 0;
    for (const Pointer& place : places(valid_)) {
        for (const json& replacement : kReplacements) {
            if (GetParam().is_beyond_a_schema(place.to_string(), replacement)) continue;
            json mutated = valid_;
            mutated[place] = replacement;
            EXPECT_TRUE(agree(mutated)) << place << " replaced by " << replacement;
            ++(schema_.accepts(mutated) ? accepted : rejected);
        }
    }
    EXPECT_GT(accepted, 100u);
    EXPECT_GT(rejected, 1000u);
}

TEST(Schemas, classic_objects_and_angles_agree_with_the_reader) {
    const Schema schema("classic-scene.schema.json");
    const Reader reader;
    const auto expect_same = [&](const json& scene) {
        EXPECT_EQ(schema.accepts(scene), reader.accepts(scene)) << scene.dump();
    };
    json scene = classic().valid;
    scene["Objects"][0]["Type"] = "Mesh";
    expect_same(scene);
    scene["Objects"][0]["Type"] = "sphere";
    expect_same(scene);

    scene = classic().valid;
    scene["Scene"]["Ambient"] = {1, 2, 3, 4};
    expect_same(scene);

    scene = classic().valid;
    for (const double angle : {3.14, 3.141592653589793, 3.15}) {
        scene["Camera"]["FieldOfView"] = angle;
        expect_same(scene);
    }
}

TEST(Schemas, cameras_of_version_2_agree_with_the_reader) {
    const Schema schema("scene-2.schema.json");
    const Reader reader;
    for (const char* camera : {
             R"({"from": [0, 0, 9], "to": [0, 0, 0]})",
             R"({"from": [0, 0, 9], "direction": [0, 0, -1]})",
             R"({"from": [0, 0, 9]})",
             R"({"from": [0, 0, 9], "to": [0, 0, 0], "direction": [0, 0, -1]})",
             R"({"type": "orthographic", "from": [0, 0, 9], "to": [0, 0, 0], "height": 2})",
             R"({"type": "orthographic", "from": [0, 0, 9], "direction": [0, 0, 1], "height": 2})",
             R"({"type": "orthographic", "from": [0, 0, 9], "to": [0, 0, 0]})",
             R"({"type": "orthographic", "from": [0, 0, 9], "to": [0, 0, 0], "height": 2,
                 "field_of_view": 30})",
             R"({"from": [0, 0, 9], "to": [0, 0, 0], "height": 2})",
             R"({"type": "fisheye", "from": [0, 0, 9], "to": [0, 0, 0]})",
         }) {
        json scene = version_2().valid;
        scene["camera"] = json::parse(camera);
        EXPECT_EQ(schema.accepts(scene), reader.accepts(scene)) << camera;
    }
}

}  // namespace
}  // namespace boxwood
