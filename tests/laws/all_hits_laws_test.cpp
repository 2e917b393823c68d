// SPDX-License-Identifier: Apache-2.0
// All crossings of a ray: those of an oracle that decides them in another way, to the last bit, for
// every builder, width and instruction set.
#include <gtest/gtest.h>

#include <cmath>

#include "boxwood/query/all_hits.h"
#include "boxwood/query/brute_force.h"
#include "boxwood/query/certified_hits.h"
#include "cases.h"
#include "laws/all_trees.h"
#include "laws/crossing_oracle.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"
#include "laws/ray_families.h"

namespace boxwood {
namespace {

bool are_identical(const std::vector<Hit>& a, const std::vector<Hit>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!are_identical(std::optional(a[i]), std::optional(b[i]))) return false;
    return true;
}

Ray ray_of(MeshView mesh, std::uint64_t seed) {
    Ray ray = random_ray(mesh, seed);
    // Some from so far away that float can't tell the scene from a point.
    if (seed % 8 == 0) ray.origin -= std::ldexp(1.0, static_cast<int>(seed % 160)) * ray.direction;
    return ray;
}

class AllHitsLaws : public testing::TestWithParam<MeshFamily> {};

TEST_P(AllHitsLaws, hits_equal_the_oracle_to_the_last_bit) {
    const TriangleMesh mesh = GetParam().make();
    const std::vector<NamedTree> trees = all_trees(mesh);
    for (std::uint64_t seed = 0; seed < cases(300); ++seed) {
        const Ray ray = ray_of(mesh, seed);
        const std::vector<Hit> expected = crossings_by_oracle(mesh, ray);
        ASSERT_TRUE(are_identical(all_hits_brute_force(mesh, ray), expected)) << "seed " << seed;
        for (const auto& [name, tree] : trees) {
            const std::vector<Hit> found = all_hits(mesh, tree, ray);
            ASSERT_TRUE(are_identical(found, expected))
                << name << ", seed " << seed << "\n"
                << testing::PrintToString(ray) << "\nfound    " << testing::PrintToString(found)
                << "\nexpected " << testing::PrintToString(expected);
            ASSERT_EQ(count_hits(mesh, tree, ray), expected.size()) << name << ", seed " << seed;
        }
    }
}

TEST_P(AllHitsLaws, first_k_hits_are_the_first_of_all) {
    const TriangleMesh mesh = GetParam().make();
    const std::vector<NamedTree> trees = all_trees(mesh);
    for (std::uint64_t seed = 0; seed < cases(150); ++seed) {
        const Ray ray = ray_of(mesh, seed);
        const std::vector<Hit> all = all_hits_brute_force(mesh, ray);
        for (const std::size_t k :
             {std::size_t{0}, std::size_t{1}, std::size_t{3}, all.size() + 2}) {
            std::vector<Hit> expected = all;
            expected.resize(k);
            for (const auto& [name, tree] : trees) {
                std::vector<Hit> found(k, Hit{.t = -1, .triangle = 5, .instance = 7});
                ASSERT_EQ(first_k_hits(mesh, tree, ray, found), std::min(k, all.size()))
                    << name << ", seed " << seed << ", k " << k;
                ASSERT_TRUE(are_identical(found, expected))
                    << name << ", seed " << seed << ", k " << k;
            }
        }
    }
}

TEST_P(AllHitsLaws, what_is_crossed_is_hit) {
    const TriangleMesh mesh = GetParam().make();
    const WideTree tree(mesh, build_tree(mesh));
    for (std::uint64_t seed = 0; seed < cases(300); ++seed) {
        const Ray ray = ray_of(mesh, seed);
        const std::vector<Hit> all = all_hits(mesh, tree, ray);
        if (all.empty()) continue;
        const auto closest = closest_hit(mesh, tree, ray);
        ASSERT_TRUE(closest) << "seed " << seed;
        EXPECT_LE(closest->t, all.front().t) << "seed " << seed;
    }
}

TEST_P(AllHitsLaws, batches_equal_single_rays_to_the_last_bit) {
    const TriangleMesh mesh = GetParam().make();
    const WideTree tree(mesh, build_tree(mesh));
    std::vector<Ray> rays;
    for (std::uint64_t seed = 0; seed < cases(600); ++seed) rays.push_back(ray_of(mesh, seed));
    const HitLists lists = all_hits(mesh, tree, rays);
    std::vector<std::size_t> counts(rays.size());
    count_hits(mesh, tree, rays, counts);
    std::vector<Hit> rows(2 * rays.size());
    first_k_hits(mesh, tree, rays, 2, rows);
    ASSERT_EQ(lists.size(), rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        std::vector<Hit> expected = all_hits(mesh, tree, rays[i]), found;
        for (std::size_t n = 0; n < lists.count(i); ++n) found.push_back(lists.hit(i, n));
        ASSERT_TRUE(are_identical(found, expected)) << "ray " << i;
        ASSERT_EQ(counts[i], expected.size()) << "ray " << i;
        expected.resize(2);
        ASSERT_TRUE(are_identical({rows[2 * i], rows[2 * i + 1]}, expected)) << "ray " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Families, AllHitsLaws, testing::ValuesIn(mesh_families()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace boxwood
