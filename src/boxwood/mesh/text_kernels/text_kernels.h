// SPDX-License-Identifier: Apache-2.0
// What reads plain lines, see plain_lines.h, for each instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

#include "boxwood/core/simd.h"
#include "boxwood/mesh/plain_lines.h"

namespace boxwood {

/// Characters that a prefix and blanks behind it may have, and those of a window behind them.
constexpr std::ptrdiff_t kMostPrefix = 8, kTextWindow = 64, kTextAhead = kMostPrefix + kTextWindow;
/// Sixteen characters are loaded that end with a number, or before the last of one that has a
/// point.
constexpr std::ptrdiff_t kTextBehind = 16;

/// Those of one instruction set: the functions of plain_lines.h, but that a line is never taken for
/// plain with less than kTextBehind characters of the text in front of it or less than kTextAhead
/// from its start on.
struct TextKernels {
    std::size_t (*read_rows)(PlainText& text, const LinePrefix& prefix, std::size_t columns,
                             double* numbers, std::size_t most);
    std::size_t (*read_triangles)(PlainText& text, const LinePrefix& prefix, std::uint32_t first,
                                  std::uint32_t count, int* indices, std::size_t most);
    LineCounts (*count_lines)(const char* begin, const char* end);
};

// One of these a source file, compiled for that instruction set alone.
const TextKernels& scalar_text_kernels();
const TextKernels& sse4_text_kernels();
const TextKernels& avx2_text_kernels();
const TextKernels& avx512_text_kernels();
const TextKernels& neon_text_kernels();
const TextKernels& wasm_text_kernels();

/// Precondition: is_supported(set).
const TextKernels& text_kernels(InstructionSet set);

/// Reads a row whose numbers are too long for the kernels or have an exponent, and moves past its
/// line's end; false if it isn't plain.
bool read_unusual_row(const char*& at, const char* end, std::size_t columns, double* row);

}  // namespace boxwood
