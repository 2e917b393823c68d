// SPDX-License-Identifier: Apache-2.0
// Rays in double from one point, which frusta in float answer: the bits of the textbook's walk,
// wherever a camera stands and however finely it looks.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "boxwood/build/build.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/any_hit.h"
#include "boxwood/query/certified_hits.h"
#include "boxwood/query/closest_hit.h"
#include "boxwood/query/wide_tree.h"
#include "cases.h"
#include "laws/accelerators.h"
#include "laws/all_trees.h"
#include "laws/hits.h"
#include "laws/random.h"

namespace boxwood {
namespace {

struct Seen {
    std::string name;
    TriangleMesh mesh;
};

/// Moved and scaled so that most vertices aren't floats, or are far apart in float.
TriangleMesh moved(TriangleMesh mesh, double scale, const Vec3d& by) {
    for (Vec3d& vertex : mesh.vertices) vertex = scale * vertex + by;
    return mesh;
}

std::vector<Seen> what_is_seen() {
    const Vec3d odd(0.1, 0.7, -0.3);
    return {{"knot", generate_torus_knot(5000)},
            {"odd knot", moved(generate_torus_knot(5000), 1.0 / 3, odd)},
            {"far away", moved(generate_icosphere(2000), 1, 3000 * odd)},
            {"tiny", moved(generate_torus_knot(3000), 1e-7, 1e-8 * odd)},
            {"huge", moved(generate_torus_knot(3000), 1e8, 1e7 * odd)},
            {"few", moved(generate_icosphere(20), 1.1, odd)},
            {"soup", moved(generate_soup(400), 1.3, odd)},
            {"fine", moved(generate_icosphere(cases(60000)), 1, odd)}};
}

/// A square of rays about a direction, in groups of 16 x 16 as frusta like them. The finest come so
/// near each other that they hardly differ in float.
std::vector<Ray> camera(MeshView mesh, std::uint64_t seed) {
    Random random(seed);
    const Box3d box = bounds(mesh);
    const double size = (box.hi - box.lo).norm();
    const Vec3d target = mesh.corner(random.index(mesh.faces.size()), 0);
    Ray ray;
    ray.origin = box.centroid() + size * random.number(0.2, 2) * random.direction();
    // Near the surface, on it, and in a plane with a vertex.
    const auto place = random.index(4);
    if (place == 1)
        ray.origin = target + size * std::pow(10.0, random.number(-7, -1)) * random.direction();
    if (place == 2) ray.origin = target;
    if (place == 3) ray.origin[static_cast<int>(random.index(3))] = target[0];
    const Vec3d way =
        place == 2 ? Vec3d(random.direction()) : Vec3d((target - ray.origin).normalized());
    const double length = std::pow(2.0, random.number(-3, 3));
    Vec3d right = way.unitOrthogonal(), up = way.cross(right);
    const double step = std::pow(10.0, random.number(-7, -1.5));
    if (random.index(4) == 0) ray.t_min = random.number(0, 0.5) * size / length;
    if (random.index(4) == 0) ray.t_max = ray.t_min + random.number(0, 1) * size / length;
    std::vector<Ray> rays;
    for (int i = 0; i < 1024; ++i) {
        const int group = i / 256, packet = i / 16 % 16, lane = i % 16;
        const int x = group % 2 * 16 + packet % 4 * 4 + lane % 4 - 16,
                  y = group / 2 * 16 + packet / 4 * 4 + lane / 4 - 16;
        ray.direction = length * (way + step * (x * right + y * up));
        rays.push_back(ray);
    }
    return rays;
}

/// For each instruction set a plain one, a compact one, and one in which triangles are in several
/// leaves.
std::vector<NamedTree> trees_of(MeshView mesh, const Tree& tree) {
    const Tree split = build_tree(mesh, {.method = BuildMethod::spatial_split});
    std::vector<NamedTree> trees;
    for (const auto& [name, set] : instruction_sets()) {
        if (!is_supported(set)) continue;
        const std::string set_name(name);
        trees.push_back({set_name, WideTree(mesh, tree, {.instruction_set = set})});
        trees.push_back({set_name + ", compact",
                         WideTree(mesh, tree, {.instruction_set = set, .compact = true})});
        trees.push_back({set_name + ", split", WideTree(mesh, split, {.instruction_set = set})});
    }
    return trees;
}

TEST(CameraLaws, batches_in_double_have_the_bits_of_single_rays) {
    std::size_t hits_seen = 0, rays_asked = 0;
    for (const Seen& seen : what_is_seen()) {
        const MeshView mesh = seen.mesh;
        const Tree tree = build_tree(mesh);
        const std::vector<NamedTree> trees = trees_of(mesh, tree);
        for (std::uint64_t seed = 0; seed < cases(120); ++seed) {
            std::vector<Ray> rays = camera(mesh, seed);
            // Some see through what they would see first.
            const auto first = closest_hit(mesh, tree, rays[rays.size() / 2]);
            if (seed % 4 == 0 && first)
                for (Ray& ray : rays) ray.skip = {0, first->triangle};
            std::vector<std::optional<Hit>> expected;
            for (const Ray& ray : rays) {
                expected.push_back(closest_hit(mesh, tree, ray));
                hits_seen += expected.back().has_value();
            }
            rays_asked += rays.size();
            for (const auto& [name, wide] : trees) {
                std::vector<Hit> hits(rays.size());
                const std::unique_ptr<bool[]> any(new bool[rays.size()]);
                closest_hits(mesh, wide, rays, hits);
                any_hits(mesh, wide, rays, {any.get(), rays.size()});
                for (std::size_t i = 0; i < rays.size(); ++i) {
                    ASSERT_TRUE(are_identical(hits[i], expected[i].value_or(Hit{})))
                        << seen.name << ", " << name << ", seed " << seed << ", ray " << i << "\n"
                        << testing::PrintToString(rays[i]) << "\nfound    "
                        << testing::PrintToString(hits[i]) << "\nexpected "
                        << testing::PrintToString(expected[i]);
                    ASSERT_EQ(any[i], expected[i].has_value())
                        << seen.name << ", " << name << ", seed " << seed << ", ray " << i;
                }
            }
        }
    }
    EXPECT_GT(hits_seen, rays_asked / 3);
}

}  // namespace
}  // namespace boxwood
