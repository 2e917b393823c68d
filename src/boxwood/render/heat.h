// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/render/integrator.h"

namespace boxwood {

class HeatIntegrator : public Integrator {
public:
    explicit HeatIntegrator(const Surfaces& surfaces) : surfaces_(surfaces) {}

    std::vector<Color> radiances(std::span<const Ray> rays) const override;
    void develop(ColorImage& image) const override;

private:
    const Surfaces& surfaces_;
};

}  // namespace boxwood
