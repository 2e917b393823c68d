// SPDX-License-Identifier: Apache-2.0
// The queries of a scene for one hit: those of its instances, put together.
#include "boxwood/core/fetch_ahead.h"
#include "boxwood/query/any_hit.h"
#include "boxwood/query/brute_force.h"
#include "boxwood/query/certified_hits.h"
#include "boxwood/query/closest_hit.h"
#include "boxwood/query/hit_places.h"
#include "boxwood/query/ray_tiles.h"
#include "boxwood/scene/ask_instance.h"
#include "boxwood/scene/scene.h"

namespace boxwood {

namespace {

/// Keeps the closest of the hits on instances.
class ClosestOfInstances {
public:
    /// Returns beyond which t nothing is of interest any more.
    double offer(std::uint32_t instance, double t_max, std::optional<Hit> hit) {
        if (!hit) return t_max;
        hit->instance = instance;
        if (!closest_ || is_closer(*hit, *closest_)) closest_ = hit;
        return closest_->t;
    }
    const std::optional<Hit>& hit() const { return closest_; }

private:
    std::optional<Hit> closest_;
};

}  // namespace

std::optional<Hit> Scene::closest_hit(const Ray& ray) const noexcept {
    ClosestOfInstances closest;
    visit_instances(ray, [&](std::uint32_t instance, const Ray& asked) {
        const auto hit = ask_instance(instance, [&](const auto& surface, const WideTree* tree) {
            return tree ? boxwood::closest_hit(surface, *tree, asked)
                        : closest_hit_brute_force(surface, asked);
        });
        return closest.offer(instance, asked.t_max, hit);
    });
    return closest.hit();
}

std::optional<Hit> Scene::closest_hit(const Ray& ray, TraversalCounts& counts) const noexcept {
    ClosestOfInstances closest;
    visit_instances(
        ray,
        [&](std::uint32_t instance, const Ray& asked) {
            const auto hit = ask_instance(instance, [&](const auto& surface, const WideTree*) {
                if (trees_.empty()) return closest_hit_brute_force(surface, asked, &counts);
                const Tree& tree = trees_[instances_[instance].mesh];
                return boxwood::closest_hit(surface, tree, asked, &counts);
            });
            return closest.offer(instance, asked.t_max, hit);
        },
        &counts);
    return closest.hit();
}

bool Scene::any_hit(const Ray& ray) const noexcept {
    bool found = false;
    visit_instances(ray, [&](std::uint32_t instance, const Ray& asked) {
        found = found || ask_instance(instance, [&](const auto& surface, const WideTree* tree) {
                    return tree ? boxwood::any_hit(surface, *tree, asked)
                                : any_hit_brute_force(surface, asked);
                });
        return found ? kEndOfWalk : asked.t_max;
    });
    return found;
}

std::size_t Scene::rays_at_a_time() const { return wide_trees_.empty() ? 256 : kCertifiedAtATime; }

const WideTree* Scene::only_tree(std::span<const Ray> rays) const {
    const WideTree* tree = only_tree();
    const auto sees_it = [&](const Ray& ray) {
        // Of another instance it skips nothing.
        const bool skips_here = ray.skip.triangle == TriangleId::kNone || ray.skip.instance == 0;
        return skips_here && (ray.visibility & instances_[0].visibility) != 0;
    };
    if (tree == nullptr) return nullptr;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        fetch_ahead(rays, i);
        if (!sees_it(rays[i])) return nullptr;
    }
    return tree;
}

void Scene::closest_hits(std::span<const Ray> rays, std::span<Hit> hits,
                         const BatchOptions& options) const {
    check_hit_places(rays.size(), hits.size());
    const auto trace = [&](std::span<const Ray> some, std::span<Hit> places) {
        if (const WideTree* tree = only_tree(some))
            return boxwood::closest_hits(meshes_[instances_[0].mesh], *tree, some, places);
        for (std::size_t i = 0; i < some.size(); ++i)
            places[i] = closest_hit(some[i]).value_or(Hit{});
    };
    const bool is_in_tiles =
        likes_tiles() && answer_in_tiles<Ray, Hit>(
                             rays.size(), options, [&](std::size_t i) { return rays[i]; }, trace,
                             [&](std::size_t i, const Hit& hit) { hits[i] = hit; });
    if (is_in_tiles) return;
    for_each_piece(rays.size(), rays_at_a_time(), options, [&](std::size_t begin, std::size_t end) {
        trace(rays.subspan(begin, end - begin), hits.subspan(begin, end - begin));
    });
}

void Scene::any_hits(std::span<const Ray> rays, std::span<bool> hits,
                     const BatchOptions& options) const {
    check_hit_places(rays.size(), hits.size());
    for_each_piece(rays.size(), rays_at_a_time(), options, [&](std::size_t begin, std::size_t end) {
        const auto some = rays.subspan(begin, end - begin);
        if (const WideTree* tree = only_tree(some))
            return boxwood::any_hits(meshes_[instances_[0].mesh], *tree, some,
                                     hits.subspan(begin, some.size()));
        for (std::size_t i = begin; i < end; ++i) hits[i] = any_hit(rays[i]);
    });
}

}  // namespace boxwood
