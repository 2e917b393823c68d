// SPDX-License-Identifier: Apache-2.0
// How the queries of a scene come to its instances.
#pragma once

#include "boxwood/scene/scene.h"

namespace boxwood {

template <class Ask>
auto Scene::ask_instance(std::uint32_t instance, const Ask& ask) const {
    const std::uint32_t mesh = instances_[instance].mesh;
    const WideTree* tree = wide_trees_.empty() ? nullptr : &wide_trees_[mesh];
    const Placement& placement = placements_[instance];
    const bool culls = given_[mesh].culls_back_faces;
    if (placement.is_identity() && !culls) return ask(meshes_[mesh], tree);
    return ask(PlacedMesh{meshes_[mesh], &placement, culls}, tree);
}

template <class Visit>
void Scene::visit_instances(const Ray& ray, const Visit& visit,
                            TraversalCounts* counts) const noexcept {
    if (!is_traceable(ray)) return;
    const auto visit_one = [&](std::uint32_t instance, double t_max) {
        if ((instances_[instance].visibility & ray.visibility) == 0) return t_max;
        Ray asked = ray;
        asked.t_max = t_max;
        if (asked.skip.instance != instance) asked.skip = {};
        return visit(instance, asked);
    };
    if (!top_.is_empty()) {
        traverse(top_, ray, visit_one, counts);
        return;
    }
    double t_max = ray.t_max;
    for (std::uint32_t i = 0; i < instances_.size() && t_max != kEndOfWalk; ++i)
        t_max = visit_one(i, t_max);
}

}  // namespace boxwood
