// SPDX-License-Identifier: Apache-2.0
#include "cli/arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <filesystem>

#include "boxwood/core/error.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/mesh_file.h"
#include "cli/warnings.h"

namespace boxwood::cli {

namespace {

constexpr const char* kBrute = "brute";

/// 250, 10k or 1M.
std::optional<std::size_t> parse_count(std::string_view text) {
    std::size_t factor = 1;
    if (text.ends_with('k')) factor = 1'000;
    if (text.ends_with('M')) factor = 1'000'000;
    if (factor > 1) text.remove_suffix(1);
    std::size_t count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    const bool is_number = error == std::errc{} && end == text.data() + text.size();
    if (!is_number || count == 0 || count > 1'000'000'000) return std::nullopt;
    return count * factor;
}

std::string extensions(bool must_write) {
    std::vector<std::string_view> result;
    for (const MeshFormat& format : mesh_formats()) {
        if (format.write || !must_write) result.push_back(format.extension);
    }
    return fmt::format("{}", fmt::join(result, ", "));
}

}  // namespace

SceneOptions Accelerator::scene_options() const {
    if (name == kBrute) return {.brute_force = true};
    for (const auto& preset : build_presets()) {
        if (preset.name == name) return {.preset = preset.value};
    }
    return {.build = BuildOptions{value_of(build_methods(), name), value_of(merge_costs(), cost)}};
}

void refuse_name(const std::string& name) { throw CLI::ValidationError(name); }

void add_cost(CLI::App& command, std::string& cost) {
    command.add_option("--cost", cost, "what agglomerative minimises when it merges two nodes")
        ->check(CLI::IsMember(names(merge_costs())))
        ->capture_default_str();
}

void add_threads(CLI::App& command, std::size_t& threads) {
    command.add_option("--threads", threads, "threads to use; 0 for all cores")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
}

std::optional<std::string> slow_build_warning(std::size_t triangles, const SceneOptions& options) {
    return options.build ? warning_before_build(triangles, *options.build) : std::nullopt;
}

std::vector<std::string> accelerator_names() {
    std::vector<std::string> result = names(build_presets());
    result.emplace_back(kBrute);
    for (const std::string& method : names(build_methods())) result.push_back(method);
    return result;
}

bool names_generated_shape(const std::string& argument) {
    return argument.find(':') != std::string::npos && argument.find('/') == std::string::npos &&
           !std::filesystem::exists(argument);
}

MeshData load_mesh(const std::string& argument) {
    MeshData mesh;
    if (!names_generated_shape(argument)) {
        mesh = read_mesh(argument);
        print_warnings(mesh.warnings);
        return mesh;
    }
    const std::size_t colon = argument.rfind(':');
    const auto count = parse_count(std::string_view(argument).substr(colon + 1));
    if (!count)
        throw InvalidInput(argument + ": expected a count such as 500, 10k or 2M after the colon");
    static_cast<TriangleMesh&>(mesh) = generate(argument.substr(0, colon), *count);
    return mesh;
}

std::string mesh_argument_help() {
    return fmt::format("a mesh file ({}), or a generated shape such as gyroid:100k ({})",
                       extensions(false), fmt::join(generated_shapes(), ", "));
}

std::string written_extensions() { return extensions(true); }

}  // namespace boxwood::cli
