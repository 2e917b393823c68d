// SPDX-License-Identifier: Apache-2.0
#include "io/memory.h"

#include <fmt/format.h>
#include <malloc.h>
#include <sys/mman.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/core/files.h"
#include "boxwood/core/parallel.h"
#include "boxwood/mesh/mesh_file.h"

namespace boxwood::bench {

namespace {

namespace fs = std::filesystem;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// A line of /proc/self/status, in bytes.
std::size_t status(const std::string& key) {
    std::ifstream in("/proc/self/status");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(key + ":")) return 1024 * std::stoull(line.substr(key.size() + 1));
    throw IoError("/proc/self/status", "no " + key);
}

std::size_t bytes_of(const MeshData& mesh) {
    const auto values = [](const auto& v) { return v.size() * sizeof(v[0]); };
    const MeshAttributes& all = mesh.attributes;
    std::size_t sum = values(mesh.vertices) + values(mesh.faces) + values(all.normals.values) +
                      values(all.texture_coordinates.values) + values(all.colors.values) +
                      values(all.groups.of_face) + values(all.materials.of_face);
    for (const MeshField& field : all.fields) sum += values(field.values);
    return sum;
}

struct Unmap {
    std::size_t size;
    void operator()(void* memory) const { munmap(memory, size); }
};

}  // namespace

void print_read_memory(const fs::path& file) {
    // The threads are there before.
    parallel_for(1'000'000, 1, [](std::size_t, std::size_t) {});
    const std::size_t before = status("VmRSS");
    const MeshData mesh = read_mesh(file);
    const std::size_t grown = status("VmHWM") - before, mapped = fs::file_size(file);
    fmt::print("{} {}\n", bytes_of(mesh), grown > mapped ? grown - mapped : 0);
}

ReadMemory read_memory(const fs::path& file) {
    const std::string command = fmt::format(
        "'{}' --memory-of '{}'", fs::read_symlink("/proc/self/exe").string(), file.string());
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    ReadMemory result;
    if (!pipe || std::fscanf(pipe.get(), "%zu %zu", &result.mesh, &result.peak) != 2)
        throw IoError(file.string(), "can't measure the memory it takes to read");
    return result;
}

double seconds_to_copy_in(const fs::path& file) {
    const double start = now();
    const MappedFile mapped(file);
    const std::size_t size = mapped.text().size();
    void* memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw IoError(file.string(), "no memory to copy it to");
    const std::unique_ptr<void, Unmap> freed(memory, {size});
    std::memcpy(memory, mapped.text().data(), size);
    return now() - start;
}

double seconds_to_copy_warm(const fs::path& file) {
    const MappedFile mapped(file);
    std::vector<char> memory(mapped.text().begin(), mapped.text().end());
    const double start = now();
    std::memcpy(memory.data(), mapped.text().data(), memory.size());
    return now() - start;
}

void return_memory() { malloc_trim(0); }

}  // namespace boxwood::bench
