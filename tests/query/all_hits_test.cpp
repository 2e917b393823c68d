// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/all_hits.h"

#include <gtest/gtest.h>

#include <limits>

#include "boxwood/build/build.h"
#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/mesh/generate.h"
#include "cases.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"
#include "laws/ray_families.h"

namespace boxwood {
namespace {

WideTree tree_over(const TriangleMesh& mesh) { return {mesh, build_tree(mesh)}; }

Ray down_at(double x, double y) { return {.origin = {x, y, 2}, .direction = {0, 0, -1}}; }

TEST(AllHits, are_sorted_by_t_and_ties_by_triangle) {
    TriangleMesh mesh;
    // From the lowest to the highest, the middle one twice.
    for (const double z : {0.0, 0.5, 0.5, 1.0}) {
        const auto first = static_cast<int>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {{-1, -1, z}, {1, -1, z}, {0, 1, z}});
        mesh.faces.emplace_back(first, first + 1, first + 2);
    }
    const WideTree tree = tree_over(mesh);
    const std::vector<Hit> hits = all_hits(mesh, tree, down_at(0, 0));
    ASSERT_EQ(hits.size(), 4u);
    const double t[] = {1, 1.5, 1.5, 2};
    const std::uint32_t triangle[] = {3, 1, 2, 0};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(hits[i].t, t[i]);
        EXPECT_EQ(hits[i].triangle, triangle[i]);
        EXPECT_EQ(hits[i].instance, 0u);
    }
}

TEST(AllHits, limits_and_skip_hold) {
    const TriangleMesh cube = subdivided_cube(1);
    const WideTree tree = tree_over(cube);
    Ray ray = down_at(0.25, 0.125);
    const std::vector<Hit> both = all_hits(cube, tree, ray);
    ASSERT_EQ(both.size(), 2u);
    ray.t_max = 1;
    EXPECT_EQ(count_hits(cube, tree, ray), 1u);
    ray.t_min = 1;
    EXPECT_EQ(count_hits(cube, tree, ray), 1u);
    ray.t_max = 2;
    EXPECT_EQ(count_hits(cube, tree, ray), 2u);
    ray.skip.triangle = both[0].triangle;
    EXPECT_EQ(count_hits(cube, tree, ray), 1u);
    ray.t_max = 0.5;
    EXPECT_EQ(count_hits(cube, tree, ray), 0u);
}

TEST(AllHits, rays_that_are_not_traceable_cross_nothing) {
    const TriangleMesh cube = subdivided_cube(2);
    const WideTree tree = tree_over(cube);
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    std::vector<Ray> rays(4, down_at(0.3, 0.3));
    rays[0].direction.setZero();
    rays[1].origin.x() = kNaN;
    rays[2].t_min = 3;
    rays[2].t_max = 1;
    rays[3].t_max = kNaN;
    for (const Ray& ray : rays) {
        EXPECT_TRUE(all_hits(cube, tree, ray).empty());
        EXPECT_EQ(count_hits(cube, tree, ray), 0u);
        Hit hit;
        EXPECT_EQ(first_k_hits(cube, tree, ray, {&hit, 1}), 0u);
        EXPECT_FALSE(hit.is_hit());
    }
}

TEST(AllHits, nothing_crosses_an_empty_mesh) {
    const TriangleMesh nothing;
    const WideTree tree = tree_over(nothing);
    EXPECT_TRUE(all_hits(nothing, tree, Ray()).empty());
    const HitLists lists = all_hits(nothing, tree, std::vector<Ray>(3));
    EXPECT_EQ(lists.offsets, std::vector<std::size_t>(4, 0));
    EXPECT_EQ(all_hits(nothing, tree, std::span<const Ray>()).size(), 0u);
}

TEST(AllHits, batches_refuse_sizes_that_differ) {
    const TriangleMesh cube = subdivided_cube(1);
    const WideTree tree = tree_over(cube);
    const std::vector<Ray> rays(5);
    for (const std::size_t count : {0, 4, 6}) {
        std::vector<std::size_t> counts(count);
        EXPECT_THROW(count_hits(cube, tree, rays, counts), InvalidInput) << count;
    }
    for (const std::size_t count : {0, 5, 14, 16, 20}) {
        std::vector<Hit> hits(count);
        EXPECT_THROW(first_k_hits(cube, tree, rays, 3, hits), InvalidInput) << count;
    }
    std::vector<Hit> hit(1);
    EXPECT_THROW(first_k_hits(cube, tree, rays, 0, hit), InvalidInput);
    EXPECT_NO_THROW(first_k_hits(cube, tree, rays, 0, {}));
    constexpr std::size_t kHuge = std::numeric_limits<std::size_t>::max() / 5 + 1;
    EXPECT_THROW(first_k_hits(cube, tree, rays, kHuge, {}), InvalidInput);
}

TEST(AllHits, batches_are_the_same_for_any_count_and_threads) {
    const TriangleMesh mesh = generate_soup(300);
    const WideTree tree = tree_over(mesh);
    for (const std::size_t count : {0, 1, 255, 256, 257, 2000}) {
        std::vector<Ray> rays;
        for (std::uint64_t seed = 0; seed < count; ++seed) rays.push_back(random_ray(mesh, seed));
        for (const std::size_t threads : {1, 2, 5}) {
            const ThreadLimit limit(threads);
            for (const bool here : {false, true}) {
                const HitLists lists = all_hits(mesh, tree, rays, {.on_this_thread = here});
                ASSERT_EQ(lists.size(), count);
                ASSERT_EQ(lists.t.size(), lists.offsets.back());
                for (std::size_t i = 0; i < count; ++i) {
                    const std::vector<Hit> expected = all_hits(mesh, tree, rays[i]);
                    ASSERT_EQ(lists.count(i), expected.size()) << i;
                    for (std::size_t n = 0; n < expected.size(); ++n)
                        ASSERT_TRUE(are_identical(lists.hit(i, n), expected[n])) << i << " " << n;
                }
            }
        }
    }
}

TEST(AllHits, batches_can_be_watched_and_cancelled) {
    const ThreadLimit limit(1);  // or the others may do all before the first report
    const TriangleMesh mesh = generate_icosphere(100);
    const WideTree tree = tree_over(mesh);
    std::vector<Ray> rays;
    for (std::uint64_t seed = 0; seed < cases(5000); ++seed) rays.push_back(random_ray(mesh, seed));
    std::vector<std::size_t> counts(rays.size());
    std::vector<Hit> rows(rays.size());
    std::vector<double> parts;
    const BatchOptions watched = {.progress = [&](double part) { parts.push_back(part); }};
    for (int query = 0; query < 3; ++query) {
        parts.clear();
        if (query == 0) all_hits(mesh, tree, rays, watched);
        if (query == 1) count_hits(mesh, tree, rays, counts, watched);
        if (query == 2) first_k_hits(mesh, tree, rays, 1, rows, watched);
        ASSERT_GT(parts.size(), 1u);
        EXPECT_EQ(parts.back(), 1);
    }
    Cancellation cancellation;
    cancellation.request();
    const BatchOptions cancelled = {.cancellation = &cancellation};
    EXPECT_THROW(all_hits(mesh, tree, rays, cancelled), Cancelled);
    EXPECT_THROW(count_hits(mesh, tree, rays, counts, cancelled), Cancelled);
    EXPECT_THROW(first_k_hits(mesh, tree, rays, 1, rows, cancelled), Cancelled);
}

}  // namespace
}  // namespace boxwood
