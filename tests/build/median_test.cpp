// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/median.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <set>

#include "boxwood/build/build.h"
#include "boxwood/core/error.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/tree/statistics.h"
#include "boxwood/tree/validate.h"
#include "laws/mesh_families.h"

namespace boxwood {
namespace {

using Primitives = std::vector<std::uint32_t>;

std::set<std::uint32_t> primitives_below(const Tree& tree, const Node& node) {
    if (node.is_leaf()) {
        const auto range = tree.primitives(node);
        return {range.begin(), range.end()};
    }
    auto result = primitives_below(tree, tree.nodes[node.left()]);
    result.merge(primitives_below(tree, tree.nodes[node.right()]));
    return result;
}

Vec3d centroid(MeshView mesh, std::uint32_t face) {
    return (mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2)) / 3;
}

/// The assignment word for word: sorts where the builder only selects.
void expect_assigned_halves(MeshView mesh, const Tree& tree, const Node& node,
                            Primitives primitives) {
    ASSERT_EQ(primitives_below(tree, node),
              std::set<std::uint32_t>(primitives.begin(), primitives.end()));
    ASSERT_EQ(node.is_leaf(), primitives.size() == 1);
    if (node.is_leaf()) return;

    Vec3d lo = centroid(mesh, primitives[0]), hi = lo;
    for (const std::uint32_t primitive : primitives) {
        lo = lo.cwiseMin(centroid(mesh, primitive));
        hi = hi.cwiseMax(centroid(mesh, primitive));
    }
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
        if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
    }
    std::sort(primitives.begin(), primitives.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(centroid(mesh, a)[axis], a) < std::pair(centroid(mesh, b)[axis], b);
    });
    const auto middle =
        primitives.begin() + static_cast<std::ptrdiff_t>((primitives.size() + 1) / 2);
    expect_assigned_halves(mesh, tree, tree.nodes[node.left()], {primitives.begin(), middle});
    expect_assigned_halves(mesh, tree, tree.nodes[node.right()], {middle, primitives.end()});
}

void expect_assigned_tree(MeshView mesh) {
    const Tree tree = build_tree(mesh, {.method = BuildMethod::median});
    ASSERT_EQ(find_fault(tree, triangle_boxes(mesh)), std::nullopt);
    Primitives all(mesh.faces.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    expect_assigned_halves(mesh, tree, tree.root(), all);
}

TEST(Median, halves_are_those_of_the_assignment) {
    expect_assigned_tree(generate_soup(777));
    expect_assigned_tree(generate_torus_knot(1000));
    expect_assigned_tree(generate_terrain(500));
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        expect_assigned_tree(generate_soup(1 + seed, seed));
    }
}

TEST(Median, equal_centroids_are_halved_by_index) {
    expect_assigned_tree(flat_grid(9));
    expect_assigned_tree(subdivided_cube(4));
    for (const MeshFamily& family : mesh_families()) {
        if (family.name != "duplicates" && family.name != "equal_centroids") continue;
        SCOPED_TRACE(family.name);
        expect_assigned_tree(family.make());
    }
}

TEST(Median, left_half_gets_the_extra_triangle) {
    for (const std::uint32_t count : {3, 5, 7, 101}) {
        const TriangleMesh soup = generate_soup(200);
        const MeshView mesh = {soup.vertices, std::span(soup.faces).first(count)};
        const Tree tree = build_tree(mesh, {.method = BuildMethod::median});
        const Node& root = tree.root();
        EXPECT_EQ(primitives_below(tree, tree.nodes[root.left()]).size(), (count + 1) / 2);
        EXPECT_EQ(primitives_below(tree, tree.nodes[root.right()]).size(), count / 2);
    }
}

/// Which is why the mesh's own centroids are handed to the builder.
TEST(Median, sorts_by_the_mean_of_the_corners_not_by_the_centre_of_the_box) {
    // Box centres along x: 5, 4.9; means of the corners: 3.33, 6.53.
    const TriangleMesh mesh = {
        .vertices = {{0, 0, 0}, {0, 1, 0}, {10, 0, 0}, {-0.2, 0, 0}, {10, 1, 0}, {9.8, 0, 0}},
        .faces = {{0, 1, 2}, {3, 4, 5}}};
    const Tree by_mean = build_tree(mesh, {.method = BuildMethod::median});
    EXPECT_EQ(by_mean.order, (Primitives{0, 1}));
    const Tree by_box = build_median(triangle_boxes(mesh));
    EXPECT_EQ(by_box.order, (Primitives{1, 0}));
}

TEST(Median, depth_is_the_logarithm_rounded_up_and_leaves_hold_one_triangle) {
    for (std::uint32_t count = 1; count < 300; ++count) {
        const std::vector<Box3f> boxes(count, {Vec3f::Zero(), Vec3f::Ones()});
        const TreeStatistics found = statistics(build_median(boxes));
        EXPECT_EQ(found.depth, std::bit_width(count - 1)) << count;
        EXPECT_EQ(found.largest_leaf, 1u) << count;
        EXPECT_EQ(found.leaves, count);
        EXPECT_EQ(found.nodes, 2 * count - 1);
    }
}

TEST(Median, no_boxes_make_an_empty_tree) {
    EXPECT_TRUE(build_median({}).is_empty());
    EXPECT_EQ(statistics(build_median({})).nodes, 0u);
}

TEST(Median, centroids_that_are_not_one_a_box_are_refused) {
    const std::vector<Box3f> boxes(3);
    const std::vector<Vec3d> centroids(2, Vec3d::Zero());
    EXPECT_THROW(build_median(boxes, {.centroids = centroids}), InvalidInput);
    EXPECT_THROW(build_median({}, {.centroids = centroids}), InvalidInput);
}

TEST(Median, centroids_that_are_not_finite_have_some_place) {
    const std::vector<Box3f> boxes(50, {Vec3f::Zero(), Vec3f::Ones()});
    std::vector<Vec3d> centroids(50, Vec3d::Ones());
    for (std::size_t i = 0; i < centroids.size(); i += 2) centroids[i].y() = std::nan("");
    centroids[1].x() = std::numeric_limits<double>::infinity();
    EXPECT_EQ(find_fault(build_median(boxes, {.centroids = centroids}), boxes), std::nullopt);
}

}  // namespace
}  // namespace boxwood
