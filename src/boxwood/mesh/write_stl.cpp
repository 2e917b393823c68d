// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "boxwood/core/error.h"
#include "boxwood/core/files.h"
#include "boxwood/core/parallel.h"
#include "boxwood/mesh/attribute_names.h"
#include "boxwood/mesh/byte_order.h"
#include "boxwood/mesh/stl.h"

namespace boxwood {

namespace {

constexpr std::size_t kTriangleBytes = 50;
constexpr std::size_t kPiece = 4096;                  // triangles that one task writes
constexpr std::size_t kBlock = std::size_t{1} << 18;  // triangles held in memory at a time
constexpr const char* kAttribute = "attribute";

/// The field that goes into the attribute bytes; null when there is none that fits.
const MeshField* attribute_field(const MeshAttributes& attributes) {
    for (const MeshField& field : attributes.fields) {
        if (field.name != kAttribute || field.of != ValuesOf::faces) continue;
        const bool fits = std::all_of(field.values.begin(), field.values.end(), [](double x) {
            return x >= 0 && x <= 65535 && x == std::floor(x);
        });
        if (fits) return &field;
    }
    return nullptr;
}

/// Of length 1, or zero where the triangle has none.
Vec3f normal_of(const Vec3f* corners) {
    const Vec3d a = corners[0].cast<double>();
    const Vec3d normal = (corners[1].cast<double>() - a).cross(corners[2].cast<double>() - a);
    const double length = normal.norm();
    return length > 0 && std::isfinite(length) ? Vec3f((normal / length).cast<float>())
                                               : Vec3f(Vec3f::Zero());
}

void write_triangle(char* bytes, MeshView mesh, std::size_t face, double attribute) {
    Vec3f corners[3];
    for (int k = 0; k < 3; ++k) corners[k] = mesh.corner(face, k).cast<float>();
    const Vec3f normal = normal_of(corners);
    for (int i = 0; i < 3; ++i) {
        write_little_float(bytes + 4 * i, normal[i]);
        for (int k = 0; k < 3; ++k) write_little_float(bytes + 12 * (k + 1) + 4 * i, corners[k][i]);
    }
    const auto bits = static_cast<std::uint32_t>(attribute);
    bytes[48] = static_cast<char>(bits & 0xff);
    bytes[49] = static_cast<char>(bits >> 8);
}

}  // namespace

void write_stl(const std::filesystem::path& path, MeshView mesh, const MeshAttributes& attributes) {
    check_indices(mesh);
    const std::size_t count = mesh.faces.size();
    constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
    if (count > kMost)
        throw InvalidInput(fmt::format("found {} triangles, expected at most {}", count, kMost));
    const MeshField* field = attribute_field(attributes);

    OutputFile file(path);
    // Must not begin with "solid".
    std::string header = "binary STL, written by Boxwood";
    header.resize(84);
    write_little_uint32(&header[80], static_cast<std::uint32_t>(count));
    file.write(header);
    std::string block;
    for (std::size_t first = 0; first < count; first += kBlock) {
        const std::size_t size = std::min(count - first, kBlock);
        block.resize(size * kTriangleBytes);
        parallel_for(size, kPiece, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                write_triangle(&block[i * kTriangleBytes], mesh, first + i,
                               field ? field->values[first + i] : 0);
        });
        file.write(block);
    }
    file.commit();
}

bool is_held_by_stl(const AttributeName& attribute) {
    return attribute.of == ValuesOf::faces && attribute.what == "field attribute";
}

}  // namespace boxwood
