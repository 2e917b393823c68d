// SPDX-License-Identifier: Apache-2.0
#include "boxwood/render/render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <mutex>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/render/sampler.h"

namespace boxwood {
namespace {

/// A white sphere, or what is seen of it, before a black sky.
World sphere_world() {
    World world;
    world.ambient = Color::Ones();
    world.materials = {{.ambient = Color::Ones()}};
    world.spheres = {{{0, 0, -3}, 1, 0}};
    return world;
}

ColorImage render(const RenderOptions& options, const World& world = sphere_world()) {
    const Surfaces surfaces(world);
    return boxwood::render(world, surfaces, options);
}

TEST(Render, options_out_of_range_are_refused) {
    for (const int bad : {0, -1, INT_MIN, INT_MAX}) {
        EXPECT_THROW(render({.width = bad}), InvalidInput) << bad;
        EXPECT_THROW(render({.height = bad}), InvalidInput) << bad;
    }
    for (const int bad : {0, -1, INT_MIN})
        EXPECT_THROW(render({.samples = bad}), InvalidInput) << bad;
    EXPECT_THROW(render({.bounces = -1}), InvalidInput);
}

TEST(Render, picture_has_the_size_asked_for) {
    for (const auto& [width, height] : {std::pair(1, 1), {16, 16}, {17, 15}, {100, 1}, {1, 33}}) {
        const ColorImage image = render({.width = width, .height = height});
        EXPECT_EQ(image.width, width);
        EXPECT_EQ(image.height, height);
        EXPECT_EQ(image.pixels.size(), static_cast<std::size_t>(width) * height);
    }
    const ColorImage by_default = render({});
    EXPECT_EQ(by_default.width, 640);
    EXPECT_EQ(by_default.height, 480);
}

TEST(Render, sphere_in_the_middle_is_in_the_middle_and_up_is_up) {
    World world = sphere_world();
    world.spheres.push_back({{0, 1, -3}, 0.1, 0});
    world.spheres[0].radius = 0.3;
    const ColorImage image = render({.width = 41, .height = 41}, world);
    EXPECT_EQ(image.at(20, 20), Color(1, 1, 1));
    EXPECT_EQ(image.at(20, 4), Color(1, 1, 1));
    EXPECT_EQ(image.at(20, 36), Color(0, 0, 0));
    EXPECT_EQ(image.at(0, 20), Color(0, 0, 0));
}

TEST(Render, progress_grows_to_1) {
    std::vector<double> parts;
    std::mutex mutex;
    bool at_once = false;
    render({.width = 100, .height = 70, .progress = [&](double part) {
                const std::unique_lock lock(mutex, std::try_to_lock);
                if (!lock) at_once = true;
                parts.push_back(part);
            }});
    ASSERT_FALSE(parts.empty());
    EXPECT_FALSE(at_once) << "called by two threads at a time";
    EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
    EXPECT_GT(parts.front(), 0);
    EXPECT_EQ(parts.back(), 1);
}

TEST(Render, can_be_cancelled) {
    const ThreadLimit limit(1);  // or the others may do all before the first report
    Cancellation cancellation;
    RenderOptions options = {.progress = [&](double) { cancellation.request(); },
                             .cancellation = &cancellation};
    EXPECT_THROW(render(options), Cancelled);
    options.cancellation = nullptr;
    EXPECT_EQ(render(options).pixels, render({}).pixels);
}

TEST(Render, inside_a_parallel_loop_gives_the_same_picture) {
    const ColorImage expected = render({.integrator = IntegratorKind::whitted});
    parallel_for(4, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            EXPECT_EQ(render({.integrator = IntegratorKind::whitted}).pixels, expected.pixels);
    });
}

TEST(Render, samples_count_only_where_they_differ) {
    World world = sphere_world();
    const auto pixels = [&](IntegratorKind integrator, int samples) {
        return render({.width = 40, .height = 30, .integrator = integrator, .samples = samples},
                      world)
            .pixels;
    };
    EXPECT_EQ(pixels(IntegratorKind::whitted, 8), pixels(IntegratorKind::whitted, 1));
    world.camera.lens_radius = 0.2;
    EXPECT_EQ(pixels(IntegratorKind::phong, 8), pixels(IntegratorKind::phong, 1));
    EXPECT_NE(pixels(IntegratorKind::whitted, 8), pixels(IntegratorKind::whitted, 1));
    world.camera.lens_radius = 0;
    world.camera.pixel_spread = 1;
    EXPECT_NE(pixels(IntegratorKind::phong, 8), pixels(IntegratorKind::phong, 1));
}

TEST(Render, samples_over_the_pixel_smooth_edges) {
    World world = sphere_world();
    world.camera.pixel_spread = 1;
    const ColorImage image = render({.width = 40, .height = 30, .samples = 16}, world);
    int gray = 0;
    for (const Color& pixel : image.pixels) gray += pixel.x() > 0 && pixel.x() < 1;
    EXPECT_GT(gray, 20);
    EXPECT_EQ(image.at(20, 15), Color(1, 1, 1));
    EXPECT_EQ(image.at(0, 0), Color(0, 0, 0));
}

TEST(Sampler, samples_lie_in_the_pixel_and_on_the_lens) {
    for (std::uint64_t pixel = 0; pixel < 100; ++pixel) {
        for (int i = 0; i < 64; ++i) {
            const CameraSample sample = camera_sample(1, pixel, i, 1, 7, 9);
            EXPECT_TRUE(sample.film.x() >= 7 && sample.film.x() <= 8);
            EXPECT_TRUE(sample.film.y() >= 9 && sample.film.y() <= 10);
            EXPECT_TRUE(sample.lens.minCoeff() >= 0 && sample.lens.maxCoeff() < 1);
            EXPECT_EQ(camera_sample(1, pixel, i, 0, 7, 9).film, Vec2d(7.5, 9.5));
        }
    }
}

TEST(Sampler, samples_of_a_pixel_fill_its_quarters_evenly) {
    for (std::uint64_t pixel = 0; pixel < 50; ++pixel) {
        int film[4] = {}, lens[4] = {};
        for (int i = 0; i < 64; ++i) {
            const CameraSample s = camera_sample(2, pixel, i, 1, 0, 0);
            ++film[(s.film.x() > 0.5) + 2 * (s.film.y() > 0.5)];
            ++lens[(s.lens.x() > 0.5) + 2 * (s.lens.y() > 0.5)];
        }
        for (int k = 0; k < 4; ++k) {
            EXPECT_NEAR(film[k], 16, 6) << pixel;
            EXPECT_NEAR(lens[k], 16, 6) << pixel;
        }
    }
}

}  // namespace
}  // namespace boxwood
