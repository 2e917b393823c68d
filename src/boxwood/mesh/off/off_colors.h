// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "boxwood/core/parallel.h"
#include "boxwood/core/warnings.h"
#include "boxwood/mesh/mesh_data.h"

namespace boxwood {

/// Where something stands in an OFF file: a line, or a byte of a binary one.
struct OffPlace {
    std::size_t number = 0;
    bool is_byte = false;

    std::string text() const { return (is_byte ? "byte " : "") + std::to_string(number); }
};

/// The numbers of a colour as a file has them: none, a colormap's index, or 3 or 4 of red, green,
/// blue and alpha.
struct OffColor {
    std::size_t count = 0;
    std::array<double, 4> numbers = {};

    bool is_rgb() const { return count == 3 || count == 4; }
    void add(double number) {
        if (count < numbers.size()) numbers[count] = number;
        ++count;
    }
    bool is_in_range() const {
        for (std::size_t i = 0; i < std::min(count, numbers.size()); ++i) {
            if (!(numbers[i] >= 0 && numbers[i] <= 255)) return false;
        }
        return true;
    }
};

// Whether colours reach to 1 or to 255 is known when all are: nothing reaches to 255 and stays
// below
// 2. Until then they are kept as they are, with this alpha for those that have none.
constexpr float kNoAlpha = -1;

/// The colour as it is kept until then, held to the range from 0 to 255; largest grows with it.
/// Precondition: is_rgb().
inline VertexColor unscaled(const OffColor& color, float& largest) {
    VertexColor result(0, 0, 0, kNoAlpha);
    for (std::size_t i = 0; i < color.count; ++i) {
        // In this order NaN becomes 0.
        const double number = std::min(std::max(0.0, color.numbers[i]), 255.0);
        result[static_cast<int>(i)] = static_cast<float>(number);
        largest = std::max(largest, result[static_cast<int>(i)]);
    }
    return result;
}

/// Makes colours that are kept so go from 0 to 1; largest is that of all of the file's.
inline void scale_off_colors(std::vector<VertexColor>& colors, float largest) {
    const float one = largest >= 2 ? 255 : 1;
    parallel_for(colors.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (colors[i][3] == kNoAlpha) colors[i][3] = one;
            colors[i] = (colors[i] / one).cwiseMin(1.0F);
        }
    });
}

inline void warn_of_off_color(Warnings& warnings, const std::string& file, const OffColor& color,
                              const OffPlace& place) {
    if (color.is_in_range()) return;
    warnings.add_lazily("colours beyond 0 to 255, held to that range", file, [&] {
        std::string found;
        for (std::size_t i = 0; i < color.count; ++i)
            found += (i > 0 ? " " : "") + std::to_string(color.numbers[i]);
        return std::pair(place.text(), "found the colour " + found + ", expected 0 to 255");
    });
}

}  // namespace boxwood
