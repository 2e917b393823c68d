// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "boxwood/core/batch.h"
#include "boxwood/image/image.h"
#include "boxwood/render/integrator.h"
#include "boxwood/render/surfaces.h"
#include "boxwood/world/world.h"

namespace boxwood {

struct RenderOptions {
    int width = 640;
    int height = 480;
    IntegratorKind integrator = IntegratorKind::phong;
    /// Rays a pixel, at least 1. More than one count where they differ: with whitted, when the
    /// camera has a lens, and with any integrator when the camera spreads them over the pixel.
    int samples = 1;
    std::uint64_t seed = 0;
    int bounces = 5;
    /// As those of BatchOptions.
    std::function<void(double)> progress = {};
    const Cancellation* cancellation = nullptr;
};

/// The picture of a world, in linear colour unless the world wants it encoded. The same bits for
/// any number of threads and any way of finding hits. Throws InvalidInput on sizes, samples or
/// bounces out of range, Cancelled when that is asked for.
ColorImage render(const World& world, const Surfaces& surfaces, const RenderOptions& options = {});

}  // namespace boxwood
