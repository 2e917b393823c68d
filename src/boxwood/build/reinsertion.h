// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/tree/tree.h"

namespace boxwood {

struct ReinsertionOptions {
    int rounds = 3;             ///< at most
    double largest_part = 0.1;  ///< of the nodes, by area, that each round looks at
    double least_gain = 5e-3;   ///< of the cost; a round that gains less is the last
};

/// Makes any valid tree cheaper: takes subtrees out and puts each back where the surface area
/// heuristic has it cost the least. Leaves stay as they are, so it works on split triangles too.
/// All cores, the same tree for any number of them. No deeper than before or than 80, whichever is
/// more. Time n times the depth at worst, about n in practice. Throws InvalidInput on options out
/// of range.
void optimize_by_reinsertion(Tree& tree, const ReinsertionOptions& options = {});

}  // namespace boxwood
