// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/build/build.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {

inline WideTree tree_over(const TriangleMesh& mesh) { return {mesh, build_tree(mesh)}; }

}  // namespace boxwood
