// SPDX-License-Identifier: Apache-2.0
// Queries in float: the same bits as one triangle at a time, for every builder, width and
// instruction set that this machine has.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "boxwood/query/brute_force.h"
#include "boxwood/query/certified_hits.h"
#include "boxwood/query/wide_hits.h"
#include "cases.h"
#include "laws/all_trees.h"
#include "laws/columns.h"
#include "laws/float_hits.h"
#include "laws/float_oracle.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"
#include "laws/ray_families.h"

namespace boxwood {
namespace {

std::string text(const std::optional<Hitf>& hit) {
    if (!hit) return "no hit";
    std::ostringstream out;
    out.precision(9);
    out << "t " << hit->t << " u " << hit->u << " v " << hit->v << " triangle " << hit->triangle
        << " normal " << hit->normal[0] << " " << hit->normal[1] << " " << hit->normal[2];
    return out.str();
}

class WideLaws : public testing::TestWithParam<MeshFamily> {};

TEST_P(WideLaws, queries_equal_the_oracle_to_the_last_bit) {
    const TriangleMesh mesh = GetParam().make();
    const std::vector<NamedTree> trees = all_trees(mesh);
    const float scale = trees[0].tree.scale();
    for (std::uint64_t seed = 0; seed < cases(400); ++seed) {
        const Rayf ray = in_float(random_ray(mesh, seed));
        const auto expected = FloatOracle(mesh, ray, scale).closest_hit();
        for (const auto& [name, tree] : trees) {
            const auto found = closest_hit(tree, ray);
            ASSERT_TRUE(have_same_bits(found, expected))
                << name << ", seed " << seed << "\nfound    " << text(found) << "\nexpected "
                << text(expected);
            ASSERT_EQ(any_hit(tree, ray), expected.has_value()) << name << ", seed " << seed;

            WideCounts counts;
            Hitf counted;
            closest_hit(tree, ray, counted, counts);
            ASSERT_TRUE(have_same_bits(counted, expected.value_or(Hitf{})))
                << name << ", seed " << seed << ", counting\nfound    " << text(counted)
                << "\nexpected " << text(expected);
            ASSERT_EQ(any_hit(tree, ray, counts), expected.has_value()) << name << seed;
        }
    }
}

/// Some come from so far away that float can't tell the scene from a point.
Ray ray_from_near_or_far(const TriangleMesh& mesh, std::uint64_t seed) {
    Ray ray = random_ray(mesh, seed);
    if (seed % 4 == 0) ray.origin -= std::ldexp(1.0, static_cast<int>(seed % 80)) * ray.direction;
    return ray;
}

TEST_P(WideLaws, queries_in_double_equal_brute_force_to_the_last_bit) {
    const TriangleMesh mesh = GetParam().make();
    const std::vector<NamedTree> trees = all_trees(mesh);
    for (std::uint64_t seed = 0; seed < cases(400); ++seed) {
        const Ray ray = ray_from_near_or_far(mesh, seed);
        const auto expected = closest_hit_brute_force(mesh, ray);
        for (const auto& [name, tree] : trees) {
            const auto found = closest_hit(mesh, tree, ray);
            ASSERT_TRUE(are_identical(found, expected))
                << name << ", seed " << seed << "\n"
                << testing::PrintToString(ray) << "\nfound    " << testing::PrintToString(found)
                << "\nexpected " << testing::PrintToString(expected);
            ASSERT_EQ(any_hit(mesh, tree, ray), expected.has_value()) << name << seed;
        }
    }
}

TEST_P(WideLaws, rays_in_double_begin_and_end_to_the_last_bit) {
    const TriangleMesh mesh = GetParam().make();
    const std::vector<NamedTree> trees = all_trees(mesh);
    for (std::uint64_t seed = 0; seed < cases(60); ++seed) {
        const Ray ray = ray_from_near_or_far(mesh, seed);
        const auto hit = closest_hit_brute_force(mesh, ray);
        if (!hit) continue;
        std::vector<Ray> rays;
        for (const double t :
             {std::nextafter(hit->t, -HUGE_VAL), hit->t, std::nextafter(hit->t, HUGE_VAL)}) {
            rays.push_back(ray);
            rays.back().t_min = t;
            rays.push_back(ray);
            rays.back().t_max = t;
        }
        // Enough that they go as a batch, too.
        while (rays.size() < 12) rays.push_back(rays[rays.size() - 6]);
        std::vector<Hit> expected, hits(rays.size());
        for (const Ray& each : rays)
            expected.push_back(closest_hit_brute_force(mesh, each).value_or(Hit{}));
        for (const auto& [name, tree] : trees) {
            closest_hits(mesh, tree, rays, hits);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                SCOPED_TRACE(name + ", seed " + std::to_string(seed) + ", " +
                             testing::PrintToString(rays[i]));
                ASSERT_TRUE(are_identical(hits[i], expected[i]));
                Hit single;
                closest_hit(mesh, tree, rays[i], single);
                ASSERT_TRUE(are_identical(single, expected[i]));
            }
        }
    }
}

/// Tiles of a camera, which begin where groups do, and rays of all sorts, so that every kernel has
/// its share.
template <class RayAt>
std::vector<Ray> many_rays(const TriangleMesh& mesh, const RayAt& single_ray) {
    constexpr std::uint64_t kTiles = kIsSanitized ? 3 : 12;
    std::vector<Ray> rays;
    for (std::uint64_t seed = 1000; seed < 1000 + kTiles; ++seed) {
        // A tile of 16 x 16 rays about a ray, in packets of 4 x 4.
        const Ray center = random_ray(mesh, seed);
        const double step = 0.002 * static_cast<double>(1 + seed % 4);
        const double size = center.direction.cwiseAbs().maxCoeff();
        for (int i = 0; i < 256; ++i) {
            const int packet = i / 16, lane = i % 16;
            const int x = packet % 4 * 4 + lane % 4, y = packet / 4 * 4 + lane / 4;
            Ray ray = center;
            ray.direction[seed % 3] += step * (x - 8) * size;
            ray.direction[(seed + 1) % 3] += step * (y - 8) * size;
            rays.push_back(ray);
        }
    }
    for (std::uint64_t seed = 0; seed < cases(500); ++seed) rays.push_back(single_ray(mesh, seed));
    return rays;
}

TEST_P(WideLaws, batches_in_double_equal_brute_force_to_the_last_bit) {
    const TriangleMesh mesh = GetParam().make();
    const std::vector<Ray> rays = many_rays(mesh, ray_from_near_or_far);
    std::vector<std::optional<Hit>> expected;
    expected.reserve(rays.size());
    for (const Ray& ray : rays) expected.push_back(closest_hit_brute_force(mesh, ray));
    for (const auto& [name, tree] : all_trees(mesh)) {
        for (const std::size_t count : {std::size_t{1}, std::size_t{9}, rays.size()}) {
            std::vector<Hit> hits(count, Hit{.t = -1, .triangle = 7, .instance = 9});
            const std::unique_ptr<bool[]> any(new bool[count]);
            closest_hits(mesh, tree, std::span(rays).first(count), hits);
            any_hits(mesh, tree, std::span(rays).first(count), {any.get(), count});
            for (std::size_t i = 0; i < count; ++i) {
                ASSERT_TRUE(are_identical(hits[i], expected[i].value_or(Hit{})))
                    << name << ", ray " << i << " of " << count << "\n"
                    << testing::PrintToString(rays[i]) << "\nfound    "
                    << testing::PrintToString(hits[i]) << "\nexpected "
                    << testing::PrintToString(expected[i]);
                ASSERT_EQ(any[i], expected[i].has_value())
                    << name << ", ray " << i << " of " << count << "\n"
                    << testing::PrintToString(rays[i]);
            }
        }
    }
}

TEST_P(WideLaws, batches_equal_single_rays_to_the_last_bit) {
    const TriangleMesh mesh = GetParam().make();
    std::vector<Rayf> rays;
    for (const Ray& ray : many_rays(mesh, random_ray)) rays.push_back(in_float(ray));
    const std::vector<NamedTree> trees = all_trees(mesh);
    const float scale = trees[0].tree.scale();
    std::vector<std::optional<Hitf>> expected;
    expected.reserve(rays.size());
    for (const Rayf& ray : rays) expected.push_back(FloatOracle(mesh, ray, scale).closest_hit());
    for (const auto& [name, tree] : trees) {
        for (const std::size_t count :
             {std::size_t{1}, std::size_t{7}, std::size_t{64}, rays.size()}) {
            std::vector<Hitf> hits(count);
            const std::unique_ptr<bool[]> any(new bool[count]);
            closest_hits(tree, std::span(rays).first(count), hits);
            any_hits(tree, std::span(rays).first(count), {any.get(), count});
            for (std::size_t i = 0; i < count; ++i) {
                ASSERT_TRUE(have_same_bits(hits[i], expected[i].value_or(Hitf{})))
                    << name << ", ray " << i << " of " << count << "\nfound    " << text(hits[i])
                    << "\nexpected " << text(expected[i]);
                ASSERT_EQ(any[i], expected[i].has_value()) << name << ", ray " << i;
            }
            Columns columns{std::span(rays).first(count)};
            closest_hits(tree, columns.rays(), columns.hits());
            ASSERT_TRUE(columns.hold(hits)) << name;
            any_hits(tree, columns.rays(), columns.any());
            ASSERT_TRUE(std::equal(any.get(), any.get() + count, columns.any().begin())) << name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Families, WideLaws, testing::ValuesIn(mesh_families()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace boxwood
