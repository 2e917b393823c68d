// SPDX-License-Identifier: Apache-2.0
#include "cli/picture.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <tuple>

#include "boxwood/image/png.h"
#include "boxwood/render/render.h"
#include "cli/progress_bar.h"
#include "cli/stopwatch.h"

namespace boxwood::cli {

namespace {

/// "640x480"; whether it was one.
bool parse_size(const std::string& text, int& width, int& height) {
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, width);
    if (first.ec != std::errc{} || first.ptr == end || *first.ptr != 'x') return false;
    const auto second = std::from_chars(first.ptr + 1, end, height);
    return second.ec == std::errc{} && second.ptr == end && is_image_size(width, height);
}

void warn_of_slow_builds(const World& world, const SceneOptions& options) {
    for (const MeshData& mesh : world.meshes) {
        if (const auto warning = slow_build_warning(mesh.faces.size(), options))
            fmt::print(stderr, "boxwood: warning: {}\n", *warning);
    }
}

}  // namespace

void add_picture_options(CLI::App& command, PictureOptions& options) {
    command.add_option("-o,--output", options.output, "the picture, a PNG file")
        ->capture_default_str();
    command
        .add_option_function<std::string>(
            "--size",
            [&options](const std::string& text) {
                int width = 0, height = 0;
                if (!parse_size(text, width, height))
                    throw CLI::ValidationError(
                        "--size", "found '" + text + "', expected WIDTHxHEIGHT, up to 2^28 pixels");
                options.size = {width, height};
            },
            "pixels of the picture [default: what the scene says, else 640x480]")
        ->option_text("WIDTHxHEIGHT");
    command.add_option("--integrator", options.integrator, "what the picture shows")
        ->check(CLI::IsMember(names(integrators())));
    command.add_option("--accelerator", options.accelerator.name, "how hits are found")
        ->check(CLI::IsMember(accelerator_names()))
        ->capture_default_str();
    add_cost(command, options.accelerator.cost);
    add_threads(command, options.threads);
    command
        .add_option("--samples", options.samples,
                    "rays a pixel, for smooth edges, and for depth of field with whitted")
        ->check(CLI::Range(1, 65536));
    command.add_option("--seed", options.seed, "of the samples' places");
    command.add_flag("--quiet", options.quiet, "print nothing but errors");
}

void check_output(const PictureOptions& options) { check_png_path(options.output); }

PictureSettings PictureOptions::applied_to(const PictureSettings& settings) const {
    PictureSettings result = settings;
    if (size) std::tie(result.width, result.height) = *size;
    if (integrator) result.integrator = value_of(integrators(), *integrator);
    if (samples) result.samples = *samples;
    if (seed) result.seed = *seed;
    return result;
}

void make_picture(World world, const PictureOptions& options, double load_seconds) {
    world.picture = options.applied_to(world.picture);
    const PictureSettings& picture = world.picture;
    SceneOptions scene_options = options.accelerator.scene_options();
    scene_options.keep_trees = picture.integrator == IntegratorKind::heat;
    if (!options.quiet) warn_of_slow_builds(world, scene_options);

    Stopwatch stopwatch;
    const Surfaces surfaces(world, scene_options);
    const double build_seconds = stopwatch.lap();

    RenderOptions render_options = {.width = picture.width,
                                    .height = picture.height,
                                    .integrator = picture.integrator,
                                    .samples = picture.samples,
                                    .seed = picture.seed,
                                    .bounces = picture.bounces};
    ColorImage image;
    {
        ProgressBar bar(options.quiet);
        if (bar.is_visible()) render_options.progress = [&](double part) { bar.show(part); };
        image = render(world, surfaces, render_options);
    }
    const double render_seconds = stopwatch.lap();
    write_png(options.output, to_rgba8(image));
    if (!options.quiet)
        fmt::print("{}: {}x{} {} in {:.3f} s (load {:.3f} s, build {:.3f} s, render {:.3f} s)\n",
                   options.output, picture.width, picture.height,
                   name_of(integrators(), picture.integrator),
                   load_seconds + build_seconds + render_seconds + stopwatch.lap(), load_seconds,
                   build_seconds, render_seconds);
}

}  // namespace boxwood::cli
