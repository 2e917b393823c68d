// SPDX-License-Identifier: Apache-2.0
// The body of the file is cut into chunks of whole lines. A first pass counts the lines of each
// chunk, which tells every chunk where its vertices and faces belong and whether the header's
// promise holds before memory is spent on it; a second pass reads the numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/mesh/off.h"
#include "boxwood/mesh/text_chunks.h"
#include "boxwood/mesh/text_scanner.h"

namespace boxwood {

namespace {

struct Header {
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::size_t line = 0;  ///< of the counts
};

/// "Content lines" hold more than blanks and comments.
struct Chunk {
    std::string_view text;
    std::size_t lines = 0, first_line = 0;
    std::size_t content_lines = 0, first_content_line = 0;
    std::vector<Vec3i> faces;
    std::size_t first_face = 0;
};

class OffReader {
public:
    explicit OffReader(const MeshSource& source, const Limits& limits)
        : name_(source.name()), text_(source.bytes), limits_(limits) {}

    MeshData read() {
        TextScanner scanner(text_);
        read_header(scanner);
        split_body(scanner);
        read_body();
        join_faces();
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(const TextScanner& scanner, const std::string& message) const {
        throw ParseError(name_, scanner.line(), message);
    }

    void read_header(TextScanner& scanner) {
        scanner.accept("\xEF\xBB\xBF");  // the byte order mark that some editors write
        if (!scanner.find_word()) fail(scanner, "the file is empty, expected the keyword OFF");
        read_keyword(scanner);
        if (scanner.at_end_of_line()) {
            scanner.finish_line();
            if (!scanner.find_word())
                fail(scanner, "the file ends, expected the counts of vertices and faces");
        }
        header_.line = scanner.line();
        header_.vertices = read_count(scanner, "vertices", limits_.max_vertices);
        header_.faces = read_count(scanner, "faces", limits_.max_faces);
        skip_numbers(scanner);  // the count of edges, which nobody keeps right
        scanner.finish_line();
    }

    void read_keyword(TextScanner& scanner) const {
        const std::string found = quoted(TextScanner(scanner).word());
        while (scanner.accept("ST") || scanner.accept("C") || scanner.accept("N")) {
        }
        if (scanner.accept("4") || scanner.accept("n"))
            fail(scanner,
                 fmt::format("found {}, expected OFF, for vertices of three coordinates", found));
        // No look at what follows: in many files the first count does, without a blank.
        if (!scanner.accept("OFF"))
            fail(scanner, fmt::format("found {}, expected the keyword OFF", found));
        if (!scanner.at_end_of_line() && scanner.accept("BINARY"))
            fail(scanner, "found 'OFF BINARY', expected OFF as text");
    }

    std::size_t read_count(TextScanner& scanner, const char* what, std::uint64_t most) const {
        const std::string_view word = TextScanner(scanner).word();
        const auto count = scanner.integer();
        if (!count || *count < 0 || static_cast<std::uint64_t>(*count) > most)
            fail(scanner, fmt::format("found {} as the count of {}, expected 0 to {}",
                                      word.empty() ? "nothing" : quoted(word), what, most));
        return static_cast<std::size_t>(*count);
    }

    void split_body(const TextScanner& scanner) {
        for (const std::string_view text : split_at_lines(scanner.rest()))
            chunks_.emplace_back().text = text;
        for_each_chunk(chunks_, [](Chunk& chunk) {
            TextScanner lines(chunk.text, 0);
            for (; lines.find_word(); lines.finish_line()) ++chunk.content_lines;
            chunk.lines = lines.line();
        });

        std::size_t line = scanner.line(), content_line = 0;
        for (Chunk& chunk : chunks_) {
            chunk.first_line = std::exchange(line, line + chunk.lines);
            chunk.first_content_line =
                std::exchange(content_line, content_line + chunk.content_lines);
        }
        const std::size_t promised = header_.vertices + header_.faces;
        if (content_line < promised)
            throw ParseError(name_, header_.line,
                             fmt::format("the header promises {} vertices and {} faces, {} lines, "
                                         "but the file has {}",
                                         header_.vertices, header_.faces, promised, content_line));
    }

    void read_body() {
        mesh_.vertices.resize(header_.vertices);
        for_each_chunk(chunks_, [this](Chunk& chunk) { read_chunk(chunk); });
    }

    void read_chunk(Chunk& chunk) {
        const std::size_t end = header_.vertices + header_.faces;
        std::size_t i = chunk.first_content_line;
        const std::size_t last = std::min(i + chunk.content_lines, end);
        chunk.faces.reserve(last - std::clamp(header_.vertices, std::min(i, last), last));

        TextScanner scanner(chunk.text, chunk.first_line);
        for (; scanner.find_word(); ++i, scanner.finish_line()) {
            if (i >= end)
                fail(scanner,
                     fmt::format("found {} after the last face, expected the end of the file",
                                 quoted(scanner.word())));
            if (i < header_.vertices) {
                read_vertex(scanner, i);
            } else {
                read_face(scanner, i - header_.vertices, chunk.faces);
            }
            skip_numbers(scanner);
        }
    }

    void read_vertex(TextScanner& scanner, std::size_t i) {
        // Boxes are of floats, so a larger coordinate could never be found again.
        constexpr double kLargest = std::numeric_limits<float>::max();
        for (int k = 0; k < 3; ++k) {
            TextScanner before = scanner;
            const auto number = scanner.number();
            if (!number && scanner.at_end_of_line())
                fail(scanner, fmt::format("vertex {} has {} coordinates, expected 3", i, k));
            if (!number) fail_number(scanner);
            if (!(std::abs(*number) <= kLargest)) fail_size(before, i);
            mesh_.vertices[i][k] = *number;
        }
    }

    void read_face(TextScanner& scanner, std::size_t i, std::vector<Vec3i>& faces) const {
        const auto corners = scanner.integer();
        if (!corners) fail_integer(scanner);
        if (*corners < 3)
            fail(scanner, fmt::format("face {} has {} corners, expected at least 3", i, *corners));
        // A fan around the first corner.
        Vec3i triangle;
        for (std::int64_t k = 0; k < *corners; ++k) {
            const auto index = scanner.integer();
            if (!index && scanner.at_end_of_line())
                fail(scanner,
                     fmt::format("face {} has {} vertex indices, expected {}", i, k, *corners));
            if (!index) fail_integer(scanner);
            const auto vertices = static_cast<std::int64_t>(header_.vertices);
            if (*index < 0 || *index >= vertices)
                fail(scanner,
                     fmt::format("face {} has vertex index {}, {}", i, *index,
                                 vertices > 0 ? fmt::format("expected 0 to {}", vertices - 1)
                                              : "but there are no vertices"));
            triangle[k == 0 ? 0 : k == 1 ? 1 : 2] = static_cast<int>(*index);
            if (k < 2) continue;
            faces.push_back(triangle);
            triangle[1] = triangle[2];
        }
    }

    /// Colours, normals and texture coordinates.
    void skip_numbers(TextScanner& scanner) const {
        while (!scanner.at_end_of_line()) {
            if (!scanner.number()) fail_number(scanner);
        }
    }

    [[noreturn]] void fail_number(TextScanner scanner) const {
        fail(scanner, fmt::format("found {}, expected a number", quoted(scanner.word())));
    }
    [[noreturn]] void fail_integer(TextScanner scanner) const {
        fail(scanner, fmt::format("found {}, expected a whole number", quoted(scanner.word())));
    }
    [[noreturn]] void fail_size(TextScanner scanner, std::size_t vertex) const {
        const std::string_view word = scanner.word();
        // Of all that reads as a number, only nan and inf have letters other than an e.
        const bool is_name = word.find_first_of("nN") != word.npos;
        fail(scanner, is_name ? fmt::format("vertex {}: found {}, expected a finite number", vertex,
                                            quoted(word))
                              : fmt::format("vertex {}: found {}, expected at most 3.4e38 in size",
                                            vertex, quoted(word)));
    }

    void join_faces() {
        std::size_t count = 0;
        for (Chunk& chunk : chunks_)
            chunk.first_face = std::exchange(count, count + chunk.faces.size());
        mesh_.faces.resize(count);
        for_each_chunk(chunks_, [this](Chunk& chunk) {
            std::copy(chunk.faces.begin(), chunk.faces.end(),
                      mesh_.faces.begin() + static_cast<std::ptrdiff_t>(chunk.first_face));
            std::vector<Vec3i>().swap(chunk.faces);
        });
    }

    std::string name_;
    std::string_view text_;
    Limits limits_;
    Header header_;
    std::vector<Chunk> chunks_;
    MeshData mesh_;
};

}  // namespace

MeshData parse_off(const MeshSource& source, const ReadOptions& options) {
    return OffReader(source, options.limits).read();
}

}  // namespace boxwood
