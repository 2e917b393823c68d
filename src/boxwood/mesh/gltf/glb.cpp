// SPDX-License-Identifier: Apache-2.0
// A header of 12 bytes: "glTF", version 2, total length. Then chunks: length, type, bytes; the
// first one is "JSON", the second may be "BIN" and a zero byte. All numbers are little-endian.
#include "boxwood/mesh/gltf/glb.h"

#include <fmt/format.h>

#include <cstdint>

#include "boxwood/core/error.h"
#include "boxwood/mesh/byte_order.h"

namespace boxwood {

namespace {

constexpr std::string_view kMagic = "glTF";
constexpr std::size_t kHeader = 12;
constexpr std::size_t kChunkHeader = 8;

[[noreturn]] void fail(const MeshSource& source, std::size_t place, const std::string& message) {
    throw ParseError(source.name(), fmt::format("byte {}", place), message);
}

/// The content up to the length that the header gives.
std::string_view checked(const MeshSource& source) {
    const std::string_view bytes = source.bytes;
    if (bytes.size() < kHeader + kChunkHeader)
        fail(source, bytes.size(), "the file ends, expected the headers of a .glb, 20 bytes");
    if (const std::uint32_t version = little_uint32(bytes.data() + 4); version != 2)
        fail(source, 4, fmt::format("found version {}, expected 2", version));
    const std::uint32_t length = little_uint32(bytes.data() + 8);
    if (length < kHeader + kChunkHeader || length > bytes.size())
        fail(source, 8,
             fmt::format("found the length {}, expected 20 to {}, the size of the file", length,
                         bytes.size()));
    return bytes.substr(0, length);
}

/// The bytes of the chunk at a place, of the given type.
std::string_view chunk_at(const MeshSource& source, std::string_view bytes, std::size_t place) {
    const std::uint32_t length = little_uint32(bytes.data() + place);
    const std::size_t room = bytes.size() - place - kChunkHeader;
    if (length > room)
        fail(source, place,
             fmt::format("found a chunk of {} bytes, expected at most {}, all that is left", length,
                         room));
    return bytes.substr(place + kChunkHeader, length);
}

}  // namespace

bool is_glb(const MeshSource& source) { return source.bytes.starts_with(kMagic); }

std::string_view glb_json(const MeshSource& source) {
    if (!is_glb(source)) return source.bytes;
    const std::string_view bytes = checked(source);
    if (bytes.substr(kHeader + 4, 4) != "JSON")
        fail(source, kHeader + 4, "found another type, expected that the first chunk is JSON");
    return chunk_at(source, bytes, kHeader);
}

std::optional<std::string_view> glb_binary(const MeshSource& source) {
    if (!is_glb(source)) return std::nullopt;
    const std::string_view json = glb_json(source);
    const std::string_view bytes = checked(source);
    // Chunks start at multiples of four.
    std::size_t place = static_cast<std::size_t>(json.data() + json.size() - bytes.data());
    place += (4 - place % 4) % 4;
    if (place + kChunkHeader > bytes.size()) return std::nullopt;
    if (bytes.substr(place + 4, 4) != std::string_view("BIN\0", 4)) return std::nullopt;
    return chunk_at(source, bytes, place);
}

}  // namespace boxwood
