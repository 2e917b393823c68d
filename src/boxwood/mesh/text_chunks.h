// SPDX-License-Identifier: Apache-2.0
// Text of many lines is read in chunks of whole lines, on all cores: a first pass counts what each
// chunk holds, which tells every chunk where its part belongs, and a second pass reads it.
#pragma once

#include <cstddef>
#include <exception>
#include <string_view>
#include <vector>

#include "boxwood/core/parallel.h"

namespace boxwood {

constexpr std::size_t kTextChunkBytes = std::size_t{1} << 18;

/// The text in pieces of about the given size, cut only after line ends.
inline std::vector<std::string_view> split_at_lines(std::string_view text,
                                                    std::size_t size = kTextChunkBytes) {
    std::vector<std::string_view> pieces;
    while (!text.empty()) {
        const std::size_t newline = text.size() > size ? text.find('\n', size) : text.npos;
        pieces.push_back(text.substr(0, newline == text.npos ? newline : newline + 1));
        text.remove_prefix(pieces.back().size());
    }
    return pieces;
}

/// Calls body(chunk) for each, on all cores. What it throws for the first chunk that fails, by the
/// order in the file and not in time, is thrown in the end.
template <class Chunk, class Body>
void for_each_chunk(std::vector<Chunk>& chunks, const Body& body) {
    std::vector<std::exception_ptr> failures(chunks.size());
    parallel_for(chunks.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            try {
                body(chunks[i]);
            } catch (...) {
                failures[i] = std::current_exception();
            }
        }
    });
    for (const std::exception_ptr& failure : failures) {
        if (failure) std::rethrow_exception(failure);
    }
}

}  // namespace boxwood
