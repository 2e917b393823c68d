// SPDX-License-Identifier: Apache-2.0
// The body of the file is cut into chunks of whole lines. A first pass counts the lines of each
// chunk, which tells every chunk where its vertices and faces belong and whether the header's
// promise holds before memory is spent on it; a second pass reads the numbers.
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/core/huge_pages.h"
#include "boxwood/mesh/off/off_body.h"
#include "boxwood/mesh/off/off_faces.h"
#include "boxwood/mesh/off/off_vertices.h"
#include "boxwood/mesh/reader_warnings.h"
#include "boxwood/mesh/text_chunks.h"

namespace boxwood {

namespace {

struct Chunk : TextChunk {
    OffVertices vertices;
    OffFaces faces;
    Warnings trailing = {};  ///< of lines after the last face
};

class OffTextReader {
public:
    OffTextReader(const OffHeader& header, const MeshSource& source, const Limits& limits)
        : header_(header), name_(source.name()), limits_(limits) {}

    MeshData read(const TextScanner& scanner) {
        split_body(scanner);
        resize_off_vertices(header_, mesh_);
        place_faces();
        for_each_chunk(chunks_, [this](Chunk& chunk) { read_chunk(chunk); });
        join();
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(const TextScanner& scanner, const std::string& message) const {
        throw ParseError(name_, scanner.line(), message);
    }

    void split_body(const TextScanner& scanner) {
        for (const std::string_view text : split_at_lines(scanner.rest()))
            chunks_.push_back({{.text = text}, {}, OffFaces(name_)});
        const std::size_t content_lines = number_lines(chunks_, scanner.line());
        const std::size_t promised = header_.vertices + header_.faces;
        if (content_lines < promised)
            throw ParseError(name_, header_.line,
                             fmt::format("the header promises {} vertices and {} faces, {} lines, "
                                         "but the file has {}",
                                         header_.vertices, header_.faces, promised, content_lines));
    }

    void place_faces() {
        resize_on_huge_pages(mesh_.faces, header_.faces);
        const auto face_of = [this](std::size_t line) {
            return std::min(std::max(line, header_.vertices) - header_.vertices, header_.faces);
        };
        for (Chunk& chunk : chunks_) {
            const std::size_t first = face_of(chunk.first_content_line);
            const std::size_t end = face_of(chunk.first_content_line + chunk.content_lines);
            chunk.faces.set_places(std::span(mesh_.faces).subspan(first, end - first));
        }
    }

    void read_chunk(Chunk& chunk) {
        const std::size_t end = header_.vertices + header_.faces;
        std::size_t i = chunk.first_content_line;
        const std::size_t chunk_end = i + chunk.content_lines;
        TextScanner scanner(chunk.text, chunk.first_line);
        while (true) {
            i += read_vertex_lines(scanner, i, chunk_end);
            i += read_face_lines(scanner, i, chunk.faces);
            if (!scanner.find_word()) return;
            if (i < header_.vertices) {
                read_vertex(scanner, i, chunk.vertices);
            } else if (i < end) {
                read_face(scanner, i - header_.vertices, chunk.faces);
            } else {
                warn_of_end(scanner, chunk.trailing);
            }
            ++i;
            scanner.finish_line();
        }
    }

    /// Plain lines of three numbers, which are a vertex each; how many. What follows those may
    /// overwrite the next vertex, so that it must be one of the chunk's.
    std::size_t read_vertex_lines(TextScanner& scanner, std::size_t i, std::size_t chunk_end) {
        const std::size_t end = std::min(header_.vertices, chunk_end);
        if (i >= end || !has_positions_only_) return 0;
        return scanner.plain_lines([&](PlainText& text) {
            return read_plain_rows(text, LinePrefix(), 3, mesh_.vertices[i].data(), end - i);
        });
    }

    /// Plain lines of a triangle without a colour; how many.
    std::size_t read_face_lines(TextScanner& scanner, std::size_t i, OffFaces& faces) const {
        const std::size_t end = header_.vertices + header_.faces;
        if (i < header_.vertices || i >= end) return 0;
        return faces.read_plain(scanner, header_.vertices, end - i);
    }

    void read_vertex(TextScanner& scanner, std::size_t i, OffVertices& part) {
        OffVertex vertex;
        read_numbers(scanner, i, "coordinates", 3 + header_.is_homogeneous,
                     [&](int k, double x) { (k < 3 ? vertex.position[k] : vertex.w) = x; });
        if (header_.has_normals)
            read_numbers(scanner, i, "numbers of a normal", 3,
                         [&](int k, double x) { vertex.normal[k] = static_cast<float>(x); });
        const bool has_more = header_.has_colors || header_.has_texture_coordinates;
        const std::size_t spare = has_more ? read_rest(scanner, i, vertex) : skip_numbers(scanner);
        if (spare > 0)
            part.warnings.add_lazily(
                "vertices with more numbers than the keyword says, ignored", name_, [&] {
                    return std::pair(
                        std::to_string(scanner.line()),
                        fmt::format("vertex {} has {} numbers more than expected", i, spare));
                });
        set_off_vertex(header_, name_, vertex, i, {.number = scanner.line()}, mesh_, part);
    }

    template <class Take>
    void read_numbers(TextScanner& scanner, std::size_t vertex, const char* what, int count,
                      const Take& take) const {
        for (int k = 0; k < count; ++k) {
            const auto number = scanner.number();
            if (!number && scanner.at_end_of_line())
                fail(scanner,
                     fmt::format("vertex {} has {} {}, expected {}", vertex, k, what, count));
            if (!number) fail_number(scanner);
            take(k, *number);
        }
    }

    /// Reads colour and texture coordinates; returns how many numbers are left.
    std::size_t read_rest(TextScanner& scanner, std::size_t i, OffVertex& vertex) const {
        std::array<double, 6> numbers = {};
        std::size_t count = 0;
        for (; !scanner.at_end_of_line(); ++count) {
            const auto number = scanner.number();
            if (!number) fail_number(scanner);
            if (count < numbers.size()) numbers[count] = *number;
        }
        const std::size_t after = header_.has_texture_coordinates ? 2 : 0;
        const std::size_t least = (header_.has_colors ? 3 : 0) + after;
        const std::size_t most = (header_.has_colors ? 4 : 0) + after;
        if (count < least)
            fail(scanner, fmt::format("vertex {} has {} numbers of {}, expected {}", i, count,
                                      !header_.has_colors ? "texture coordinates"
                                      : after == 0        ? "a colour"
                                                          : "colour and texture coordinates",
                                      least == most ? std::to_string(least)
                                                    : fmt::format("{} or {}", least, most)));
        const std::size_t used = std::min(count, most);
        for (std::size_t k = 0; k < used - after; ++k) vertex.color.add(numbers[k]);
        for (std::size_t k = 0; k < after; ++k)
            vertex.texture_coordinates[static_cast<int>(k)] =
                static_cast<float>(numbers[used - after + k]);
        return count - used;
    }

    void read_face(TextScanner& scanner, std::size_t i, OffFaces& faces) const {
        const auto corners = scanner.integer();
        if (!corners) fail_integer(scanner);
        if (*corners < 0)
            fail(scanner, fmt::format("face {} has {} corners, expected at least 3", i, *corners));
        const auto vertices = static_cast<std::int64_t>(header_.vertices);
        for (std::int64_t k = 0; k < *corners; ++k) {
            const auto index = scanner.integer();
            if (!index && scanner.at_end_of_line())
                fail(scanner,
                     fmt::format("face {} has {} vertex indices, expected {}", i, k, *corners));
            if (!index) fail_integer(scanner);
            if (*index < 0 || *index >= vertices)
                fail(scanner,
                     fmt::format("face {} has vertex index {}, {}", i, *index,
                                 vertices > 0 ? fmt::format("expected 0 to {}", vertices - 1)
                                              : "but there are no vertices"));
            faces.add_corner(static_cast<int>(*index));
        }
        OffColor color;
        while (!scanner.at_end_of_line()) {
            const auto number = scanner.number();
            if (!number) fail_number(scanner);
            color.add(*number);
        }
        faces.end_face(color, i, {.number = scanner.line()});
    }

    std::size_t skip_numbers(TextScanner& scanner) const {
        std::size_t count = 0;
        for (; !scanner.at_end_of_line(); ++count) {
            if (!scanner.number()) fail_number(scanner);
        }
        return count;
    }

    [[noreturn]] void fail_number(TextScanner scanner) const {
        fail(scanner, fmt::format("found {}, expected a number", quoted(scanner.word())));
    }
    [[noreturn]] void fail_integer(TextScanner scanner) const {
        fail(scanner, fmt::format("found {}, expected a whole number", quoted(scanner.word())));
    }

    void warn_of_end(TextScanner& scanner, Warnings& warnings) const {
        warnings.add_lazily(kTrailingLines, name_, [&] {
            return std::pair(
                std::to_string(scanner.line()),
                fmt::format("found {} after the last face, expected the end of the file",
                            quoted(scanner.word())));
        });
    }

    void join() {
        float largest_color = 0;
        std::vector<OffFaces*> faces;
        for (Chunk& chunk : chunks_) {
            mesh_.warnings.append(chunk.vertices.warnings);
            largest_color = std::max(largest_color, chunk.vertices.largest_color);
            faces.push_back(&chunk.faces);
        }
        scale_off_colors(mesh_.attributes.colors.values, largest_color);
        OffFaces::join(faces, name_, limits_, mesh_);
        for (const Chunk& chunk : chunks_) mesh_.warnings.append(chunk.trailing);
    }

    OffHeader header_;
    bool has_positions_only_ = !(header_.is_homogeneous || header_.has_normals ||
                                 header_.has_colors || header_.has_texture_coordinates);
    std::string name_;
    Limits limits_;
    std::vector<Chunk> chunks_;
    MeshData mesh_;
};

}  // namespace

MeshData read_off_text(const OffHeader& header, const MeshSource& source,
                       const TextScanner& scanner, const Limits& limits) {
    return OffTextReader(header, source, limits).read(scanner);
}

}  // namespace boxwood
