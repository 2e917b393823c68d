// SPDX-License-Identifier: Apache-2.0
#include "boxwood/render/render.h"

#include <algorithm>
#include <mutex>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/render/sampler.h"

namespace boxwood {

namespace {

constexpr int kTileSize = 16;

class Renderer {
public:
    Renderer(const World& world, const Surfaces& surfaces, const RenderOptions& options)
        : camera_(world.camera),
          options_(options),
          integrator_(make_integrator(options.integrator, world, surfaces, options.bounces)),
          image_(options.width, options.height, Color::Zero()) {
        uses_lens_ = integrator_->uses_lens() && options.samples > 1 && camera_.lens_radius > 0;
        const bool rays_differ = uses_lens_ || camera_.pixel_spread > 0;
        samples_ = rays_differ && integrator_->can_average() ? options.samples : 1;
    }

    ColorImage render() && {
        const int columns = (options_.width + kTileSize - 1) / kTileSize;
        const int rows = (options_.height + kTileSize - 1) / kTileSize;
        const auto tiles = static_cast<std::size_t>(columns) * rows;
        parallel_for(tiles, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t tile = begin; tile < end; ++tile) {
                render_tile(static_cast<int>(tile % columns), static_cast<int>(tile / columns));
                report_one_of(tiles);
            }
        });
        integrator_->develop(image_);
        return std::move(image_);
    }

private:
    void render_tile(int column, int row) {
        const int right = std::min((column + 1) * kTileSize, options_.width);
        const int bottom = std::min((row + 1) * kTileSize, options_.height);
        for (int y = row * kTileSize; y < bottom; ++y) {
            for (int x = column * kTileSize; x < right; ++x) image_.at(x, y) = pixel(x, y);
        }
    }

    Color pixel(int x, int y) const {
        if (samples_ == 1) return radiance({.film = {x + 0.5, y + 0.5}});
        const auto index = static_cast<std::uint64_t>(y) * options_.width + x;
        Color sum = Color::Zero();
        for (int i = 0; i < samples_; ++i) {
            CameraSample sample =
                camera_sample(options_.seed, index, i, camera_.pixel_spread, x, y);
            if (!uses_lens_) sample.lens.setZero();
            sum += radiance(sample);
        }
        return sum / samples_;
    }

    Color radiance(const CameraSample& sample) const {
        return integrator_->radiance(camera_.ray(sample, options_.width, options_.height));
    }

    void report_one_of(std::size_t tiles) {
        if (!options_.progress) return;
        const std::lock_guard lock(progress_mutex_);
        ++tiles_done_;
        options_.progress(static_cast<double>(tiles_done_) / static_cast<double>(tiles));
    }

    const Camera& camera_;
    const RenderOptions& options_;
    std::unique_ptr<Integrator> integrator_;
    ColorImage image_;
    bool uses_lens_ = false;
    int samples_ = 1;
    std::mutex progress_mutex_;
    std::size_t tiles_done_ = 0;
};

}  // namespace

ColorImage render(const World& world, const Surfaces& surfaces, const RenderOptions& options) {
    if (!is_image_size(options.width, options.height))
        throw InvalidInput(
            "render: expected a width and a height of at least 1, up to 2^28 pixels");
    if (options.samples < 1 || options.bounces < 0)
        throw InvalidInput("render: expected at least one sample and no negative bounces");
    if (options.integrator == IntegratorKind::heat && !surfaces.scene().counts_steps())
        throw InvalidInput("render: heat counts steps, expected SceneOptions with keep_trees");
    return Renderer(world, surfaces, options).render();
}

}  // namespace boxwood
