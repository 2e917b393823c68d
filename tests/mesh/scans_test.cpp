// SPDX-License-Identifier: Apache-2.0
// Files from many sources have as many vertices and triangles as other programs find in them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "boxwood/mesh/mesh_file.h"

namespace boxwood {
namespace {

struct KnownMesh {
    const char* file;
    std::size_t vertices, faces;
};

class SharedMeshes : public testing::TestWithParam<KnownMesh> {};

TEST_P(SharedMeshes, counts_are_as_known) {
    const char* shared = std::getenv("BOXWOOD_SHARED");
    if (!shared) GTEST_SKIP() << "BOXWOOD_SHARED names no folder with data/" << GetParam().file;
    const std::filesystem::path file = std::filesystem::path(shared) / "data" / GetParam().file;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
    const MeshData mesh = read_mesh(file);
    EXPECT_EQ(mesh.vertices.size(), GetParam().vertices);
    EXPECT_EQ(mesh.faces.size(), GetParam().faces);
}

INSTANTIATE_TEST_SUITE_P(All, SharedMeshes,
                         testing::Values(KnownMesh{"cad/Cray_right.obj", 8, 12},
                                         KnownMesh{"cad/Generic_Twin_7863.1.t0_left.obj", 110, 212},
                                         KnownMesh{"cad/Generic_Twin_7863.1.t0_right.obj", 126,
                                                   244},
                                         KnownMesh{"cad/Havocglass8_left.obj", 84, 164},
                                         KnownMesh{"scans/fandisk.obj", 6475, 12946},
                                         KnownMesh{"scans/igea.ply", 134345, 268686},
                                         KnownMesh{"scans/plane_holes.obj", 8519, 16747},
                                         KnownMesh{"scans/rocker-arm.obj", 10044, 20088},
                                         KnownMesh{"scans/scorpion.obj", 49997, 99990},
                                         KnownMesh{"scans/spot.obj", 2930, 5856},
                                         KnownMesh{"scans/teapot.obj", 3644, 6320},
                                         KnownMesh{"scans/wingnut.obj", 3047, 6090}),
                         [](const auto& info) {
                             std::string name = info.param.file;
                             for (char& c : name)
                                 if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                             return name;
                         });

}  // namespace
}  // namespace boxwood
