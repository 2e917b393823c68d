// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/mesh/text_kernels/count_lines.h"
#include "boxwood/mesh/text_kernels/read_rows.h"
#include "boxwood/mesh/text_kernels/read_triangles.h"
#include "boxwood/mesh/text_kernels/text_kernels.h"

namespace boxwood {

/// The kernels that an instruction set's vocabulary makes.
template <class Bytes>
constexpr TextKernels text_kernels_of() {
    return {
        .read_rows =
            [](PlainText& text, const LinePrefix& prefix, std::size_t columns, double* numbers,
               std::size_t most) { return read_rows<Bytes>(text, prefix, columns, numbers, most); },
        .read_triangles =
            [](PlainText& text, const LinePrefix& prefix, std::uint32_t first, std::uint32_t count,
               int* indices, std::size_t most) {
                return read_triangles<Bytes>(text, prefix, first, count, indices, most);
            },
        .count_lines = [](const char* begin,
                          const char* end) { return count_lines<Bytes>(begin, end); },
    };
}

}  // namespace boxwood
