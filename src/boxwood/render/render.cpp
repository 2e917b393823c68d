// SPDX-License-Identifier: Apache-2.0
#include "boxwood/render/render.h"

#include <algorithm>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/image/srgb.h"
#include "boxwood/render/sampler.h"

namespace boxwood {

namespace {

constexpr int kTileSize = 16;

struct Pixel {
    int x, y;
};

class Renderer {
public:
    Renderer(const World& world, const Surfaces& surfaces, const RenderOptions& options)
        : camera_(world.camera),
          film_(camera_.film(options.width, options.height)),
          options_(options),
          encoding_(world.picture.encoding),
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
        const BatchOptions watched = {.progress = options_.progress,
                                      .cancellation = options_.cancellation};
        for_each_piece(tiles, 1, watched, [&](std::size_t tile, std::size_t) {
            render_tile(static_cast<int>(tile % columns), static_cast<int>(tile / columns));
        });
        integrator_->develop(image_);
        if (integrator_->shows_light() && encoding_ == ColorEncoding::srgb) encode();
        return std::move(image_);
    }

private:
    void encode() {
        for (Color& pixel : image_.pixels) pixel = pixel.unaryExpr(&linear_to_srgb);
    }

    /// The rays of one sample go together, so that memory doesn't grow with the samples.
    void render_tile(int column, int row) {
        const int right = std::min((column + 1) * kTileSize, options_.width);
        const int bottom = std::min((row + 1) * kTileSize, options_.height);
        std::vector<Pixel> pixels;
        for (int y = row * kTileSize; y < bottom; ++y)
            for (int x = column * kTileSize; x < right; ++x) pixels.push_back({x, y});

        std::vector<Ray> rays(pixels.size());
        std::vector<Color> sums(pixels.size(), Color::Zero());
        for (int i = 0; i < samples_; ++i) {
            for (std::size_t k = 0; k < pixels.size(); ++k)
                rays[k] = camera_.ray(sample(pixels[k], i), film_);
            const std::vector<Color> colors = integrator_->radiances(rays);
            for (std::size_t k = 0; k < pixels.size(); ++k) sums[k] += colors[k];
        }
        for (std::size_t k = 0; k < pixels.size(); ++k)
            image_.at(pixels[k].x, pixels[k].y) = sums[k] / samples_;
    }

    CameraSample sample(const Pixel& pixel, int i) const {
        const auto [x, y] = pixel;
        if (samples_ == 1) return {.film = {x + 0.5, y + 0.5}};
        const auto index = static_cast<std::uint64_t>(y) * options_.width + x;
        CameraSample sample = camera_sample(options_.seed, index, i, camera_.pixel_spread, x, y);
        if (!uses_lens_) sample.lens.setZero();
        return sample;
    }

    const Camera& camera_;
    const Film film_;
    const RenderOptions& options_;
    const ColorEncoding encoding_;
    std::unique_ptr<Integrator> integrator_;
    ColorImage image_;
    bool uses_lens_ = false;
    int samples_ = 1;
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
