// SPDX-License-Identifier: Apache-2.0
// The pictures that came with the assignment. They stay out of the repository, as nobody has said
// under which licence they are: BOXWOOD_SHARED names the folder that has them in acceptance/.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "boxwood/image/png.h"
#include "boxwood/render/render.h"
#include "boxwood/world/read_world.h"
#include "cases.h"
#include "laws/accelerators.h"

namespace boxwood {
namespace {

class Acceptance : public testing::TestWithParam<NamedAccelerator> {
protected:
    void SetUp() override {
        const char* shared = std::getenv("BOXWOOD_SHARED");
        if (!shared) GTEST_SKIP() << "BOXWOOD_SHARED doesn't name the folder with the pictures";
        if (kIsSanitized && GetParam().options.brute_force)
            GTEST_SKIP() << "takes a minute under a sanitizer; the laws try brute force, too";
        folder_ = std::filesystem::path(shared) / "acceptance";
    }

    /// Pixels in which our picture and the reference differ.
    int differing_pixels(IntegratorKind integrator, const char* reference_name) const {
        const World world = read_world(folder_ / "scene_bunny.json");
        const Surfaces surfaces(world, GetParam().options);
        const Rgba8Image ours = to_rgba8(render(world, surfaces, {.integrator = integrator}));
        const Rgba8Image reference = read_png(folder_ / reference_name);
        if (ours.width != reference.width || ours.height != reference.height) return -1;
        int differing = 0;
        for (std::size_t i = 0; i < ours.pixels.size(); ++i)
            differing += ours.pixels[i] != reference.pixels[i];
        RecordProperty("differing_pixels", differing);
        return differing;
    }

    std::filesystem::path folder_;
};

TEST_P(Acceptance, phong_is_the_reference_pixel_for_pixel) {
    EXPECT_EQ(differing_pixels(IntegratorKind::phong, "reference_bunny.png"), 0);
}

TEST_P(Acceptance, whitted_differs_from_the_reference_in_at_most_40_pixels) {
    const int differing = differing_pixels(IntegratorKind::whitted, "reference_bunny_whitted.png");
    EXPECT_GE(differing, 0) << "another size";
    EXPECT_LE(differing, 40);
}

INSTANTIATE_TEST_SUITE_P(Accelerators, Acceptance, testing::ValuesIn(all_accelerators()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace boxwood
