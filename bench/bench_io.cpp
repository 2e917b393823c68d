// SPDX-License-Identifier: Apache-2.0
// How fast are mesh files read? Binary ones against a copy of their bytes, text against assimp and
// tinyobjloader; all from the page cache, in one process.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/mesh/mesh_file.h"
#include "io/file_reader.h"
#include "io/memory.h"
#include "io/sample_files.h"
#include "meshes.h"
#include "options.h"

namespace boxwood::bench {

namespace {

namespace fs = std::filesystem;

struct IoOptions {
    std::vector<std::string> meshes;
    int passes = 7;
    bool check = false, check_triangles = false;
    std::string json, memory_of;
};

struct IoScore {
    std::string mesh, format, reader;
    int threads;       ///< 0: all there are
    double seconds;    ///< the best of the passes
    double megabytes;  ///< of the file
    bool is_right;     ///< as many triangles as the mesh has
};

struct MemoryScore {
    std::string mesh, format;
    ReadMemory memory;

    double meshes() const {
        return static_cast<double>(memory.peak) / static_cast<double>(memory.mesh);
    }
};

constexpr const char *kCopyIn = "memcpy", *kCopyWarm = "memcpy, all warm";

/// Until the mesh is there; giving it back isn't timed.
double seconds_to_read(const FileReader& reader, const fs::path& file, std::size_t& triangles) {
    const ThreadLimit limit(static_cast<std::size_t>(reader.threads));
    return_memory();
    const auto start = std::chrono::steady_clock::now();
    const FileInMemory read = reader.read(file);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    triangles = read.triangles;
    return seconds.count();
}

std::vector<IoScore> measure(const std::string& mesh, const SampleFile& sample,
                             std::size_t triangles, int passes) {
    const double megabytes = 1e-6 * static_cast<double>(fs::file_size(sample.path));
    const auto score = [&](const std::string& reader, int threads) {
        return IoScore{mesh, sample.format, reader, threads, 1e30, megabytes, true};
    };
    std::vector<FileReader> readers;
    std::vector<IoScore> scores = {score(kCopyIn, 1), score(kCopyWarm, 1)};
    for (const FileReader& reader : file_readers()) {
        if (!reader.reads(sample.path.extension().string())) continue;
        readers.push_back(reader);
        scores.push_back(score(reader.name, reader.threads));
    }
    const auto keep = [](IoScore& best, double seconds) {
        best.seconds = std::min(best.seconds, seconds);
    };
    for (int pass = 0; pass < passes; ++pass) {
        keep(scores[0], seconds_to_copy_in(sample.path));
        keep(scores[1], seconds_to_copy_warm(sample.path));
        for (std::size_t i = 0; i < readers.size(); ++i) {
            std::size_t found = 0;
            keep(scores[i + 2], seconds_to_read(readers[i], sample.path, found));
            scores[i + 2].is_right = found == triangles;
        }
    }
    return scores;
}

void print(const std::vector<IoScore>& scores, const MemoryScore& memory) {
    fmt::print("  {}: {:.1f} MB; memory at the most {:.2f} meshes\n", scores[0].format,
               scores[0].megabytes, memory.meshes());
    for (const IoScore& score : scores) {
        const char* threads = score.threads == 0 ? "all threads" : "one thread";
        fmt::print("    {:<20}{:<12}{:9.2f} ms {:8.0f} MB/s   {:7.2f} of memcpy{}\n", score.reader,
                   threads, 1e3 * score.seconds, score.megabytes / score.seconds,
                   scores[0].seconds / score.seconds,
                   score.is_right ? "" : "   another number of triangles");
    }
    std::fflush(stdout);
}

/// Seconds, or 0 when it wasn't measured.
double seconds_of(const std::vector<IoScore>& scores, const std::string& mesh,
                  const std::string& format, const std::string& reader, int threads) {
    for (const IoScore& score : scores)
        if (score.mesh == mesh && score.format == format && score.reader == reader &&
            score.threads == threads)
            return score.seconds;
    return 0;
}

/// How many times as fast as somebody Boxwood is on a format, over the meshes.
void add_target(std::vector<Target>& targets, const std::vector<IoScore>& scores,
                const std::string& format, const std::string& peer, double target) {
    std::vector<std::pair<std::string, double>> ratios;
    for (const IoScore& score : scores) {
        if (score.format != format || score.reader != peer) continue;
        const double ours = seconds_of(scores, score.mesh, format, "boxwood", 0);
        ratios.emplace_back(score.mesh, score.seconds / ours);
    }
    if (!ratios.empty())
        targets.push_back(over_meshes(format + " to " + peer, target, target, ratios));
}

std::vector<Target> targets_of(const std::vector<IoScore>& scores,
                               const std::vector<MemoryScore>& memory) {
    std::vector<Target> targets;
    for (const char* format : {"PLY, binary", "PLY, binary, double", "STL, binary"})
        add_target(targets, scores, format, kCopyIn, 0.5);
    for (const char* format : {"OBJ", "PLY, text", "OFF", "STL, text"})
        add_target(targets, scores, format, "assimp", 8);
    add_target(targets, scores, "OBJ", "tinyobjloader", 2);
    const double dragon = seconds_of(scores, "dragon_871k", "PLY, text", "boxwood", 0);
    if (dragon > 0)
        targets.push_back(over_meshes("PLY, text: 0.25 s to what it took", 1, 1,
                                      {{"dragon_871k", 0.25 / dragon}}));
    std::vector<std::pair<std::string, double>> ratios;
    ratios.reserve(memory.size());
    for (const MemoryScore& score : memory)
        ratios.emplace_back(score.mesh + ", " + score.format, 2 / score.meshes());
    targets.push_back(over_meshes("memory: 2 meshes to the most it took", 1, 1, ratios));
    return targets;
}

/// The largest dragon when it's at hand, else a shape as large.
std::vector<std::string> meshes_for(const IoOptions& options) {
    if (!options.meshes.empty()) return options.meshes;
    for (const std::string& mesh : default_meshes())
        if (mesh.ends_with("dragon_871k.off")) return {mesh};
    return {"gyroid:871k"};
}

TriangleMesh load(const std::string& name) {
    return fs::exists(name) ? read_mesh(name) : load_bench_mesh(name).exact;
}

/// A folder of its own, removed in the end.
class WorkFolder {
public:
    WorkFolder() {
        std::string pattern = (fs::temp_directory_path() / "boxwood_io_XXXXXX").string();
        if (!mkdtemp(pattern.data())) throw IoError(pattern, "can't be made");
        path_ = pattern;
    }
    ~WorkFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

nlohmann::ordered_json json_of(const std::vector<Target>& targets,
                               const std::vector<IoScore>& scores,
                               const std::vector<MemoryScore>& memory) {
    nlohmann::ordered_json json = report(targets);
    for (const IoScore& score : scores)
        json["scores"].push_back({{"mesh", score.mesh},
                                  {"format", score.format},
                                  {"reader", score.reader},
                                  {"threads", score.threads},
                                  {"megabytes", score.megabytes},
                                  {"seconds", score.seconds},
                                  {"right", score.is_right}});
    for (const MemoryScore& score : memory)
        json["memory"].push_back({{"mesh", score.mesh},
                                  {"format", score.format},
                                  {"mesh_bytes", score.memory.mesh},
                                  {"peak_bytes", score.memory.peak}});
    return json;
}

int run(const IoOptions& options) {
    if (!options.memory_of.empty()) {
        print_read_memory(options.memory_of);
        return 0;
    }
    std::vector<IoScore> all;
    std::vector<MemoryScore> memory;
    bool right = true;
    for (const std::string& name : meshes_for(options)) {
        const WorkFolder folder;
        const TriangleMesh mesh = load(name);
        const std::string short_name = fs::path(name).stem().string();
        fmt::print("{}: {} vertices, {} triangles\n", short_name, mesh.vertices.size(),
                   mesh.faces.size());
        for (const SampleFile& sample : write_samples(folder.path(), mesh)) {
            memory.push_back({short_name, sample.format, read_memory(sample.path)});
            const std::vector<IoScore> scores =
                measure(short_name, sample, mesh.faces.size(), options.passes);
            print(scores, memory.back());
            for (const IoScore& score : scores) right = right && score.is_right;
            all.insert(all.end(), scores.begin(), scores.end());
        }
    }
    for (const char* peer : {"assimp", "tinyobjloader"}) {
        const auto is_it = [&](const FileReader& reader) { return reader.name == peer; };
        const std::vector<FileReader> readers = file_readers();
        if (std::none_of(readers.begin(), readers.end(), is_it))
            fmt::print("{} wasn't there when this was built (./dev setup peers)\n", peer);
    }
    const std::vector<Target> targets = targets_of(all, memory);
    print_targets(targets);
    write_json(options.json, json_of(targets, all, memory));
    return (options.check && !all_met(targets)) || (options.check_triangles && !right) ? 1 : 0;
}

}  // namespace

}  // namespace boxwood::bench

int main(int argc, char** argv) {
    CLI::App app("How fast mesh files are read", "bench_io");
    boxwood::bench::IoOptions options;
    app.add_option("MESH", options.meshes,
                   "mesh files or shapes such as gyroid:100k, each written in every format first; "
                   "without any, the largest dragon");
    boxwood::bench::add_passes_option(app, options.passes);
    boxwood::bench::add_check_option(app, options.check);
    app.add_flag("--check-triangles", options.check_triangles,
                 "exit with 1 when somebody finds another number of triangles");
    boxwood::bench::add_json_option(app, options.json);
    // How the program calls itself.
    app.add_option("--memory-of", options.memory_of)->group("");
    return boxwood::bench::run_benchmark(app, argc, argv,
                                         [&] { return boxwood::bench::run(options); });
}
