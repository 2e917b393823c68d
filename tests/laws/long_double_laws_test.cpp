// SPDX-License-Identifier: Apache-2.0
// Rays hit what they hit in long double, by another formula, wherever rounding can't decide: a
// million pairs of a ray and a triangle for double, and as many for float.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "boxwood/query/certified_hits.h"
#include "boxwood/query/wide_hits.h"
#include "boxwood/scene/build_wide_tree.h"
#include "cases.h"
#include "laws/hits.h"
#include "laws/long_double_oracle.h"
#include "laws/random.h"

namespace boxwood {
namespace {

constexpr std::size_t kTriangles = 32, kRays = 100;
constexpr std::uint64_t kMeshes = 320;
static_assert(kTriangles * kRays * kMeshes >= 1'000'000);

/// Triangles and rays of one kind, the same for one seed.
struct Case {
    TriangleMesh mesh;
    std::vector<Ray> rays;
    std::string kind;
};

Case make_case(std::uint64_t seed) {
    Random random(seed);
    const char* kKinds[] = {"fat",  "needles",  "slivers",  "tiny",
                            "huge", "far away", "coplanar", "sharing edges"};
    const std::size_t kind = seed % std::size(kKinds);
    Case result;
    result.kind = kKinds[kind];
    double scale = 1;
    Vec3d offset = Vec3d::Zero();
    if (kind == 3) scale = std::pow(10.0, random.number(-12, -3));
    if (kind == 4) scale = std::pow(10.0, random.number(3, 12));
    if (kind == 5) offset = random.point(-1e4, 1e4);
    TriangleMesh& mesh = result.mesh;
    for (std::size_t i = 0; i < kTriangles; ++i) {
        const int first = static_cast<int>(mesh.vertices.size());
        const Vec3d a = random.point(-1, 1), along = random.point(-1, 1),
                    aside = random.point(-1, 1);
        double thin = 1;
        if (kind == 1) thin = std::pow(10.0, random.number(-6, -2));
        if (kind == 2) thin = std::pow(10.0, random.number(-14, -6));
        Vec3d corners[3] = {a, a + along, a + random.number() * along + thin * aside};
        if (kind == 6)
            for (Vec3d& p : corners) p.z() = 0.25 * static_cast<double>(i % 4);
        for (const Vec3d& p : corners) mesh.vertices.push_back(scale * p + offset);
        if (kind == 7 && i > 0)
            mesh.faces.push_back({first - 2, first - 1, first + 2});
        else
            mesh.faces.push_back({first, first + 1, first + 2});
    }
    for (std::size_t i = 0; i < kRays; ++i) {
        const Vec3i& face = mesh.faces[random.index(kTriangles)];
        // On a triangle, on its edge, at its corner, or anywhere.
        double u = random.number(), v = random.number() * (1 - u);
        if (i % 8 == 1) v = 0;
        if (i % 8 == 2) u = v = 0;
        Vec3d target = (1 - u - v) * mesh.vertices[face[0]] + u * mesh.vertices[face[1]] +
                       v * mesh.vertices[face[2]];
        if (i % 8 == 3) target = scale * random.point(-1, 1) + offset;
        Ray ray;
        ray.origin = scale * random.point(-3, 3) + offset;
        // In the plane of the coplanar ones.
        if (kind == 6 && i % 8 == 4) ray.origin.z() = target.z();
        ray.direction = (target - ray.origin) * std::pow(2.0, random.number(-6, 6));
        if (scale != 1) ray.direction /= scale;
        result.rays.push_back(ray);
    }
    return result;
}

/// How the pairs were judged.
struct Counts {
    std::size_t pairs = 0, hits = 0, unsure = 0;
};

/// Holds an answer against what long double says of every triangle.
template <class Answer>
void check_answer(const Case& it, const Ray& ray, const Answer& found, long double off,
                  Counts& counts) {
    for (std::uint32_t i = 0; i < it.mesh.faces.size(); ++i) {
        const MeshView mesh = it.mesh;
        const Judgement exact =
            judge(ray, mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2), off);
        ++counts.pairs;
        counts.hits += exact.verdict == Judgement::hits;
        counts.unsure += exact.verdict == Judgement::unsure;
        const bool is_found = found && found->triangle == i;
        if (exact.verdict == Judgement::misses) ASSERT_FALSE(is_found) << it.kind << " face " << i;
        if (exact.verdict != Judgement::hits) continue;
        ASSERT_TRUE(found) << it.kind << " face " << i;
        if (is_found)
            ASSERT_LE(std::abs(exact.t - static_cast<long double>(found->t)), exact.t_error)
                << it.kind << " face " << i;
        else
            ASSERT_LE(static_cast<long double>(found->t), exact.t + exact.t_error)
                << it.kind << " face " << i << " is nearer";
    }
}

/// Has answer(case, tree, ray) judged for all of them; it may round the ray.
template <class Answer>
void check_a_million_pairs(long double off, const Answer& answer) {
    Counts counts;
    for (std::uint64_t seed = 0; seed < cases(kMeshes); ++seed) {
        const Case it = make_case(seed);
        const WideTree tree = build_wide_tree(it.mesh);
        for (Ray ray : it.rays) {
            const auto found = answer(it, tree, ray);
            ASSERT_NO_FATAL_FAILURE(check_answer(it, ray, found, off, counts))
                << "seed " << seed << "\n"
                << testing::PrintToString(ray);
        }
    }
    EXPECT_EQ(counts.pairs, cases(kMeshes) * kRays * kTriangles);
    EXPECT_GT(counts.hits, counts.pairs / 50);
    EXPECT_LT(counts.unsure, counts.pairs / 10);
}

TEST(LongDoubleLaws, double_agrees_on_a_million_pairs) {
    check_a_million_pairs(0x1p-49L, [](const Case& it, const WideTree& tree, const Ray& ray) {
        return closest_hit(it.mesh, tree, ray);
    });
}

TEST(LongDoubleLaws, float_agrees_on_a_million_pairs) {
    check_a_million_pairs(0x1p-20L, [](const Case&, const WideTree& tree, Ray& ray) {
        Rayf in_float;
        for (int k = 0; k < 3; ++k) {
            ray.origin[k] = in_float.origin[k] = static_cast<float>(ray.origin[k]);
            ray.direction[k] = in_float.direction[k] = static_cast<float>(ray.direction[k]);
        }
        return closest_hit(tree, in_float);
    });
}

}  // namespace
}  // namespace boxwood
