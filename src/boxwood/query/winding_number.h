// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "boxwood/core/batch.h"
#include "boxwood/core/vec.h"
#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

struct WindingOptions {
    /// A part of the mesh is summed up when the point is farther from its middle than this many
    /// times its radius: errors fall with its cube, time rises with its square. At least 1.
    double accuracy = 2;
};

/// What winding numbers of a mesh are found with: a binary tree whose nodes sum up the triangles
/// below as if they were in one place. Refers to the mesh's arrays, which must outlive it and stay
/// as they are. O(n log n) to build, on all cores, and 224 bytes for four to eight triangles to
/// keep.
class WindingTree {
public:
    /// The triangles from `first` on, as seen from far away: the Taylor expansion of their solid
    /// angle about `center`.
    struct Node {
        Vec3d center = Vec3d::Zero();
        double squared_radius = 0;
        Vec3d dipole = Vec3d::Zero();        ///< the sum of area times normal
        std::array<double, 6> linear = {};   ///< xx, yy, zz, xy, yz, zx
        Vec3d quadratic = Vec3d::Zero();     ///< what falls with the fifth power of distance
        std::array<double, 10> cubic = {};   ///< xxx, yyy, zzz, xxy, xxz, yyx, yyz, zzx, zzy, xyz
        std::uint32_t first = 0, count = 0;  ///< triangles
        std::uint32_t after = 0;             ///< the next node that isn't below this one
        bool is_leaf = false;
    };

    /// Precondition: indices in range.
    explicit WindingTree(MeshView mesh);

    MeshView mesh() const { return mesh_; }
    /// Each before those below it, the left subtree before the right one.
    std::span<const Node> nodes() const { return nodes_; }
    std::span<const std::uint32_t> triangles(const Node& node) const {
        return std::span(order_).subspan(node.first, node.count);
    }

private:
    MeshView mesh_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

/// How often the mesh winds around the point: 1 inside and 0 outside of a closed mesh whose fronts
/// face outward, and something between for one with holes; where two closed parts overlap, 2. On
/// the surface the mean of both sides. Within about 0.01 of winding_number_brute_force() for closed
/// meshes and an accuracy of 2. Triangles with a corner that isn't finite or beyond the range of
/// float don't count; a point that isn't finite gives 0. O(log n). Source: Barill et al., "Fast
/// Winding Numbers for Soups and Clouds", ACM TOG 37(4), 2018. See
/// docs/algorithms/winding_number.md.
double winding_number(const WindingTree& tree, const Vec3d& point,
                      const WindingOptions& options = {}) noexcept;

/// The same for each point, on all cores. Throws InvalidInput when the sizes differ, and what
/// BatchOptions says.
void winding_numbers(const WindingTree& tree, std::span<const Vec3d> points,
                     std::span<double> results, const WindingOptions& options = {},
                     const BatchOptions& batch = {});

}  // namespace boxwood
