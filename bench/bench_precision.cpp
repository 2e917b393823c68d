// SPDX-License-Identifier: Apache-2.0
// What does double precision cost? Closest hits in double against those in float, on the same tree
// and the same rays in one process.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "boxwood/core/parallel.h"
#include "boxwood/query/certified_hits.h"
#include "boxwood/query/wide_hits.h"
#include "boxwood/scene/scene.h"
#include "meshes.h"
#include "options.h"
#include "ray_sets.h"

namespace boxwood::bench {

namespace {

constexpr double kTarget = 0.8;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct PrecisionScore {
    std::string mesh;
    RayKind kind;
    double in_float, in_double, batch_in_float, batch_in_double;  ///< million rays a second
    std::size_t rays;
    std::size_t wrong;  ///< in double: another t than the exact one

    double ratio() const { return in_double / in_float; }
    double batch_ratio() const { return batch_in_double / batch_in_float; }
};

struct PrecisionOptions {
    std::vector<std::string> meshes;
    std::vector<std::string> kind_names = {"primary", "diffuse", "random"};
    RayOptions rays;
    int passes = 5;
    bool vertices_in_double = false;
    bool check = false, check_hits = false;
    std::string json;

    std::vector<RayKind> kinds() const {
        std::vector<RayKind> result;
        for (const RayKind kind : kRayKinds)
            if (std::find(kind_names.begin(), kind_names.end(), name_of(kind)) != kind_names.end())
                result.push_back(kind);
        return result;
    }
};

/// Seconds of this process for each way to ask, pass by pass.
struct Way {
    std::vector<double> seconds = {};

    template <class Work>
    void time(const Work& work) {
        const double start = thread_seconds();
        work();
        seconds.push_back(thread_seconds() - start);
    }
    double mrays(std::size_t rays) const {
        return 1e-6 * static_cast<double>(rays) / median(seconds);
    }
};

PrecisionScore measure(const BenchMesh& mesh, const Scene& scene, const RaySet& set, int passes) {
    const MeshView view = mesh.exact;
    const WideTree& tree = scene.wide_trees()[0];
    static_assert(sizeof(PlainRay) == sizeof(Rayf));
    const std::span rays_in_float(reinterpret_cast<const Rayf*>(set.rays.data()), set.rays.size());
    std::vector<Ray> rays;
    for (const PlainRay& ray : set.rays) rays.push_back(exact(ray));
    std::vector<Hitf> hits_in_float(rays.size());
    std::vector<Hit> hits(rays.size());

    const ThreadLimit one(1);
    Way in_float, in_double, batch_in_float, batch_in_double;
    std::size_t wrong = 0;
    // The first pass warms up.
    for (int pass = -1; pass < passes; ++pass) {
        in_float.time([&] {
            for (std::size_t i = 0; i < rays.size(); ++i)
                closest_hit(tree, rays_in_float[i], hits_in_float[i]);
        });
        in_double.time([&] {
            for (std::size_t i = 0; i < rays.size(); ++i) closest_hit(view, tree, rays[i], hits[i]);
        });
        batch_in_float.time([&] { closest_hits(tree, rays_in_float, hits_in_float); });
        batch_in_double.time([&] { scene.closest_hits(rays, hits); });
        if (pass >= 0) continue;
        for (std::size_t i = 0; i < rays.size(); ++i)
            wrong += (hits[i].is_hit() ? hits[i].t : kInfinity) != set.truth[i];
        for (Way* way : {&in_float, &in_double, &batch_in_float, &batch_in_double})
            way->seconds.clear();
    }
    return {mesh.name,
            set.kind,
            in_float.mrays(rays.size()),
            in_double.mrays(rays.size()),
            batch_in_float.mrays(rays.size()),
            batch_in_double.mrays(rays.size()),
            rays.size(),
            wrong};
}

void print(const PrecisionScore& score) {
    fmt::print(
        "  {:<8}  single {:7.3f} {:7.3f} {:6.2f}   batch {:7.3f} {:7.3f} {:6.2f}   wrong {}\n",
        name_of(score.kind), score.in_float, score.in_double, score.ratio(), score.batch_in_float,
        score.batch_in_double, score.batch_ratio(), score.wrong);
}

std::vector<Target> targets_of(const std::vector<PrecisionScore>& scores,
                               const std::vector<RayKind>& kinds) {
    std::vector<Target> targets;
    const auto add = [&](const char* what, RayKind kind, double (PrecisionScore::*ratio)() const) {
        std::vector<std::pair<std::string, double>> ratios;
        for (const PrecisionScore& score : scores)
            if (score.kind == kind) ratios.emplace_back(score.mesh, (score.*ratio)());
        if (!ratios.empty())
            targets.push_back(
                over_meshes(fmt::format("double to float, {}, {}", what, name_of(kind)), kTarget,
                            0.95 * kTarget, ratios));
    };
    for (const RayKind kind : kinds) add("one by one", kind, &PrecisionScore::ratio);
    for (const RayKind kind : kinds) add("batches", kind, &PrecisionScore::batch_ratio);
    return targets;
}

/// The bunny and the dragons as far as they are at hand, and a hall.
std::vector<std::string> meshes_for(const PrecisionOptions& options) {
    if (!options.meshes.empty()) return options.meshes;
    std::vector<std::string> result;
    for (const std::string& mesh : default_meshes()) {
        const auto holds = [&](const char* name) { return mesh.find(name) != std::string::npos; };
        if (holds("bunny") || holds("dragon_871k") || holds("interior:100k"))
            result.push_back(mesh);
    }
    return result;
}

int run(const PrecisionOptions& options) {
    std::vector<PrecisionScore> scores;
    for (const std::string& name : meshes_for(options)) {
        BenchMesh mesh = load_bench_mesh(name);
        if (options.vertices_in_double)
            for (Vec3d& vertex : mesh.exact.vertices) vertex *= 1 + 0x1p-40;
        const Scene scene({mesh.exact}, {.preset = BuildPreset::best});
        fmt::print("{}: {} triangles; million rays a second in float, in double, their ratio\n",
                   mesh.name, mesh.exact.faces.size());
        for (const RaySet& set : make_ray_sets(mesh, options.kinds(), options.rays)) {
            scores.push_back(measure(mesh, scene, set, options.passes));
            print(scores.back());
            std::fflush(stdout);
        }
    }
    const std::vector<Target> targets = targets_of(scores, options.kinds());
    print_targets(targets);
    nlohmann::ordered_json json = report(targets);
    bool right = true;
    for (const PrecisionScore& score : scores) {
        right = right && score.wrong == 0;
        json["scores"].push_back({{"mesh", score.mesh},
                                  {"kind", name_of(score.kind)},
                                  {"rays", score.rays},
                                  {"float_mrays_per_second", score.in_float},
                                  {"double_mrays_per_second", score.in_double},
                                  {"float_batch_mrays_per_second", score.batch_in_float},
                                  {"double_batch_mrays_per_second", score.batch_in_double},
                                  {"wrong", score.wrong}});
    }
    write_json(options.json, json);
    return (options.check && !all_met(targets)) || (options.check_hits && !right) ? 1 : 0;
}

}  // namespace

}  // namespace boxwood::bench

int main(int argc, char** argv) {
    CLI::App app("What double precision costs: closest hits, against those in float",
                 "bench_precision");
    boxwood::bench::PrecisionOptions options;
    app.add_option("MESH", options.meshes,
                   "OFF or OBJ files or shapes such as gyroid:100k; without any, the bunny, the "
                   "dragon and a hall");
    app.add_option("--kinds", options.kind_names, "kinds of rays")
        ->delimiter(',')
        ->check(CLI::IsMember({"primary", "diffuse", "random"}))
        ->capture_default_str();
    app.add_flag("--vertices-in-double", options.vertices_in_double,
                 "with vertices that float would round, where most files hold floats");
    boxwood::bench::add_rays_option(app, options.rays);
    boxwood::bench::add_passes_option(app, options.passes);
    boxwood::bench::add_check_option(app, options.check);
    app.add_flag("--check-hits", options.check_hits,
                 "exit with 1 when a hit in double differs from the exact one");
    boxwood::bench::add_json_option(app, options.json);
    return boxwood::bench::run_benchmark(app, argc, argv,
                                         [&] { return boxwood::bench::run(options); });
}
