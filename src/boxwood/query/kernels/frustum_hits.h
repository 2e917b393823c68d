// SPDX-License-Identifier: Apache-2.0
// The closest hits of a group of rays in float: the test that single rays use decides where linear
// functions don't, and works out the hits of all rays in the end. Explained in
// docs/algorithms/frustum.md.
#pragma once

#include "boxwood/query/kernels/frustum.h"
#include "boxwood/query/kernels/triangle_block.h"

namespace boxwood {

/// A rule of Frustum.
template <class S>
class FrustumHits {
public:
    static constexpr int N = S::kWidth;
    static constexpr bool kIsRounded = false;
    static constexpr int kStepsOfOpen = 0;  ///< there are few
    static constexpr std::size_t kStepsOfRayAlone = 20;

    BOXWOOD_KERNEL FrustumHits(const WideTreeView& tree, const FrustumRays<S>& rays)
        : tree_(tree), rays_(rays) {}

    BOXWOOD_KERNEL void start(int packet) {
        S::store(t_[packet], S::load(rays_.t_max[packet]));
        S::store_unaligned(triangle_[packet], S::broadcast_integer(Hitf::kNone));
        hit_[packet] = 0;
    }

    BOXWOOD_KERNEL bool decide_open(int packet, std::uint32_t code, SureHits<S>& sure) {
        const unsigned closer = decide(packet, FrustumRays<S>::kAll, one_triangle(code));
        if (closer == 0) return false;
        const Float nearest = rays_.inverse_depth(packet, S::load(t_[packet]));
        const auto raise = [&](float* place, float by) {
            const Float old = S::load(place);
            S::store(place, S::select(closer, S::max(nearest * S::broadcast(by), old), old));
        };
        raise(sure.near[packet], 1 - kDepthRounding);
        raise(sure.surely_near[packet], 1 + kDepthRounding);
        return true;
    }

    BOXWOOD_KERNEL bool decide_ray(int packet, int ray, std::uint32_t first_code,
                                   const BlockFromOrigin<S>& block, SureHits<S>& sure) {
        const auto sheared = [&](int i) { return block.sheared(i, rays_, packet, ray); };
        float& t = t_[packet][ray];
        const BlockHit<S> hit =
            intersect<S>(sheared(0), sheared(1), sheared(2), S::broadcast(rays_.sz[packet][ray]),
                         S::broadcast(rays_.t_min), S::broadcast(t));
        if (hit.mask == 0) return false;
        const float least = S::least(hit.mask, hit.t);
        const int lane = __builtin_ctz(hit.mask & S::equal(hit.t, S::broadcast(least)));
        const BlockTriangle triangle =
            triangle_of_code<N>(tree_, first_code + static_cast<std::uint32_t>(lane));
        // Equal distances go to the lower triangle.
        if (least == t && triangle_[packet][ray] <= triangle.index) return false;
        t = least;
        triangle_[packet][ray] = triangle.index;
        alignas(64) float v[N], w[N], determinant[N];
        S::store(v, hit.v);
        S::store(w, hit.w);
        S::store(determinant, hit.determinant);
        v_[packet][ray] = v[lane];
        w_[packet][ray] = w[lane];
        determinant_[packet][ray] = determinant[lane];
        float normal[3];
        normal_of(triangle, normal);
        for (int k = 0; k < 3; ++k) normal_[k][packet][ray] = normal[k];
        hit_[packet] |= 1u << ray;
        const float nearest = 1 / (t * rays_.depth[packet][ray]);
        const auto raise = [&](float& place, float inverse_depth) {
            if (inverse_depth > place) place = inverse_depth;
        };
        raise(sure.near[packet][ray], nearest * (1 - kDepthRounding));
        raise(sure.surely_near[packet][ray], nearest * (1 + kDepthRounding));
        return true;
    }

    BOXWOOD_KERNEL void write(const SureHits<S>& sure, Hitf* hits) {
        for (int packet = 0; packet < N; ++packet) {
            if (sure.taken[packet] != 0) decide_taken(sure, packet);
            write_packet(packet, hits + packet * N);
        }
    }

private:
    using Float = typename S::Float;

    /// A triangle in each lane, its corners along the axes of the group.
    struct Triangles {
        Float corner[3][3];
        alignas(64) std::uint32_t index[N];
    };

    BOXWOOD_KERNEL Triangles one_triangle(std::uint32_t code) const {
        const BlockTriangle triangle = triangle_of_code<N>(tree_, code);
        Triangles result;
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k)
                result.corner[i][k] = S::broadcast(triangle.corner[i][rays_.axis[k]]);
        }
        S::store_unaligned(result.index, S::broadcast_integer(triangle.index));
        return result;
    }

    BOXWOOD_KERNEL Triangles triangles(const std::uint32_t* codes) const {
        alignas(64) float corners[3][3][N];
        Triangles result;
        for (int lane = 0; lane < N; ++lane) {
            const BlockTriangle triangle = triangle_of_code<N>(tree_, codes[lane]);
            for (int i = 0; i < 3; ++i) {
                for (int k = 0; k < 3; ++k) corners[i][k][lane] = triangle.corner[i][k];
            }
            result.index[lane] = triangle.index;
        }
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) result.corner[i][k] = S::load(corners[i][rays_.axis[k]]);
        }
        return result;
    }

    /// The test of single rays for the triangles that are surely hit.
    BOXWOOD_KERNEL void decide_taken(const SureHits<S>& sure, int packet) {
        const unsigned taken = sure.taken[packet];
        const std::uint32_t code = sure.code[packet][__builtin_ctz(taken)];
        const unsigned same = S::equal(S::load(sure.code[packet]), S::broadcast_integer(code));
        if ((taken & ~same) == 0) {
            decide(packet, taken, one_triangle(code));
            return;
        }
        std::uint32_t codes[N];
        for (int lane = 0; lane < N; ++lane)
            codes[lane] = taken >> lane & 1 ? sure.code[packet][lane] : code;
        decide(packet, taken, triangles(codes));
    }

    /// The same for some of the rays. Keeps the hits that are closer than those there are, and
    /// returns which rays have one.
    BOXWOOD_KERNEL unsigned decide(int packet, unsigned rays, const Triangles& triangles) {
        const auto& corner = triangles.corner;
        const auto sheared = [&](int i) {
            Float from[3];
            for (int k = 0; k < 3; ++k) from[k] = corner[i][k] - S::broadcast(rays_.origin[k]);
            return rays_.sheared(packet, from[0], from[1], from[2]);
        };
        const ShearedCorner<S> a = sheared(0), b = sheared(1), c = sheared(2);
        const Float t = S::load(t_[packet]);
        const BlockHit<S> hit =
            intersect<S>(a, b, c, S::load(rays_.sz[packet]), S::broadcast(rays_.t_min), t);
        unsigned closer = hit.mask & rays;
        // Equal distances go to the lower triangle.
        for (unsigned ties = closer & S::equal(hit.t, t); ties != 0; ties &= ties - 1) {
            const int lane = __builtin_ctz(ties);
            if (triangle_[packet][lane] < triangles.index[lane]) closer &= ~(1u << lane);
        }
        if (closer == 0) return 0;
        const auto keep = [&](float* place, Float value) { S::store_masked(closer, place, value); };
        keep(t_[packet], hit.t);
        keep(v_[packet], hit.v);
        keep(w_[packet], hit.w);
        keep(determinant_[packet], hit.determinant);
        for (int k = 0; k < 3; ++k) {
            const int i = k == 2 ? 0 : k + 1, j = i == 2 ? 0 : i + 1;
            keep(normal_[rays_.axis[k]][packet],
                 (corner[1][i] - corner[0][i]) * (corner[2][j] - corner[0][j]) -
                     (corner[1][j] - corner[0][j]) * (corner[2][i] - corner[0][i]));
        }
        S::store_masked(closer, triangle_[packet], S::load(triangles.index));
        hit_[packet] |= closer;
        return closer;
    }

    BOXWOOD_KERNEL void write_packet(int packet, Hitf* hits) const {
        const Float zero = S::broadcast(0);
        const unsigned hit = hit_[packet];
        const auto or_zero = [&](Float x) { return S::select(hit, x, zero); };
        const Float determinant = S::load(determinant_[packet]);
        Float field[8] = {
            S::select(hit, S::load(t_[packet]) + zero, S::broadcast(__builtin_inff())),
            or_zero(S::load(v_[packet]) / determinant + zero),
            or_zero(S::load(w_[packet]) / determinant + zero),
            S::as_float(S::load(triangle_[packet])),
            or_zero(S::load(normal_[0][packet])),
            or_zero(S::load(normal_[1][packet])),
            or_zero(S::load(normal_[2][packet])),
            zero};
        S::store_records(&hits->t, field);
    }

    const WideTreeView& tree_;
    const FrustumRays<S>& rays_;
    // Of each ray of each packet, the closest hit of those that had to be decided.
    alignas(64) float t_[N][N], v_[N][N], w_[N][N], determinant_[N][N], normal_[3][N][N];
    alignas(64) std::uint32_t triangle_[N][N];
    unsigned hit_[N];  ///< of each packet, a mask of rays
};

}  // namespace boxwood
