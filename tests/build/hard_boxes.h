// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "boxwood/core/box.h"
#include "laws/random.h"

namespace boxwood {

struct HardBoxes {
    std::string name;
    std::vector<Box3f> boxes;
};

inline std::vector<Box3f> random_boxes(std::size_t count, double scale, std::uint64_t seed = 1) {
    Random random(seed);
    std::vector<Box3f> boxes(count);
    for (Box3f& box : boxes) {
        box.extend((scale * random.point(-1, 1)).cast<float>());
        box.extend((scale * random.point(-1, 1)).cast<float>());
    }
    return boxes;
}

/// Boxes of every kind that might make a builder slow, its tree deep or its costs infinite. Those
/// of meshes are in laws/mesh_families.h.
inline std::vector<HardBoxes> hard_boxes() {
    constexpr float kLargest = std::numeric_limits<float>::max();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const auto at = [](double x, double y, double z, double size = 0) {
        const Vec3f lo = Vec3d(x, y, z).cast<float>();
        return Box3f{lo, lo + Vec3f::Constant(static_cast<float>(size))};
    };
    const Vec3f largest = Vec3f::Constant(kLargest);
    std::vector<HardBoxes> all = {{"nothing", {}}, {"one", {at(1, 2, 3, 4)}}, {"one_empty", {{}}}};

    all.push_back({"two_corners", {{-largest, -largest}, {largest, largest}}});
    all.push_back({"copies", std::vector<Box3f>(10'000, at(1, 2, 3, 0.1))});
    all.push_back({"points", std::vector<Box3f>(3000, at(1, 2, 3))});
    all.push_back({"empty", std::vector<Box3f>(1000)});
    all.push_back({"everything", std::vector<Box3f>(1000, {-largest, largest})});

    std::vector<Box3f> plane, line, concentric, chain, growing, doubling, extreme, infinite;
    for (int i = 0; i < 100; ++i) {
        for (int k = 0; k < 100; ++k) plane.push_back({Vec3f(i, k, 7), Vec3f(i + 1, k + 1, 7)});
    }
    for (int i = 0; i < 5000; ++i) {
        line.push_back(at(i % 1250, 0, 0));
        concentric.push_back({Vec3f::Constant(-1.0f - i), Vec3f::Constant(1.0f + i)});
        // Each beside the last and a little larger: always cheaper to join those before.
        const double place = std::pow(1.02, i % 4000 - 2000);
        chain.push_back(at(place, 0, 0, 0.01 * place));
        growing.push_back(at(0, 0, 0, place));
        doubling.push_back(at(std::ldexp(1, i % 250 - 125), 0, 0));
    }
    for (int i = 0; i < 250; ++i) {
        doubling.push_back(at(0, std::ldexp(1, -i / 2), 0));
        doubling.push_back(at(0, 0, 0, std::ldexp(1, i / 2 - 60)));
    }
    for (int i = 0; i < 40; ++i) {
        for (const Box3f& box : {Box3f{-largest, largest}, Box3f{largest, largest},
                                 Box3f{-largest, -largest}, Box3f{}, at(i, i, i)})
            extreme.push_back(box);
        infinite.push_back(at(i, i, i, 1));
        infinite.push_back({Vec3f::Constant(-kInfinity), Vec3f::Constant(kInfinity)});
        infinite.push_back({Vec3f::Zero(), Vec3f(1, kInfinity, 1)});
        infinite.push_back({Vec3f::Constant(kInfinity), Vec3f::Constant(kInfinity)});
    }
    all.push_back({"plane", plane});
    all.push_back({"line", line});
    all.push_back({"concentric", concentric});
    all.push_back({"chain", chain});
    all.push_back({"growing", growing});
    all.push_back({"doubling", doubling});
    all.push_back({"extreme", extreme});
    all.push_back({"infinite", infinite});

    std::vector<Box3f> spanned = random_boxes(3000, 1);
    spanned.push_back(at(-1000, -1000, -1000, 2000));
    all.push_back({"one_spans_all", spanned});
    std::vector<Box3f> far = random_boxes(3000, 1);
    for (int i = 0; i < 30; ++i) far.push_back(at(std::pow(10.0, i), 0, 0, 1));
    all.push_back({"far_away", far});
    for (const double scale : {1e-45, 1e-40, 1e-37, 1e-30, 1e-20, 1e20, 1e30, 1e37, 3e38}) {
        const std::string name = "scale_" + std::to_string(std::log10(scale));
        all.push_back({name, random_boxes(500, scale)});
        std::vector<Box3f> mixed = random_boxes(500, scale);
        for (std::size_t i = 0; i < mixed.size(); i += 2)
            mixed[i] = at(1e-45 * static_cast<double>(i), 0, 1e-44);
        all.push_back({name + "_and_tiny", mixed});
        for (Box3f& box : mixed) box.lo.x() = box.hi.x() = 1;
        all.push_back({name + "_flat", mixed});
        for (Box3f& box : mixed) box.lo.z() = box.hi.z() = kLargest;
        all.push_back({name + "_line", mixed});
    }
    return all;
}

/// Boxes that a careless caller might pass: some are not a number.
inline std::vector<Box3f> boxes_with_nan() {
    std::vector<Box3f> boxes = random_boxes(600, 1);
    const Vec3f nan = Vec3f::Constant(std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < boxes.size(); i += 3) boxes[i] = {nan, nan};
    return boxes;
}

}  // namespace boxwood
