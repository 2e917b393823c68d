// SPDX-License-Identifier: Apache-2.0
// Numbers as files have them, byte by byte, so that the machine's own byte order doesn't matter.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace boxwood {

inline std::uint32_t byte_at(const char* bytes, std::size_t i) {
    return static_cast<unsigned char>(bytes[i]);
}

inline std::uint32_t little_uint16(const char* bytes) {
    return byte_at(bytes, 0) | byte_at(bytes, 1) << 8;
}

inline std::uint32_t little_uint32(const char* bytes) {
    return little_uint16(bytes) | little_uint16(bytes + 2) << 16;
}

inline std::uint32_t big_uint32(const char* bytes) {
    return byte_at(bytes, 0) << 24 | byte_at(bytes, 1) << 16 | byte_at(bytes, 2) << 8 |
           byte_at(bytes, 3);
}

inline float float_of_bits(std::uint32_t bits) {
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

inline void write_little_uint32(char* bytes, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) bytes[i] = static_cast<char>(value >> (8 * i) & 0xff);
}

inline void write_little_float(char* bytes, float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    write_little_uint32(bytes, bits);
}

}  // namespace boxwood
