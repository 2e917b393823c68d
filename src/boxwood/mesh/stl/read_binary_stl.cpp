// SPDX-License-Identifier: Apache-2.0
// 80 bytes of anything, the count of triangles, and for each of them its normal and corners, 12
// floats, and an attribute of two bytes; the lower bytes first.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/core/huge_pages.h"
#include "boxwood/mesh/byte_order.h"
#include "boxwood/mesh/reader_warnings.h"
#include "boxwood/mesh/stl.h"
#include "boxwood/mesh/text_chunks.h"

namespace boxwood {

namespace {

constexpr std::size_t kHeaderBytes = 84, kTriangleBytes = 50;
constexpr std::size_t kPiece = 8192;

/// Some of the triangles.
struct Piece {
    std::size_t first = 0, last = 0;
    bool has_attributes = false;
    Warnings warnings = {};
};

class BinaryStlReader {
public:
    BinaryStlReader(const MeshSource& source, const Limits& limits)
        : name_(source.name()), bytes_(source.bytes), limits_(limits) {}

    MeshData read() {
        const std::size_t count = read_count();
        resize_on_huge_pages(mesh_.vertices, 3 * count);
        resize_on_huge_pages(mesh_.faces, count);
        std::vector<Piece> pieces;
        for (std::size_t first = 0; first < count; first += kPiece)
            pieces.push_back({.first = first, .last = std::min(count, first + kPiece)});
        for_each_chunk(pieces, [this](Piece& piece) { read_piece(piece); });

        bool has_attributes = false;
        for (const Piece& piece : pieces) {
            has_attributes |= piece.has_attributes;
            mesh_.warnings.append(piece.warnings);
        }
        if (has_attributes) read_attributes();
        const std::size_t end = kHeaderBytes + kTriangleBytes * count;
        if (end < bytes_.size())
            mesh_.warnings.add(
                kTrailingBytes, name_, byte(end),
                fmt::format("found {} bytes after the last triangle, expected the end of the file",
                            bytes_.size() - end));
        return std::move(mesh_);
    }

private:
    static std::string byte(std::size_t place) { return fmt::format("byte {}", place); }
    const char* triangle(std::size_t i) const {
        return bytes_.data() + kHeaderBytes + kTriangleBytes * i;
    }

    std::size_t read_count() const {
        if (bytes_.size() < kHeaderBytes)
            throw ParseError(name_, "byte 0",
                             fmt::format("found {} bytes and no text that begins with \"solid\", "
                                         "expected at least {} of a binary STL file",
                                         bytes_.size(), kHeaderBytes));
        const std::uint64_t count = little_uint32(bytes_.data() + 80);
        const std::uint64_t most = std::min(limits_.max_faces, limits_.max_vertices / 3);
        const std::uint64_t needed = kHeaderBytes + kTriangleBytes * count;
        if (needed > bytes_.size())
            throw ParseError(name_, "byte 80",
                             fmt::format("the header promises {} triangles, {} bytes, but the file "
                                         "has {}",
                                         count, needed, bytes_.size()));
        if (count > most)
            throw ParseError(name_, "byte 80",
                             fmt::format("found {} triangles, expected at most {}", count, most));
        // To some programs this is an empty mesh. But it is what is left of an export that broke
        // off before it wrote the count, and then all triangles would be dropped.
        if (count == 0 && bytes_.size() > kHeaderBytes)
            throw ParseError(name_, "byte 80",
                             fmt::format("the header promises 0 triangles, but {} bytes follow",
                                         bytes_.size() - kHeaderBytes));
        return count;
    }

    void read_piece(Piece& piece) {
        std::uint32_t attributes = 0;
        for (std::size_t i = piece.first; i < piece.last; ++i) {
            const char* bytes = triangle(i);
            std::array<float, 12> numbers;
            for (std::size_t k = 0; k < 12; ++k)
                numbers[k] = float_of_bits(little_uint32(bytes + 4 * k));
            Vec3d corners[3];
            for (std::size_t k = 0; k < 3; ++k) {
                corners[k] = Vec3f(&numbers[3 + 3 * k]).cast<double>();
                mesh_.vertices[3 * i + k] = corners[k];
            }
            const int first = static_cast<int>(3 * i);
            mesh_.faces[i] = {first, first + 1, first + 2};
            attributes |= little_uint16(bytes + 48);

            const Vec3d cross = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
            if (Vec3f(numbers.data()).cast<double>().dot(cross) < 0) warn_of_normal(piece, i);
            // Not finite when a corner isn't, and never beyond double.
            const Vec3d sum = corners[0] + corners[1] + corners[2];
            if (!std::isfinite(sum.x() + sum.y() + sum.z())) warn_of_corners(piece, i, corners);
        }
        piece.has_attributes = attributes != 0;
    }

    void warn_of_normal(Piece& piece, std::size_t i) const {
        piece.warnings.add_lazily("normals that point to the back of their triangles, ignored",
                                  name_, [&] {
                                      return std::pair(byte(kHeaderBytes + kTriangleBytes * i),
                                                       fmt::format("triangle {} turns clockwise as "
                                                                   "seen from where its normal "
                                                                   "points",
                                                                   i));
                                  });
    }

    void warn_of_corners(Piece& piece, std::size_t i, const Vec3d* corners) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d& corner = corners[k];
            if (corner.allFinite()) continue;
            piece.warnings.add_lazily(kNotFinite, name_, [&] {
                return std::pair(byte(kHeaderBytes + kTriangleBytes * i + 12 * (k + 1)),
                                 fmt::format("vertex {} is ({}, {}, {}), expected finite numbers",
                                             3 * i + k, corner.x(), corner.y(), corner.z()));
            });
        }
    }

    void read_attributes() {
        MeshField field{.name = "attribute", .of = ValuesOf::faces, .values = {}};
        field.values.resize(mesh_.faces.size());
        parallel_for(field.values.size(), kPiece, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                field.values[i] = little_uint16(triangle(i) + 48);
        });
        mesh_.attributes.fields.push_back(std::move(field));
    }

    std::string name_;
    std::string_view bytes_;
    Limits limits_;
    MeshData mesh_;
};

}  // namespace

MeshData parse_binary_stl(const MeshSource& source, const ReadOptions& options) {
    return BinaryStlReader(source, options.limits).read();
}

}  // namespace boxwood
