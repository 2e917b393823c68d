// SPDX-License-Identifier: Apache-2.0
#include "peers/boxwood.h"

#include "boxwood/core/parallel.h"
#include "boxwood/query/wide_hits.h"
#include "boxwood/scene/build_wide_tree.h"

namespace boxwood::bench {

namespace {

// The plain records are those of the library.
static_assert(sizeof(PlainRay) == sizeof(Rayf) && sizeof(PlainHit) == sizeof(Hitf));
static_assert(kNoTriangle == Hitf::kNone);

const Rayf* as_rays(const PlainRay* rays) { return reinterpret_cast<const Rayf*>(rays); }
Hitf* as_hits(PlainHit* hits) { return reinterpret_cast<Hitf*>(hits); }

class BoxwoodTree : public Accelerator {
public:
    explicit BoxwoodTree(int threads) : threads_(threads) {}

    void build(const PlainMesh& mesh, Quality quality) override {
        const ThreadLimit limit(static_cast<std::size_t>(threads_));
        // The library takes vertices in double.
        std::vector<Vec3d> vertices(mesh.vertex_count());
        for (std::size_t i = 0; i < vertices.size(); ++i)
            vertices[i] = Eigen::Map<const Vec3f>(&mesh.vertices[3 * i]).cast<double>();
        const std::span faces(reinterpret_cast<const Vec3i*>(mesh.faces.data()), mesh.face_count());
        constexpr BuildPreset kPresets[] = {BuildPreset::fast, BuildPreset::balanced,
                                            BuildPreset::best};
        tree_ = build_wide_tree(MeshView{vertices, faces},
                                {.preset = kPresets[static_cast<int>(quality)]});
    }

    std::size_t bytes() const override { return tree_.bytes(); }

    void closest_hits(Mode mode, std::span<const PlainRay> rays, PlainHit* hits) const override {
        if (mode == Mode::batch) {
            const ThreadLimit one(1);
            boxwood::closest_hits(tree_, {as_rays(rays.data()), rays.size()},
                                  {as_hits(hits), rays.size()});
        } else {
            for (std::size_t i = 0; i < rays.size(); ++i)
                closest_hit(tree_, *as_rays(&rays[i]), *as_hits(&hits[i]));
        }
    }

    void any_hits(Mode mode, std::span<const PlainRay> rays, std::uint8_t* hits) const override {
        static_assert(sizeof(bool) == sizeof(std::uint8_t));
        if (mode == Mode::batch) {
            const ThreadLimit one(1);
            boxwood::any_hits(tree_, {as_rays(rays.data()), rays.size()},
                              {reinterpret_cast<bool*>(hits), rays.size()});
        } else {
            for (std::size_t i = 0; i < rays.size(); ++i)
                hits[i] = any_hit(tree_, *as_rays(&rays[i]));
        }
    }

private:
    int threads_;
    WideTree tree_;
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
