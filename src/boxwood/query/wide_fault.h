// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "boxwood/query/wide_tree.h"

namespace boxwood {

/// What could make a walk of these parts read outside of them, name a triangle that isn't there or
/// not end, one line for the first fault found; nothing when no walk can. Whether boxes and corners
/// are right, it can't tell without the mesh. O(n), all cores.
std::optional<std::string> find_fault(const WideTreeParts& parts);

}  // namespace boxwood
