// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/morton_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "build/hard_boxes.h"

namespace boxwood {
namespace {

std::vector<MortonKey> sorted(const std::vector<Box3f>& boxes,
                              void (*sort)(std::span<const Box3f>, std::span<MortonKey>,
                                           std::span<MortonKey>)) {
    std::vector<MortonKey> keys(boxes.size()), scratch(boxes.size());
    number_primitives(keys);
    sort(boxes, keys, scratch);
    return keys;
}

TEST(MortonOrder, codes_rise_and_equal_ones_go_by_primitive) {
    for (const auto& [name, boxes] : hard_boxes()) {
        const std::vector<MortonKey> keys = sorted(boxes, sort_by_morton_code);
        EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end())) << name;
    }
}

TEST(MortonOrder, codes_interleave_the_bits_of_the_cells) {
    const auto at = [](float x, float y, float z) { return Box3f{{x, y, z}, {x, y, z}}; };
    // In a cube of 1024 cells a side, one a unit.
    const std::vector<Box3f> boxes = {at(0, 0, 0),    at(1024, 1024, 1024), at(1.5f, 0, 0),
                                      at(0, 1.5f, 0), at(0, 0, 1.5f),       at(5.5f, 0, 3.5f)};
    std::vector<std::uint32_t> codes(boxes.size());
    for (const MortonKey key : sorted(boxes, sort_by_morton_code))
        codes[primitive_of(key)] = code_of(key);
    EXPECT_EQ(codes,
              (std::vector<std::uint32_t>{0, (1u << 30) - 1, 0b100, 0b010, 0b001, 0b100'001'101}));
}

TEST(MortonOrder, the_curve_visits_every_primitive_once) {
    for (const auto& [name, boxes] : hard_boxes()) {
        std::vector<std::uint32_t> primitives;
        for (const MortonKey key : sorted(boxes, sort_along_curve))
            primitives.push_back(primitive_of(key));
        std::sort(primitives.begin(), primitives.end());
        for (std::uint32_t i = 0; i < boxes.size(); ++i) ASSERT_EQ(primitives[i], i) << name;
    }
}

/// The order of those in the middle is the same whether others are far away or not.
TEST(MortonOrder, the_curve_goes_into_crowded_cells) {
    std::vector<Box3f> boxes = random_boxes(1000, 1);
    const auto order = [&] {
        std::vector<std::uint32_t> result;
        for (const MortonKey key : sorted(boxes, sort_along_curve))
            if (primitive_of(key) < 1000) result.push_back(primitive_of(key));
        return result;
    };
    const std::vector<std::uint32_t> alone = order();
    for (const float far : {1e5f, 1e9f, 1e20f}) boxes.push_back({{far, 0, 0}, {far, 0, 0}});
    EXPECT_EQ(order(), alone);
}

}  // namespace
}  // namespace boxwood
