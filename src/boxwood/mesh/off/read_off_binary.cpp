// SPDX-License-Identifier: Apache-2.0
// Binary OFF, as Geomview writes it: integers and floats of 32 bits, the higher bytes first. Three
// counts; for each vertex its coordinates, normal, colour of 4 numbers and texture coordinates; for
// each face the count of its corners, their indices, the count of its colour's numbers and those.
// Source: geomview.org/docs/html/OFF.html.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/mesh/byte_order.h"
#include "boxwood/mesh/off/off_body.h"
#include "boxwood/mesh/off/off_faces.h"
#include "boxwood/mesh/off/off_vertices.h"
#include "boxwood/mesh/reader_warnings.h"
#include "boxwood/mesh/text_chunks.h"

namespace boxwood {

namespace {

constexpr std::size_t kPiece = 8192;

/// Some of the vertices.
struct Piece {
    std::size_t first = 0, last = 0;
    OffVertices vertices = {};
};

class OffBinaryReader {
public:
    OffBinaryReader(const OffHeader& header, const MeshSource& source, std::string_view bytes,
                    const Limits& limits)
        : header_(header),
          name_(source.name()),
          bytes_(source.bytes),
          at_(source.bytes.size() - bytes.size()),
          limits_(limits) {}

    MeshData read() {
        read_counts();
        read_vertices();
        read_faces();
        if (at_ < bytes_.size())
            mesh_.warnings.add(
                kTrailingBytes, name_, place(),
                fmt::format("found {} bytes after the last face, expected the end of the file",
                            bytes_.size() - at_));
        return std::move(mesh_);
    }

private:
    std::size_t left() const { return bytes_.size() - at_; }
    std::string place() const { return fmt::format("byte {}", at_); }
    [[noreturn]] void fail(const std::string& message) const {
        throw ParseError(name_, place(), message);
    }

    std::int32_t integer(const char* what) {
        if (left() < 4) fail(fmt::format("the file ends, expected {}", what));
        at_ += 4;
        return static_cast<std::int32_t>(big_uint32(bytes_.data() + at_ - 4));
    }

    std::size_t count(const char* what, std::uint64_t most) {
        if (left() < 4) fail(fmt::format("the file ends, expected the count of {}", what));
        const std::int32_t found = integer(what);
        if (found >= 0 && static_cast<std::uint64_t>(found) <= most)
            return static_cast<std::size_t>(found);
        at_ -= 4;
        fail(fmt::format("found {} as the count of {}, expected 0 to {}", found, what, most));
    }

    void read_counts() {
        if (header_.has_dimension) {
            const std::int32_t dimension = integer("the dimension");
            if (dimension != 3) {
                at_ -= 4;
                fail(
                    fmt::format("found {} as the dimension, expected 3, for vertices of three "
                                "coordinates",
                                dimension));
            }
        }
        header_.vertices = count("vertices", limits_.max_vertices);
        header_.faces = count("faces", limits_.max_faces);
        integer("the count of edges");
    }

    std::size_t vertex_bytes() const {
        return 4 * (3 + std::size_t{header_.is_homogeneous} + 3 * header_.has_normals +
                    4 * header_.has_colors + 2 * header_.has_texture_coordinates);
    }

    void read_vertices() {
        const std::uint64_t needed = std::uint64_t{header_.vertices} * vertex_bytes();
        if (needed > left())
            fail(fmt::format("the header promises {} vertices, {} bytes, but the file has {}",
                             header_.vertices, needed, left()));
        resize_off_vertices(header_, mesh_);
        std::vector<Piece> pieces;
        for (std::size_t first = 0; first < header_.vertices; first += kPiece)
            pieces.push_back({.first = first, .last = std::min(header_.vertices, first + kPiece)});
        for_each_chunk(pieces, [this](Piece& piece) {
            for (std::size_t i = piece.first; i < piece.last; ++i) read_vertex(i, piece.vertices);
        });
        at_ += needed;

        float largest_color = 0;
        for (const Piece& piece : pieces) {
            mesh_.warnings.append(piece.vertices.warnings);
            largest_color = std::max(largest_color, piece.vertices.largest_color);
        }
        scale_off_colors(mesh_.attributes.colors.values, largest_color);
    }

    void read_vertex(std::size_t i, OffVertices& part) {
        const std::size_t begin = at_ + i * vertex_bytes();
        const char* bytes = bytes_.data() + begin;
        const auto next = [&] {
            return float_of_bits(big_uint32(std::exchange(bytes, bytes + 4)));
        };
        OffVertex vertex;
        for (double& x : vertex.position) x = next();
        if (header_.is_homogeneous) vertex.w = next();
        if (header_.has_normals)
            for (float& x : vertex.normal) x = next();
        if (header_.has_colors)
            for (int k = 0; k < 4; ++k) vertex.color.add(next());
        if (header_.has_texture_coordinates)
            for (float& x : vertex.texture_coordinates) x = next();
        set_off_vertex(header_, name_, vertex, i, {.number = begin, .is_byte = true}, mesh_, part);
    }

    void read_faces() {
        constexpr std::size_t kLeastFace = 8;
        const std::uint64_t needed = std::uint64_t{header_.faces} * kLeastFace;
        if (needed > left())
            fail(fmt::format("the header promises {} faces, at least {} bytes, but the file has {}",
                             header_.faces, needed, left()));
        OffFaces faces(name_);
        faces.reserve(header_.faces);
        for (std::size_t i = 0; i < header_.faces; ++i) read_face(i, faces);
        OffFaces* const parts[] = {&faces};
        OffFaces::join(parts, name_, limits_, mesh_);
    }

    void read_face(std::size_t i, OffFaces& faces) {
        const OffPlace begin = {.number = at_, .is_byte = true};
        const std::size_t corners = items(i, "corners");
        for (std::size_t k = 0; k < corners; ++k) {
            const std::int32_t index = integer("a vertex index");
            if (index < 0 || static_cast<std::size_t>(index) >= header_.vertices) {
                at_ -= 4;
                fail(fmt::format("face {} has vertex index {}, {}", i, index,
                                 header_.vertices > 0
                                     ? fmt::format("expected 0 to {}", header_.vertices - 1)
                                     : "but there are no vertices"));
            }
            faces.add_corner(index);
        }
        OffColor color;
        for (std::size_t k = items(i, "numbers of a colour"); k > 0; --k)
            color.add(float_of_bits(static_cast<std::uint32_t>(integer("a colour"))));
        faces.end_face(color, i, begin);
    }

    /// A count of numbers that follow it.
    std::size_t items(std::size_t face, const char* what) {
        if (left() < 4) fail(fmt::format("the file ends, expected the {} of face {}", what, face));
        const std::int32_t found = integer(what);
        if (found < 0 || static_cast<std::size_t>(found) > left() / 4) {
            at_ -= 4;
            fail(fmt::format("face {} has {} {}, expected 0 to {}, what the file has room for",
                             face, found, what, (left() - 4) / 4));
        }
        return static_cast<std::size_t>(found);
    }

    OffHeader header_;
    std::string name_;
    std::string_view bytes_;
    std::size_t at_;
    Limits limits_;
    MeshData mesh_;
};

}  // namespace

MeshData read_off_binary(OffHeader header, const MeshSource& source, std::string_view bytes,
                         const Limits& limits) {
    return OffBinaryReader(header, source, bytes, limits).read();
}

}  // namespace boxwood
