// SPDX-License-Identifier: Apache-2.0
// Rings of vertices around a curve that winds twice around the axis of a torus while it winds three
// times around its core. The torus' normal gives the rings a frame that closes up without a twist.
#include <algorithm>
#include <cmath>

#include "boxwood/core/turns.h"
#include "boxwood/mesh/generate.h"

namespace boxwood {

namespace {

constexpr int kAroundAxis = 2, kAroundCore = 3;
constexpr double kTorus = 2, kCore = 1, kTube = 0.5;  ///< radii, before scaling to the cube
constexpr double kScale = 0.999 / (kTorus + kCore + kTube);
constexpr double kLengthToGirth = 10;  ///< the curve's length is about ten times around the tube

Vec3d normalized(const Vec3d& p) {
    // The order of the additions is written out: Eigen's depends on the instruction set.
    return p / std::sqrt(p.x() * p.x() + p.y() * p.y() + p.z() * p.z());
}

/// A ring of the tube: center + cos * normal + sin * binormal.
struct Frame {
    Vec3d center, normal, binormal;
};

Frame frame_at(double turn) {
    const double ca = cos_turns(kAroundAxis * turn), sa = sin_turns(kAroundAxis * turn);
    const double cc = cos_turns(kAroundCore * turn), sc = sin_turns(kAroundCore * turn);
    const double radius = kTorus + kCore * cc;
    const Vec3d outward(ca, sa, 0), forward(-sa, ca, 0), up(0, 0, 1);

    const Vec3d normal = cc * outward + sc * up;
    const Vec3d around_core = cc * up - sc * outward;
    const Vec3d tangent =
        normalized(kAroundAxis * radius * forward + kAroundCore * kCore * around_core);
    return {radius * outward + kCore * sc * up, normal, tangent.cross(normal)};
}

}  // namespace

TriangleMesh generate_torus_knot(std::size_t triangles) {
    const double quads = static_cast<double>(triangles) / 2;
    const int sides = std::max(3, static_cast<int>(std::round(std::sqrt(quads / kLengthToGirth))));
    const int rings = std::max(12, static_cast<int>(std::round(quads / sides)));

    TriangleMesh mesh;
    mesh.vertices.reserve(static_cast<std::size_t>(rings) * sides);
    mesh.faces.reserve(2 * mesh.vertices.capacity());
    for (int i = 0; i < rings; ++i) {
        const Frame frame = frame_at(static_cast<double>(i) / rings);
        for (int j = 0; j < sides; ++j) {
            const double angle = static_cast<double>(j) / sides;
            const Vec3d spoke = cos_turns(angle) * frame.normal + sin_turns(angle) * frame.binormal;
            mesh.vertices.push_back(kScale * (frame.center + kTube * spoke));
        }
    }
    const auto vertex = [&](int i, int j) { return i % rings * sides + j % sides; };
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < sides; ++j) {
            const int a = vertex(i, j), b = vertex(i + 1, j);
            const int c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
            mesh.faces.emplace_back(a, d, c);
            mesh.faces.emplace_back(a, c, b);
        }
    }
    return mesh;
}

}  // namespace boxwood
