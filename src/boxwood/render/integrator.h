// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "boxwood/image/image.h"
#include "boxwood/render/surfaces.h"
#include "boxwood/world/world.h"

namespace boxwood {

/// What a picture shows: turns each camera ray into a colour. One integrator a file.
class Integrator {
public:
    virtual ~Integrator() = default;

    /// What each ray sees, in order, on this thread. Called from many threads at once, each with
    /// the rays of a tile.
    virtual std::vector<Color> radiances(std::span<const Ray> rays) const = 0;

    /// What one ray sees.
    Color radiance(const Ray& ray) const { return radiances(std::span(&ray, 1))[0]; }

    /// Whether rays should leave from all over the camera's lens.
    virtual bool uses_lens() const { return false; }

    /// Whether a pixel may be the mean of several rays.
    virtual bool can_average() const { return true; }

    /// Whether what it measures is light, which a world's picture may want encoded.
    virtual bool shows_light() const { return false; }

    /// What radiance() measured, turned into colours once all pixels are known.
    virtual void develop(ColorImage&) const {}
};

/// The bounces limit how often whitted follows a ray. The arguments must outlive the integrator.
std::unique_ptr<Integrator> make_integrator(IntegratorKind kind, const World& world,
                                            const Surfaces& surfaces, int bounces);

}  // namespace boxwood
