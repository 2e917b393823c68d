// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "boxwood/mesh/gltf/document.h"

namespace boxwood {

/// The numbers of a glTF accessor, element by element.
struct GltfNumbers {
    std::size_t components = 0;  ///< of an element
    std::vector<float> values;

    std::size_t count() const { return components > 0 ? values.size() / components : 0; }
};

/// Reads the accessor that a value names, of vectors with least to most components. Normalised
/// integers become -1 to 1 or 0 to 1, others floats of their value; sparse ones are filled in.
/// Throws ParseError.
GltfNumbers read_numbers(const GltfDocument& document, const JsonReader& named, std::size_t least,
                         std::size_t most);

/// Reads the accessor of indices that a value names. Throws ParseError, also when an index isn't
/// below the number of vertices.
std::vector<std::uint32_t> read_indices(const GltfDocument& document, const JsonReader& named,
                                        std::size_t vertices);

}  // namespace boxwood
