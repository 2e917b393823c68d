// SPDX-License-Identifier: Apache-2.0
// A hall as architects draw it: boards, walls with windows and a vault of few long thin triangles;
// columns, arches, ribs and balusters of many small ones; things that stand about in between.
#include <algorithm>
#include <cmath>

#include "boxwood/core/random.h"
#include "boxwood/core/turns.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/patches.h"

namespace boxwood {

namespace {

constexpr double kLength = 1.96, kWidth = 1;  ///< of the hall, x by y
constexpr double kAisle = 0.24;               ///< where the columns stand, on both sides
constexpr int kColumns = 8;
constexpr double kBay = 0.24, kFirstColumn = -0.84;
constexpr double kShaft = 0.3;     ///< the height of a column
constexpr double kCornice = 0.46;  ///< where the walls over the arches end and the vault begins

/// Cuts patches as finely as the detail allows; each has a phase of its own, by its turn. So two
/// cuts must not be arguments of one call: compilers evaluate these in different orders.
class Cutter {
public:
    explicit Cutter(double detail) : detail_(detail) {}

    int operator()(double scale, int least) {
        return pieces(detail_, scale, least, uniform(7, count_++, 0));
    }

private:
    double detail_;
    std::uint64_t count_ = 0;
};

void add_upright_box(const Vec3d& center, const Vec3d& size, std::vector<Patch>& patches) {
    const Vec3d o = center - Vec3d(size.x() / 2, size.y() / 2, 0);
    add_box(o, {size.x(), 0, 0}, {0, size.y(), 0}, {0, 0, size.z()}, patches);
}

/// Floor, walls with windows between their piers, flat ceilings over the aisles, the vault.
void add_shell(std::vector<Patch>& patches) {
    const double x = -kLength / 2, y = kWidth / 2;
    patches.push_back(flat_patch({x, -y, 0}, {kLength, 0, 0}, {0, kWidth, 0}, 4, 48));
    for (const int side : {-1, 1}) {
        const double wall = side * (y + 0.01);
        add_upright_box({0, wall, -0.01}, {kLength, 0.02, 0.17}, patches);
        add_upright_box({0, wall, 0.4}, {kLength, 0.021, 0.08}, patches);
        for (int pier = 0; pier <= 2 * kColumns; ++pier)
            add_upright_box({x + 0.03 + pier * (kLength - 0.06) / (2 * kColumns), wall, 0.155},
                            {0.045, 0.018, 0.25}, patches);
        add_upright_box({side * (kLength / 2 + 0.01), 0, -0.011}, {0.02, kWidth, 0.76}, patches);
        const double outer = side * y, inner = side * kAisle;
        patches.push_back(flat_patch({x, std::max(outer, inner), 0.475}, {kLength, 0, 0},
                                     {0, -(y - kAisle), 0}, 2, 12));
    }
    patches.push_back({1, 24, [x](double u, double v) -> Vec3d {
                           return {x + u * kLength, kAisle * cos_turns(v / 2),
                                   kCornice + kAisle * sin_turns(v / 2)};
                       }});
}

void add_column(double x, double y, Cutter& cut, std::vector<Patch>& patches) {
    add_upright_box({x, y, -0.003}, {0.09, 0.09, 0.025}, patches);
    add_upright_box({x, y, 0.022 + kShaft}, {0.085, 0.085, 0.02}, patches);
    const auto swelling = [](double v) { return 0.03 + 0.004 * sin_turns(v / 2) - 0.004 * v; };
    const int flutes = 12;
    patches.push_back({cut(6, 12), cut(1.5, 3), [=](double u, double v) -> Vec3d {
                           const double turn = u == 1 ? 0 : u;
                           const double radius =
                               swelling(v) * (1 + 0.04 * cos_turns(flutes * turn));
                           return {x + radius * cos_turns(turn), y + radius * sin_turns(turn),
                                   0.02 + (kShaft + 0.004) * v};
                       }});
    // A ring under the capital.
    const int around = cut(3, 10), up = cut(1, 4);
    patches.push_back(turned_patch({x, y, kShaft - 0.012}, around, up, [](double v) {
        return Vec2d(0.029 + 0.008 * sin_turns(v / 2), 0.03 * v);
    }));
}

/// The wall over an arch from one column to the next: both its faces, and the arch from below.
void add_arch(double x, double y, Cutter& cut, std::vector<Patch>& patches) {
    const double radius = 0.085, foot = 0.041 + kShaft, thick = 0.022;
    // From the middle of a capital over the arch to the middle of the next.
    const auto edge = [=](double s) {
        const double arc = std::clamp(1.25 * s - 0.125, 0.0, 1.0);
        const double rest = (s - (arc + 0.125) / 1.25) * (kBay - 2 * radius) / 0.2;
        return Vec2d(x - radius * cos_turns(arc / 2) + rest, foot + radius * sin_turns(arc / 2));
    };
    const int around = cut(2.5, 8);
    for (const int side : {-1, 1}) {
        patches.push_back({around, cut(0.3, 1), [=](double u, double v) -> Vec3d {
                               const double s = side < 0 ? u : 1 - u;
                               const Vec2d low = edge(s), high(x + (s - 0.5) * kBay, kCornice);
                               const Vec2d at = low + v * (high - low);
                               return {at.x(), y + side * thick, at.y()};
                           }});
    }
    patches.push_back({around, cut(0.4, 1), [=](double u, double v) -> Vec3d {
                           const Vec2d at = edge(u);
                           return {at.x(), y + thick * (1 - 2 * v), at.y()};
                       }});
}

/// A rib under the vault, from column to column.
void add_rib(double x, Cutter& cut, std::vector<Patch>& patches) {
    const int around = cut(1, 4), along = cut(3, 12);
    patches.push_back(tube_patch(
        around, along,
        [x](double v) -> Vec3d {
            return {x, 0.232 * cos_turns(v / 2), kCornice + 0.232 * sin_turns(v / 2)};
        },
        [](double v) -> Vec3d {
            return {0, cos_turns(v / 2), sin_turns(v / 2)};
        },
        -Vec3d::UnitX(), [](double) { return 0.009; }));
}

void add_chandelier(double x, Cutter& cut, std::vector<Patch>& patches) {
    const double z = 0.42;
    const auto direction = [](double v) -> Vec3d {
        const double turn = v == 1 ? 0 : v;
        return {cos_turns(turn), sin_turns(turn), 0};
    };
    const int around = cut(1, 4), along = cut(4, 10);
    patches.push_back(tube_patch(
        around, along, [=](double v) -> Vec3d { return Vec3d(x, 0, z) + 0.06 * direction(v); },
        direction, -Vec3d::UnitZ(), [](double) { return 0.006; }));
    for (int i = 0; i < 3; ++i) {
        const Vec3d outward = direction(i / 3.0), foot = Vec3d(x, 0, z) + 0.06 * outward;
        const Vec3d top = Vec3d(x, 0, 0.69) + 0.005 * outward;
        add_box(foot, {0.002, 0, 0}, {0, 0.002, 0}, top - foot, patches);
    }
}

/// Steps up to a landing at the end, with balusters on both sides.
void add_stairs(Cutter& cut, std::vector<Patch>& patches) {
    constexpr int kSteps = 12;
    for (int i = 0; i < kSteps; ++i) {
        const double front = 0.62 + 0.018 * i, height = 0.008 * (i + 1);
        add_box({front, -0.2, -0.002 * i}, {0.97 - front, 0, 0}, {0, 0.4 + 1e-4 * i, 0},
                {0, 0, height + 0.002 * i}, patches);
        for (const int side : {-1, 1}) {
            const int around = cut(1.2, 6), up = cut(1.2, 5);
            patches.push_back(turned_patch(
                {front + 0.009, side * 0.19, height - 0.001}, around, up, [](double v) {
                    return Vec2d(0.002 + 0.003 * sin_turns(v / 2) * (1 - 0.6 * v), 0.05 * v);
                }));
        }
    }
    for (const int side : {-1, 1})
        add_box({0.62, side * 0.19 - 0.004, 0.056}, {0.216, 0, 0.096}, {0, 0.008, 0}, {0, 0, 0.006},
                patches);
}

void add_table(const Vec3d& place, double size, std::vector<Patch>& patches) {
    const Vec3d top = place + Vec3d(0, 0, 0.9 * size);
    add_upright_box(top, {1.8 * size, 1.1 * size, 0.06 * size}, patches);
    for (const int i : {-1, 1})
        for (const int j : {-1, 1})
            add_upright_box(place + Vec3d(0.8 * i * size, 0.45 * j * size, -0.001),
                            {0.07 * size, 0.07 * size, 0.93 * size}, patches);
}

void add_crate(const Vec3d& place, double size, double turn, std::vector<Patch>& patches) {
    const Vec3d a = size * Vec3d(cos_turns(turn), sin_turns(turn), 0);
    const Vec3d b(-0.7 * a.y(), 0.7 * a.x(), 0);
    add_box(place - Vec3d(0, 0, 0.001), a, b, {0, 0, 0.6 * size}, patches);
}

void add_vase(const Vec3d& place, double size, double shape, Cutter& cut,
              std::vector<Patch>& patches) {
    const int around = cut(3, 8), up = cut(3, 6);
    patches.push_back(turned_patch(place, around, up, [=](double v) {
        const double belly = sin_turns(0.48 * v + 0.01) * (1 - shape * v);
        return Vec2d(size * (0.12 + 0.4 * belly), size * (0.5 + shape) * v);
    }));
}

void add_clutter(int count, Cutter& cut, std::vector<Patch>& patches) {
    for (int i = 0; i < count; ++i) {
        const auto random = [&](std::uint32_t dimension) {
            return uniform(11, static_cast<std::uint64_t>(i), dimension);
        };
        const double x = -0.93 + 1.5 * random(0), y = (random(1) - 0.5) * 0.92;
        const double size = (0.02 + 0.04 * random(2)) / (1 + 0.004 * count);
        const Vec3d place(x, y, 0);
        const double kind = random(3);
        if (kind < 0.15) {
            add_table(place, size, patches);
            add_vase(place + Vec3d(0, 0, 0.95 * size), 0.5 * size, random(4), cut, patches);
        } else if (kind < 0.3) {
            add_crate(place, size, random(4), patches);
        } else {
            add_vase(place, size, random(4), cut, patches);
        }
    }
}

std::vector<Patch> patches_of(double detail, int clutter) {
    Cutter cut(detail);
    std::vector<Patch> patches;
    add_shell(patches);
    for (int i = 0; i < kColumns; ++i) {
        const double x = kFirstColumn + i * kBay;
        for (const int side : {-1, 1}) {
            add_column(x, side * kAisle, cut, patches);
            if (i + 1 < kColumns) add_arch(x + kBay / 2, side * kAisle, cut, patches);
        }
        add_rib(x, cut, patches);
    }
    for (const double x : {-0.6, -0.2, 0.2, 0.6}) add_chandelier(x, cut, patches);
    add_stairs(cut, patches);
    add_clutter(clutter, cut, patches);
    return patches;
}

}  // namespace

TriangleMesh generate_interior(std::size_t triangles) {
    const auto clutter = static_cast<int>(std::clamp<std::size_t>(triangles / 1500, 4, 400));
    return tessellated(
        with_triangles([&](double detail) { return patches_of(detail, clutter); }, triangles));
}

}  // namespace boxwood
