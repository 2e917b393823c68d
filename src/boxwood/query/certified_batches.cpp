// SPDX-License-Identifier: Apache-2.0
// Rays in double, many at a time: frusta and a wavefront in float find the candidates of each, and
// these are decided in double, apart from the walk, so that no ray waits for the mesh's memory.
// Explained in docs/algorithms/certified_hits.md.
#include <algorithm>
#include <cstdint>
#include <new>
#include <span>

#include "boxwood/core/fetch_ahead.h"
#include "boxwood/query/certified_hits.h"
#include "boxwood/query/hit_lanes.h"
#include "boxwood/query/kernels/ray_kernels.h"
#include "boxwood/query/kernels/wide_walk.h"
#include "boxwood/query/mesh_ray.h"
#include "boxwood/query/near_ray.h"

namespace boxwood {

namespace {

/// Those of some rays that have to be looked at, but can't come from too far away.
struct Questions {
    std::size_t count = 0;
    std::uint32_t place[kCertifiedAtATime];  ///< among those rays
    union {
        Rayf ray[kCertifiedAtATime];  ///< not made before they are needed: batches may be short
    };
    float extra_rounding[kCertifiedAtATime];
    std::uint32_t skip[kCertifiedAtATime];
    Candidates candidates[kCertifiedAtATime];

    Questions() {}

    void add(std::size_t i, const NearRay& near, std::uint32_t skipped) {
        place[count] = static_cast<std::uint32_t>(i);
        new (&ray[count]) Rayf(near.ray());
        extra_rounding[count] = near.extra_rounding();
        skip[count++] = skipped;
    }
    CandidateRays rays() const { return {ray, extra_rounding, skip}; }
};

/// Whether there are kernels for many rays for trees like this. Others are rare.
bool has_kernels(const WideTree& tree) {
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
        const auto hit = mesh_ray.intersect(Candidate{candidates.triangle[k]}, t_max);
        if (!hit || !is_closer(*hit, closest)) continue;
        closest = *hit;
        t_max = hit->t;
    }
    return closest;
}

bool is_any_hit(MeshView mesh, const Ray& ray, const Candidates& candidates) {
    if (candidates.count == Candidates::kSureHit) return true;
    if (candidates.count == 0) return false;
    const MeshRay mesh_ray(mesh, ray);
    for (std::uint32_t k = 0; k < candidates.count; ++k) {
        if (mesh_ray.intersect(Candidate{candidates.triangle[k]}, ray.t_max)) return true;
    }
    return false;
}

/// Decides which candidates are hit first. Rays with one of them, which are most, are decided some
/// at a time.
class ClosestHits {
public:
    ClosestHits(MeshView mesh, const Questions& questions, std::span<const Ray> rays,
                std::span<Hit> hits)
        : mesh_(mesh), questions_(questions), rays_(rays), hits_(hits) {}

    BOXWOOD_KERNEL void decide(std::size_t i) {
        const Candidates& candidates = questions_.candidates[i];
        const std::uint32_t place = questions_.place[i];
        if (candidates.count == 0) return;
        if (candidates.count != 1) {
            hits_[place] = closest_of(mesh_, rays_[place], candidates);
            return;
        }
        const std::uint32_t triangle = candidates.triangle[0];
        lanes_.set(used_, rays_[place], mesh_.corner(triangle, 0), mesh_.corner(triangle, 1),
                   mesh_.corner(triangle, 2));
        question_[used_++] = static_cast<std::uint32_t>(i);
        if (used_ == HitLanes::kLanes) decide_lanes();
    }
    BOXWOOD_KERNEL void finish() {
        if (used_ > 0) decide_lanes();
    }

private:
    BOXWOOD_KERNEL void decide_lanes() {
        lanes_.test();
        for (int lane = 0; lane < used_; ++lane) {
            const Candidates& candidates = questions_.candidates[question_[lane]];
            const std::uint32_t place = questions_.place[question_[lane]];
            if (lanes_.is_missed(lane)) continue;
            hits_[place] = lanes_.is_hit(lane) ? Hit{.t = lanes_.t[lane],
                                                     .u = lanes_.u[lane],
                                                     .v = lanes_.v[lane],
                                                     .triangle = candidates.triangle[0]}
                                               : closest_of(mesh_, rays_[place], candidates);
        }
        used_ = 0;
    }

    MeshView mesh_;
    const Questions& questions_;
    std::span<const Ray> rays_;
    std::span<Hit> hits_;
    HitLanes lanes_ = {};
    std::uint32_t question_[HitLanes::kLanes];
    int used_ = 0;
};

class AnyHits {
public:
    AnyHits(MeshView mesh, const Questions& questions, std::span<const Ray> rays,
            std::span<bool> hits)
        : mesh_(mesh), questions_(questions), rays_(rays), hits_(hits) {}

    BOXWOOD_KERNEL void decide(std::size_t i) {
        const std::uint32_t place = questions_.place[i];
        hits_[place] = is_any_hit(mesh_, rays_[place], questions_.candidates[i]);
    }
    void finish() {}

private:
    MeshView mesh_;
    const Questions& questions_;
    std::span<const Ray> rays_;
    std::span<bool> hits_;
};

/// Answers each ray: by what find() gives and Decisions make of it, or by one(ray) where it can't.
template <class Decisions, class Answer, class One>
void answer(MeshView mesh, const WideTree& tree, std::span<const Ray> rays,
            std::span<Answer> answers, decltype(RayKernels::closest_candidates) find,
            const One& one) {
    if (rays.size() < kFewRays || !has_kernels(tree)) {
        std::transform(rays.begin(), rays.end(), answers.begin(), one);
        return;
    }
    Questions questions;
    for (std::size_t begin = 0; begin < rays.size(); begin += kCertifiedAtATime) {
        const std::size_t size = std::min(kCertifiedAtATime, rays.size() - begin);
        const auto some = rays.subspan(begin, size);
        const auto places = answers.subspan(begin, size);
        run_fused(tree.instruction_set(), [&] {
            questions.count = 0;
            for (std::size_t i = 0; i < size; ++i) {
                fetch_ahead(some, i);
                fetch_ahead(places, i);
                const Ray& ray = some[i];
                places[i] = Answer{};
                if (!is_traceable(ray)) continue;
                const NearRay near(tree, ray);
                if (near.can_leave_out())
                    questions.add(i, near, ray.skip.triangle);
                else
                    places[i] = one(ray);
            }
        });
        find(tree.view(), questions.rays(), questions.candidates, questions.count);
        run_fused(tree.instruction_set(), [&] {
            const Lookahead lookahead(mesh, questions);
            Decisions decisions(mesh, questions, some, places);
            for (std::size_t i = 0; i < questions.count; ++i) {
                lookahead.before(i);
                if (questions.candidates[i].count != Candidates::kTooMany)
                    decisions.decide(i);
                else
                    places[questions.place[i]] = one(some[questions.place[i]]);
            }
            decisions.finish();
        });
    }
}

}  // namespace

void closest_hits(MeshView mesh, const WideTree& tree, std::span<const Ray> rays,
                  std::span<Hit> hits) noexcept {
    const auto find = ray_kernels(tree.instruction_set()).closest_candidates;
    answer<ClosestHits>(mesh, tree, rays, hits, find, [&](const Ray& ray) {
        Hit hit;
        closest_hit(mesh, tree, ray, hit);
        return hit;
    });
}

void any_hits(MeshView mesh, const WideTree& tree, std::span<const Ray> rays,
              std::span<bool> hits) noexcept {
    const auto find = ray_kernels(tree.instruction_set()).any_candidates;
    answer<AnyHits>(mesh, tree, rays, hits, find,
                    [&](const Ray& ray) { return any_hit(mesh, tree, ray); });
}

}  // namespace boxwood
