// SPDX-License-Identifier: Apache-2.0
// What the fuzzers of readers share. A reader may throw Error, and nothing else may happen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "boxwood/core/error.h"
#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/mesh_source.h"

namespace boxwood::fuzz {

/// Small enough that a file can't fill the machine within them.
inline ReadOptions small_options() {
    return {.limits = {.max_bytes = 1 << 22, .max_vertices = 1 << 16, .max_faces = 1 << 16}};
}

/// Names a folder that isn't there, so that nothing is found beside the file.
inline MeshSource source_of(const std::uint8_t* data, std::size_t size, const char* name) {
    return {{reinterpret_cast<const char*>(data), size}, std::string("/nowhere/") + name};
}

/// Ends the program where the reader let something through that it promises to keep out.
inline void check(const MeshData& mesh) {
    try {
        check_indices(mesh);
        check_attributes(mesh, mesh.attributes);
    } catch (const Error&) {
        std::abort();
    }
}

/// What a reader of meshes does with the bytes.
template <class Parse>
int try_mesh(const std::uint8_t* data, std::size_t size, const char* name, const Parse& parse) {
    try {
        check(parse(source_of(data, size, name), small_options()));
    } catch (const Error&) {
    }
    return 0;
}

}  // namespace boxwood::fuzz
