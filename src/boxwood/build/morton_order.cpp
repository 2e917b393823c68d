// SPDX-License-Identifier: Apache-2.0
// Source: Morton, "A Computer Oriented Geodetic Data Base and a New Technique in File Sequencing",
// IBM, 1966.
#include "boxwood/build/morton_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "boxwood/build/unit_scale.h"
#include "boxwood/core/parallel.h"
#include "boxwood/core/radix_sort.h"

namespace boxwood {

namespace {

constexpr std::size_t kPiece = 8192;

constexpr int kAxisBits = kMortonBits / 3;
constexpr int kCells = 1 << kAxisBits;  ///< along each axis

/// Three bits of the code for each bit of a coordinate: 0b101 becomes 0b001000001.
constexpr std::array<std::uint32_t, kCells> kSpread = [] {
    std::array<std::uint32_t, kCells> table = {};
    for (std::uint32_t cell = 0; cell < kCells; ++cell) {
        for (int bit = 0; bit < kAxisBits; ++bit) table[cell] |= (cell >> bit & 1) << 3 * bit;
    }
    return table;
}();

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
            Box3f bounds;
            for_each_key(boxes, keys.subspan(begin, end - begin), [&](MortonKey key) {
                const Vec3f centroid = boxes[primitive_of(key)].centroid();
                if (centroid.allFinite()) bounds.extend(centroid);
            });
            return bounds;
        },
        [](const Box3f& a, const Box3f& b) { return merged(a, b); });
}

/// A cube around centroids, cut into cells.
class MortonCube {
public:
    explicit MortonCube(const Box3f& centroid_bounds)
        : to_unit_(unit_scale(centroid_bounds)), lo_(to_unit_ * centroid_bounds.lo) {
        const float extent = (to_unit_ * centroid_bounds.hi - lo_).maxCoeff();
        if (extent > 0) cells_per_unit_ = kCells / extent;
    }

    /// The first cell's when the centroid is NaN, as those of boxes are that nothing hits.
    std::uint32_t code(const Vec3f& centroid) const {
        const Vec3f place = cells_per_unit_ * (to_unit_ * centroid - lo_);
        if (!std::isfinite(place.sum())) return 0;
        return spread(place.x()) << 2 | spread(place.y()) << 1 | spread(place.z());
    }

private:
    static std::uint32_t spread(float place) {
        return kSpread[static_cast<std::size_t>(std::min(static_cast<int>(place), kCells - 1))];
    }

    float to_unit_;
    Vec3f lo_;
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
        for_each_key(boxes, keys.subspan(begin, end - begin), [&](MortonKey& key) {
            const std::uint32_t primitive = primitive_of(key);
            key = morton_key(cube.code(boxes[primitive].centroid()), primitive);
        });
    });
    radix_sort(keys, scratch, 32, kMortonBits);
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
