// SPDX-License-Identifier: Apache-2.0
// Scene files of both versions, and the upgrade from one to the other.
#include "boxwood/world/classic_scene.h"
#include "boxwood/world/scene_description.h"
#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace boxwood;
    ReadOptions options = fuzz::small_options();
    options.limits.max_faces = 1000;
    const MeshSource source = fuzz::source_of(data, size, "scene.json");
    try {
        const JsonReader json = JsonReader::parse(source.bytes, source.name(), options.limits);
        if (json.is_object() && json.find("boxwood")) {
            read_scene_description(json, source.path, options);
        } else {
            upgraded_classic_scene(json);
            read_classic_scene(json, source.path, options);
        }
    } catch (const Error&) {
    }
    return 0;
}
