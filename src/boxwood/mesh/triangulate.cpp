// SPDX-License-Identifier: Apache-2.0
// An ear is a triangle of three neighbouring corners that holds no other corner. Every simple
// polygon has one; what is left without it is a simple polygon again. Only corners that point
// inwards can lie in an ear.
#include "boxwood/mesh/triangulate.h"

#include <atomic>
#include <cmath>

#include "boxwood/core/parallel.h"

namespace boxwood {

namespace {

/// Twice the signed area of a triangle.
double turn(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool holds(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& p) {
    if (p == a || p == b || p == c) return false;
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

/// The polygon as seen from where it turns counter-clockwise, along the axis that it faces most.
std::vector<Vec2d> flattened(std::span<const Vec3d> polygon) {
    Vec3d normal = Vec3d::Zero();  // by Newell's sum over the corners, relative to the first
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        normal += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const int x = (axis + (normal[axis] < 0 ? 2 : 1)) % 3;
    const int y = 3 - axis - x;
    std::vector<Vec2d> points;
    points.reserve(polygon.size());
    for (const Vec3d& p : polygon) points.emplace_back(p[x] - polygon[0][x], p[y] - polygon[0][y]);
    return points;
}

/// Whether each triangle of the fan turns the way the polygon does: then they cover it, side by
/// side. Unknown places can't be cut better.
bool is_covered_by_fan(std::span<const Vec2d> points) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        if (turn(points[0], points[i], points[i + 1]) < 0) return false;
    }
    return true;
}

class EarClipping {
public:
    explicit EarClipping(std::span<const Vec2d> points)
        : points_(points), before_(points.size()), after_(points.size()) {
        const int n = static_cast<int>(points.size());
        for (int i = 0; i < n; ++i) {
            before_[i] = (i + n - 1) % n;
            after_[i] = (i + 1) % n;
        }
        double sum = 0;
        for (int i = 0; i < n; ++i) {
            if (turn_at(i) <= 0) inward_.push_back(i);
            sum += std::abs(turn_at(i));
        }
        flat_ = 1e-12 * sum;
    }

    /// None when there are no more ears before the end: the polygon crosses itself.
    std::vector<Vec3i> triangles() {
        std::vector<Vec3i> result;
        int at = 0;
        for (std::size_t left = points_.size(); left > 3; --left) {
            at = next_ear(at, left);
            if (at < 0) return {};
            result.emplace_back(before_[at], at, after_[at]);
            after_[before_[at]] = after_[at];
            before_[after_[at]] = before_[at];
            std::erase_if(inward_, [&](int i) { return i == at || turn_at(i) > 0; });
            at = after_[at];
        }
        if (!(turn_at(at) >= -flat_)) return {};
        result.emplace_back(before_[at], at, after_[at]);
        return result;
    }

private:
    double turn_at(int i) const {
        return turn(points_[before_[i]], points_[i], points_[after_[i]]);
    }

    bool is_ear(int i) const {
        if (!(turn_at(i) > 0)) return false;
        for (const int other : inward_) {
            if (other != before_[i] && other != after_[i] &&
                holds(points_[before_[i]], points_[i], points_[after_[i]], points_[other]))
                return false;
        }
        return true;
    }

    /// The next one from a corner on; without any, a corner that covers no area, but for rounding,
    /// or -1.
    int next_ear(int from, std::size_t left) const {
        int at = from, flattest = from;
        for (std::size_t i = 0; i < left; ++i, at = after_[at]) {
            if (is_ear(at)) return at;
            if (std::abs(turn_at(at)) < std::abs(turn_at(flattest))) flattest = at;
        }
        return std::abs(turn_at(flattest)) <= flat_ ? flattest : -1;
    }

    std::span<const Vec2d> points_;
    std::vector<int> before_, after_;
    double flat_ = 0;          ///< turns of at most this are rounding
    std::vector<int> inward_;  ///< corners that turn the wrong way, or not at all
};

/// The triangles of a fan, from an array that has the polygon's corners in them.
void reorder(std::vector<Vec3i>& faces, const PolygonFan& fan, std::span<const Vec3i> triangles) {
    std::vector<int> corners = {faces[fan.first_face][0], faces[fan.first_face][1]};
    for (std::size_t i = 0; i + 2 < fan.corners; ++i)
        corners.push_back(faces[fan.first_face + i][2]);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k)
            faces[fan.first_face + i][k] = corners[static_cast<std::size_t>(triangles[i][k])];
    }
}

}  // namespace

std::size_t mend_fans(std::span<const Vec3d> vertices, std::span<const PolygonFan> fans,
                      std::vector<Vec3i>& faces, std::span<std::vector<Vec3i>* const> others) {
    std::atomic<std::size_t> unmended = 0;
    parallel_for(fans.size(), 1024, [&](std::size_t begin, std::size_t end) {
        std::vector<Vec3d> polygon;
        for (const PolygonFan& fan : fans.subspan(begin, end - begin)) {
            polygon = {vertices[faces[fan.first_face][0]], vertices[faces[fan.first_face][1]]};
            for (std::size_t i = 0; i + 2 < fan.corners; ++i)
                polygon.push_back(vertices[faces[fan.first_face + i][2]]);
            const std::vector<Vec2d> points = flattened(polygon);
            if (is_covered_by_fan(points)) continue;
            if (fan.corners > kMostClippedCorners) {
                ++unmended;
                continue;
            }
            const std::vector<Vec3i> triangles = EarClipping(points).triangles();
            if (triangles.empty()) continue;
            reorder(faces, fan, triangles);
            for (std::vector<Vec3i>* other : others) reorder(*other, fan, triangles);
        }
    });
    return unmended;
}

}  // namespace boxwood
