// SPDX-License-Identifier: Apache-2.0
// Octaves of value noise, each of half the size and turned a little, where steep ground takes less
// of the finer ones: slopes stay smooth as if eroded, ridges get rugged.
// Source: Quilez, "Value noise derivatives", 2008, https://iquilezles.org/articles/morenoise.
#include <algorithm>
#include <cmath>

#include "boxwood/core/parallel.h"
#include "boxwood/core/random.h"
#include "boxwood/mesh/generate.h"

namespace boxwood {

namespace {

constexpr double kHillsAcross = 3;
constexpr double kHeight = 0.45;
constexpr double kSeaLevel = 0.25;  ///< what is subtracted, so that z = 0 is inside the range

struct Noise {
    double value = 0;  ///< in [0, 1]
    double dx = 0, dy = 0;
};

/// Random values at whole coordinates, and a smooth function between them.
Noise value_noise(double x, double y, std::uint32_t seed, std::uint32_t octave) {
    const double column = std::floor(x), row = std::floor(y);
    const auto corner = [&](int i, int j) {
        const auto key = [](double k) {
            return static_cast<std::uint32_t>(static_cast<std::int64_t>(k));
        };
        return uniform(seed, std::uint64_t{key(column + i)} << 32 | key(row + j), octave);
    };
    const double a = corner(0, 0), b = corner(1, 0), c = corner(0, 1), d = corner(1, 1);

    const double fx = x - column, fy = y - row;
    const auto smooth = [](double f) { return f * f * f * (f * (6 * f - 15) + 10); };
    const auto slope = [](double f) { return 30 * f * f * (f - 1) * (f - 1); };
    const double u = smooth(fx), v = smooth(fy);
    const double twist = a - b - c + d;
    return {a + (b - a) * u + (c - a) * v + twist * u * v, slope(fx) * (b - a + twist * v),
            slope(fy) * (c - a + twist * u)};
}

/// In [0, 2).
double ground(double x, double y, std::uint32_t seed, std::uint32_t octaves) {
    double sum = 0, amplitude = 1, dx = 0, dy = 0;
    for (std::uint32_t octave = 0; octave < octaves; ++octave) {
        const Noise noise = value_noise(x, y, seed, octave);
        dx += noise.dx;
        dy += noise.dy;
        sum += amplitude * noise.value / (1 + dx * dx + dy * dy);
        amplitude /= 2;
        // Twice as fine, and turned, so that the lattices of the octaves don't line up.
        const double turned = 1.6 * x - 1.2 * y;
        y = 1.2 * x + 1.6 * y;
        x = turned;
    }
    return sum;
}

}  // namespace

TriangleMesh generate_terrain(std::size_t triangles, std::uint32_t seed) {
    const double side = std::round(std::sqrt(static_cast<double>(triangles) / 2));
    const int cells = std::max(1, static_cast<int>(side));
    const auto points = static_cast<std::size_t>(cells) + 1;
    // As fine as the grid can show, and no finer.
    std::uint32_t octaves = 1;
    while (2 * kHillsAcross * static_cast<double>(1u << octaves) <= cells) ++octaves;

    TriangleMesh mesh;
    mesh.vertices.resize(points * points);
    parallel_for(points, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = begin; j < end; ++j) {
            for (std::size_t i = 0; i < points; ++i) {
                const double s = static_cast<double>(i) / cells, t = static_cast<double>(j) / cells;
                const double height = ground(kHillsAcross * s, kHillsAcross * t, seed, octaves);
                mesh.vertices[j * points + i] =
                    Vec3d(2 * s - 1, 2 * t - 1, kHeight * height - kSeaLevel);
            }
        }
    });

    mesh.faces.reserve(2 * static_cast<std::size_t>(cells) * cells);
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const int a = j * (cells + 1) + i, b = a + 1;
            const int c = b + cells + 1, d = a + cells + 1;
            mesh.faces.emplace_back(a, b, c);
            mesh.faces.emplace_back(a, c, d);
        }
    }
    return mesh;
}

}  // namespace boxwood
