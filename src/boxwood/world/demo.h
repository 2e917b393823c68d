// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "boxwood/world/world.h"

namespace boxwood {

/// A scene that needs no files: a gyroid, a torus knot and two balls, one of glass and one a
/// mirror, before a mountain range, all generated. Best seen with whitted, 16:9 and a few samples.
World make_demo_world(std::size_t triangles = 400'000);

}  // namespace boxwood
