// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <limits>

#include "boxwood/core/error.h"
#include "boxwood/core/files.h"
#include "boxwood/mesh/off.h"
#include "boxwood/mesh/write_lines.h"

namespace boxwood {

namespace {

/// So that read_off takes what write_off wrote.
void check_vertices(MeshView mesh) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        for (const double x : mesh.vertices[i]) {
            if (!(std::abs(x) <= kLargest))
                throw InvalidInput(fmt::format(
                    "vertex {} has coordinate {}, expected a number of at most 3.4e38 in size", i,
                    x));
        }
    }
}

}  // namespace

void write_off(const std::filesystem::path& path, MeshView mesh,
               const MeshAttributes& /* has no place for them */) {
    check_vertices(mesh);
    check_indices(mesh);

    OutputFile file(path);
    file.write(fmt::format("OFF\n{} {} 0\n", mesh.vertices.size(), mesh.faces.size()));
    write_lines(file, mesh.vertices.size(), [&](fmt::memory_buffer& buffer, std::size_t i) {
        const Vec3d& v = mesh.vertices[i];
        fmt::format_to(std::back_inserter(buffer), "{} {} {}\n", v.x(), v.y(), v.z());
    });
    write_lines(file, mesh.faces.size(), [&](fmt::memory_buffer& buffer, std::size_t i) {
        const Vec3i& f = mesh.faces[i];
        fmt::format_to(std::back_inserter(buffer), "3 {} {} {}\n", f.x(), f.y(), f.z());
    });
    file.commit();
}

}  // namespace boxwood
