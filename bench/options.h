// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/command_line.h"
#include "contest.h"
#include "targets.h"

namespace boxwood::bench {

/// What every benchmark of Boxwood and its peers can be told.
struct CommonOptions {
    std::vector<std::string> meshes;
    std::vector<std::string> libraries;
    std::vector<std::string> kind_names = {"primary", "ao", "diffuse", "random"};
    RayOptions rays;
    int passes = 5;
    bool check = false;
    bool check_hits = false;
    std::string json;

    std::vector<RayKind> kinds() const;
};

void add_common_options(CLI::App& app, CommonOptions& options);

// Options that every benchmark has, common ones or not.
void add_rays_option(CLI::App& app, RayOptions& options);
void add_passes_option(CLI::App& app, int& passes);
void add_check_option(CLI::App& app, bool& check);
void add_json_option(CLI::App& app, std::string& file);

/// Prints the targets, writes the JSON, and tells the program's exit code.
int finish(const CommonOptions& options, const std::vector<Target>& targets,
           const std::vector<Score>& scores, const nlohmann::ordered_json& details);

/// The main() of a benchmark: errors are one line on stderr.
int run_benchmark(CLI::App& app, int argc, char** argv, const std::function<int()>& run);

}  // namespace boxwood::bench
