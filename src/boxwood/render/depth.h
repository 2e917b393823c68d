// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/render/integrator.h"

namespace boxwood {

class DepthIntegrator : public Integrator {
public:
    explicit DepthIntegrator(const Surfaces& surfaces) : surfaces_(surfaces) {}

    std::vector<Color> radiances(std::span<const Ray> rays) const override;
    /// There is no mean of a distance and of nothing.
    bool can_average() const override { return false; }
    void develop(ColorImage& image) const override;

private:
    const Surfaces& surfaces_;
};

}  // namespace boxwood
