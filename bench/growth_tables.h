// SPDX-License-Identifier: Apache-2.0
// What bench_growth measures, and what it makes of that.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace boxwood::bench {

/// One builder or preset on one mesh. Seconds are those of one thread.
struct GrowthScore {
    std::string mesh;
    std::size_t triangles = 0;
    std::string name;
    double build_seconds = 0;
    std::vector<double> seconds_per_ray = {};  ///< by kind of ray; none for the textbook's builders
    std::size_t wrong_hits = 0;                ///< rays whose hit isn't the exact one
};

/// Of one mesh: milliseconds, nanoseconds for each of the n log2 n steps, nanoseconds a ray.
void print_growth(const std::vector<GrowthScore>& scores, const std::vector<std::string>& kinds);

/// How everything grows over the meshes, a line a name: the exponent of n that fits the time best,
/// and for rays the nanoseconds that each doubling of n adds. Nothing for a single size.
void print_fits(const std::vector<GrowthScore>& scores, const std::vector<std::string>& kinds);

/// The scores, with their fits.
nlohmann::ordered_json as_json(const std::vector<GrowthScore>& scores,
                               const std::vector<std::string>& kinds);

}  // namespace boxwood::bench
