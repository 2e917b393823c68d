// SPDX-License-Identifier: Apache-2.0
// In which order a batch takes its rays. Those of a camera mostly come row by row; side by side in
// tiles they have more in common, which makes them twice as fast. So rows are looked for, by the
// jump that directions make from the end of one to the start of the next. Answers don't depend on
// the order.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace boxwood {

/// The length of the rows, or 0 where the rays are too few, don't start at one point, or don't look
/// like rows. ray_at(i) gives the i-th of `count` rays, in float or double. It is called about
/// twice as often as a row is long, and a few times where there are none.
template <class RayAt>
std::size_t row_length(std::size_t count, const RayAt& ray_at) {
    constexpr std::size_t kFewest = 8192, kShortest = 32, kLongest = std::size_t{1} << 16;
    constexpr float kJump = 8;  ///< in steps from ray to ray
    if (count < kFewest) return 0;
    const auto first = ray_at(0);
    const auto starts_there = [&](const auto& ray) {
        return ray.origin[0] == first.origin[0] && ray.origin[1] == first.origin[1] &&
               ray.origin[2] == first.origin[2];
    };
    const auto apart = [&](std::size_t i, std::size_t j) {
        const auto a = ray_at(i), b = ray_at(j);
        const auto x = a.direction[0] - b.direction[0], y = a.direction[1] - b.direction[1],
                   z = a.direction[2] - b.direction[2];
        return static_cast<float>(std::sqrt(x * x + y * y + z * z));
    };
    if (!starts_there(ray_at(count / 2)) || !starts_there(ray_at(count - 1))) return 0;

    float step = 0;
    for (std::size_t i = 1; i < 8; ++i) step = std::fmax(step, apart(i - 1, i));
    // A row goes somewhere.
    if (!(step > 0) || !(apart(0, kShortest - 1) > kJump * step)) return 0;
    std::size_t length = 8;
    while (length < count && length <= kLongest && apart(length - 1, length) <= kJump * step)
        ++length;
    if (length < kShortest || length > kLongest || 2 * length > count) return 0;

    // Rows are neighbours, and there is one after another.
    const std::size_t rows = count / length;
    for (const std::size_t row : {std::size_t{1}, rows / 2, rows - 1}) {
        const std::size_t start = row * length;
        if (apart(start - length, start) > kJump * step ||
            apart(start - 1, start) <= kJump * step ||
            apart(start + length / 2, start + length / 2 + 1) > kJump * step)
            return 0;
    }
    return length;
}

/// A ray's place in the batch, from the first of its piece on, and the one that it takes in the
/// piece.
struct RayPlace {
    std::uint32_t in_batch, in_piece;
};

/// The order: tile by tile of rows, piece by piece.
class RayOrder {
public:
    static constexpr std::size_t kPiece = 4096;            ///< rays of a piece
    static constexpr std::size_t kTile = 16;               ///< rows and columns of a tile
    static constexpr std::size_t kWidth = kPiece / kTile;  ///< of a piece of tiles

    /// Some rays of some rows, side by side; of the last row maybe fewer.
    struct Shape {
        std::size_t row_length = 0, width = 0, size = 0;
        bool operator==(const Shape&) const = default;
    };

    /// Precondition: row_length > 0.
    RayOrder(std::size_t count, std::size_t row_length)
        : count_(count),
          row_length_(row_length),
          pieces_per_row_((row_length + kWidth - 1) / kWidth) {}

    std::size_t pieces() const {
        const std::size_t rows = (count_ + row_length_ - 1) / row_length_;
        return pieces_per_row_ * ((rows + kTile - 1) / kTile);
    }
    /// The first ray of a piece.
    std::size_t first(std::size_t piece) const {
        return piece / pieces_per_row_ * kTile * row_length_ + piece % pieces_per_row_ * kWidth;
    }
    Shape shape(std::size_t piece) const {
        const std::size_t begin = first(piece);
        const std::size_t left = begin % row_length_;
        Shape shape = {row_length_, std::min(kWidth, row_length_ - left), 0};
        for (std::size_t y = 0; y < kTile; ++y) {
            const std::size_t row = begin + y * row_length_;
            if (row < count_) shape.size += std::min(shape.width, count_ - row);
        }
        return shape;
    }

    /// Writes the places of a piece's rays. They come in the order in which they stand in the
    /// batch, so that memory is read as it lies.
    static void write_places(const Shape& shape, std::vector<RayPlace>& places) {
        const std::size_t rows = shape.size / shape.width, rest = shape.size % shape.width;
        const auto width_of = [&](std::size_t y) {
            return y < rows ? shape.width : y == rows ? rest : 0;
        };
        // Tile by tile, in each by its Morton code: groups of 64 or 256 rays are squares.
        std::array<std::uint32_t, kPiece> in_piece;
        std::uint32_t next = 0;
        for (std::size_t tile = 0; tile < shape.width; tile += kTile) {
            for (std::size_t code = 0; code < kTile * kTile; ++code) {
                const std::size_t x = tile + every_second_bit(code),
                                  y = every_second_bit(code >> 1);
                if (x < width_of(y)) in_piece[y * kWidth + x] = next++;
            }
        }
        places.clear();
        for (std::size_t y = 0; y < kTile; ++y) {
            for (std::size_t x = 0; x < width_of(y); ++x)
                places.push_back({static_cast<std::uint32_t>(y * shape.row_length + x),
                                  in_piece[y * kWidth + x]});
        }
    }

private:
    /// Bits 0, 2, 4 and 6 of a Morton code, moved together.
    static constexpr std::size_t every_second_bit(std::size_t code) {
        return (code & 1) | (code >> 1 & 2) | (code >> 2 & 4) | (code >> 3 & 8);
    }

    std::size_t count_, row_length_, pieces_per_row_;
};

/// The rays and hits of a piece. One serves many pieces, so that memory is asked for once, and most
/// pieces have one of two shapes: whole, or cut off at the end of the rows.
template <class Ray, class Hit>
struct RayPiece {
    std::vector<Ray> rays;
    std::vector<Hit> hits;  ///< as many as rays

    template <class RayAt>
    void take(const RayOrder& order, std::size_t piece, const RayAt& ray_at) {
        first_ = order.first(piece);
        const RayOrder::Shape shape = order.shape(piece);
        is_whole_ = shape.width == RayOrder::kWidth;
        Tiles& tiles = tiles_[is_whole_];
        if (tiles.shape != shape) {
            tiles.shape = shape;
            RayOrder::write_places(shape, tiles.places);
        }
        rays.resize(shape.size);
        hits.resize(shape.size);
        for_each(
            [&](std::size_t in_batch, std::size_t in_piece) { rays[in_piece] = ray_at(in_batch); });
    }

    /// Calls visit(place in the batch, place in the piece) for each ray.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (const RayPlace& place : tiles_[is_whole_].places)
            visit(first_ + place.in_batch, place.in_piece);
    }

private:
    struct Tiles {
        RayOrder::Shape shape;
        std::vector<RayPlace> places;
    };

    std::size_t first_ = 0;
    Tiles tiles_[2];
    bool is_whole_ = false;
};

}  // namespace boxwood
