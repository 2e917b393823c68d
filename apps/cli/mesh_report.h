// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "boxwood/mesh/inspect.h"
#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/repair.h"

namespace boxwood::cli {

/// What "boxwood info" tells of a mesh, without trees.
struct MeshInfo {
    std::string format;  ///< empty for a mesh that comes from no file
    MeshReport report;
    std::vector<std::string> attributes;
    Warnings warnings;
    std::optional<RepairReport> repair;  ///< what was done before
};

nlohmann::ordered_json as_json(const MeshInfo& info);
void print_text(const MeshInfo& info);

}  // namespace boxwood::cli
