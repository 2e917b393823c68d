// SPDX-License-Identifier: Apache-2.0
// Every file of ./dev data holds the triangles that assimp finds in it, or it is told here why not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <string>

#include "boxwood/core/error.h"
#include "boxwood/mesh/mesh_file.h"
#include "differential/assimp_mesh.h"
#include "differential/exceptions.h"

namespace boxwood {
namespace {

namespace fs = std::filesystem;

std::vector<Corners> triangles_of(MeshView mesh) {
    std::vector<Corners> result(mesh.faces.size());
    for (std::size_t f = 0; f < result.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const Vec3f p = mesh.corner(f, k).cast<float>();
            result[f][static_cast<std::size_t>(k)] = {p.x(), p.y(), p.z()};
        }
    }
    return result;
}

double size_of(const std::vector<Corners>& triangles) {
    float size = 0;
    for (const Corners& triangle : triangles)
        for (const auto& p : triangle)
            for (const float x : p)
                if (std::isfinite(x)) size = std::max(size, std::abs(x));
    return size;
}

double area_of(const std::vector<Corners>& triangles) {
    double sum = 0;
    for (const Corners& t : triangles) {
        const auto point = [&](std::size_t k) { return Vec3d(t[k][0], t[k][1], t[k][2]); };
        const double area = (point(1) - point(0)).cross(point(2) - point(0)).norm() / 2;
        if (std::isfinite(area)) sum += area;
    }
    return sum;
}

/// On a grid about as fine as floats are, in an order that doesn't depend on the file's.
using Place = std::array<std::int64_t, 3>;
std::vector<std::array<Place, 3>> sorted(const std::vector<Corners>& triangles, double step) {
    std::vector<std::array<Place, 3>> result;
    for (const Corners& triangle : triangles) {
        std::array<Place, 3> places;
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const float x = triangle[k][axis];
                places[k][axis] = std::isfinite(x) ? std::llround(x / step) : INT64_MAX;
            }
        std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
        result.push_back(places);
    }
    std::sort(result.begin(), result.end());
    return result;
}

/// How many of the triangles aren't among the others.
std::size_t count_missing(const std::vector<Corners>& a, const std::vector<Corners>& b) {
    const double step = std::max(size_of(a), size_of(b)) * 1e-6 + 1e-30;
    const auto ours = sorted(a, step), theirs = sorted(b, step);
    std::vector<std::array<Place, 3>> left;
    std::set_difference(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                        std::back_inserter(left));
    return left.size();
}

/// "same", or in a word and numbers what differs.
std::string comparison(const fs::path& file) {
    const AssimpMesh theirs = read_by_assimp(file);
    MeshData ours;
    try {
        ours = read_mesh(file);
    } catch (const Error& error) {
        return theirs.error.empty() ? std::string("only assimp reads it: ") + error.what()
                                    : "neither reads it";
    }
    if (!theirs.error.empty()) return "only Boxwood reads it; assimp " + theirs.error;
    const std::vector<Corners> mine = triangles_of(ours);
    if (mine.size() != theirs.triangles.size())
        return "triangles: " + std::to_string(mine.size()) + " and " +
               std::to_string(theirs.triangles.size());
    const std::size_t missing = count_missing(mine, theirs.triangles);
    if (missing == 0) return "same";
    // Both may be right about a polygon.
    const double area = area_of(mine), their_area = area_of(theirs.triangles);
    return (std::abs(area - their_area) <= 1e-5 * area ? "same area, other triangles: "
                                                       : "other area and triangles: ") +
           std::to_string(missing) + " of " + std::to_string(mine.size());
}

bool is_mesh(const fs::path& file) {
    try {
        mesh_format_of(file);
        return true;
    } catch (const InvalidInput&) {
        return false;
    }
}

class Differential : public testing::TestWithParam<const char*> {};

TEST_P(Differential, files_hold_the_triangles_that_assimp_finds) {
    const fs::path data = BOXWOOD_DATA_DIR, folder = data / GetParam();
    if (!fs::exists(folder)) GTEST_SKIP() << "no " << folder << "; ./dev data brings it";
    std::map<std::string, int> kinds;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file() || !is_mesh(entry.path())) continue;
        const std::string name = fs::relative(entry.path(), data).generic_string();
        const std::string_view expected = expected_difference(name);
        const std::string found = comparison(entry.path());
        EXPECT_TRUE(found.starts_with(expected)) << name << ": " << found;
        ++kinds[expected == "same" ? "the same" : "explained"];
    }
    for (const auto& [kind, count] : kinds) RecordProperty(kind, count);
}

INSTANTIATE_TEST_SUITE_P(All, Differential, testing::Values("assimp", "cgal"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace boxwood
