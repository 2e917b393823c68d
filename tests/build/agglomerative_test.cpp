// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/agglomerative.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "boxwood/build/build.h"
#include "boxwood/query/any_hit.h"
#include "boxwood/query/closest_hit.h"
#include "boxwood/tree/statistics.h"
#include "boxwood/tree/validate.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"
#include "laws/random.h"

namespace boxwood {
namespace {

// The oracle: what the header says, by trying all pairs before each merge. Cubic.

struct Cluster {
    Box3f box;
    std::uint32_t lowest;  ///< primitive
    std::shared_ptr<const Cluster> left = nullptr, right = nullptr;
};

float volume(const Box3f& box) {
    const Vec3f e = box.extent();
    return e.x() * e.y() * e.z();
}

float cost_of_merging(const Box3f& a, const Box3f& b, MergeCost cost) {
    const Vec3f between = 0.5f * (a.lo + a.hi) - 0.5f * (b.lo + b.hi);
    const Box3f both = merged(a, b);
    const Vec3f e = both.extent();
    switch (cost) {
        case MergeCost::centroid_distance:
            return between.x() * between.x() + between.y() * between.y() +
                   between.z() * between.z();
        case MergeCost::volume_increase:
            return volume(both) - (volume(a) + volume(b));
        case MergeCost::surface_area:
            return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
    }
    return 0;
}

void append(Tree& tree, std::uint32_t index, const Cluster& cluster) {
    if (!cluster.left) {
        tree.nodes[index] = {cluster.box, static_cast<std::uint32_t>(tree.order.size()), 1};
        tree.order.push_back(cluster.lowest);
        return;
    }
    const auto left = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes.resize(left + 2);
    tree.nodes[index] = {cluster.box, left, 0};
    append(tree, left, *cluster.left);
    append(tree, left + 1, *cluster.right);
}

Tree build_naively(const std::vector<Box3f>& boxes, MergeCost cost) {
    // In the order of their lowest primitives throughout.
    std::vector<std::shared_ptr<const Cluster>> clusters;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        clusters.push_back(std::make_shared<Cluster>(Cluster{boxes[i], i}));
    while (clusters.size() > 1) {
        float least = std::numeric_limits<float>::infinity();
        std::size_t lower = 0, higher = 0;
        for (std::size_t i = 0; i < clusters.size(); ++i) {
            for (std::size_t j = i + 1; j < clusters.size(); ++j) {
                const float c = cost_of_merging(clusters[i]->box, clusters[j]->box, cost);
                if (c < least) std::tie(least, lower, higher) = std::tuple(c, i, j);
            }
        }
        const auto a = clusters[lower], b = clusters[higher];
        clusters[lower] =
            std::make_shared<Cluster>(Cluster{merged(a->box, b->box), a->lowest, a, b});
        clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(higher));
    }
    Tree tree;
    if (clusters.empty()) return tree;
    tree.nodes.resize(1);
    append(tree, 0, *clusters.front());
    return tree;
}

std::vector<Box3f> random_boxes(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Box3f> boxes(count);
    for (Box3f& box : boxes) {
        const Vec3f lo = random.point(-10, 10).cast<float>();
        box.extend(lo).extend(lo + random.point(0, 3).cast<float>());
    }
    return boxes;
}

/// Boxes with corners at few places: many costs are equal, many volumes 0.
std::vector<Box3f> boxes_with_ties(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Box3f> boxes(count);
    for (Box3f& box : boxes) {
        const Vec3f lo = random.point(0, 4).array().floor().cast<float>();
        box.extend(lo).extend(lo + Vec3f(random.point(0, 2).array().floor().cast<float>()));
    }
    return boxes;
}

void expect_same_as_naive(const std::vector<Box3f>& boxes, const std::string& what) {
    for (const auto& [name, cost] : merge_costs()) {
        const Tree tree = build_agglomerative(boxes, {.cost = cost});
        ASSERT_EQ(find_fault(tree, boxes), std::nullopt) << name << ", " << what;
        ASSERT_TRUE(are_identical(tree, build_naively(boxes, cost))) << name << ", " << what;
    }
}

TEST(Agglomerative, random_boxes_give_the_naive_builders_tree) {
    for (std::uint64_t seed = 0; seed < 150; ++seed)
        expect_same_as_naive(random_boxes(1 + seed % 50, seed), "seed " + std::to_string(seed));
}

TEST(Agglomerative, boxes_with_many_ties_give_the_naive_builders_tree) {
    for (std::uint64_t seed = 0; seed < 250; ++seed)
        expect_same_as_naive(boxes_with_ties(1 + seed % 60, seed), "seed " + std::to_string(seed));
}

/// Costs that differ by their last bits, if at all: they must not depend on which node was asked.
TEST(Agglomerative, boxes_with_near_ties_give_the_naive_builders_tree) {
    for (std::uint64_t seed = 0; seed < 250; ++seed) {
        std::vector<Box3f> boxes = boxes_with_ties(1 + seed % 60, seed);
        for (Box3f& box : boxes) {
            box.lo *= 0.1f;
            box.hi *= 0.1f;
        }
        expect_same_as_naive(boxes, "seed " + std::to_string(seed));
    }
}

TEST(Agglomerative, grids_and_duplicates_give_the_naive_builders_tree) {
    expect_same_as_naive(triangle_boxes(flat_grid(6)), "grid");
    expect_same_as_naive(triangle_boxes(subdivided_cube(2)), "cube");
    expect_same_as_naive(std::vector<Box3f>(60, random_boxes(1, 3)[0]), "duplicates");
    std::vector<Box3f> twice = random_boxes(30, 4);
    twice.insert(twice.end(), twice.begin(), twice.begin() + 30);
    expect_same_as_naive(twice, "each box twice");
}

TEST(Agglomerative, scaling_by_powers_of_two_changes_nothing) {
    // The naive builder's areas and volumes would overflow or vanish here.
    const std::vector<Box3f> boxes = random_boxes(80, 9);
    for (const auto& [name, cost] : merge_costs()) {
        const Tree tree = build_agglomerative(boxes, {.cost = cost});
        for (const float scale : {0x1p-100f, 0x1p-20f, 0x1p20f, 0x1p120f}) {
            std::vector<Box3f> scaled = boxes;
            for (Box3f& box : scaled) {
                box.lo *= scale;
                box.hi *= scale;
            }
            Tree expected = tree;
            for (Node& node : expected.nodes) {
                node.box.lo *= scale;
                node.box.hi *= scale;
            }
            EXPECT_TRUE(are_identical(build_agglomerative(scaled, {.cost = cost}), expected))
                << name << " " << scale;
        }
    }
}

TEST(Agglomerative, cheapest_pair_is_merged_first) {
    const auto at = [](float x) { return Box3f{Vec3f(x, 0, 0), Vec3f(x + 1, 1, 1)}; };
    const std::vector<Box3f> boxes = {at(0), at(10), at(2), at(11)};
    for (const auto& [name, cost] : merge_costs()) {
        const Tree tree = build_agglomerative(boxes, {.cost = cost});
        EXPECT_EQ(tree.order, (std::vector<std::uint32_t>{0, 2, 1, 3})) << name;
        EXPECT_EQ(statistics(tree).depth, 2u) << name;
    }
}

TEST(Agglomerative, costs_choose_different_partners) {
    // A long flat box beside a far small one: joining flat boxes in their plane costs no volume.
    const std::vector<Box3f> boxes = {{Vec3f(0, 0, 0), Vec3f(8, 8, 0)},
                                      {Vec3f(3.5f, 3.5f, 1), Vec3f(4.5f, 4.5f, 1.5f)},
                                      {Vec3f(100, 0, 0), Vec3f(108, 8, 0)}};
    const auto first_merge = [&](MergeCost cost) {
        const Tree tree = build_agglomerative(boxes, {.cost = cost});
        const Node& inner = tree.nodes[tree.nodes[1].is_leaf() ? 2 : 1];
        return std::pair(tree.order[tree.nodes[inner.left()].first],
                         tree.order[tree.nodes[inner.right()].first]);
    };
    EXPECT_EQ(first_merge(MergeCost::centroid_distance), std::pair(0u, 1u));
    EXPECT_EQ(first_merge(MergeCost::surface_area), std::pair(0u, 1u));
    EXPECT_EQ(first_merge(MergeCost::volume_increase), std::pair(0u, 2u));
}

TEST(Agglomerative, nothing_one_and_two_primitives) {
    EXPECT_TRUE(build_agglomerative({}).is_empty());
    for (const std::size_t count : {1, 2}) {
        const std::vector<Box3f> boxes = random_boxes(count, 1);
        const Tree tree = build_agglomerative(boxes);
        EXPECT_EQ(tree.nodes.size(), 2 * count - 1);
        EXPECT_EQ(find_fault(tree, boxes), std::nullopt);
    }
}

TEST(Agglomerative, boxes_that_nothing_hits_are_in_the_tree_too) {
    std::vector<Box3f> boxes = random_boxes(40, 5);
    for (std::size_t i = 0; i < boxes.size(); i += 3) boxes[i] = {};
    for (const auto& [name, cost] : merge_costs())
        EXPECT_EQ(find_fault(build_agglomerative(boxes, {.cost = cost}), boxes), std::nullopt);
    const std::vector<Box3f> all_empty(20);
    EXPECT_EQ(find_fault(build_agglomerative(all_empty), all_empty), std::nullopt);
}

TEST(Agglomerative, boxes_as_large_as_float_allows_make_a_valid_tree) {
    const Vec3f largest = Vec3f::Constant(std::numeric_limits<float>::max());
    std::vector<Box3f> boxes = random_boxes(30, 6);
    boxes.push_back({-largest, largest});
    boxes.push_back({largest, largest});
    boxes.push_back({-largest, -largest});
    for (const auto& [name, cost] : merge_costs())
        EXPECT_EQ(find_fault(build_agglomerative(boxes, {.cost = cost}), boxes), std::nullopt);
}

/// Each flat cluster grows at no cost by its neighbour: ties without end. Minutes if cubic.
TEST(Agglomerative, coplanar_grid_of_3000_boxes_is_built) {
    const std::vector<Box3f> boxes = triangle_boxes(flat_grid(39));
    for (const auto& [name, cost] : merge_costs())
        EXPECT_EQ(find_fault(build_agglomerative(boxes, {.cost = cost}), boxes), std::nullopt);
}

/// The tree may be as deep as it has primitives; nothing may recurse down it.
TEST(Agglomerative, chain_of_20000_coplanar_boxes_is_built_measured_and_traversed) {
    TriangleMesh mesh;
    for (int i = 0; i < 20'000; ++i) {
        const int first = static_cast<int>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(),
                             {Vec3d(2 * i, 0, 0), Vec3d(2 * i + 1, 0, 0), Vec3d(2 * i, 1, 0)});
        mesh.faces.emplace_back(first, first + 1, first + 2);
    }
    const Tree tree = build_tree(
        mesh, {.method = BuildMethod::agglomerative, .cost = MergeCost::volume_increase});
    EXPECT_EQ(find_fault(tree, triangle_boxes(mesh)), std::nullopt);
    EXPECT_EQ(statistics(tree).depth, mesh.faces.size() - 1);

    // Down on one triangle, and lengthwise so that all nodes wait on the stack at once.
    const Ray down = {.origin = {31'000.25, 0.25, 1}};
    const auto hit = closest_hit(mesh, tree, down);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->triangle, 15'500u);
    EXPECT_TRUE(any_hit(mesh, tree, down));
    const Ray lengthwise = {.origin = {-1, 0.1, 0}, .direction = {1, 0, 0}};
    EXPECT_FALSE(closest_hit(mesh, tree, lengthwise));
    EXPECT_FALSE(any_hit(mesh, tree, lengthwise));
    const Ray backwards = {.origin = {50'000, 0.1, 0}, .direction = {-1, 0, 0}};
    EXPECT_FALSE(closest_hit(mesh, tree, backwards));
}

}  // namespace
}  // namespace boxwood
