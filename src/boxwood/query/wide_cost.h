// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace boxwood {

// What a visit costs, to a node and to a leaf, as measured. The cost of a tree sums them up, each
// weighed by the surface area of its box, which is the chance that a random line comes by.
constexpr float kNodeCost = 1;
constexpr float kBlockCost = 0.8f;

}  // namespace boxwood
