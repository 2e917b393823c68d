// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "boxwood/core/box.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

/// Makes each box of the tree the smallest around the primitives below, whose boxes have changed.
/// Which primitive is in which leaf stays. Where a builder split primitives, boxes are around them
/// whole from now on. O(n). Precondition: as many boxes as primitives, a valid tree over them.
void refit(Tree& tree, std::span<const Box3f> boxes);

}  // namespace boxwood
