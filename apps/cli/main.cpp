// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <new>

#include "boxwood/core/error.h"
#include "cli/commands.h"

// Exits with 0, with 1 and one line on stderr when something failed, or with 2 on wrong usage.
int main(int argc, char** argv) {
    CLI::App app("Ray tracing triangle meshes with trees of boxes", "boxwood");
    app.set_version_flag("--version", BOXWOOD_VERSION);
    app.require_subcommand(1);
    boxwood::cli::add_render(app);
    boxwood::cli::add_demo(app);
    boxwood::cli::add_info(app);
    boxwood::cli::add_bench(app);
    boxwood::cli::add_convert(app);
    boxwood::cli::add_scene(app);
    try {
        app.parse(argc, argv);
        return 0;
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "boxwood: error: out of memory\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "boxwood: error: {}\n", boxwood::one_line(error.what()));
    }
    return 1;
}
