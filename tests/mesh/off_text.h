// SPDX-License-Identifier: Apache-2.0
// OFF files as text, for tests that read, write and spoil them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "boxwood/core/error.h"
#include "boxwood/mesh/off.h"
#include "temp_dir.h"

namespace boxwood {

inline const std::string kTriangle = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

inline const std::string kTwoFaces =
    "OFF # a square\n"
    "\n"
    "4 2 5\n"
    "0 0 0\n"
    "1.5e0 0 0 # right\n"
    "  # the upper two\n"
    "1.5\t+1 0\r\n"
    "-0 1 .0\n"
    "3  0 1 2\n"
    "3 0 2 3  255 0 0\n";

inline TriangleMesh parsed(std::string_view text) { return parse_off({text, "mesh.off"}); }

/// What is wrong with the text, as "line: message".
inline std::string complaint_about(std::string_view text) {
    constexpr std::string_view kName = "mesh.off:";
    try {
        parse_off({text, "mesh.off"});
    } catch (const ParseError& error) {
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with(kName)) << message;
        return message.substr(std::min(message.size(), kName.size()));
    }
    return "none";
}

inline bool same(const TriangleMesh& a, const TriangleMesh& b) {
    return a.vertices == b.vertices && a.faces == b.faces;
}

inline std::string text_of(const TriangleMesh& mesh) {
    const TempDir dir;
    write_off(dir / "mesh.off", mesh);
    return content_of(dir / "mesh.off");
}

/// The text with a line, counted from 1, replaced.
inline std::string with_line(std::string text, std::size_t line, std::string_view replacement) {
    std::size_t begin = 0;
    for (; line > 1; --line) begin = text.find('\n', begin) + 1;
    return text.replace(begin, text.find('\n', begin) - begin, replacement);
}

}  // namespace boxwood
