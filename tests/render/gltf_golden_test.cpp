// SPDX-License-Identifier: Apache-2.0
// Sample models of glTF look as they did when somebody looked at the pictures, which tests/golden
// keeps. The models stay out of the repository; those that aren't there are skipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <string>

#include "boxwood/image/png.h"
#include "boxwood/render/render.h"
#include "boxwood/world/read_world.h"

namespace boxwood {
namespace {

namespace fs = std::filesystem;

/// Where a model is: in the data that BOXWOOD_SHARED names, or in that of ./dev data.
struct Model {
    bool is_shared;
    const char* path;

    std::string name() const { return fs::path(path).stem().string(); }
};

constexpr Model kModels[] = {
    {true, "AlphaBlendModeTest.glb"},
    {true, "BoxInterleaved.glb"},
    {true, "CesiumMilkTruck.glb"},
    {true, "CornellBox.glb"},
    {true, "Duck.glb"},
    {true, "Fox.glb"},
    {true, "cubevc.glb"},
    {true, "mode5.gltf"},
    {true, "textureTransform/TextureTransformTest.gltf"},
    {false, "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb"},
    {false, "glTF2/BoxTextured-glTF-Binary/BoxTextured.glb"},
};

void PrintTo(const Model& model, std::ostream* out) { *out << model.path; }

class GltfGolden : public testing::TestWithParam<Model> {};

fs::path place_of(const Model& model) {
    if (!model.is_shared) return fs::path(BOXWOOD_SOURCE_DIR) / "data/assimp" / model.path;
    const char* shared = std::getenv("BOXWOOD_SHARED");
    return shared ? fs::path(shared) / "data/gltf" / model.path : fs::path();
}

bool is_near(const Rgba8& a, const Rgba8& b) {
    constexpr int kRounding = 4;  // what another machine's functions and decoder may differ by
    return std::abs(a.r - b.r) <= kRounding && std::abs(a.g - b.g) <= kRounding &&
           std::abs(a.b - b.b) <= kRounding;
}

TEST_P(GltfGolden, looks_as_it_should) {
    const fs::path path = place_of(GetParam());
    if (!fs::exists(path))
        GTEST_SKIP() << GetParam().path << " is not there: "
                     << (GetParam().is_shared ? "BOXWOOD_SHARED names no folder with it"
                                              : "./dev data brings it");
    const World world = read_world(path);
    const Surfaces surfaces(world);
    const Rgba8Image picture = to_rgba8(render(world, surfaces,
                                               {.width = 160,
                                                .height = 120,
                                                .integrator = world.picture.integrator,
                                                .samples = world.picture.samples}));
    const Rgba8Image golden =
        read_png(fs::path(BOXWOOD_SOURCE_DIR) / "tests/golden/gltf" / (GetParam().name() + ".png"));
    ASSERT_EQ(golden.width, picture.width);
    ASSERT_EQ(golden.height, picture.height);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        differing += !is_near(picture.pixels[i], golden.pixels[i]);
    EXPECT_LE(differing, picture.pixels.size() / 500) << "of " << picture.pixels.size();
}

INSTANTIATE_TEST_SUITE_P(Models, GltfGolden, testing::ValuesIn(kModels), [](const auto& test) {
    std::string name = test.param.name();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
    return name;
});

}  // namespace
}  // namespace boxwood
