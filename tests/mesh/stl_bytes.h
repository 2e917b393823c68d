// SPDX-License-Identifier: Apache-2.0
// STL files as bytes, for tests that read and spoil them.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "boxwood/mesh/byte_order.h"

namespace boxwood {

inline std::string little(std::uint32_t value) {
    std::string bytes(4, '\0');
    write_little_uint32(bytes.data(), value);
    return bytes;
}

/// A triangle of a binary STL file: a normal and three corners, and the attribute.
inline std::string stl_triangle(const std::array<float, 12>& numbers, unsigned attribute = 0) {
    std::string bytes(50, '\0');
    for (std::size_t i = 0; i < 12; ++i) write_little_float(&bytes[4 * i], numbers[i]);
    bytes[48] = static_cast<char>(attribute & 0xff);
    bytes[49] = static_cast<char>(attribute >> 8);
    return bytes;
}

inline std::string binary_stl(std::uint32_t count, const std::string& triangles,
                              std::string header = "a part") {
    header.resize(80);
    return header + little(count) + triangles;
}

inline const std::string kUpward = stl_triangle({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0});

inline const std::string kFacet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\n"
    "endfacet\n";

}  // namespace boxwood
