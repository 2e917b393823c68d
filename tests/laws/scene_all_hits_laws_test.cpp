// SPDX-License-Identifier: Apache-2.0
// The crossings of a scene are those of its meshes, put in order, whatever its trees.
#include <gtest/gtest.h>

#include <algorithm>

#include "boxwood/core/error.h"
#include "boxwood/scene/scene.h"
#include "cases.h"
#include "laws/accelerators.h"
#include "laws/crossing_oracle.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"
#include "laws/random.h"
#include "laws/ray_families.h"

namespace boxwood {
namespace {

/// Families that lie about the origin; some twice, so that meshes tie.
std::vector<TriangleMesh> some_meshes() {
    std::vector<TriangleMesh> meshes;
    for (const char* name : {"soup", "nothing", "cube", "duplicates", "grid", "duplicates",
                             "only_nan", "grid", "with_bad_vertices", "cube"}) {
        const auto& families = mesh_families();
        const auto family = std::find_if(families.begin(), families.end(),
                                         [&](const MeshFamily& f) { return f.name == name; });
        meshes.push_back(family->make());
    }
    return meshes;
}

std::vector<Hit> crossings_of_all(const std::vector<TriangleMesh>& meshes, const Ray& ray) {
    std::vector<Hit> all;
    for (std::uint32_t i = 0; i < meshes.size(); ++i) {
        Ray ray_in_mesh = ray;
        if (ray.skip.instance != i) ray_in_mesh.skip = {};
        for (Hit hit : crossings_by_oracle(meshes[i], ray_in_mesh)) {
            hit.instance = i;
            all.push_back(hit);
        }
    }
    std::sort(all.begin(), all.end(), [](const Hit& a, const Hit& b) { return is_closer(a, b); });
    return all;
}

std::vector<Ray> some_rays(const std::vector<TriangleMesh>& meshes, std::uint64_t count) {
    std::vector<Ray> rays;
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        const std::size_t mesh = Random(seed).index(meshes.size());
        rays.push_back(random_ray(meshes[mesh], seed));
        if (rays.back().skip.triangle != TriangleId::kNone)
            rays.back().skip.instance = static_cast<std::uint32_t>(mesh);
    }
    return rays;
}

bool are_identical(std::span<const Hit> a, std::span<const Hit> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Hit& p, const Hit& q) {
        return are_identical(std::optional(p), std::optional(q));
    });
}

TEST(SceneAllHits, equal_the_oracle_to_the_last_bit_one_by_one_and_in_batches) {
    const std::vector<TriangleMesh> meshes = some_meshes();
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, meshes.size()}) {
        const std::vector<TriangleMesh> chosen(meshes.begin(),
                                               meshes.begin() + static_cast<std::ptrdiff_t>(count));
        const std::vector<Ray> rays = some_rays(meshes, cases(700));
        std::vector<std::vector<Hit>> expected;
        for (const Ray& ray : rays) expected.push_back(crossings_of_all(chosen, ray));
        for (const NamedAccelerator& accelerator : all_accelerators()) {
            const Scene scene({chosen.begin(), chosen.end()}, accelerator.options);
            constexpr std::size_t kFirst = 3;
            const HitLists lists = scene.all_hits(rays);
            std::vector<std::size_t> counts(rays.size());
            scene.count_hits(rays, counts);
            std::vector<Hit> rows(kFirst * rays.size());
            scene.first_k_hits(rays, kFirst, rows);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const auto what = [&] {
                    return accelerator.name + ", ray " + std::to_string(i) + " " +
                           testing::PrintToString(rays[i]);
                };
                ASSERT_TRUE(are_identical(scene.all_hits(rays[i]), expected[i])) << what();
                ASSERT_EQ(scene.count_hits(rays[i]), expected[i].size()) << what();
                ASSERT_EQ(counts[i], expected[i].size()) << what();
                std::vector<Hit> listed;
                for (std::size_t n = 0; n < lists.count(i); ++n) listed.push_back(lists.hit(i, n));
                ASSERT_TRUE(are_identical(listed, expected[i])) << what();
                std::vector<Hit> first = expected[i], found(kFirst);
                first.resize(kFirst);
                ASSERT_EQ(scene.first_k_hits(rays[i], found), std::min(kFirst, expected[i].size()));
                ASSERT_TRUE(are_identical(found, first)) << what();
                ASSERT_TRUE(are_identical(std::span(rows).subspan(kFirst * i, kFirst), first))
                    << what();
            }
        }
    }
}

TEST(SceneAllHits, batches_refuse_sizes_that_differ) {
    const Scene scene({});
    const std::vector<Ray> rays(5);
    std::vector<std::size_t> counts(4);
    std::vector<Hit> hits(14);
    EXPECT_THROW(scene.count_hits(rays, counts), InvalidInput);
    EXPECT_THROW(scene.first_k_hits(rays, 3, hits), InvalidInput);
}

}  // namespace
}  // namespace boxwood
