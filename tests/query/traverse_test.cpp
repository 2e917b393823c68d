// SPDX-License-Identifier: Apache-2.0
// Trees deeper than the stack of a walk. They are made by hand, as builders seldom make them.
#include "boxwood/query/traverse.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "boxwood/build/agglomerative.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/any_hit.h"
#include "boxwood/query/brute_force.h"
#include "boxwood/query/closest_hit.h"
#include "boxwood/query/mesh_ray.h"
#include "boxwood/tree/parents.h"
#include "boxwood/tree/statistics.h"
#include "boxwood/tree/validate.h"
#include "laws/hits.h"
#include "laws/random.h"

namespace boxwood {
namespace {

/// Where a range of the primitives is cut.
using Cut = std::function<std::uint32_t(std::uint32_t begin, std::uint32_t end)>;

/// A tree over the boxes in their order, each range cut where the function says.
Tree make_tree(std::span<const Box3f> boxes, const Cut& cut) {
    struct Range {
        std::uint32_t node, begin, end;
    };
    Tree tree;
    tree.nodes.resize(1);
    std::vector<Range> to_do = {{0, 0, static_cast<std::uint32_t>(boxes.size())}};
    for (std::uint32_t i = 0; i < boxes.size(); ++i) tree.order.push_back(i);
    while (!to_do.empty()) {
        const auto [node, begin, end] = to_do.back();
        to_do.pop_back();
        if (end - begin == 1) {
            tree.nodes[node] = {boxes[begin], begin, 1};
            continue;
        }
        const auto left = static_cast<std::uint32_t>(tree.nodes.size());
        tree.nodes.resize(left + 2);
        tree.nodes[node].first = left;
        const std::uint32_t middle = cut(begin, end);
        to_do.push_back({left, begin, middle});
        to_do.push_back({left + 1, middle, end});
    }
    // Children stand behind their parents.
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        Node& node = tree.nodes[i];
        if (!node.is_leaf())
            node.box = merged(tree.nodes[node.left()].box, tree.nodes[node.right()].box);
    }
    add_parents(tree);
    return tree;
}

/// A row of triangles across the z axis at z = 0, -1, -2 ...
TriangleMesh row(int count) {
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
        const double z = -i;
        mesh.vertices.insert(mesh.vertices.end(), {{-1, -1, z}, {2, -1, z}, {-1, 2, z}});
        mesh.faces.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return mesh;
}

/// Triangles of different slope whose boxes all have their centre at the origin.
TriangleMesh concentric(int count) {
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 / (i + 1);
        mesh.vertices.insert(mesh.vertices.end(), {{-1, -1, -z}, {1, -1, z}, {-1, 1, z}});
        mesh.faces.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return mesh;
}

/// A child of one primitive at every node, on the left or on the right.
std::uint32_t cut_off_first(std::uint32_t begin, std::uint32_t) { return begin + 1; }
std::uint32_t cut_off_last(std::uint32_t, std::uint32_t end) { return end - 1; }

/// What is visited, in order, and the counts: with a stack that grows.
template <class Visit>
void traverse_with_vector(const Tree& tree, const Ray& ray, Visit&& visit,
                          TraversalCounts* counts) {
    const SlabRay slabs(ray, tree.root().box);
    double t_max = ray.t_max;
    const auto enter = [&](std::uint32_t node) {
        return std::pair(slabs.intersect(tree.nodes[node].box, ray.t_min, t_max), node);
    };
    std::vector<std::pair<double, std::uint32_t>> stack = {enter(0)};
    while (!stack.empty()) {
        const auto [t, index] = stack.back();
        stack.pop_back();
        if (t == SlabRay::kMiss || t > t_max) continue;
        const Node& node = tree.nodes[index];
        ++counts->nodes;
        if (node.is_leaf()) {
            for (const std::uint32_t primitive : tree.primitives(node)) {
                ++counts->primitives;
                t_max = visit(primitive, t_max);
            }
            if (t_max == kEndOfWalk) return;
        } else {
            auto near = enter(node.left()), far = enter(node.right());
            if (far.first < near.first) std::swap(near, far);
            stack.push_back(far);
            stack.push_back(near);
        }
    }
}

struct Visits {
    std::vector<std::uint32_t> primitives;
    TraversalCounts counts;
};

/// The walk for the closest hit, ended after so many visits.
template <class Traverse>
Visits walk(const Traverse& traverse_with, MeshView mesh, const Tree& tree, const Ray& ray,
            std::size_t most) {
    Visits visits;
    const auto visit = [&](std::uint32_t triangle, double t_max) {
        visits.primitives.push_back(triangle);
        if (visits.primitives.size() == most) return kEndOfWalk;
        const auto hit = MeshRay(MeshView(mesh), ray).intersect(triangle, t_max);
        return hit ? hit->t : t_max;
    };
    traverse_with(tree, ray, visit, &visits.counts);
    return visits;
}

TEST(Traverse, visits_the_same_in_the_same_order_however_deep_the_tree) {
    const TriangleMesh meshes[] = {generate_soup(400), concentric(400), row(400)};
    std::size_t deepest = 0, most_visits = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const TriangleMesh& mesh = meshes[seed % 3];
        const std::vector<Box3f> boxes = triangle_boxes(mesh);
        // From chains to trees that are nearly balanced.
        const double share = random.number(0, 0.5);
        const Tree tree = make_tree(boxes, [&](std::uint32_t begin, std::uint32_t end) {
            const auto small = static_cast<std::uint32_t>(share * random.number() * (end - begin));
            const std::uint32_t part = std::clamp(small, 1u, end - begin - 1);
            return random.number() < 0.5 ? begin + part : end - part;
        });
        ASSERT_EQ(find_fault(tree, boxes), std::nullopt);
        deepest = std::max(deepest, statistics(tree).depth);
        for (int i = 0; i < 20; ++i) {
            const Vec3d origin = i % 3 == 0 ? Vec3d(0, 0, -500) : random.point(-3, 3);
            Ray ray = {.origin = origin, .direction = random.point(-0.1, 0.1) - origin};
            if (i % 4 == 0) ray.t_max = 0.99;
            const std::size_t most = i % 5 == 0 ? 1 + random.index(200) : 1000;
            const Visits found = walk([](auto&&... a) { traverse(a...); }, mesh, tree, ray, most);
            const Visits expected =
                walk([](auto&&... a) { traverse_with_vector(a...); }, mesh, tree, ray, most);
            ASSERT_EQ(found.primitives, expected.primitives);
            ASSERT_EQ(found.counts.nodes, expected.counts.nodes);
            ASSERT_EQ(found.counts.primitives, expected.counts.primitives);
            most_visits = std::max(most_visits, found.primitives.size());
        }
    }
    EXPECT_GT(deepest, 3 * kDeepestWithoutParents);
    EXPECT_GT(most_visits, 2 * kDeepestWithoutParents);
}

TEST(Traverse, chains_about_as_deep_as_the_stack_are_walked) {
    for (int depth = 76; depth < 86; ++depth) {
        const TriangleMesh mesh = row(depth + 1);
        const std::vector<Box3f> boxes = triangle_boxes(mesh);
        for (const auto& cut : {cut_off_first, cut_off_last}) {
            const Tree tree = make_tree(boxes, cut);
            ASSERT_EQ(statistics(tree).depth, static_cast<std::size_t>(depth));
            for (const double z : {1.0, -depth - 1.0, -40.5}) {
                for (const double direction : {-1.0, 1.0}) {
                    const Ray ray = {.origin = {0, 0, z}, .direction = {0, 0, direction}};
                    ASSERT_TRUE(are_identical(closest_hit(mesh, tree, ray),
                                              closest_hit_brute_force(mesh, ray)));
                    ASSERT_EQ(any_hit(mesh, tree, ray), any_hit_brute_force(mesh, ray));
                }
            }
        }
    }
}

TEST(Traverse, agglomerative_chain_answers_as_brute_force_does) {
    // Each pair costs nothing, so the lowest is merged with the next, and again.
    const TriangleMesh mesh = concentric(300);
    const std::vector<Box3f> boxes = triangle_boxes(mesh);
    const Tree tree = build_agglomerative(boxes, {.cost = MergeCost::centroid_distance});
    ASSERT_EQ(find_fault(tree, boxes), std::nullopt);
    ASSERT_EQ(statistics(tree).depth, 299u);
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        Random random(seed);
        const Vec3d origin = random.point(-3, 3);
        const Ray ray = {.origin = origin, .direction = random.point(-1, 1) - origin};
        const auto expected = closest_hit_brute_force(mesh, ray);
        ASSERT_TRUE(are_identical(closest_hit(mesh, tree, ray), expected)) << seed;
        ASSERT_EQ(any_hit(mesh, tree, ray), expected.has_value()) << seed;
    }
}

/// Answers to a question asked on a thread with a small call stack.
struct Question {
    const TriangleMesh& mesh;
    const Tree& tree;
    std::vector<Ray> rays;
    std::vector<std::optional<Hit>> hits;
    std::vector<bool> any;
};

void* answer(void* question) {
    auto& [mesh, tree, rays, hits, any] = *static_cast<Question*>(question);
    for (const Ray& ray : rays) {
        hits.push_back(closest_hit(mesh, tree, ray));
        any.push_back(any_hit(mesh, tree, ray));
    }
    return nullptr;
}

TEST(Traverse, chain_of_200_000_is_walked_on_a_small_call_stack) {
    constexpr int kCount = 200'000;
    const TriangleMesh mesh = row(kCount);
    const std::vector<Box3f> boxes = triangle_boxes(mesh);
    for (const auto& cut : {cut_off_first, cut_off_last}) {
        const Tree tree = make_tree(boxes, cut);
        ASSERT_EQ(find_fault(tree, boxes), std::nullopt);
        ASSERT_EQ(statistics(tree).depth, kCount - 1u);
        Question question = {mesh, tree, {}, {}, {}};
        for (const double direction : {-1.0, 1.0}) {
            for (const double z : {1.0, -kCount - 1.0, -kCount / 2 - 0.5}) {
                question.rays.push_back({.origin = {0, 0, z}, .direction = {0, 0, direction}});
                // Enters every box and hits nothing.
                question.rays.push_back({.origin = {1.9, 1.9, z}, .direction = {0, 0, direction}});
            }
        }
        pthread_attr_t attributes;
        pthread_attr_init(&attributes);
        pthread_attr_setstacksize(&attributes, 128 * 1024);
        pthread_t thread;
        ASSERT_EQ(pthread_create(&thread, &attributes, answer, &question), 0);
        pthread_join(thread, nullptr);
        pthread_attr_destroy(&attributes);
        for (std::size_t i = 0; i < question.rays.size(); ++i) {
            const auto expected = closest_hit_brute_force(mesh, question.rays[i]);
            EXPECT_TRUE(are_identical(question.hits[i], expected)) << i;
            EXPECT_EQ(question.any[i], expected.has_value()) << i;
        }
    }
}

}  // namespace
}  // namespace boxwood
