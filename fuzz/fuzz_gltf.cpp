// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/gltf.h"
#include "boxwood/world/gltf_world.h"
#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace boxwood;
    fuzz::try_mesh(data, size, "mesh.gltf", parse_gltf);
    try {
        const World world =
            parse_gltf_world(fuzz::source_of(data, size, "mesh.gltf"), fuzz::small_options());
        for (const MeshData& mesh : world.meshes) fuzz::check(mesh);
    } catch (const Error&) {
    }
    return 0;
}
