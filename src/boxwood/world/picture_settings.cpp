// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/picture_settings.h"

namespace boxwood {

std::span<const Named<IntegratorKind>> integrators() {
    static constexpr Named<IntegratorKind> kIntegrators[] = {
        {"phong", IntegratorKind::phong},   {"whitted", IntegratorKind::whitted},
        {"normal", IntegratorKind::normal}, {"depth", IntegratorKind::depth},
        {"heat", IntegratorKind::heat},
    };
    return kIntegrators;
}

std::span<const Named<ColorEncoding>> color_encodings() {
    static constexpr Named<ColorEncoding> kEncodings[] = {
        {"linear", ColorEncoding::linear},
        {"srgb", ColorEncoding::srgb},
    };
    return kEncodings;
}

}  // namespace boxwood
