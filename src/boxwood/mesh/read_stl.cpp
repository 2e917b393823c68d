// SPDX-License-Identifier: Apache-2.0
// Text begins with "solid", but so do many binary files, whose first 80 bytes may hold anything.
// What tells them apart is the size of the file, and for a binary file of another size the bytes
// that no text has.
#include <algorithm>

#include "boxwood/core/error.h"
#include "boxwood/mesh/byte_order.h"
#include "boxwood/mesh/stl.h"

namespace boxwood {

namespace {

constexpr std::size_t kHeaderBytes = 84, kTriangleBytes = 50;

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

bool has_size_of_binary(std::string_view bytes) {
    return bytes.size() >= kHeaderBytes &&
           bytes.size() ==
               kHeaderBytes + kTriangleBytes * std::uint64_t{little_uint32(bytes.data() + 80)};
}

bool begins_with_solid(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    while (!bytes.empty() && is_blank(bytes[0])) bytes.remove_prefix(1);
    constexpr std::string_view kSolid = "solid";
    if (bytes.size() < kSolid.size()) return false;
    for (std::size_t i = 0; i < kSolid.size(); ++i) {
        if ((bytes[i] | ' ') != kSolid[i]) return false;
    }
    return bytes.size() == kSolid.size() || is_blank(bytes[kSolid.size()]);
}

bool has_control_characters(std::string_view bytes) {
    return std::any_of(bytes.begin(), bytes.end(), [](char c) {
        return (static_cast<unsigned char>(c) < ' ' && !is_blank(c)) || c == '\x7f';
    });
}

}  // namespace

MeshData parse_stl(const MeshSource& source, const ReadOptions& options) {
    constexpr std::size_t kLookedAt = 1024;
    const std::string_view bytes = source.bytes;
    if (bytes.empty()) throw ParseError(source.name(), "", "the file is empty, expected STL");
    if (!has_size_of_binary(bytes) && begins_with_solid(bytes) &&
        !has_control_characters(bytes.substr(0, kLookedAt)))
        return parse_stl_text(source, options);
    return parse_binary_stl(source, options);
}

}  // namespace boxwood
