// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "boxwood/core/limits.h"
#include "boxwood/mesh/mesh_source.h"

namespace boxwood {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// In bytes, as binary files hold it.
std::size_t size_of(PlyType type);

inline bool is_floating(PlyType type) {
    return type == PlyType::float32 || type == PlyType::float64;
}

/// A number, or a list of them, that each of an element's items has.
struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;  ///< of a list: of its items
    bool is_list = false;
    PlyType count_type = PlyType::uint8;
    std::size_t line = 0;
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::size_t line = 0;
    std::vector<PlyProperty> properties;

    bool has_lists() const;
    /// The least size of one in a binary file: with empty lists.
    std::size_t least_size() const;
    /// Nothing of it is in the file when it has no properties.
    bool is_stored() const { return count > 0 && !properties.empty(); }
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0;  ///< up to the body
    std::size_t lines = 0;
};

/// Reads the header, which is the same for all formats. Throws ParseError with the line.
PlyHeader read_ply_header(const MeshSource& source, const Limits& limits);

}  // namespace boxwood
