// SPDX-License-Identifier: Apache-2.0
// What bench_rays makes of its scores: tables for people, targets for --check.
#pragma once

#include <vector>

#include "contest.h"
#include "targets.h"

namespace boxwood::bench {

/// Of one mesh: million rays a second of everybody, and times the best of Embree's single rays.
void print_scores(const std::vector<Score>& scores, const std::vector<RayKind>& kinds);

/// The geometric mean of those ratios over all meshes.
void print_means(const std::vector<Score>& scores, const std::vector<RayKind>& kinds);

/// Those that can be told from the scores: without Embree there are few.
std::vector<Target> ray_targets(const std::vector<Score>& scores);

nlohmann::ordered_json as_json(const std::vector<Score>& scores);

}  // namespace boxwood::bench
