// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/core/vec.h"

namespace boxwood {

/// Linear RGB.
using Color = Vec3d;

}  // namespace boxwood
