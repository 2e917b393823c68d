// SPDX-License-Identifier: Apache-2.0
// Text of many lines is read in chunks of whole lines, on all cores: a first pass counts what each
// chunk holds, which tells every chunk where its part belongs, and a second pass reads it.
#pragma once

#include <cstddef>
#include <exception>
#include <string_view>
#include <utility>
#include <vector>

#include "boxwood/core/parallel.h"
#include "boxwood/mesh/plain_lines.h"
#include "boxwood/mesh/text_scanner.h"

namespace boxwood {

constexpr std::size_t kTextChunkBytes = std::size_t{1} << 18;

/// Whole lines of a text and where they stand in it. "Content lines" hold more than blanks and
/// comments.
struct TextChunk {
    std::string_view text;
    std::size_t lines = 0, first_line = 0;
    std::size_t content_lines = 0, first_content_line = 0;
};

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

inline std::size_t count_line_ends(std::string_view text) { return line_counts(text).line_ends; }

/// Counts the lines of a chunk. Where none of them begins with a blank, a # or a line end, all are
/// content lines, and counting characters is enough.
inline void count_lines(TextChunk& chunk) {
    const std::string_view text = chunk.text;
    const bool is_first_doubtful =
        text.empty() || static_cast<unsigned char>(text[0]) <= ' ' || text[0] == '#';
    const LineCounts counts = line_counts(text);
    if (!is_first_doubtful && counts.doubtful == 0) {
        chunk.lines = chunk.content_lines = counts.line_ends + !text.ends_with('\n');
        return;
    }
    TextScanner lines(text, 0);
    for (; lines.find_word(); lines.finish_line()) ++chunk.content_lines;
    chunk.lines = lines.line();
}

/// Counts the lines of each TextChunk, on all cores, and numbers them on from the given one.
/// Returns how many content lines there are.
template <class Chunk>
std::size_t number_lines(std::vector<Chunk>& chunks, std::size_t line) {
    for_each_chunk(chunks, [](TextChunk& chunk) { count_lines(chunk); });
    std::size_t content_line = 0;
    for (TextChunk& chunk : chunks) {
        chunk.first_line = std::exchange(line, line + chunk.lines);
        chunk.first_content_line = std::exchange(content_line, content_line + chunk.content_lines);
    }
    return content_line;
}

}  // namespace boxwood
