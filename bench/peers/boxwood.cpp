// SPDX-License-Identifier: Apache-2.0
#include "peers/boxwood.h"

#include <optional>

#include "boxwood/core/parallel.h"
#include "boxwood/scene/scene.h"
#include "boxwood/tree/statistics.h"

namespace boxwood::bench {

namespace {

Ray as_ray(const PlainRay& ray) {
    return {.origin = {ray.ox, ray.oy, ray.oz},
            .direction = {ray.dx, ray.dy, ray.dz},
            .t_min = ray.t_min,
            .t_max = ray.t_max};
}

class BoxwoodTree : public Accelerator {
public:
    explicit BoxwoodTree(int threads) : threads_(threads) {}

    void build(const PlainMesh& mesh, Quality) override {
        const ThreadLimit limit(static_cast<std::size_t>(threads_));
        mesh_.vertices.resize(mesh.vertex_count());
        for (std::size_t i = 0; i < mesh_.vertices.size(); ++i)
            mesh_.vertices[i] = Eigen::Map<const Vec3f>(&mesh.vertices[3 * i]).cast<double>();
        mesh_.faces.resize(mesh.face_count());
        for (std::size_t i = 0; i < mesh_.faces.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                mesh_.faces[i][static_cast<int>(k)] = static_cast<int>(mesh.faces[3 * i + k]);
        scene_.emplace(std::vector<MeshView>{mesh_});
    }

    std::size_t bytes() const override { return statistics(scene_->trees()[0]).bytes; }

    void closest_hits(Mode, std::span<const PlainRay> rays, PlainHit* hits) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto hit = scene_->closest_hit(as_ray(rays[i]));
            hits[i].triangle = hit ? hit->triangle : kNoTriangle;
            if (!hit) continue;
            const Vec3f normal = geometric_normal(mesh_, hit->triangle).cast<float>();
            hits[i] = {static_cast<float>(hit->t),
                       static_cast<float>(hit->u),
                       static_cast<float>(hit->v),
                       hit->triangle,
                       normal.x(),
                       normal.y(),
                       normal.z(),
                       0};
        }
    }

    void any_hits(Mode, std::span<const PlainRay> rays, std::uint8_t* hits) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = scene_->any_hit(as_ray(rays[i]));
    }

private:
    int threads_;
    TriangleMesh mesh_;
    std::optional<Scene> scene_;
};

class Boxwood : public Peer {
public:
    std::string library() const override { return "boxwood"; }
    std::string name() const override { return "boxwood"; }
    std::vector<Mode> modes() const override { return {Mode::single, Mode::batch}; }
    std::unique_ptr<Accelerator> make(int threads) const override {
        return std::make_unique<BoxwoodTree>(threads);
    }
};

}  // namespace

std::unique_ptr<Peer> make_boxwood() { return std::make_unique<Boxwood>(); }

}  // namespace boxwood::bench
