// SPDX-License-Identifier: Apache-2.0
// Bikker's tinybvh: its eight-wide tree for CPUs, single rays.
#define TINYBVH_IMPLEMENTATION
#include <tiny_bvh.h>

#include "flush_denormals.h"
#include "peer.h"

namespace boxwood::bench {

namespace {

class TinybvhTree : public Accelerator {
public:
    explicit TinybvhTree(int threads) { tree_.bvh8.bvh.threadedBuild = threads > 1; }

    void build(const PlainMesh& mesh, Quality quality) override {
        mesh_ = mesh;
        vertices_.reserve(mesh.vertex_count());
        for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
            const float* p = &mesh.vertices[3 * i];
            vertices_.emplace_back(p[0], p[1], p[2], 0);
        }
        const tinybvh::bvhvec4slice vertices(vertices_.data(),
                                             static_cast<std::uint32_t>(vertices_.size()));
        const auto count = static_cast<std::uint32_t>(mesh.face_count());
        if (quality == Quality::high)
            tree_.BuildHQ(vertices, mesh.faces.data(), count);
        else
            tree_.Build(vertices, mesh.faces.data(), count);
    }

    std::size_t bytes() const override { return std::size_t{64} * tree_.usedBlocks; }

    void closest_hits(Mode, std::span<const PlainRay> rays, PlainHit* hits) const override {
        const FlushDenormals flush;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            tinybvh::Ray ray = as_tinybvh(rays[i]);
            tree_.Intersect(ray);
            hits[i].triangle = kNoTriangle;
            if (ray.hit.t >= far_end(rays[i])) continue;
            const tinybvh::bvhvec3 normal = normal_of(ray.hit.prim);
            hits[i] = {ray.hit.t, ray.hit.u, ray.hit.v, ray.hit.prim,
                       normal.x,  normal.y,  normal.z,  0};
        }
    }

    void any_hits(Mode, std::span<const PlainRay> rays, std::uint8_t* hits) const override {
        const FlushDenormals flush;
        for (std::size_t i = 0; i < rays.size(); ++i)
            hits[i] = tree_.IsOccluded(as_tinybvh(rays[i]));
    }

private:
    // Its rays have unit length and no near end; ours start at 0.
    static float far_end(const PlainRay& ray) { return std::min<float>(ray.t_max, BVH_FAR); }
    static tinybvh::Ray as_tinybvh(const PlainRay& ray) {
        return {{ray.ox, ray.oy, ray.oz}, {ray.dx, ray.dy, ray.dz}, far_end(ray)};
    }

    tinybvh::bvhvec3 normal_of(std::uint32_t triangle) const {
        const auto corner = [&](std::size_t k) {
            const float* p = &mesh_.vertices[3 * mesh_.faces[3 * triangle + k]];
            return tinybvh::bvhvec3(p[0], p[1], p[2]);
        };
        const tinybvh::bvhvec3 a = corner(0);
        return tinybvh::tinybvh_cross(corner(1) - a, corner(2) - a);
    }

    PlainMesh mesh_;
    std::vector<tinybvh::bvhvec4> vertices_;
    tinybvh::BVH8_CPU tree_;
};

class Tinybvh : public Peer {
public:
    std::string library() const override { return "tinybvh"; }
    std::string name() const override { return "tinybvh"; }
    std::vector<Quality> qualities() const override { return {Quality::medium, Quality::high}; }
    std::unique_ptr<Accelerator> make(int threads) const override {
        return std::make_unique<TinybvhTree>(threads);
    }
};

}  // namespace

}  // namespace boxwood::bench

extern "C" void boxwood_bench_add_peers(boxwood::bench::Peers& peers) {
    peers.push_back(std::make_unique<boxwood::bench::Tinybvh>());
}
