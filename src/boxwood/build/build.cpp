// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/build.h"

#include <fmt/format.h>

#include "boxwood/build/binned_sah.h"
#include "boxwood/build/block_sah.h"
#include "boxwood/build/median.h"
#include "boxwood/build/morton.h"
#include "boxwood/build/ploc.h"
#include "boxwood/build/reinsertion.h"
#include "boxwood/build/spatial_split.h"
#include "boxwood/build/sweep_sah.h"

namespace boxwood {

namespace {

Tree optimized(Tree tree) {
    optimize_by_reinsertion(tree);
    return tree;
}

}  // namespace

Tree build_tree(MeshView mesh, const BuildOptions& options) {
    if (options.method == BuildMethod::spatial_split) return build_spatial_split(mesh);
    if (options.method == BuildMethod::reinsertion) return optimized(build_spatial_split(mesh));
    if (options.method == BuildMethod::block_sah)
        return build_block_sah(mesh, {.block = options.block});
    const std::vector<Box3f> boxes = triangle_boxes(mesh);
    if (options.method == BuildMethod::median)
        return build_median(boxes, {.centroids = triangle_centroids(mesh)});
    return build_tree(boxes, options);
}

Tree build_tree(std::span<const Box3f> boxes, const BuildOptions& options) {
    switch (options.method) {
        case BuildMethod::median:
            return build_median(boxes);
        case BuildMethod::agglomerative:
            return build_agglomerative(boxes, {options.cost});
        case BuildMethod::binned_sah:
        case BuildMethod::spatial_split:
            return build_binned_sah(boxes);
        case BuildMethod::morton:
            return build_morton(boxes);
        case BuildMethod::ploc:
            return build_ploc(boxes);
        case BuildMethod::sweep_sah:
            return build_sweep_sah(boxes);
        case BuildMethod::reinsertion:
            return optimized(build_binned_sah(boxes));
        case BuildMethod::block_sah:
            return build_block_sah(boxes, {.block = options.block});
    }
    return {};
}

std::optional<std::string> warning_before_build(std::size_t primitives,
                                                const BuildOptions& options) {
    if (options.method != BuildMethod::agglomerative || primitives <= kManyToAgglomerate)
        return std::nullopt;
    const double minutes =
        1e-10 * static_cast<double>(primitives) * static_cast<double>(primitives);
    return fmt::format(
        "the agglomerative builder takes quadratic time: for {} triangles about {:.0f} minutes",
        primitives, minutes);
}

std::span<const Named<BuildMethod>> build_methods() {
    static constexpr Named<BuildMethod> kMethods[] = {
        {"median", BuildMethod::median},           {"agglomerative", BuildMethod::agglomerative},
        {"binned_sah", BuildMethod::binned_sah},   {"block_sah", BuildMethod::block_sah},
        {"morton", BuildMethod::morton},           {"ploc", BuildMethod::ploc},
        {"sweep_sah", BuildMethod::sweep_sah},     {"spatial_split", BuildMethod::spatial_split},
        {"reinsertion", BuildMethod::reinsertion},
    };
    return kMethods;
}

std::span<const Named<MergeCost>> merge_costs() {
    static constexpr Named<MergeCost> kCosts[] = {
        {"centroid_distance", MergeCost::centroid_distance},
        {"volume_increase", MergeCost::volume_increase},
        {"surface_area", MergeCost::surface_area},
    };
    return kCosts;
}

}  // namespace boxwood
