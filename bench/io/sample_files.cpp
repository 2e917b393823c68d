// SPDX-License-Identifier: Apache-2.0
// Boxwood writes PLY and STL as binary only; here they are as text, as other programs write them.
#include "io/sample_files.h"

#include "boxwood/mesh/mesh_file.h"
#include "boxwood/mesh/write_lines.h"

namespace boxwood::bench {

namespace {

namespace fs = std::filesystem;

void write_text_ply(const fs::path& path, MeshView mesh) {
    OutputFile file(path);
    file.write(
        fmt::format("ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
                    "property float z\nelement face {}\nproperty list uchar int vertex_indices\n"
                    "end_header\n",
                    mesh.vertices.size(), mesh.faces.size()));
    write_lines(file, mesh.vertices.size(), [&](fmt::memory_buffer& line, std::size_t i) {
        const Vec3d& p = mesh.vertices[i];
        fmt::format_to(fmt::appender(line), "{} {} {}\n", p.x(), p.y(), p.z());
    });
    write_lines(file, mesh.faces.size(), [&](fmt::memory_buffer& line, std::size_t i) {
        const Vec3i& f = mesh.faces[i];
        fmt::format_to(fmt::appender(line), "3 {} {} {}\n", f[0], f[1], f[2]);
    });
    file.commit();
}

void write_text_stl(const fs::path& path, MeshView mesh) {
    OutputFile file(path);
    file.write("solid sample\n");
    write_lines(file, mesh.faces.size(), [&](fmt::memory_buffer& line, std::size_t i) {
        const Vec3d &a = mesh.corner(i, 0), &b = mesh.corner(i, 1), &c = mesh.corner(i, 2);
        const Vec3f n = (b - a).cross(c - a).normalized().cast<float>();
        fmt::format_to(fmt::appender(line), "facet normal {} {} {}\nouter loop\n", n.x(), n.y(),
                       n.z());
        for (const Vec3d& p : {a, b, c})
            fmt::format_to(fmt::appender(line), "vertex {} {} {}\n", p.x(), p.y(), p.z());
        fmt::format_to(fmt::appender(line), "endloop\nendfacet\n");
    });
    file.write("endsolid sample\n");
    file.commit();
}

TriangleMesh rounded(MeshView mesh) {
    // The floats in memory of their own: g++ 12 leaves out the rounding of a vector that goes to
    // float and back at once.
    std::vector<Vec3f> floats;
    floats.reserve(mesh.vertices.size());
    for (const Vec3d& p : mesh.vertices) floats.emplace_back(p.cast<float>());
    TriangleMesh result{{}, {mesh.faces.begin(), mesh.faces.end()}};
    result.vertices.reserve(floats.size());
    for (const Vec3f& p : floats) result.vertices.emplace_back(p.cast<double>());
    return result;
}

}  // namespace

std::vector<SampleFile> write_samples(const fs::path& folder, MeshView mesh) {
    std::vector<SampleFile> samples = {{"PLY, binary", false, folder / "float.ply"},
                                       {"PLY, binary, double", false, folder / "double.ply"},
                                       {"STL, binary", false, folder / "binary.stl"},
                                       {"PLY, text", true, folder / "text.ply"},
                                       {"OBJ", true, folder / "text.obj"},
                                       {"OFF", true, folder / "text.off"},
                                       {"STL, text", true, folder / "text.stl"}};
    write_mesh(folder / "float.ply", rounded(mesh));
    write_mesh(folder / "double.ply", mesh);
    write_mesh(folder / "binary.stl", mesh);
    write_text_ply(folder / "text.ply", mesh);
    write_mesh(folder / "text.obj", mesh);
    write_mesh(folder / "text.off", mesh);
    write_text_stl(folder / "text.stl", mesh);
    return samples;
}

}  // namespace boxwood::bench
