// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "boxwood/core/error.h"
#include "boxwood/core/files.h"
#include "boxwood/core/parallel.h"
#include "boxwood/mesh/off.h"

namespace boxwood {

namespace {

constexpr std::size_t kBlock = 4096;  // lines that one task formats
constexpr std::size_t kBlocks = 64;   // blocks held in memory at a time

/// Writes lines 0 to count - 1; append(buffer, i) formats one, newline included.
template <class Append>
void write_lines(OutputFile& file, std::size_t count, const Append& append) {
    std::vector<fmt::memory_buffer> buffers(kBlocks);
    for (std::size_t first = 0; first < count; first += kBlock * kBlocks) {
        const std::size_t end = std::min(count, first + kBlock * kBlocks);
        parallel_for(kBlocks, 1, [&](std::size_t block, std::size_t last_block) {
            for (; block < last_block; ++block) {
                buffers[block].clear();
                const std::size_t begin = first + block * kBlock;
                for (std::size_t i = begin; i < std::min(end, begin + kBlock); ++i)
                    append(buffers[block], i);
            }
        });
        for (const auto& buffer : buffers) file.write({buffer.data(), buffer.size()});
    }
}

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
