// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "boxwood/core/limits.h"
#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/off/off_colors.h"
#include "boxwood/mesh/plain_faces.h"
#include "boxwood/mesh/triangulate.h"

namespace boxwood {

/// The faces of a part of an OFF file.
class OffFaces {
public:
    /// The file's name is kept by reference.
    explicit OffFaces(const std::string& file) : file_(&file) {}

    /// Lets its triangles be put into these places, of all its faces, if all are plain triangles.
    void set_places(std::span<Vec3i> places) { placed_ = PlacedFaces(places); }

    /// Reads triangles that have no colour from plain lines, at most so many; how many.
    std::size_t read_plain(TextScanner& scanner, std::size_t vertices, std::size_t most) {
        const std::size_t count = placed_.read(scanner, vertices, most, triangles_);
        if (is_colored_ && count > 0) drop_colors();
        return count;
    }
    /// Adds a corner to the face that is being read, which becomes a fan around the first.
    void add_corner(int index) {
        fan_[corners_ < 2 ? static_cast<int>(corners_) : 2] = index;
        if (++corners_ < 3) return;
        placed_.leave(triangles_);
        triangles_.push_back(fan_);
        fan_[1] = fan_[2];
    }
    /// Ends that face, the i-th of the file. One of fewer than three corners is skipped.
    void end_face(const OffColor& color, std::size_t i, const OffPlace& place);

    std::size_t size() const { return placed_.placed() + triangles_.size(); }
    void reserve(std::size_t triangles) { triangles_.reserve(triangles); }

    /// Puts the faces of all parts into the mesh, with their colours and warnings, and empties the
    /// parts. Vertices and their colours must be there; if parts have been given places, these are
    /// the mesh's faces, each part's behind those before it. Throws ParseError when there are more
    /// triangles than the limits allow.
    static void join(std::span<OffFaces* const> parts, const std::string& file,
                     const Limits& limits, MeshData& mesh);

private:
    void drop_colors();
    void add_color(const OffColor& color, std::size_t i, const OffPlace& place);

    const std::string* file_;
    PlacedFaces placed_;
    std::vector<Vec3i> triangles_;
    std::vector<PolygonFan> fans_;
    std::size_t large_fans_ = 0;
    Vec3i fan_ = Vec3i::Zero();
    std::size_t corners_ = 0;
    std::vector<VertexColor> colors_;  ///< one a triangle, while every face has had one
    bool is_colored_ = true;
    float largest_color_ = 0;
    Warnings warnings_;
    Warnings color_warnings_;  ///< for when the colours of faces are skipped
    std::size_t first_ = 0;    ///< where its triangles go
};

}  // namespace boxwood
