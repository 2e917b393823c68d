// SPDX-License-Identifier: Apache-2.0
// Parts as CAD programs export them. They aren't part of the project: BOXWOOD_SHARED names the
// folder that has them in data/cad.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "boxwood/mesh/inspect.h"
#include "boxwood/mesh/mesh_file.h"
#include "boxwood/mesh/repair.h"

namespace boxwood {
namespace {

struct Part {
    const char* file;
    std::size_t faces;
    std::size_t positions;  ///< distinct ones, as other programs count them
};

TEST(CadFiles, parts_are_closed_and_have_the_positions_that_others_count) {
    const char* shared = std::getenv("BOXWOOD_SHARED");
    if (!shared) GTEST_SKIP() << "BOXWOOD_SHARED names no folder with data/cad/*.stl";
    const std::filesystem::path folder = std::filesystem::path(shared) / "data" / "cad";
    const Part parts[] = {{"112932.stl", 7880, 3932},
                          {"472042.stl", 3632, 1814},
                          {"65004.stl", 1466, 731},
                          {"79741.stl", 14740, 7372},
                          {"908460.stl", 36074, 18035}};
    for (const Part& part : parts) {
        if (!std::filesystem::exists(folder / part.file))
            GTEST_SKIP() << (folder / part.file) << " is missing";
        MeshData mesh = read_mesh(folder / part.file);
        EXPECT_EQ(mesh.faces.size(), part.faces) << part.file;
        EXPECT_EQ(mesh.vertices.size(), 3 * part.faces) << part.file;
        EXPECT_EQ(mesh.vertices.size() - inspect(mesh).duplicate_vertices, part.positions);
        weld_vertices(mesh);
        EXPECT_EQ(mesh.vertices.size(), part.positions) << part.file;
        EXPECT_TRUE(is_closed(mesh)) << part.file;
        EXPECT_GT(inspect(mesh).volume.value_or(0), 0) << part.file;
    }
}

}  // namespace
}  // namespace boxwood
