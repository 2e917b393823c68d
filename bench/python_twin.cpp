// SPDX-License-Identifier: Apache-2.0
// The batch in C++ that bench_python.py compares the Python layer with: the same mesh, rays and
// process-wide settings. For each line on stdin, "double" or "float" and a file of rays, it answers
// with the seconds that the batch took. It delivers what Python delivers: hits with normals of unit
// length, in memory of their own.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/mesh/mesh_file.h"
#include "boxwood/scene/scene.h"

namespace boxwood::bench {

namespace {

/// Six doubles a ray: origin, direction.
std::vector<double> read_numbers(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) throw IoError(path, "can't be opened");
    std::vector<double> numbers(static_cast<std::size_t>(file.tellg()) / sizeof(double));
    file.seekg(0);
    file.read(reinterpret_cast<char*>(numbers.data()),
              static_cast<std::streamsize>(numbers.size() * sizeof(double)));
    return numbers;
}

template <class AnyRay>
std::vector<AnyRay> rays_of(const std::vector<double>& numbers) {
    std::vector<AnyRay> rays(numbers.size() / 6);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            using Number = std::remove_reference_t<decltype(rays[i].origin[0])>;
            rays[i].origin[static_cast<int>(k)] = static_cast<Number>(numbers[6 * i + k]);
            rays[i].direction[static_cast<int>(k)] = static_cast<Number>(numbers[6 * i + 3 + k]);
        }
    }
    return rays;
}

Vec3d unit_normal(const Scene& scene, const Hit& hit) { return scene.geometric_normal(hit); }
Vec3f unit_normal(const Scene&, const Hitf& hit) {
    return Eigen::Map<const Vec3f>(hit.normal).cast<double>().normalized().cast<float>();
}

template <class AnyRay, class AnyHit>
double seconds(const Scene& scene, const std::vector<AnyRay>& rays) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<AnyHit> hits(rays.size());
    scene.closest_hits(rays, hits);
    std::vector<decltype(unit_normal(scene, hits[0]))> normals(hits.size());
    parallel_for(hits.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (hits[i].is_hit()) normals[i] = unit_normal(scene, hits[i]);
    });
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void serve(const std::string& mesh_file) {
    const TriangleMesh mesh = read_mesh(mesh_file);
    const Scene scene({mesh});
    std::string precision, path, loaded;
    std::vector<Ray> rays;
    std::vector<Rayf> raysf;
    while (std::cin >> precision >> path) {
        if (path != loaded) {
            const std::vector<double> numbers = read_numbers(path);
            rays = rays_of<Ray>(numbers);
            raysf = rays_of<Rayf>(numbers);
            loaded = path;
        }
        fmt::print("{}\n", precision == "float" ? seconds<Rayf, Hitf>(scene, raysf)
                                                : seconds<Ray, Hit>(scene, rays));
        std::fflush(stdout);
    }
}

}  // namespace

}  // namespace boxwood::bench

int main(int argc, char** argv) {
    try {
        if (argc != 2) throw boxwood::InvalidInput("expected one argument, a mesh file");
        boxwood::bench::serve(argv[1]);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "python_twin: {}\n", error.what());
        return 1;
    }
}
