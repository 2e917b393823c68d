// SPDX-License-Identifier: Apache-2.0
#include "views.h"

#include <algorithm>

namespace boxwood::bench {

namespace {

Camera camera(const Vec3d& from, const Vec3d& to, const Vec3d& up, double field_of_view) {
    Camera result;
    result.look_at(from, to, up);
    result.field_of_view = field_of_view;
    return result;
}

std::vector<Camera> views_around(const Vec3d& center, double radius) {
    std::vector<Camera> result;
    for (const Vec3d& from : {Vec3d(0.5, 0.4, 1), Vec3d(-0.8, 0.2, -0.4)})
        result.push_back(
            camera(center + 2 * radius * from.normalized(), center, Vec3d::UnitY(), 0.7854));
    return result;
}

/// Down the longer side of the hall, and across it.
std::vector<Camera> views_inside(const Box3d& bounds, int up_axis) {
    const Vec3d extent = bounds.extent();
    int across = (up_axis + 1) % 3, along = (up_axis + 2) % 3;
    if (extent[across] > extent[along]) std::swap(across, along);
    const auto place = [&](double a, double b, double height) {
        Vec3d result = bounds.centroid();
        result[along] += a * extent[along] / 2;
        result[across] += b * extent[across] / 2;
        result[up_axis] = bounds.lo[up_axis] + height * extent[up_axis];
        return result;
    };
    const Vec3d up = Vec3d::Unit(up_axis);
    return {camera(place(-0.7, 0.05, 0.25), place(0.8, 0, 0.25), up, 1.1),
            camera(place(0.1, -0.1, 0.5), place(-0.4, 0.9, 0.1), up, 1.1)};
}

/// The small thing in the middle, close by and from the stands.
std::vector<Camera> views_of_stadium() {
    const Vec3d middle(0, 0, 0.01), up = Vec3d::UnitZ();
    return {camera({0.05, -0.03, 0.04}, middle, up, 0.6), camera({0.5, 0.3, 0.25}, middle, up, 1)};
}

}  // namespace

std::vector<Camera> views_of(std::string_view mesh, const Box3d& bounds) {
    if (mesh.starts_with("interior")) return views_inside(bounds, 2);
    if (mesh.starts_with("atrium")) return views_inside(bounds, 1);
    if (mesh.starts_with("stadium")) return views_of_stadium();
    return views_around(bounds.centroid(), bounds.extent().norm() / 2);
}

}  // namespace boxwood::bench
