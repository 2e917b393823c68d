// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/triangle_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>

#include "boxwood/core/error.h"
#include "boxwood/core/huge_pages.h"
#include "boxwood/core/parallel.h"
#include "boxwood/core/ray_triangle.h"

namespace boxwood {

namespace {

constexpr std::size_t kPiece = 4096;

/// Times a power of two, exactly, such that products of coordinates don't underflow.
Vec3d scaled(const Vec3d& edge) {
    int exponent = 0;
    std::frexp(edge.cwiseAbs().maxCoeff(), &exponent);
    return edge.unaryExpr([&](double x) { return std::ldexp(x, -exponent); });
}

template <class Visit>
void for_each_box(MeshView mesh, const Visit& visit) {
    parallel_for(mesh.faces.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            fetch_vertices_ahead(mesh, i);
            visit(i, triangle_box(mesh, i));
        }
    });
}

}  // namespace

std::vector<Vec3d> in_double(std::span<const Vec3f> vertices) {
    std::vector<Vec3d> result;
    resize_on_huge_pages(result, vertices.size());
    parallel_for(vertices.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) result[i] = vertices[i].cast<double>();
    });
    return result;
}

bool are_floats(std::span<const Vec3d> vertices) {
    // By their bits: g++ 12 takes a double for its own rounding to float and back where it makes
    // vectors of both. No branches, so that it can.
    const auto is_rounded = [](double x) {
        constexpr std::uint64_t kDigitsOfDouble =
            (std::uint64_t{1} << (DBL_MANT_DIG - FLT_MANT_DIG)) - 1;
        std::uint64_t bits = 0;
        std::memcpy(&bits, &x, sizeof bits);
        const double size = std::abs(x);
        const int has_digits = (bits & kDigitsOfDouble) != 0;
        const int is_finite = size <= DBL_MAX, is_large = size > FLT_MAX;
        const int is_small = static_cast<int>(size > 0) & static_cast<int>(size < FLT_MIN);
        return is_finite & (has_digits | is_large | is_small);
    };
    std::atomic<bool> result = true;
    parallel_for(vertices.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t piece = begin; piece < end && result; piece += kPiece) {
            int some = 0;
            for (std::size_t i = piece; i < std::min(piece + kPiece, end); ++i)
                for (int k = 0; k < 3; ++k) some |= is_rounded(vertices[i][k]);
            if (some != 0) result = false;
        }
    });
    return result;
}

void check_indices(MeshView mesh) {
    const auto count = static_cast<std::int64_t>(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        for (const int index : mesh.faces[i]) {
            if (index < 0 || index >= count)
                throw InvalidInput(fmt::format("face {} has vertex index {}, expected 0 to {}", i,
                                               index, count - 1));
        }
    }
}

bool has_zero_area(MeshView mesh, std::size_t face) {
    const Vec3d ab = mesh.corner(face, 1) - mesh.corner(face, 0);
    const Vec3d ac = mesh.corner(face, 2) - mesh.corner(face, 0);
    // Plain arithmetic settles nearly all: far from rounding and from underflow.
    const double product = ab.x() * ac.y(), other = ab.y() * ac.x();
    if (std::abs(product - other) > 0x1p-50 * (std::abs(product) + std::abs(other)) + 1e-290)
        return false;
    const Vec3d e = scaled(ab), f = scaled(ac);
    return difference_of_products(e.x(), f.y(), e.y(), f.x()) == 0 &&
           difference_of_products(e.y(), f.z(), e.z(), f.y()) == 0 &&
           difference_of_products(e.z(), f.x(), e.x(), f.z()) == 0;
}

std::vector<Box3f> triangle_boxes(MeshView mesh) {
    std::vector<Box3f> boxes;
    resize_on_huge_pages(boxes, mesh.faces.size());
    for_each_box(mesh, [&](std::size_t i, const Box3f& box) { boxes[i] = box; });
    return boxes;
}

std::span<const Box3f> triangle_boxes(MeshView mesh, std::span<std::byte> memory) {
    auto* const boxes = reinterpret_cast<Box3f*>(memory.data());
    for_each_box(mesh, [&](std::size_t i, const Box3f& box) { new (boxes + i) Box3f(box); });
    return {boxes, mesh.faces.size()};
}

std::vector<Vec3d> triangle_centroids(MeshView mesh) {
    std::vector<Vec3d> centroids(mesh.faces.size());
    parallel_for(centroids.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            centroids[i] = (mesh.corner(i, 0) + mesh.corner(i, 1) + mesh.corner(i, 2)) / 3;
    });
    return centroids;
}

Box3d bounds(MeshView mesh) {
    Box3d box;
    for (const Vec3d& vertex : mesh.vertices) {
        if (vertex.allFinite()) box.extend(vertex);
    }
    return box;
}

Vec3d geometric_normal(MeshView mesh, std::size_t face) {
    const Vec3d& a = mesh.corner(face, 0);
    return (mesh.corner(face, 1) - a).cross(mesh.corner(face, 2) - a).normalized();
}

}  // namespace boxwood
