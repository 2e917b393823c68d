// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/tree/tree.h"

namespace boxwood {

/// Gives a tree its parents if it is deeper than kDeepestWithoutParents. For the end of a builder
/// that has no bound on the depth. O(n).
void add_parents(Tree& tree);

}  // namespace boxwood
