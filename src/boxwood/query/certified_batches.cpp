// SPDX-License-Identifier: Apache-2.0
// Rays in double, many at a time: a wavefront in float finds the candidates of each, and these are
// decided in double one ray after another, so that no ray waits for the mesh's memory. Explained in
// docs/algorithms/certified_hits.md.
#include <algorithm>
#include <cstdint>

#include "boxwood/query/certified_hits.h"
#include "boxwood/query/kernels/wide_walk.h"
#include "boxwood/query/mesh_ray.h"
#include "boxwood/query/near_ray.h"

namespace boxwood {

namespace {

/// Rays that are in the caches together with their candidates.
constexpr std::size_t kAtATime = 1024;

/// Those of some rays that a wavefront can answer.
struct Questions {
    std::size_t count = 0;
    std::uint32_t place[kAtATime];  ///< among all
    CandidateRay ray[kAtATime];
    Candidates candidates[kAtATime];
};

/// Whether there is a wavefront for trees like this. Others are rare.
bool has_wavefront(const WideTree& tree) {
    return !tree.is_empty() && tree.scale() == 1 && tree.view().stack_size <= kWavefrontStack;
}

/// Asks for the mesh's memory some rays before it is read.
class Lookahead {
public:
    Lookahead(MeshView mesh, const Questions& questions) : mesh_(mesh), questions_(questions) {}

    /// Inlined, as compilers drop calls of functions that do nothing else.
    BOXWOOD_KERNEL void before(std::size_t i) const {
        constexpr std::size_t kFaces = 32, kVertices = 16;
        if (has_triangles(i + kFaces)) __builtin_prefetch(&mesh_.faces[first(i + kFaces)]);
        if (has_triangles(i + kVertices)) {
            for (int k = 0; k < 3; ++k) {
                const Vec3d& corner = mesh_.corner(first(i + kVertices), k);
                __builtin_prefetch(&corner);
                __builtin_prefetch(&corner[2]);
            }
        }
    }

private:
    bool has_triangles(std::size_t i) const {
        return i < questions_.count && questions_.candidates[i].count - 1 < Candidates::kMost;
    }
    std::uint32_t first(std::size_t i) const { return questions_.candidates[i].triangle[0]; }

    MeshView mesh_;
    const Questions& questions_;
};

Hit closest_of(MeshView mesh, const Ray& ray, const Candidates& candidates) {
    const MeshRay mesh_ray(mesh, ray);
    Hit closest;
    double t_max = ray.t_max;
    for (std::uint32_t k = 0; k < candidates.count; ++k) {
        const auto hit = mesh_ray.intersect(candidates.triangle[k], t_max);
        if (!hit || !is_closer(*hit, closest)) continue;
        closest = *hit;
        t_max = hit->t;
    }
    return closest;
}

bool any_of(MeshView mesh, const Ray& ray, const Candidates& candidates) {
    if (candidates.count == Candidates::kSureHit) return true;
    const MeshRay mesh_ray(mesh, ray);
    for (std::uint32_t k = 0; k < candidates.count; ++k) {
        if (mesh_ray.intersect(candidates.triangle[k], ray.t_max)) return true;
    }
    return false;
}

/// Answers each ray: of(candidates, ray) where a wavefront has found them, one(ray) where it can't.
template <class Answer, class Find, class Of, class One>
void answer(MeshView mesh, const WideTree& tree, std::span<const Ray> rays,
            std::span<Answer> answers, const Find& find, const Of& of, const One& one) {
    Questions questions;
    for (std::size_t begin = 0; begin < rays.size(); begin += kAtATime) {
        const std::size_t end = std::min(begin + kAtATime, rays.size());
        questions.count = 0;
        run_fused(tree.instruction_set(), [&] {
            for (std::size_t i = begin; i < end; ++i) {
                const Ray& ray = rays[i];
                answers[i] = Answer{};
                if (!is_traceable(ray)) continue;
                const NearRay near(tree, ray);
                if (!near.can_leave_out()) {
                    answers[i] = one(ray);
                    continue;
                }
                questions.place[questions.count] = static_cast<std::uint32_t>(i - begin);
                questions.ray[questions.count++] = {near.ray(), near.extra_rounding(),
                                                    ray.skip.triangle};
            }
        });
        find(tree.view(), questions.ray, questions.candidates, questions.count);
        run_fused(tree.instruction_set(), [&] {
            const Lookahead lookahead(mesh, questions);
            for (std::size_t i = 0; i < questions.count; ++i) {
                lookahead.before(i);
                const std::size_t place = begin + questions.place[i];
                const Candidates& candidates = questions.candidates[i];
                answers[place] = candidates.count == Candidates::kTooMany
                                     ? one(rays[place])
                                     : of(rays[place], candidates);
            }
        });
    }
}

}  // namespace

void closest_hits(MeshView mesh, const WideTree& tree, std::span<const Ray> rays,
                  std::span<Hit> hits) noexcept {
    const auto one = [&](const Ray& ray) { return closest_hit(mesh, tree, ray).value_or(Hit{}); };
    if (rays.size() < kFewRays || !has_wavefront(tree)) {
        std::transform(rays.begin(), rays.end(), hits.begin(), one);
        return;
    }
    const auto of = [&](const Ray& ray, const Candidates& candidates) {
        return closest_of(mesh, ray, candidates);
    };
    answer(mesh, tree, rays, hits, ray_kernels(tree.instruction_set()).closest_candidates, of, one);
}

void any_hits(MeshView mesh, const WideTree& tree, std::span<const Ray> rays,
              std::span<bool> hits) noexcept {
    const auto one = [&](const Ray& ray) { return any_hit(mesh, tree, ray); };
    if (rays.size() < kFewRays || !has_wavefront(tree)) {
        std::transform(rays.begin(), rays.end(), hits.begin(), one);
        return;
    }
    const auto of = [&](const Ray& ray, const Candidates& candidates) {
        return any_of(mesh, ray, candidates);
    };
    answer(mesh, tree, rays, hits, ray_kernels(tree.instruction_set()).any_candidates, of, one);
}

}  // namespace boxwood
