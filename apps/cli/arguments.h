// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "boxwood/core/named.h"
#include "boxwood/mesh/mesh_data.h"
#include "boxwood/scene/scene.h"
#include "cli/command_line.h"

namespace boxwood::cli {

/// How hits are found, as a user names it.
struct Accelerator {
    std::string name = "balanced";
    std::string cost = "surface_area";

    SceneOptions scene_options() const;
};

/// Adds --cost.
void add_cost(CLI::App& command, std::string& cost);
/// Adds --threads.
void add_threads(CLI::App& command, std::size_t& threads);

/// What to say before a build that takes minutes or more; else nothing.
std::optional<std::string> slow_build_warning(std::size_t triangles, const SceneOptions& options);

/// The presets, "brute" and the builders.
std::vector<std::string> accelerator_names();

template <class Value>
std::vector<std::string> names(std::span<const Named<Value>> choices) {
    std::vector<std::string> result;
    for (const auto& choice : choices) result.emplace_back(choice.name);
    return result;
}

/// Throws CLI::ValidationError.
[[noreturn]] void refuse_name(const std::string& name);

/// The value of a name that a CLI::IsMember check let through.
template <class Value>
Value value_of(std::span<const Named<Value>> choices, const std::string& name) {
    if (const auto* choice = find_named(choices, name)) return choice->value;
    refuse_name(name);
}

/// A mesh file, or a generated shape as SHAPE:COUNT, such as gyroid:100k.
bool names_generated_shape(const std::string& argument);

/// The mesh that this names. Prints what is wrong with a file and was tolerated.
MeshData load_mesh(const std::string& argument);

/// Help for it.
std::string mesh_argument_help();

/// ".off, .stl", for help: of the formats that can be written.
std::string written_extensions();

}  // namespace boxwood::cli
