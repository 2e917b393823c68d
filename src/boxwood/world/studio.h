// SPDX-License-Identifier: Apache-2.0
// What makes a good picture of objects that come without a camera or lights.
#pragma once

#include "boxwood/world/world.h"

namespace boxwood {

/// Which way is up for what a file holds.
enum class UpAxis { y, z };

/// Points the camera at all objects and spheres, three-quarter from the front and a little from
/// above, so that they fill the world's picture. O(n) in the vertices.
void frame(World& world, UpAxis up);

/// Light as in a photographer's studio, as the world's camera needs it: a bright one from the left
/// above, a dim one from the right, one from behind for the edges, and some from everywhere.
void light_studio(World& world, UpAxis up);

/// The picture that such objects want: shadows, smooth edges, colors encoded for screens.
PictureSettings studio_picture();

/// Clay, for a mesh of which nothing is known.
Material clay();

}  // namespace boxwood
