// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/render/integrator.h"

namespace boxwood {

class WhittedIntegrator : public Integrator {
public:
    WhittedIntegrator(const World& world, const Surfaces& surfaces, int bounces)
        : world_(world), surfaces_(surfaces), bounces_(bounces) {}

    std::vector<Color> radiances(std::span<const Ray> rays) const override {
        return trace(rays, bounces_);
    }
    bool uses_lens() const override { return true; }
    bool shows_light() const override { return true; }

private:
    std::vector<Color> trace(std::span<const Ray> rays, int bounces) const;
    /// Adds the light's part at each hit that it isn't hidden from.
    void add_light(const Light& light, std::span<const Ray> rays, const SurfaceHits& hits,
                   std::vector<Color>& colors) const;

    const World& world_;
    const Surfaces& surfaces_;
    int bounces_;
};

}  // namespace boxwood
