// SPDX-License-Identifier: Apache-2.0
// Rays in double: pieces of them are gathered from arrays, and their hits scattered into others.
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <vector>

#include "boxwood/query/ray_tiles.h"
#include "py_scene.h"
#include "ray_arrays.h"
#include "watch.h"

namespace boxwood::python {

using namespace nanobind::literals;

namespace {

constexpr std::size_t kPiece = 256;

/// Calls store(begin, rays) for pieces of so many rays, on all cores.
template <class Store>
void for_each_piece(Watch& watch, const RayArrays& arrays, std::size_t size, const Store& store) {
    tbb::enumerable_thread_specific<std::vector<Ray>> pieces;
    watch.for_each_piece(size, [&](std::size_t begin, std::size_t end) {
        std::vector<Ray>& rays = pieces.local();
        rays.resize(end - begin);
        arrays.gather(begin, rays);
        store(begin, std::span<const Ray>(rays));
    });
}

/// The same, with the scene kept as it is meanwhile.
template <class Store>
void for_each_piece(const PyScene& scene, const RayArrays& arrays, nb::handle progress,
                    std::size_t size, const Store& store) {
    run_watched(arrays.size(), progress, [&](Watch& watch) {
        const Gate::Query query(scene.gate);
        for_each_piece(watch, arrays, size, store);
    });
}

/// Where hits go.
struct HitPlaces {
    ValuesOut<double> t;
    ValuesOut<std::int32_t> triangle, instance;
    RowsOut<double, 2> uv;

    void store(std::size_t at, const Hit& hit) const {
        t.data()[at] = hit.t;
        triangle.data()[at] = static_cast<std::int32_t>(hit.triangle);
        instance.data()[at] = hit.is_hit() ? static_cast<std::int32_t>(hit.instance) : -1;
        uv.data()[2 * at] = hit.u;
        uv.data()[2 * at + 1] = hit.v;
    }
};

void closest_hit(const PyScene& scene, const RayArrays& arrays, const ValuesOut<double>& t,
                 const ValuesOut<std::int32_t>& triangle, const ValuesOut<std::int32_t>& instance,
                 const RowsOut<double, 2>& uv, const RowsOut<double, 3>& normal,
                 nb::handle progress) {
    check_places(arrays.size(), t, triangle, instance, uv, normal);
    const HitPlaces places = {t, triangle, instance, uv};
    const auto put = [&](std::size_t at, const Hit& hit) {
        places.store(at, hit);
        const Vec3d n = hit.is_hit() ? scene.scene().geometric_normal(hit) : Vec3d::Zero();
        for (int k = 0; k < 3; ++k) normal.data()[3 * at + static_cast<std::size_t>(k)] = n[k];
    };
    const auto trace = [&](std::span<const Ray> rays, std::span<Hit> hits) {
        scene.scene().closest_hits(rays, hits, {.on_this_thread = true});
    };
    run_watched(arrays.size(), progress, [&](Watch& watch) {
        const Gate::Query query(scene.gate);
        const bool is_in_tiles = scene.scene().likes_tiles() &&
                                 answer_in_tiles<Ray, Hit>(
                                     arrays.size(), watch.options(arrays.size()),
                                     [&](std::size_t i) { return arrays[i]; }, trace, put);
        if (is_in_tiles) return;
        const std::size_t size = scene.scene().rays_at_a_time();
        for_each_piece(watch, arrays, size, [&](std::size_t begin, std::span<const Ray> rays) {
            std::vector<Hit> hits(rays.size());
            trace(rays, hits);
            for (std::size_t i = 0; i < hits.size(); ++i) put(begin + i, hits[i]);
        });
    });
}

void any_hit(const PyScene& scene, const RayArrays& arrays, const ValuesOut<bool>& results,
             nb::handle progress) {
    check_places(arrays.size(), results);
    const auto store = [&](std::size_t begin, std::span<const Ray> rays) {
        scene.scene().any_hits(rays, std::span(results.data() + begin, rays.size()),
                               {.on_this_thread = true});
    };
    for_each_piece(scene, arrays, progress, scene.scene().rays_at_a_time(), store);
}

void count_hits(const PyScene& scene, const RayArrays& arrays,
                const ValuesOut<std::int64_t>& results, nb::handle progress) {
    check_places(arrays.size(), results);
    const auto store = [&](std::size_t begin, std::span<const Ray> rays) {
        std::array<std::size_t, kPiece> counts;
        scene.scene().count_hits(rays, std::span(counts).first(rays.size()),
                                 {.on_this_thread = true});
        std::copy_n(counts.begin(), rays.size(), results.data() + begin);
    };
    for_each_piece(scene, arrays, progress, kPiece, store);
}

Dict all_hits(const PyScene& scene, const RayArrays& arrays, nb::handle progress) {
    // So many rays at a time have rays in memory besides their arrays.
    constexpr std::size_t kAtATime = std::size_t{1} << 17;
    HitLists all;
    run_watched(arrays.size(), progress, [&](Watch& watch) {
        const Gate::Query query(scene.gate);
        std::vector<Ray> rays;
        for (std::size_t begin = 0; begin < arrays.size(); begin += kAtATime) {
            rays.resize(std::min(kAtATime, arrays.size() - begin));
            arrays.gather(begin, rays);
            HitLists part = scene.scene().all_hits(rays, watch.options(rays.size()));
            if (begin == 0 && rays.size() == arrays.size()) {
                all = std::move(part);
            } else {
                for (std::size_t i = 0; i < part.size(); ++i)
                    all.offsets.push_back(all.t.size() + part.offsets[i + 1]);
                const auto append = [](auto& to, const auto& from) {
                    to.insert(to.end(), from.begin(), from.end());
                };
                append(all.t, part.t);
                append(all.u, part.u);
                append(all.v, part.v);
                append(all.triangle, part.triangle);
                append(all.instance, part.instance);
            }
        }
    });
    Dict result;
    result["offsets"] = array_of(std::move(all.offsets));
    result["t"] = array_of(std::move(all.t));
    result["u"] = array_of(std::move(all.u));
    result["v"] = array_of(std::move(all.v));
    result["triangle"] = array_of(std::move(all.triangle));
    result["instance"] = array_of(std::move(all.instance));
    return result;
}

void first_k_hits(const PyScene& scene, const RayArrays& arrays, std::size_t k,
                  const ValuesOut<double>& t, const ValuesOut<std::int32_t>& triangle,
                  const ValuesOut<std::int32_t>& instance, const RowsOut<double, 2>& uv,
                  nb::handle progress) {
    check_places(arrays.size() * k, t, triangle, instance, uv);
    const HitPlaces places = {t, triangle, instance, uv};
    // So many hits of a piece are in memory besides the arrays, or those of one ray.
    constexpr std::size_t kAtATime = std::size_t{1} << 14;
    const std::size_t piece =
        std::clamp(kAtATime / std::max<std::size_t>(k, 1), std::size_t{1}, kPiece);
    const auto store = [&](std::size_t begin, std::span<const Ray> rays) {
        std::vector<Hit> hits(rays.size() * k);
        scene.scene().first_k_hits(rays, k, hits, {.on_this_thread = true});
        for (std::size_t i = 0; i < hits.size(); ++i) places.store(begin * k + i, hits[i]);
    };
    for_each_piece(scene, arrays, progress, piece, store);
}

}  // namespace

void bind_hits(nb::module_& module, nb::class_<PyScene>& scene) {
    nb::class_<RayArrays>(module, "Rays")
        .def(nb::init<const Rows<double>&, const Rows<double>&, const Values<double>&,
                      const Values<double>&, const Values<std::int32_t>&,
                      const Values<std::int32_t>&, const Values<std::uint32_t>&>(),
             "origins"_a.noconvert(), "directions"_a.noconvert(), "t_min"_a.noconvert(),
             "t_max"_a.noconvert(), "skip_instance"_a.noconvert(), "skip_triangle"_a.noconvert(),
             "visibility"_a.noconvert());
    scene.def("closest_hit", &closest_hit, "rays"_a, "t"_a.noconvert(), "triangle"_a.noconvert(),
              "instance"_a.noconvert(), "uv"_a.noconvert(), "normal"_a.noconvert(),
              "progress"_a.none());
    scene.def("any_hit", &any_hit, "rays"_a, "results"_a.noconvert(), "progress"_a.none());
    scene.def("count_hits", &count_hits, "rays"_a, "results"_a.noconvert(), "progress"_a.none());
    scene.def("first_k_hits", &first_k_hits, "rays"_a, "k"_a, "t"_a.noconvert(),
              "triangle"_a.noconvert(), "instance"_a.noconvert(), "uv"_a.noconvert(),
              "progress"_a.none());
    scene.def("all_hits", &all_hits, "rays"_a, "progress"_a.none());
}

}  // namespace boxwood::python
