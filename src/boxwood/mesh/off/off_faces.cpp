// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/off/off_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/core/huge_pages.h"
#include "boxwood/mesh/reader_warnings.h"

namespace boxwood {

void OffFaces::end_face(const OffColor& color, std::size_t i, const OffPlace& place) {
    const std::size_t corners = std::exchange(corners_, 0);
    if (corners < 3) {
        placed_.leave(triangles_);
        warnings_.add_lazily(kFewCorners, *file_, [&] {
            return std::pair(
                place.text(),
                fmt::format("face {} has {} corners, expected at least 3", i, corners));
        });
        return;
    }
    if (corners > std::numeric_limits<std::uint32_t>::max()) {
        ++large_fans_;
    } else if (corners > 3) {
        fans_.push_back({triangles_.size() - (corners - 2), static_cast<std::uint32_t>(corners)});
    }
    add_color(color, i, place);
}

void OffFaces::add_color(const OffColor& color, std::size_t i, const OffPlace& place) {
    if (color.count > 0)
        color_warnings_.add_lazily("colours of faces, skipped", *file_, [&] {
            return std::pair(place.text(),
                             fmt::format("face {} has {} numbers for its colour, expected 3 or 4 "
                                         "for each face and none for vertices",
                                         i, color.count));
        });
    if (is_colored_ && color.is_rgb()) {
        warn_of_off_color(warnings_, *file_, color, place);
        colors_.resize(triangles_.size(), unscaled(color, largest_color_));
    } else if (is_colored_) {
        drop_colors();
    }
}

void OffFaces::drop_colors() {
    is_colored_ = false;
    std::vector<VertexColor>().swap(colors_);
}

void OffFaces::join(std::span<OffFaces* const> parts, const std::string& file, const Limits& limits,
                    MeshData& mesh) {
    std::size_t count = 0, large_fans = 0;
    bool is_colored = mesh.attributes.colors.is_empty();
    float largest_color = 0;
    std::vector<PolygonFan> fans;
    for (OffFaces* part : parts) {
        part->first_ = std::exchange(count, count + part->size());
        large_fans += part->large_fans_;
        is_colored &= part->is_colored_;
        largest_color = std::max(largest_color, part->largest_color_);
        for (const PolygonFan& fan : part->fans_)
            fans.push_back({part->first_ + fan.first_face, fan.corners});
        mesh.warnings.append(part->warnings_);
    }
    if (count > limits.max_faces)
        throw ParseError(
            file, "",
            fmt::format("found {} triangles, expected at most {}", count, limits.max_faces));

    const bool are_placed = std::all_of(
        parts.begin(), parts.end(), [](const OffFaces* part) { return part->placed_.is_placed(); });
    std::vector<Vec3i> faces;
    if (!are_placed) resize_on_huge_pages(faces, count);
    if (is_colored && count > 0) {
        mesh.attributes.colors.of = ValuesOf::faces;
        mesh.attributes.colors.values.resize(count);
    }
    parallel_for(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (OffFaces* part : parts.subspan(begin, end - begin)) {
            const auto first = static_cast<std::ptrdiff_t>(part->first_);
            if (!are_placed) {
                part->placed_.leave(part->triangles_);
                std::copy(part->triangles_.begin(), part->triangles_.end(), faces.begin() + first);
            }
            if (is_colored)
                std::copy(part->colors_.begin(), part->colors_.end(),
                          mesh.attributes.colors.values.begin() + first);
            std::vector<Vec3i>().swap(part->triangles_);
            std::vector<VertexColor>().swap(part->colors_);
        }
    });
    if (!are_placed) mesh.faces.swap(faces);
    if (is_colored) scale_off_colors(mesh.attributes.colors.values, largest_color);
    for (const OffFaces* part : parts) {
        if (!is_colored) mesh.warnings.append(part->color_warnings_);
    }

    large_fans += mend_fans(mesh.vertices, fans, mesh.faces);
    for (std::size_t i = 0; i < large_fans; ++i)
        mesh.warnings.add_lazily("polygons too large to look for a better cut", file, [&] {
            return std::pair(std::string(),
                             fmt::format("found a polygon of more than {} corners that isn't "
                                         "convex, expected fewer",
                                         kMostClippedCorners));
        });
}

}  // namespace boxwood
