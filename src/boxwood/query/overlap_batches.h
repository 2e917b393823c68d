// SPDX-License-Identifier: Apache-2.0
// Batches of overlaps, on a mesh or in a scene.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "boxwood/core/batch.h"
#include "boxwood/query/overlaps.h"

namespace boxwood {

/// Shapes between two looks at whether to go on.
constexpr std::size_t kShapesOfPiece = 64;

/// What one(shape) finds, a vector of ids, for each shape, in order and on all cores.
template <class Id, class Shape, class One>
TriangleLists<Id> overlaps_of_all(std::span<const Shape> shapes, const BatchOptions& options,
                                  const One& one) {
    std::vector<std::vector<Id>> found(shapes.size());
    for_each_piece(shapes.size(), kShapesOfPiece, options, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) found[i] = one(shapes[i]);
    });
    TriangleLists<Id> lists;
    lists.offsets.reserve(shapes.size() + 1);
    for (const auto& list : found) lists.offsets.push_back(lists.offsets.back() + list.size());
    lists.triangles.reserve(lists.offsets.back());
    for (const auto& list : found)
        lists.triangles.insert(lists.triangles.end(), list.begin(), list.end());
    return lists;
}

}  // namespace boxwood
