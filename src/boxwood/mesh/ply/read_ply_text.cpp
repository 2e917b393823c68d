// SPDX-License-Identifier: Apache-2.0
// Like OFF: a first pass counts the lines of each chunk of the body, a second one reads them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/core/huge_pages.h"
#include "boxwood/mesh/plain_faces.h"
#include "boxwood/mesh/ply/ply_rows.h"
#include "boxwood/mesh/text_chunks.h"
#include "boxwood/mesh/text_scanner.h"

namespace boxwood {

namespace {

/// Numbers of a vertex whose line is read at once.
constexpr std::size_t kMostPlainNumbers = 16;

struct Chunk : TextChunk {
    PlyFaces faces;
    PlacedFaces placed = {};
};

class TextCursor {
public:
    TextCursor(TextScanner& scanner, const std::string& file) : scanner_(scanner), file_(file) {}

    double number(PlyType) {
        const auto number = scanner_.number();
        if (!number) fail_word("a number");
        return *number;
    }
    std::int64_t integer(PlyType) {
        const auto number = scanner_.integer();
        if (!number) fail_word("a whole number");
        return *number;
    }
    std::size_t count(PlyType type) {
        const std::int64_t count = integer(type);
        if (count < 0)
            fail(fmt::format("found {} as the count of a list, expected 0 or more", count));
        return static_cast<std::size_t>(count);
    }
    void skip(PlyType type) { number(type); }

    [[noreturn]] void fail(const std::string& message) const {
        throw ParseError(file_, scanner_.line(), message);
    }
    void warn(Warnings& warnings, const char* kind, const std::string& message) const {
        warnings.add(kind, file_, scanner_.line(), message);
    }

private:
    [[noreturn]] void fail_word(const char* expected) {
        const std::string_view word = scanner_.word();
        fail(fmt::format("found {}, expected {}",
                         word.empty() ? "the end of the line" : quoted(word), expected));
    }

    TextScanner& scanner_;
    const std::string& file_;
};

class PlyTextReader {
public:
    explicit PlyTextReader(PlyBody& body) : body_(body) {
        for (const PlyElement& element : body.header.elements) {
            if (element.is_stored()) elements_.push_back(&element);
        }
    }

    std::vector<PlyFaces> read() {
        split();
        body_.make_vertices();
        place_faces();
        for_each_chunk(chunks_, [this](Chunk& chunk) { read_chunk(chunk); });
        body_.has_faces = std::all_of(chunks_.begin(), chunks_.end(),
                                      [](const Chunk& chunk) { return chunk.placed.is_placed(); });
        if (!body_.has_faces) collect_faces();
        std::vector<PlyFaces> faces;
        faces.reserve(chunks_.size());
        for (Chunk& chunk : chunks_) faces.push_back(std::move(chunk.faces));
        return faces;
    }

private:
    void split() {
        for (const std::string_view text : split_at_lines(body_.text.substr(body_.header.bytes)))
            chunks_.emplace_back().text = text;
        check_size(number_lines(chunks_, body_.header.lines + 1));
    }

    /// Before memory is spent.
    void check_size(std::size_t lines) const {
        // A number and what parts it from the next; the last may have nothing behind it.
        std::size_t bytes = body_.text.size() - body_.header.bytes + 1;
        for (const PlyElement* element : elements_) {
            if (element->count > lines)
                throw ParseError(
                    body_.name, element->line,
                    fmt::format("the header promises {} of the element {}, a line each, but the "
                                "file has {}",
                                element->count, boxwood::quoted(element->name), lines));
            const std::size_t numbers = element->properties.size();
            if (element->count > bytes / (2 * numbers))
                throw ParseError(
                    body_.name, element->line,
                    fmt::format("the header promises {} of the element {}, {} numbers each, but "
                                "the file has {} bytes for them",
                                element->count, boxwood::quoted(element->name), numbers,
                                bytes - 1));
            lines -= element->count;
            bytes -= element->count * 2 * numbers;
        }
    }

    /// Where each chunk's faces go if all are triangles and nothing else.
    void place_faces() {
        if (!has_plain_faces_) return;
        resize_on_huge_pages(body_.mesh.faces, body_.faces->count);
        std::size_t before = 0;
        for (auto element = elements_.begin(); *element != body_.faces; ++element)
            before += (*element)->count;
        const auto face_of = [&](std::size_t line) {
            return std::min(std::max(line, before) - before, body_.faces->count);
        };
        for (Chunk& chunk : chunks_) {
            const std::size_t first = face_of(chunk.first_content_line);
            const std::size_t end = face_of(chunk.first_content_line + chunk.content_lines);
            chunk.placed = PlacedFaces(std::span(body_.mesh.faces).subspan(first, end - first));
        }
    }

    void collect_faces() {
        for_each_chunk(chunks_,
                       [](Chunk& chunk) { chunk.placed.leave(chunk.faces.polygons.faces); });
        std::vector<Vec3i>().swap(body_.mesh.faces);
    }

    void read_chunk(Chunk& chunk) {
        // Which element the first line is of, and which of its items.
        std::size_t row = chunk.first_content_line;
        auto element = elements_.begin();
        const auto find_element = [&] {
            while (element != elements_.end() && row >= (*element)->count) {
                row -= (*element)->count;
                ++element;
            }
        };
        TextScanner scanner(chunk.text, chunk.first_line);
        TextCursor cursor(scanner, body_.name);
        PlyPolygon polygon;
        std::vector<int> indices;
        while (true) {
            find_element();
            if (element != elements_.end()) {
                const std::size_t count = read_plain_lines(scanner, **element, row, chunk);
                row += count;
                if (count > 0) continue;
            }
            if (!scanner.find_word()) return;
            if (element == elements_.end()) {
                cursor.warn(
                    chunk.faces.warnings, kTrailingLines,
                    fmt::format("found {}, expected the end of the file", quoted(scanner.word())));
            } else if (*element == body_.vertices) {
                read_ply_vertex(cursor, body_, row);
            } else if (*element == body_.faces) {
                chunk.placed.leave(chunk.faces.polygons.faces);
                read_ply_face(cursor, body_, row, polygon, chunk.faces);
            } else if (*element == body_.strips) {
                read_ply_strips(cursor, body_, row, indices, chunk.faces);
            }
            const bool is_read = element != elements_.end() && body_.is_needed(**element);
            if (is_read && !scanner.at_end_of_line())
                cursor.fail(
                    fmt::format("found {}, expected the end of the line", quoted(scanner.word())));
            ++row;
            scanner.finish_line();
        }
    }

    /// The next lines that are plain, items of the element from the given row on; how many.
    std::size_t read_plain_lines(TextScanner& scanner, const PlyElement& element, std::size_t row,
                                 Chunk& chunk) {
        const std::size_t most = element.count - row;
        if (&element == body_.vertices && has_plain_vertices_)
            return read_plain_vertices(scanner, row, most);
        if (&element == body_.faces && has_plain_faces_) {
            std::vector<Vec3i>& faces = chunk.faces.polygons.faces;
            return chunk.placed.read(scanner, body_.vertices->count,
                                     std::min(most, body_.max_faces - faces.size()), faces);
        }
        return 0;
    }

    std::size_t read_plain_vertices(TextScanner& scanner, std::size_t row, std::size_t most) {
        const std::size_t columns = body_.vertex_columns.size();
        std::array<double, 64 * kMostPlainNumbers> numbers;
        const std::size_t room = numbers.size() / columns;
        std::size_t count = 0, last = 0;
        do {
            last = scanner.plain_lines([&](PlainText& text) {
                return read_plain_rows(text, LinePrefix(), columns, numbers.data(),
                                       std::min(room, most - count));
            });
            for (std::size_t k = 0; k < columns; ++k) {
                for (std::size_t i = 0; i < last; ++i)
                    body_.vertex_columns[k].set(row + count + i, numbers[i * columns + k]);
            }
            count += last;
        } while (last == room);
        return count;
    }

    PlyBody& body_;
    bool has_plain_vertices_ =
        !body_.vertices->has_lists() && body_.vertices->properties.size() <= kMostPlainNumbers;
    bool has_plain_faces_ = body_.faces && body_.faces->properties.size() == 1;
    std::vector<const PlyElement*> elements_;
    std::vector<Chunk> chunks_;
};

}  // namespace

std::vector<PlyFaces> read_ply_text(PlyBody& body) { return PlyTextReader(body).read(); }

}  // namespace boxwood
