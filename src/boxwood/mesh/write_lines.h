// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "boxwood/core/files.h"
#include "boxwood/core/parallel.h"

namespace boxwood {

/// Writes lines 0 to count - 1; append(buffer, i) formats one, newline included, on any thread.
/// Binary records are lines as well.
template <class Append>
void write_lines(OutputFile& file, std::size_t count, const Append& append) {
    constexpr std::size_t kBlock = 4096;  // lines that one task formats
    constexpr std::size_t kBlocks = 64;   // blocks held in memory at a time
    std::vector<fmt::memory_buffer> buffers(kBlocks);
    for (std::size_t first = 0; first < count; first += kBlock * kBlocks) {
        const std::size_t end = std::min(count, first + kBlock * kBlocks);
        parallel_for(kBlocks, 1, [&](std::size_t block, std::size_t last_block) {
            for (; block < last_block; ++block) {
                buffers[block].clear();
                const std::size_t begin = first + block * kBlock;
                for (std::size_t i = begin; i < std::min(end, begin + kBlock); ++i)
                    append(buffers[block], i);
            }
        });
        for (const auto& buffer : buffers) file.write({buffer.data(), buffer.size()});
    }
}

}  // namespace boxwood
