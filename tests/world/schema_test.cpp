// SPDX-License-Identifier: Apache-2.0
// The JSON Schema that ships with Boxwood and the reader of scene files agree on what a scene is.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/world/read_world.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Pointer = json::json_pointer;

const fs::path kRoot = BOXWOOD_SOURCE_DIR;

json read_json(const fs::path& path) { return json::parse(content_of(path)); }

bool schema_accepts(const json& scene) {
    static const json text = read_json(kRoot / "schemas/classic-scene.schema.json");
    static const auto* schema = [] {
        auto* result = new valijson::Schema;
        valijson::SchemaParser(valijson::SchemaParser::kDraft7)
            .populateSchema(valijson::adapters::NlohmannJsonAdapter(text), *result);
        return result;
    }();
    valijson::Validator validator(valijson::Validator::kStrongTypes);
    return validator.validate(*schema, valijson::adapters::NlohmannJsonAdapter(scene), nullptr);
}

/// Has a folder with the mesh that its scenes name.
class Reader {
public:
    Reader() { folder_.write("mesh.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"); }

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

/// Has every section, every key and every type of object; four materials, so that the index 3 that
/// the mutations put in is in range.
json valid_scene() {
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
    return scene;
}

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

/// What a schema can't know: that a material index is in range, and what files there are.
bool is_beyond_a_schema(const Pointer& place, const json& replacement) {
    const bool leaves_no_materials =
        place.to_string() == "/Materials" && replacement == json::array();
    const bool names_no_file = place.to_string() == "/Objects/2/Path" && replacement.is_string();
    return leaves_no_materials || names_no_file;
}

testing::AssertionResult agree(const json& scene) {
    static const Reader reader;
    const bool by_schema = schema_accepts(scene), by_reader = reader.accepts(scene);
    if (by_schema == by_reader) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << (by_schema ? "only the schema" : "only the reader") << " accepts " << scene.dump();
}

TEST(Schema, shipped_examples_are_valid) {
    std::size_t scenes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / "examples")) {
        if (entry.path().extension() != ".json") continue;
        EXPECT_TRUE(schema_accepts(read_json(entry.path()))) << entry.path();
        EXPECT_NO_THROW(read_world(entry.path())) << entry.path();
        ++scenes;
    }
    EXPECT_GT(scenes, 0u);
}

TEST(Schema, scene_that_the_mutations_start_from_is_valid) {
    EXPECT_TRUE(schema_accepts(valid_scene()));
    EXPECT_TRUE(agree(valid_scene()));
}

TEST(Schema, agrees_with_the_reader_on_missing_keys) {
    const json scene = valid_scene();
    for (const Pointer& place : places(scene)) {
        if (place.empty() || !scene[place.parent_pointer()].is_object()) continue;
        json mutated = scene;
        mutated[place.parent_pointer()].erase(place.back());
        EXPECT_FALSE(schema_accepts(mutated)) << place;
        EXPECT_TRUE(agree(mutated)) << place;
    }
}

TEST(Schema, agrees_with_the_reader_on_unknown_keys) {
    const json scene = valid_scene();
    for (const Pointer& place : places(scene)) {
        if (!scene[place].is_object()) continue;
        json mutated = scene;
        mutated[place]["Extra"] = 1;
        EXPECT_FALSE(schema_accepts(mutated)) << place;
        EXPECT_TRUE(agree(mutated)) << place;
    }
}

TEST(Schema, agrees_with_the_reader_on_replaced_values) {
    const json scene = valid_scene();
    std::size_t accepted = 0, rejected = 0;
    for (const Pointer& place : places(scene)) {
        for (const json& replacement : kReplacements) {
            if (is_beyond_a_schema(place, replacement)) continue;
            json mutated = scene;
            mutated[place] = replacement;
            EXPECT_TRUE(agree(mutated)) << place << " replaced by " << replacement;
            ++(schema_accepts(mutated) ? accepted : rejected);
        }
    }
    EXPECT_GT(accepted, 100u);
    EXPECT_GT(rejected, 1000u);
}

TEST(Schema, agrees_with_the_reader_on_arrays_and_types) {
    json scene = valid_scene();
    scene["Objects"][0]["Type"] = "Mesh";
    EXPECT_TRUE(agree(scene));
    scene["Objects"][0]["Type"] = "sphere";
    EXPECT_TRUE(agree(scene));

    scene = valid_scene();
    scene["Scene"]["Ambient"] = {1, 2, 3, 4};
    EXPECT_TRUE(agree(scene));

    scene = valid_scene();
    for (const double angle : {3.14, 3.141592653589793, 3.15}) {
        scene["Camera"]["FieldOfView"] = angle;
        EXPECT_TRUE(agree(scene)) << angle;
    }
}

}  // namespace
}  // namespace boxwood
