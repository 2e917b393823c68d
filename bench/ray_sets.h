// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "boxwood/core/ray.h"
#include "meshes.h"
#include "peers/peer.h"

namespace boxwood::bench {

enum class RayKind {
    primary,  ///< closest hit: from cameras
    ao,       ///< any hit: short, into the half space above what primary rays see
    diffuse,  ///< closest hit: as those, but as long as may be
    random    ///< closest hit: chords of the ball around the mesh
};

inline constexpr RayKind kRayKinds[] = {RayKind::primary, RayKind::ao, RayKind::diffuse,
                                        RayKind::random};

std::string_view name_of(RayKind kind);

/// The same ray in double.
Ray exact(const PlainRay& ray);

struct RayOptions {
    std::size_t count = 524'288;  ///< of each kind, about
    /// Primary rays come in square tiles of this many pixels a side, a power of two, and in each in
    /// Morton order, so that packets of 8 and 16 get pixels side by side; 1 is row by row. The
    /// secondary rays follow them.
    int tile = 16;
};

struct RaySet {
    RayKind kind;
    std::vector<PlainRay> rays;
    std::vector<double> truth;  ///< the exact t of the closest hit, infinite for none

    bool wants_any() const { return kind == RayKind::ao; }
};

/// The same rays each time; kinds of which there are none are left out. Rays start off the surface
/// by more than any peer's error, so that none meets the triangle it comes from.
std::vector<RaySet> make_ray_sets(const BenchMesh& mesh, const std::vector<RayKind>& kinds,
                                  const RayOptions& options);

}  // namespace boxwood::bench
