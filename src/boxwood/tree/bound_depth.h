// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/tree/tree.h"

namespace boxwood {

/// The same leaves in a tree that is at most max_depth + ceil(log2(leaves)) deep: below max_depth
/// the leaves are joined in balanced pairs, in their order. For trees that a bottom-up builder made
/// as deep as they have primitives. O(n).
Tree bound_depth(const Tree& tree, int max_depth);

}  // namespace boxwood
