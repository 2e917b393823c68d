// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/scene/scene.h"

int main() {
    const boxwood::TriangleMesh mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                     .faces = {{0, 1, 2}}};
    const boxwood::Scene scene({mesh});
    const auto hit = scene.closest_hit({.origin = {0.2, 0.2, 2}, .direction = {0, 0, -1}});
    if (hit) std::cout << hit->t << " on triangle " << hit->triangle << "\n";
    return hit && hit->t == 2 && hit->triangle == 0 ? 0 : 1;
}
