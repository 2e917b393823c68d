// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/render/integrator.h"

namespace boxwood {

class NormalIntegrator : public Integrator {
public:
    explicit NormalIntegrator(const Surfaces& surfaces) : surfaces_(surfaces) {}

    std::vector<Color> radiances(std::span<const Ray> rays) const override;

private:
    const Surfaces& surfaces_;
};

}  // namespace boxwood
