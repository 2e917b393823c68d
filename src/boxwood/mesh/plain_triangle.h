// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "boxwood/core/vec.h"
#include "boxwood/mesh/text_scanner.h"

namespace boxwood {

/// The corners of a face whose line is "3 a b c", parted by single spaces, each of them one of so
/// many vertices, which is what most lines are. Else nothing, and the scanner stays where it is:
/// whoever knows other faces, and what is wrong with them, reads the line. For speed.
inline std::optional<Vec3i> plain_triangle(TextScanner& scanner, std::size_t vertices) {
    const TextScanner before = scanner;
    std::array<std::int64_t, 4> numbers;
    const auto is_vertex = [&](std::int64_t index) {
        return static_cast<std::uint64_t>(index) < vertices;
    };
    if (scanner.plain_line(numbers.data(), 4) && numbers[0] == 3 && is_vertex(numbers[1]) &&
        is_vertex(numbers[2]) && is_vertex(numbers[3]))
        return Vec3i(static_cast<int>(numbers[1]), static_cast<int>(numbers[2]),
                     static_cast<int>(numbers[3]));
    scanner = before;
    return std::nullopt;
}

}  // namespace boxwood
