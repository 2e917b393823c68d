// SPDX-License-Identifier: Apache-2.0
// The "teapot in a stadium" of the literature: a hall of few large triangles, rings of steps and
// beams that are long and thin, and in the middle of it a small thing that has nearly all the
// triangles. Trees that split space or cut boxes in half waste their levels on the way there.
#include <algorithm>
#include <cmath>

#include "boxwood/core/turns.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/patches.h"

namespace boxwood {

namespace {

constexpr double kTeapot = 0.015;  ///< its radius; the stadium's is 1

/// Terraces: a step forward, a step up, all the way around an oval.
Patch terraces(int columns, int steps) {
    return {columns, 2 * steps, [steps](double u, double v) -> Vec3d {
                const int edge = static_cast<int>(std::round(2 * steps * v));
                const int forward = (edge + 1) / 2, up = edge / 2;
                const double run = static_cast<double>(forward) / steps;
                const double rise = static_cast<double>(up) / steps;
                const double turn = u == 1 ? 0 : u;
                // The front looks inward and up.
                return {(0.45 + 0.53 * run) * cos_turns(-turn),
                        (0.33 + 0.5 * run) * sin_turns(-turn),
                        0.03 + 0.3 * rise * (0.6 + 0.4 * run)};
            }};
}

void add_field(int columns, std::vector<Patch>& patches) {
    // From a small hole under the teapot to below the terraces, flat.
    patches.push_back({columns, 1, [](double u, double v) -> Vec3d {
                           const double turn = u == 1 ? 0 : u;
                           return {(0.005 + 0.46 * v) * cos_turns(-turn),
                                   (0.005 + 0.34 * v) * sin_turns(-turn), 0};
                       }});
    // The wall before the first row.
    patches.push_back(
        {columns, 1, [](double u, double v) -> Vec3d {
             const double turn = u == 1 ? 0 : u;
             return {0.45 * cos_turns(-turn), 0.33 * sin_turns(-turn), -0.001 + 0.036 * v};
         }});
}

/// Thin girders from the rim toward the middle, and posts that carry them.
void add_roof(int girders, std::vector<Patch>& patches) {
    for (int i = 0; i < girders; ++i) {
        const double turn = static_cast<double>(i) / girders;
        const Vec3d outward(cos_turns(turn), sin_turns(turn), 0);
        const Vec3d across(-outward.y(), outward.x(), 0);
        const Vec3d rim = outward.cwiseProduct(Vec3d(0.97, 0.84, 0));
        const Vec3d inner = outward.cwiseProduct(Vec3d(0.5, 0.38, 0)) + Vec3d(0, 0, 0.55);
        const Vec3d top = rim + Vec3d(0, 0, 0.48);
        add_box(inner, top - inner, 0.004 * across, Vec3d(0, 0, 0.012), patches);
        add_box(rim - Vec3d(0, 0, 0.02), 0.008 * outward, 0.008 * across, Vec3d(0, 0, 0.49),
                patches);
    }
}

Vec2d body_profile(double v) {
    // An ellipse that bulges below the middle, open above and below.
    const double turn = 0.02 + 0.43 * v;
    return {kTeapot * sin_turns(turn) * (1.1 - 0.25 * v),
            kTeapot * (0.62 - 0.62 * cos_turns(turn))};
}

Vec2d lid_profile(double v) {
    const double knob = 1 / (1 + 300 * (v - 0.86) * (v - 0.86));
    return {kTeapot * (0.02 + 0.36 * (1 - v) * (1 - v) + 0.1 * knob), kTeapot * (1.18 + 0.36 * v)};
}

void add_teapot(double detail, std::vector<Patch>& patches) {
    const auto cut = [&](double scale, int least, double phase) {
        return pieces(detail, scale, least, phase);
    };
    patches.push_back(turned_patch({0, 0, 0}, cut(4, 8, 0.3), cut(2, 5, 0.8), body_profile));
    patches.push_back(turned_patch({0, 0, 0}, cut(3, 8, 0.1), cut(1, 4, 0.6), lid_profile));
    // The handle: a half ring behind the body. The spout: a tapering arm before it.
    patches.push_back(tube_patch(
        cut(1, 5, 0.5), cut(2, 6, 0.2),
        [](double v) -> Vec3d {
            const double turn = 0.2 + 0.6 * v;
            return kTeapot * Vec3d(-0.85 + 0.5 * cos_turns(turn), 0, 0.68 + 0.42 * sin_turns(turn));
        },
        [](double v) -> Vec3d {
            const double turn = 0.2 + 0.6 * v;
            return {cos_turns(turn), 0, sin_turns(turn)};
        },
        Vec3d::UnitY(), [](double) { return 0.09 * kTeapot; }));
    patches.push_back(tube_patch(
        cut(1, 5, 0.9), cut(1.5, 5, 0.4),
        [](double v) -> Vec3d { return kTeapot * Vec3d(0.7 + 0.9 * v, 0, 0.4 + 0.7 * v * v); },
        [](double v) -> Vec3d { return Vec3d(1.4 * v, 0, -0.9) / std::sqrt(0.81 + 1.96 * v * v); },
        Vec3d::UnitY(), [](double v) { return kTeapot * (0.26 - 0.16 * v); }));
}

}  // namespace

TriangleMesh generate_stadium(std::size_t triangles) {
    // The hall has at most 12,000 triangles and never more than half of them.
    const double share = std::min(1.0, static_cast<double>(triangles) / 24'000);
    const int around = std::max(12, static_cast<int>(72 * std::sqrt(share)));
    const int steps = std::max(3, static_cast<int>(30 * std::sqrt(share)));
    const int girders = std::max(3, static_cast<int>(64 * share));
    return tessellated(with_triangles(
        [&](double detail) {
            std::vector<Patch> patches;
            patches.push_back(terraces(around, steps));
            add_field(around, patches);
            add_roof(girders, patches);
            add_teapot(detail, patches);
            return patches;
        },
        triangles));
}

}  // namespace boxwood
