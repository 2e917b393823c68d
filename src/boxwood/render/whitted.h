// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/render/integrator.h"

namespace boxwood {

class WhittedIntegrator : public Integrator {
public:
    WhittedIntegrator(const World& world, const Surfaces& surfaces, int bounces)
        : world_(world), surfaces_(surfaces), bounces_(bounces) {}

    Color radiance(const Ray& ray) const override { return trace(ray, bounces_); }
    bool uses_lens() const override { return true; }

private:
    Color trace(const Ray& ray, int bounces) const;

    const World& world_;
    const Surfaces& surfaces_;
    int bounces_;
};

}  // namespace boxwood
