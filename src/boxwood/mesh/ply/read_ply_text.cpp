// SPDX-License-Identifier: Apache-2.0
// Like OFF: a first pass counts the lines of each chunk of the body, a second one reads them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/mesh/plain_triangle.h"
#include "boxwood/mesh/ply/ply_rows.h"
#include "boxwood/mesh/text_chunks.h"
#include "boxwood/mesh/text_scanner.h"

namespace boxwood {

namespace {

/// Numbers of a vertex whose line is read at once.
constexpr std::size_t kMostPlainNumbers = 16;

struct Chunk : TextChunk {
    PlyFaces faces;
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
        for_each_chunk(chunks_, [this](Chunk& chunk) { read_chunk(chunk); });
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
        for (; scanner.find_word(); ++row, scanner.finish_line()) {
            find_element();
            if (element == elements_.end()) {
                cursor.warn(
                    chunk.faces.warnings, kTrailingLines,
                    fmt::format("found {}, expected the end of the file", quoted(scanner.word())));
            } else if (*element == body_.vertices) {
                if (!read_plain_vertex(scanner, row)) read_ply_vertex(cursor, body_, row);
            } else if (*element == body_.faces) {
                if (!read_plain_triangle(scanner, chunk.faces.polygons))
                    read_ply_face(cursor, body_, row, polygon, chunk.faces);
            } else if (*element == body_.strips) {
                read_ply_strips(cursor, body_, row, indices, chunk.faces);
            }
            const bool is_read = element != elements_.end() && body_.is_needed(**element);
            if (is_read && !scanner.at_end_of_line())
                cursor.fail(
                    fmt::format("found {}, expected the end of the line", quoted(scanner.word())));
        }
    }

    bool read_plain_vertex(TextScanner& scanner, std::size_t row) {
        const std::size_t count = body_.vertex_columns.size();
        std::array<double, kMostPlainNumbers> numbers;
        if (!has_plain_vertices_ || !scanner.plain_line(numbers.data(), count)) return false;
        for (std::size_t i = 0; i < count; ++i) body_.vertex_columns[i].set(row, numbers[i]);
        if (!body_.mesh.vertices[row].allFinite()) body_.has_unfinite_vertices = true;
        return true;
    }

    bool read_plain_triangle(TextScanner& scanner, PlyFaceBatch& batch) const {
        if (!has_plain_faces_ || batch.faces.size() == body_.max_faces) return false;
        const auto triangle = plain_triangle(scanner, body_.vertices->count);
        if (triangle) batch.faces.push_back(*triangle);
        return triangle.has_value();
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
