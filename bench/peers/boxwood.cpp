// SPDX-License-Identifier: Apache-2.0
#include "peers/boxwood.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "boxwood/core/parallel.h"
#include "boxwood/query/closest_point.h"
#include "boxwood/query/signed_distance.h"
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
        // Trees are built over vertices in double, as scenes do for those in float.
        vertices_ =
            in_double({reinterpret_cast<const Vec3f*>(mesh.vertices.data()), mesh.vertex_count()});
        const std::span faces(reinterpret_cast<const Vec3i*>(mesh.faces.data()), mesh.face_count());
        mesh_ = {vertices_, faces};
        constexpr BuildPreset kPresets[] = {BuildPreset::fast, BuildPreset::balanced,
                                            BuildPreset::best};
        tree_ = build_wide_tree(mesh_, {.preset = kPresets[static_cast<int>(quality)]});
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

    bool tells_distances() const override { return true; }

    void nearest(Mode mode, bool signs, std::span<const PlainPoint> points,
                 PlainNearest* results) override {
        const ThreadLimit one(1);
        if (signs && !sign_) sign_.emplace(mesh_);
        const std::span<const Vec3d> at(reinterpret_cast<const Vec3d*>(points.data()),
                                        points.size());
        // In pieces, as somebody with this many points might have them.
        constexpr std::size_t kPiece = std::size_t{1} << 17;
        for (std::size_t begin = 0; begin < at.size(); begin += kPiece) {
            const auto piece = at.subspan(begin, std::min(kPiece, at.size() - begin));
            const auto write = [&](std::size_t i, const ClosestPoint& closest, double distance) {
                results[begin + i] = {{closest.point.x(), closest.point.y(), closest.point.z()},
                                      distance,
                                      closest.triangle};
            };
            if (mode != Mode::batch) {
                for (std::size_t i = 0; i < piece.size(); ++i) {
                    if (signs) {
                        const auto found = signed_distance(mesh_, tree_, *sign_, piece[i]);
                        write(i, found->closest, found->distance);
                    } else {
                        const auto found = closest_point(mesh_, tree_, piece[i]);
                        write(i, *found, found->distance);
                    }
                }
            } else if (signs) {
                std::vector<SignedDistance> found(piece.size());
                signed_distances(mesh_, tree_, *sign_, piece, found);
                for (std::size_t i = 0; i < piece.size(); ++i)
                    write(i, found[i].closest, found[i].distance);
            } else {
                std::vector<ClosestPoint> found(piece.size());
                closest_points(mesh_, tree_, piece, found);
                for (std::size_t i = 0; i < piece.size(); ++i)
                    write(i, found[i], found[i].distance);
            }
        }
    }

private:
    int threads_;
    std::vector<Vec3d> vertices_;
    MeshView mesh_;
    std::optional<MeshSign> sign_;
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
