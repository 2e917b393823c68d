// SPDX-License-Identifier: Apache-2.0
// A million rays at real meshes, and none with an odd number of crossings. ./dev data brings the
// meshes.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "boxwood/mesh/mesh_file.h"
#include "boxwood/mesh/weld.h"
#include "boxwood/query/all_hits.h"
#include "boxwood/scene/build_wide_tree.h"
#include "cases.h"
#include "laws/hits.h"
#include "laws/parity_rays.h"

namespace boxwood {
namespace {

/// Whether each edge belongs to an even number of faces: two in closed meshes, four and more where
/// simplification made surfaces touch, which counting doesn't mind.
bool edges_are_even(MeshView mesh) {
    const std::vector<std::uint32_t> name = weld(mesh.vertices);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const Vec3i& face : mesh.faces) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = name[face[k]], b = name[face[(k + 1) % 3]];
            if (a != b) edges.emplace_back(std::min(a, b), std::max(a, b));
        }
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
        while (next < edges.size() && edges[next] == edges[i]) ++next;
        if ((next - i) % 2 != 0) return false;
    }
    return true;
}

class ScanParity : public testing::TestWithParam<const char*> {};

TEST_P(ScanParity, no_ray_from_outside_crosses_an_odd_number_of_times) {
    const std::filesystem::path file =
        std::filesystem::path(BOXWOOD_DATA_DIR) / (std::string(GetParam()) + ".off");
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file << ": run ./dev data";
    const TriangleMesh mesh = read_mesh(file);
    ASSERT_TRUE(edges_are_even(mesh));
    const WideTree tree = build_wide_tree(mesh, {.preset = BuildPreset::fast});

    constexpr std::uint64_t kSeed = 6;
    const std::vector<Ray> rays = rays_from_outside(mesh, cases(350'000), kSeed);
    std::vector<std::size_t> counts(rays.size());
    count_hits(mesh, tree, rays, counts);
    std::size_t odd = 0, crossed = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (counts[i] % 2 != 0 && odd++ == 0)
            ADD_FAILURE() << "seed " << kSeed << ", ray " << i << " crosses " << counts[i]
                          << " times\n"
                          << testing::PrintToString(rays[i]);
        crossed += counts[i] > 0;
    }
    EXPECT_EQ(odd, 0u);
    EXPECT_GT(crossed, rays.size() / 2);
}

INSTANTIATE_TEST_SUITE_P(Scans, ScanParity, testing::Values("bunny", "dragon_48k", "dragon_871k"),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace boxwood
