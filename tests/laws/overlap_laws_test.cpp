// SPDX-License-Identifier: Apache-2.0
// What touches a box, a sphere or a triangle: the same as testing every triangle, for every
// builder, width and instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/query/brute_force.h"
#include "boxwood/query/overlaps.h"
#include "cases.h"
#include "laws/all_trees.h"
#include "laws/mesh_families.h"
#include "laws/point_families.h"
#include "laws/random.h"

namespace boxwood {
namespace {

constexpr std::uint64_t kShapes = cases(120);
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Between two random points of the mesh or around it: many touch something exactly.
Box3d random_box(MeshView mesh, std::uint64_t seed) {
    if (seed % 20 == 1) return {Vec3d::Constant(-kInfinity), Vec3d::Constant(kInfinity)};
    const Vec3d a = random_point(mesh, 2 * seed), b = random_point(mesh, 2 * seed + 1);
    if (seed % 20 == 2) return {a, a};
    if (seed % 20 == 3) return Box3d{};
    return Box3d{}.extend(a).extend(b);
}

Sphere3d random_sphere(MeshView mesh, std::uint64_t seed) {
    const Vec3d center = random_point(mesh, seed);
    const auto closest = closest_point_brute_force(mesh, center);
    switch (seed % 5) {
        case 0:
            return {center, closest ? closest->distance : 1};
        case 1:
            return {center, -1};
        case 2:
            return {center, seed % 2 ? kInfinity : std::nan("")};
        default:
            return {center, 1.5 * (closest ? closest->distance : 1)};
    }
}

TriangleCorners random_triangle(MeshView mesh, std::uint64_t seed) {
    Random random(seed);
    if (seed % 3 == 0 && !mesh.faces.empty()) {
        // A neighbour, one that has a corner in common, or the same.
        const auto i = static_cast<std::uint32_t>(random.index(mesh.faces.size()));
        TriangleCorners corners = corners_of(mesh, i);
        for (std::size_t k = 0; k < seed / 3 % 3; ++k)
            corners[k] = random_point(mesh, seed + 100 * k);
        return corners;
    }
    return {random_point(mesh, seed), random_point(mesh, seed + 1), random_point(mesh, seed + 2)};
}

class OverlapLaws : public testing::TestWithParam<MeshFamily> {};

TEST_P(OverlapLaws, trees_equal_testing_every_triangle) {
    const TriangleMesh mesh = GetParam().make();
    const std::vector<NamedTree> trees = all_trees(mesh);
    for (std::uint64_t seed = 0; seed < kShapes; ++seed) {
        const Box3d box = random_box(mesh, seed);
        const Sphere3d sphere = random_sphere(mesh, seed);
        const TriangleCorners triangle = random_triangle(mesh, seed);
        const auto in_box = box_overlap_brute_force(mesh, box);
        const auto in_sphere = sphere_overlap_brute_force(mesh, sphere);
        const bool touches = triangle_overlap_brute_force(mesh, triangle);
        for (const auto& [name, tree] : trees) {
            ASSERT_EQ(box_overlap(mesh, tree, box), in_box) << name << ", seed " << seed;
            ASSERT_EQ(sphere_overlap(mesh, tree, sphere), in_sphere) << name << ", seed " << seed;
            ASSERT_EQ(triangle_overlap(mesh, tree, triangle), touches) << name << ", seed " << seed;
        }
    }
}

TEST_P(OverlapLaws, a_sphere_touches_when_the_closest_point_is_near_enough) {
    const TriangleMesh mesh = GetParam().make();
    for (std::uint64_t seed = 0; seed < kShapes; ++seed) {
        const Sphere3d sphere = random_sphere(mesh, seed);
        const auto found = sphere_overlap_brute_force(mesh, sphere);
        const auto closest = closest_point_brute_force(mesh, sphere.center, sphere.radius);
        ASSERT_EQ(closest.has_value(), !found.empty()) << seed;
        if (closest) {
            ASSERT_TRUE(std::binary_search(found.begin(), found.end(), closest->triangle)) << seed;
        }
    }
}

TEST_P(OverlapLaws, every_triangle_touches_itself_and_its_box) {
    const TriangleMesh mesh = GetParam().make();
    for (std::uint32_t i = 0; i < std::min<std::size_t>(mesh.faces.size(), 100); ++i) {
        if (triangle_box(mesh, i).is_empty()) continue;
        const TriangleCorners corners = corners_of(mesh, i);
        ASSERT_TRUE(triangle_overlap_brute_force(mesh, corners)) << i;
        const auto found = box_overlap_brute_force(mesh, box_of(corners));
        ASSERT_TRUE(std::binary_search(found.begin(), found.end(), i)) << i;
        for (const Vec3d& corner : corners) {
            const auto at_corner = box_overlap_brute_force(mesh, {corner, corner});
            ASSERT_TRUE(std::binary_search(at_corner.begin(), at_corner.end(), i)) << i;
        }
    }
}

TEST(Overlaps, batches_hold_what_single_queries_find) {
    const TriangleMesh mesh = mesh_families().front().make();
    const WideTree tree(mesh, build_tree(mesh));
    std::vector<Box3d> boxes;
    std::vector<Sphere3d> spheres;
    std::vector<TriangleCorners> triangles;
    for (std::uint64_t seed = 0; seed < cases(1000); ++seed) {
        boxes.push_back(random_box(mesh, seed));
        spheres.push_back(random_sphere(mesh, seed));
        triangles.push_back(random_triangle(mesh, seed));
    }
    const OverlapLists in_boxes = box_overlaps(mesh, tree, boxes);
    const OverlapLists in_spheres = sphere_overlaps(mesh, tree, spheres);
    const std::unique_ptr<bool[]> touches(new bool[triangles.size()]);
    triangle_overlaps(mesh, tree, triangles, {touches.get(), triangles.size()});
    const auto as_vector = [](std::span<const std::uint32_t> list) {
        return std::vector<std::uint32_t>(list.begin(), list.end());
    };
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        ASSERT_EQ(as_vector(in_boxes[i]), box_overlap(mesh, tree, boxes[i]));
        ASSERT_EQ(as_vector(in_spheres[i]), sphere_overlap(mesh, tree, spheres[i]));
        ASSERT_EQ(touches[i], triangle_overlap(mesh, tree, triangles[i]));
    }
    EXPECT_THROW(triangle_overlaps(mesh, tree, triangles, {touches.get(), 3}), InvalidInput);
    EXPECT_EQ(box_overlaps(mesh, tree, {}).offsets, std::vector<std::size_t>{0});
}

INSTANTIATE_TEST_SUITE_P(Families, OverlapLaws, testing::ValuesIn(mesh_families()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace boxwood
