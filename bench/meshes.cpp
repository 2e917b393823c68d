// SPDX-License-Identifier: Apache-2.0
#include "meshes.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "boxwood/core/error.h"
#include "cli/arguments.h"
#include "read_obj.h"

namespace boxwood::bench {

namespace {

/// Each triangle cut into parts * parts of its shape; no vertices are shared.
TriangleMesh subdivided(const TriangleMesh& mesh, int parts) {
    TriangleMesh result;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        const MeshView view = mesh;
        const int first = static_cast<int>(result.vertices.size());
        const auto vertex = [&](int i, int j) { return first + i * (i + 1) / 2 + j; };
        for (int i = 0; i <= parts; ++i) {
            for (int j = 0; j <= i; ++j) {
                const double b = static_cast<double>(i - j) / parts,
                             c = static_cast<double>(j) / parts;
                result.vertices.push_back((1 - b - c) * view.corner(face, 0) +
                                          b * view.corner(face, 1) + c * view.corner(face, 2));
            }
        }
        for (int i = 0; i < parts; ++i) {
            for (int j = 0; j <= i; ++j) {
                result.faces.emplace_back(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
                if (j < i)
                    result.faces.emplace_back(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
            }
        }
    }
    return result;
}

TriangleMesh load(const std::string& argument) {
    return argument.ends_with(".obj") ? read_obj(argument) : cli::load_mesh(argument);
}

}  // namespace

BenchMesh load_bench_mesh(const std::string& argument) {
    BenchMesh result;
    const std::size_t at = argument.rfind('@');
    result.exact = load(argument.substr(0, at));
    result.name = std::filesystem::path(argument.substr(0, at)).stem().string();
    if (at != std::string::npos) {
        const int parts = std::atoi(argument.c_str() + at + 1);
        if (parts < 1 || parts > 100)
            throw InvalidInput(argument + ": expected a number from 1 to 100 after the @");
        result.exact = subdivided(result.exact, parts);
        result.name += argument.substr(at);
    }
    // Room for a peer that reads four floats a vertex.
    result.vertices.resize(3 * result.exact.vertices.size() + 4);
    for (std::size_t i = 0; i < result.exact.vertices.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            result.vertices[3 * i + k] =
                static_cast<float>(result.exact.vertices[i][static_cast<int>(k)]);
    // In a loop of its own: GCC 12 takes a double for its own rounding to float and back where it
    // vectorizes both steps together.
    for (std::size_t i = 0; i < result.exact.vertices.size(); ++i)
        result.exact.vertices[i] = Eigen::Map<const Vec3f>(&result.vertices[3 * i]).cast<double>();
    result.faces.reserve(3 * result.exact.faces.size());
    for (const Vec3i& face : result.exact.faces)
        for (const int index : face) result.faces.push_back(static_cast<std::uint32_t>(index));
    return result;
}

bool is_scene(std::string_view name) {
    return name.starts_with("interior") || name.starts_with("stadium") ||
           name.starts_with("atrium");
}

std::vector<std::string> default_meshes() {
    std::vector<std::string> result;
    const auto add = [&](const std::filesystem::path& path, const std::string& suffix,
                         const char* remedy) {
        if (std::filesystem::exists(path))
            result.push_back(path.string() + suffix);
        else
            fmt::print(stderr, "skipped: {}{} ({})\n", path.stem().string(), suffix, remedy);
    };
    const std::filesystem::path data = BOXWOOD_DATA_DIR;
    for (const char* name : {"bunny", "dragon_48k", "dragon_200k", "dragon_871k"})
        add(data / fmt::format("{}.off", name), "", "./dev data brings it");
    add(data / "dragon_200k.off", "@3", "./dev data brings it");
    for (const char* shape : {"interior:100k", "interior:1M", "stadium:100k", "stadium:1M"})
        result.emplace_back(shape);
    const char* shared = std::getenv("BOXWOOD_SHARED");
    add(std::filesystem::path(shared ? shared : "") / "data/scenes/atrium.obj", "",
        "BOXWOOD_SHARED names no folder with it");
    return result;
}

}  // namespace boxwood::bench
