// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/core/json_reader.h"
#include "boxwood/world/camera.h"
#include "boxwood/world/light.h"

namespace boxwood {

/// The camera of a scene file of version 2. Throws ParseError.
Camera read_description_camera(const JsonReader& json);

/// One of its lights. Throws ParseError.
Light read_description_light(const JsonReader& json);

}  // namespace boxwood
