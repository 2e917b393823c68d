// SPDX-License-Identifier: Apache-2.0
// Source: Morton, "A Computer Oriented Geodetic Data Base and a New Technique in File Sequencing",
// IBM, 1966.
#include "boxwood/build/morton_order.h"

#include <algorithm>
#include <cstddef>

#include "boxwood/build/unit_scale.h"
#include "boxwood/core/parallel.h"
#include "boxwood/core/radix_sort.h"
#include "boxwood/core/vector_box.h"

namespace boxwood {

namespace {

constexpr std::size_t kPiece = 8192;

constexpr int kAxisBits = kMortonBits / 3;
constexpr int kCells = 1 << kAxisBits;  ///< along each axis

/// Three bits for each of the ten bits of a coordinate: 0b101 becomes 0b001000001.
Int4 spread(Int4 cell) {
    cell = (cell | cell << 16) & 0x030000ff;
    cell = (cell | cell << 8) & 0x0300f00f;
    cell = (cell | cell << 4) & 0x030c30c3;
    return (cell | cell << 2) & 0x09249249;
}

/// Calls visit(key) for each of the given ones, whose boxes are asked for early: they may lie
/// anywhere, and where they follow one another, machines that look ahead stop where a page ends.
template <class Keys, class Visit>
void for_each_key(std::span<const Box3f> boxes, Keys keys, const Visit& visit) {
    constexpr std::size_t kAhead = 32;
    const std::size_t last = keys.size() - 1;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        __builtin_prefetch(&boxes[primitive_of(keys[std::min(i + kAhead, last)])]);
        visit(keys[i]);
    }
}

Box3f bounds_of_centroids(std::span<const Box3f> boxes, std::span<const MortonKey> keys) {
    return parallel_reduce(
        keys.size(), kPiece, Box3f{},
        [&](std::size_t begin, std::size_t end) {
            VectorBox bounds;
            for_each_key(boxes, keys.subspan(begin, end - begin), [&](MortonKey key) {
                const Float4 centroid = VectorBox(boxes[primitive_of(key)]).centroid();
                if (is_finite(centroid)) bounds.extend({centroid, centroid});
            });
            return bounds.box();
        },
        [](const Box3f& a, const Box3f& b) { return merged(a, b); });
}

/// A cube around centroids, cut into cells.
class MortonCube {
public:
    explicit MortonCube(const Box3f& centroid_bounds)
        : to_unit_(unit_scale(centroid_bounds)), lo_(to_unit_ * VectorBox(centroid_bounds).lo) {
        const Vec3f extent = to_unit_ * centroid_bounds.hi - to_unit_ * centroid_bounds.lo;
        if (extent.maxCoeff() > 0) cells_per_unit_ = kCells / extent.maxCoeff();
    }

    /// The first cell's when the centroid is NaN, as those of boxes are that nothing hits.
    std::uint32_t code(const VectorBox& box) const {
        const Float4 place = cells_per_unit_ * (to_unit_ * box.centroid() - lo_);
        if (!is_finite(place)) return 0;
        constexpr float kLast = kCells - 1;
        const Int4 bits =
            spread(__builtin_convertvector(place < kLast ? place : Float4{} + kLast, Int4));
        return static_cast<std::uint32_t>(bits[0] << 2 | bits[1] << 1 | bits[3]);
    }

private:
    float to_unit_;
    Float4 lo_;
    float cells_per_unit_ = 0;
};

}  // namespace

void number_primitives(std::span<MortonKey> keys) {
    parallel_for(keys.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            keys[i] = morton_key(0, static_cast<std::uint32_t>(i));
    });
}

void sort_by_morton_code(std::span<const Box3f> boxes, std::span<MortonKey> keys,
                         std::span<MortonKey> scratch) {
    const MortonCube cube(bounds_of_centroids(boxes, keys));
    parallel_for(keys.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        auto place = scratch.begin() + static_cast<std::ptrdiff_t>(begin);
        for_each_key(boxes, keys.subspan(begin, end - begin), [&](MortonKey key) {
            const std::uint32_t primitive = primitive_of(key);
            *place++ = morton_key(cube.code(VectorBox(boxes[primitive])), primitive);
        });
    });
    radix_sort(scratch.first(keys.size()), keys, 32, kMortonBits);
}

void sort_along_curve(std::span<const Box3f> boxes, std::span<MortonKey> keys,
                      std::span<MortonKey> scratch) {
    constexpr std::size_t kMany = 16;
    sort_by_morton_code(boxes, keys, scratch);
    for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
        while (end < keys.size() && code_of(keys[end]) == code_of(keys[begin])) ++end;
        // A cell of its own is a thousandth as wide, which ends within the range of float. When it
        // holds all of them, there is but one centroid.
        if (end - begin > kMany && end - begin < keys.size())
            sort_along_curve(boxes, keys.subspan(begin, end - begin), scratch);
    }
}

}  // namespace boxwood
