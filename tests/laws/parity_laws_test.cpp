// SPDX-License-Identifier: Apache-2.0
// A ray from outside a closed mesh crosses it an even number of times, one from inside an odd
// number, also where it meets edges and vertices or runs along them.
#include <gtest/gtest.h>

#include <cmath>

#include "boxwood/mesh/inspect.h"
#include "boxwood/query/all_hits.h"
#include "boxwood/query/brute_force.h"
#include "cases.h"
#include "laws/all_trees.h"
#include "laws/closed_meshes.h"
#include "laws/hits.h"
#include "laws/parity_rays.h"
#include "laws/random.h"

namespace boxwood {
namespace {

constexpr std::uint64_t kSeed = 5;

TEST(Parity, rays_from_outside_a_closed_mesh_cross_it_an_even_number_of_times) {
    std::size_t crossed = 0;
    for (const ClosedMesh& closed : closed_meshes()) {
        ASSERT_TRUE(inspect(closed.mesh).closed) << closed.name;
        const WideTree tree(closed.mesh, build_tree(closed.mesh));
        const std::vector<Ray> rays = rays_from_outside(closed.mesh, cases(20'000), kSeed);
        std::vector<std::size_t> counts(rays.size());
        count_hits(closed.mesh, tree, rays, counts);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ASSERT_EQ(counts[i] % 2, 0u)
                << closed.name << ", seed " << kSeed << ", ray " << i << "\n"
                << testing::PrintToString(rays[i]);
            crossed += counts[i] > 0;
        }
    }
    EXPECT_GT(crossed, cases(200'000u));
}

/// Where a point is, the sum of solid angles knows.
TEST(Parity, rays_from_anywhere_tell_inside_from_outside) {
    std::size_t inside = 0, outside = 0;
    for (const ClosedMesh& closed : closed_meshes()) {
        const MeshView mesh = closed.mesh;
        const WideTree tree(mesh, build_tree(mesh));
        const Box3d box = bounds(mesh);
        Random random(kSeed);
        for (int i = 0; i < cases(200); ++i) {
            const std::size_t face = random.index(mesh.faces.size());
            const Vec3d middle =
                (mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2)) / 3;
            Vec3d origin = middle - closed.thickness * geometric_normal(mesh, face);
            if (i % 2 == 0) origin = box.lo + random.point(0, 1).cwiseProduct(box.extent());
            const double winding = winding_number_brute_force(mesh, origin);
            ASSERT_NEAR(winding, std::round(winding), 1e-6) << closed.name;
            const bool is_inside = std::lround(winding) % 2 != 0;
            ++(is_inside ? inside : outside);
            for (int k = 0; k < 30; ++k) {
                const std::size_t aim = random.index(mesh.faces.size());
                const Vec3d &a = mesh.corner(aim, 0), &b = mesh.corner(aim, 1);
                const Vec3d target = k % 2 == 0 ? a : 0.5 * (a + b);
                const Ray ray = {.origin = origin, .direction = target - origin};
                ASSERT_EQ(count_hits(mesh, tree, ray) % 2 == 1, is_inside)
                    << closed.name << ", seed " << kSeed << "\n"
                    << testing::PrintToString(ray);
            }
        }
    }
    EXPECT_GT(inside, cases(1000u));
    EXPECT_GT(outside, cases(500u));
}

/// All coordinates and directions are exact here: the rays do pass through vertices, along edges
/// and diagonals, and in the planes of faces.
TEST(Parity, rays_exactly_through_a_cube_cross_it_twice_or_graze_it) {
    const TriangleMesh mesh = subdivided_cube(4);
    for (const auto& [name, tree] : all_trees(mesh)) {
        for (int i = -1; i <= 9; ++i) {
            for (int j = -1; j <= 9; ++j) {
                for (int axis = 0; axis < 3; ++axis) {
                    for (const double slope : {0.0, 1.0, -1.0}) {
                        Ray ray;
                        ray.origin[axis] = -2;
                        ray.origin[(axis + 1) % 3] = i / 8.0 - 2 * slope;
                        ray.origin[(axis + 2) % 3] = j / 8.0;
                        ray.direction.setZero();
                        ray.direction[axis] = 1;
                        ray.direction[(axis + 1) % 3] = slope;
                        const std::size_t count = count_hits(mesh, tree, ray);
                        ASSERT_TRUE(count == 0 || count == 2)
                            << name << ": " << count << ", " << testing::PrintToString(ray);
                        const bool goes_inside = slope == 0 && i > 0 && i < 8 && j > 0 && j < 8;
                        if (goes_inside) {
                            ASSERT_EQ(count, 2u) << name << testing::PrintToString(ray);
                        }
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace boxwood
