// SPDX-License-Identifier: Apache-2.0
#include "boxwood/render/integrator.h"

#include "boxwood/render/depth.h"
#include "boxwood/render/heat.h"
#include "boxwood/render/normal.h"
#include "boxwood/render/phong.h"
#include "boxwood/render/whitted.h"

namespace boxwood {

std::unique_ptr<Integrator> make_integrator(IntegratorKind kind, const World& world,
                                            const Surfaces& surfaces, int bounces) {
    switch (kind) {
        case IntegratorKind::phong:
            return std::make_unique<PhongIntegrator>(world, surfaces);
        case IntegratorKind::whitted:
            return std::make_unique<WhittedIntegrator>(world, surfaces, bounces);
        case IntegratorKind::normal:
            return std::make_unique<NormalIntegrator>(surfaces);
        case IntegratorKind::depth:
            return std::make_unique<DepthIntegrator>(surfaces);
        case IntegratorKind::heat:
            return std::make_unique<HeatIntegrator>(surfaces);
    }
    return nullptr;
}

}  // namespace boxwood
