// SPDX-License-Identifier: Apache-2.0
// Where all items of an element have one size, they are read at once, on all cores. Else their
// lists are walked along first, so that blocks of them can be read on all cores.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>
#include <optional>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/core/huge_pages.h"
#include "boxwood/core/parallel.h"
#include "boxwood/mesh/ply/ply_cursor.h"
#include "boxwood/mesh/ply/ply_rows.h"
#include "boxwood/mesh/text_chunks.h"
#include "boxwood/mesh/text_scanner.h"

namespace boxwood {

namespace {

constexpr std::size_t kBlock = 4096;  // items that are read at a time

struct Block {
    std::size_t first_byte = 0;
    std::size_t first_row = 0, rows = 0;
    PlyFaces faces;
};

class PlyBinaryReader {
public:
    explicit PlyBinaryReader(PlyBody& body) : body_(body), at_(body.header.bytes) {
        const PlyFormat native = std::endian::native == std::endian::little
                                     ? PlyFormat::binary_little_endian
                                     : PlyFormat::binary_big_endian;
        must_swap_ = body.header.format != native;
    }

    std::vector<PlyFaces> read() {
        check_size();
        body_.make_vertices();
        for (const PlyElement& element : body_.header.elements) {
            if (element.is_stored()) read_element(element);
        }
        if (at_ < body_.text.size())
            body_.mesh.warnings.add(kTrailingBytes, body_.name, fmt::format("byte {}", at_),
                                    fmt::format("found {} bytes, expected the end of the file",
                                                body_.text.size() - at_));
        return std::move(faces_);
    }

private:
    /// Before memory is spent.
    void check_size() const {
        std::size_t left = body_.text.size() - at_;
        for (const PlyElement& element : body_.header.elements) {
            if (!element.is_stored()) continue;
            const std::size_t size = element.least_size();
            if (element.count > left / size)
                throw ParseError(
                    body_.name, element.line,
                    fmt::format("the header promises {} of the element {}, at least {} bytes each, "
                                "but the file has {} for them",
                                element.count, boxwood::quoted(element.name), size, left));
            left -= element.count * size;
        }
    }

    void read_element(const PlyElement& element) {
        if (!element.has_lists()) {
            if (element.count > (body_.text.size() - at_) / element.least_size())
                fail_at_end(element);
            if (&element == body_.vertices) read_vertices();
            at_ += element.count * element.least_size();
        } else if (&element != body_.faces || !read_triangles()) {
            read_blocks(element);
        }
    }

    void read_vertices() {
        const std::size_t size = body_.vertices->least_size();
        const std::optional<std::size_t> positions = find_positions();
        parallel_for(body_.vertices->count, kBlock, [&](std::size_t begin, std::size_t end) {
            // Column by column of what a cache holds.
            constexpr std::size_t kStep = 256;
            for (; begin < end; begin += kStep)
                read_vertices(begin, std::min(begin + kStep, end), size, positions);
        });
    }

    /// The property x, when y and z of the same floating type follow.
    std::optional<std::size_t> find_positions() const {
        const std::vector<PlyColumn>& columns = body_.vertex_columns;
        const std::vector<PlyProperty>& properties = body_.vertices->properties;
        for (std::size_t i = 0; i + 2 < columns.size(); ++i) {
            bool is_found = is_floating(properties[i].type);
            for (std::size_t k = 0; k < 3; ++k)
                is_found = is_found && columns[i + k].role == PlyRole::position &&
                           columns[i + k].component == static_cast<int>(k) &&
                           properties[i + k].type == properties[i].type;
            if (is_found) return i;
        }
        return std::nullopt;
    }

    void read_vertices(std::size_t begin, std::size_t end, std::size_t size,
                       std::optional<std::size_t> positions) {
        const char* place = body_.text.data() + at_ + begin * size;
        for (std::size_t i = 0; i < body_.vertex_columns.size(); ++i) {
            const PlyColumn& column = body_.vertex_columns[i];
            const PlyType type = body_.vertices->properties[i].type;
            with_ply_type(type, [&](auto number) {
                using Number = decltype(number);
                if (i == positions) {
                    read_positions<Number>(place, begin, end, size);
                } else if (!positions || i < *positions || i > *positions + 2) {
                    const char* from = place;
                    for (std::size_t row = begin; row < end; ++row, from += size)
                        column.set(row, static_cast<double>(load_ply<Number>(from, must_swap_)));
                }
            });
            place += size_of(type);
        }
        // A sum keeps what isn't finite.
        Vec3d sum = Vec3d::Zero();
        for (std::size_t row = begin; row < end; ++row) sum += 0 * body_.mesh.vertices[row];
        if (!(sum.array() == 0).all()) body_.has_unfinite_vertices = true;
    }

    /// The three numbers of each at once.
    template <class Number>
    void read_positions(const char* from, std::size_t begin, std::size_t end, std::size_t size) {
        Vec3d* const vertices = body_.mesh.vertices.data();
        if (must_swap_) {
            for (std::size_t row = begin; row < end; ++row, from += size) {
                for (int k = 0; k < 3; ++k)
                    vertices[row][k] = static_cast<double>(load_ply<Number>(
                        from + static_cast<std::size_t>(k) * sizeof(Number), true));
            }
            return;
        }
        for (std::size_t row = begin; row < end; ++row, from += size) {
            Number numbers[3];
            std::memcpy(numbers, from, sizeof(numbers));
            for (int k = 0; k < 3; ++k) vertices[row][k] = static_cast<double>(numbers[k]);
        }
    }

    /// Reads the faces if they have no other lists and are triangles, with indices of 32 bits in
    /// range; else leaves them for those who can say what is wrong with them.
    bool read_triangles() {
        const PlyElement& element = *body_.faces;
        const PlyProperty& indices = element.properties[*body_.face_indices];
        const auto lists = std::count_if(element.properties.begin(), element.properties.end(),
                                         [](const PlyProperty& p) { return p.is_list; });
        if (lists != 1 || is_floating(indices.type) || size_of(indices.type) != 4) return false;
        const std::size_t size = element.least_size() + 3 * size_of(indices.type);
        if (element.count > (body_.text.size() - at_) / size) return false;

        std::size_t offset = 0;
        for (std::size_t i = 0; i < *body_.face_indices; ++i)
            offset += size_of(element.properties[i].type);
        resize_on_huge_pages(body_.mesh.faces, element.count);
        const bool are_triangles =
            size_of(indices.count_type) == 1   ? read_triangles<std::uint8_t>(offset, size)
            : size_of(indices.count_type) == 2 ? read_triangles<std::uint16_t>(offset, size)
                                               : read_triangles<std::uint32_t>(offset, size);
        if (!are_triangles) {
            body_.mesh.faces.clear();
            return false;
        }
        read_face_numbers(size);
        body_.has_faces = true;
        at_ += element.count * size;
        return true;
    }

    template <class Count>
    bool read_triangles(std::size_t offset, std::size_t size) {
        const char* first = body_.text.data() + at_ + offset;
        std::atomic<bool> are_triangles = true;
        parallel_for(body_.faces->count, kBlock, [&](std::size_t begin, std::size_t end) {
            const char* place = first + begin * size;
            if (!(must_swap_ ? read_triangles<Count, true>(place, size, begin, end)
                             : read_triangles<Count, false>(place, size, begin, end)))
                are_triangles = false;
        });
        return are_triangles;
    }

    template <class Count, bool must_swap>
    bool read_triangles(const char* place, std::size_t size, std::size_t begin, std::size_t end) {
        const auto vertices = static_cast<std::uint32_t>(body_.vertices->count);
        Vec3i* const faces = body_.mesh.faces.data();
        bool is_bad = false;
        for (std::size_t i = begin; i < end; ++i, place += size) {
            is_bad |= load_ply<Count>(place, must_swap) != 3;
            std::uint32_t corners[3];
            if constexpr (must_swap) {
                for (std::size_t k = 0; k < 3; ++k)
                    corners[k] = load_ply<std::uint32_t>(place + sizeof(Count) + 4 * k, true);
            } else {
                std::memcpy(corners, place + sizeof(Count), sizeof(corners));
            }
            // Negative ones are too large without their sign.
            is_bad |=
                (corners[0] >= vertices) | (corners[1] >= vertices) | (corners[2] >= vertices);
            std::memcpy(faces[i].data(), corners, sizeof(corners));
        }
        return !is_bad;
    }

    void read_face_numbers(std::size_t size) {
        const PlyElement& element = *body_.faces;
        bind_columns(body_.face_columns, element, ValuesOf::faces, element.count, body_.mesh);
        std::size_t offset = at_;
        for (std::size_t i = 0; i < body_.face_columns.size(); ++i) {
            const PlyProperty& property = element.properties[i];
            if (property.is_list) {
                offset += size_of(property.count_type) + 3 * size_of(property.type);
                continue;
            }
            with_ply_type(property.type, [&](auto number) {
                using Number = decltype(number);
                parallel_for(element.count, kBlock, [&](std::size_t begin, std::size_t end) {
                    for (std::size_t row = begin; row < end; ++row)
                        body_.face_columns[i].set(
                            row, static_cast<double>(load_ply<Number>(
                                     body_.text.data() + offset + row * size, must_swap_)));
                });
            });
            offset += size_of(property.type);
        }
    }

    void read_blocks(const PlyElement& element) {
        std::vector<Block> blocks = walk_along(element);
        if (!body_.is_needed(element)) return;
        for_each_chunk(blocks, [&](Block& block) {
            PlyBinaryCursor cursor(body_.text, block.first_byte, must_swap_, body_.name);
            PlyPolygon polygon;
            std::vector<int> indices;
            if (&element == body_.faces) block.faces.polygons.faces.reserve(block.rows);
            for (std::size_t i = 0; i < block.rows; ++i) {
                const std::size_t row = block.first_row + i;
                if (&element == body_.vertices) {
                    read_ply_vertex(cursor, body_, row);
                } else if (&element == body_.faces) {
                    read_ply_face(cursor, body_, row, polygon, block.faces);
                } else {
                    read_ply_strips(cursor, body_, row, indices, block.faces);
                }
            }
        });
        for (Block& block : blocks) faces_.push_back(std::move(block.faces));
    }

    std::vector<Block> walk_along(const PlyElement& element) {
        std::vector<Block> blocks;
        PlyBinaryCursor cursor(body_.text, at_, must_swap_, body_.name);
        for (std::size_t row = 0; row < element.count; ++row) {
            if (row % kBlock == 0) blocks.push_back({cursor.byte(), row, 0, {}});
            ++blocks.back().rows;
            for (const PlyProperty& property : element.properties) {
                if (property.is_list) {
                    cursor.skip_list(property);
                } else {
                    cursor.skip(property.type);
                }
            }
        }
        at_ = cursor.byte();
        return blocks;
    }

    [[noreturn]] void fail_at_end(const PlyElement& element) const {
        throw ParseError(body_.name, fmt::format("byte {}", at_),
                         fmt::format("found {} bytes for {} of the element {}, expected {} bytes "
                                     "each",
                                     body_.text.size() - at_, element.count,
                                     boxwood::quoted(element.name), element.least_size()));
    }

    PlyBody& body_;
    std::size_t at_;
    bool must_swap_ = false;
    std::vector<PlyFaces> faces_;
};

}  // namespace

std::vector<PlyFaces> read_ply_binary(PlyBody& body) { return PlyBinaryReader(body).read(); }

}  // namespace boxwood
