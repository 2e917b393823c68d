// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "boxwood/query/wide_counts.h"
#include "boxwood/scene/scene.h"
#include "cli/bench_rays.h"

namespace boxwood::cli {

/// What rays of one kind did on the tree of one accelerator.
struct RayCounts {
    std::string_view rays;
    std::size_t count = 0;  ///< of rays
    WideCounts closest_hit, any_hit;
};

struct CounterRow {
    std::string accelerator;
    std::vector<RayCounts> kinds;
};

/// Asks the scene's wide trees for the closest and for any hit of each ray in float. A ray that
/// skips the triangle that it starts on, which such rays can't, starts a ten thousandth of its
/// length further on.
CounterRow count_visits(const std::string& accelerator, const Scene& scene,
                        const std::vector<RaySet>& sets);

/// A table of means over the rays.
void print_counters(const std::string& mesh, std::size_t triangles,
                    const std::vector<CounterRow>& rows);
nlohmann::ordered_json counters_as_json(const std::string& mesh, std::size_t triangles,
                                        const std::vector<CounterRow>& rows);

}  // namespace boxwood::cli
