// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/core/json_reader.h"
#include "boxwood/world/world.h"

namespace boxwood {

// Parts of a classic scene that readers of it share. All throw ParseError.

void check_classic_keys(const JsonReader& scene);
Camera read_classic_camera(const JsonReader& json);
Material read_classic_material(const JsonReader& json);
Light read_classic_light(const JsonReader& json);

enum class ClassicType { sphere, parallelogram, mesh };

/// The type of an object, which has the keys of that type and no others.
ClassicType classic_type(const JsonReader& object);

}  // namespace boxwood
