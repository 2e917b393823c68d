// SPDX-License-Identifier: Apache-2.0
// What bench_build measures, and what it makes of that: a table for people, targets for --check.
#pragma once

#include <string>
#include <vector>

#include "contest.h"
#include "targets.h"

namespace boxwood::bench {

/// A peer's build of one quality of one mesh.
struct BuildScore {
    std::string mesh;
    std::size_t triangles;
    std::string library;
    std::string name;  ///< of the peer and the quality; what its rays are listed under
    Quality quality;
    double one_thread = 0;  ///< seconds, the median of the passes
    double two_threads = 0;
    double bytes_a_triangle = 0;  ///< 0 where the peer doesn't tell
    double mrays = 0;             ///< of single rays, the geometric mean over the kinds
};

/// "low" ...
std::string_view name_of(Quality quality);

void print_builds(const std::vector<BuildScore>& builds);

std::vector<Target> build_targets(const std::vector<BuildScore>& builds);

nlohmann::ordered_json as_json(const std::vector<BuildScore>& builds);

}  // namespace boxwood::bench
