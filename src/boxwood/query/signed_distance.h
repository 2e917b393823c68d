// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <span>

#include "boxwood/core/named.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/query/closest_point.h"
#include "boxwood/query/pseudonormals.h"
#include "boxwood/query/wide_tree.h"
#include "boxwood/query/winding_number.h"

namespace boxwood {

/// How the inside of a mesh is told from its outside.
enum class SignMethod {
    pseudonormal,    ///< by the normal at the closest point: the fastest, for closed meshes that
                     ///< don't intersect themselves
    winding_number,  ///< by how often the mesh winds around the point: bears holes
    ray_parity       ///< by counting what a ray crosses: whichever way triangles face
};

std::span<const Named<SignMethod>> sign_methods();

/// Where a point is.
struct Side {
    bool is_inside = false;
    bool is_sure = false;  ///< else it is a guess
};

/// That of a point with this winding number.
Side side_by_winding(double number);

/// What a method has to know of a mesh. Refers to the mesh's arrays, which must outlive it and stay
/// as they are. O(n log n) to make.
class MeshSign {
public:
    /// Precondition: indices in range.
    explicit MeshSign(MeshView mesh, SignMethod method = SignMethod::pseudonormal,
                      const WindingOptions& winding = {});

    SignMethod method() const { return method_; }
    /// Whether the mesh is closed, for pseudonormals also with all triangles facing the same way:
    /// what these methods rest on. Winding numbers rest on nothing, so there it is always true.
    bool is_trustworthy() const { return is_trustworthy_; }

    /// On which side the point is whose closest point that is.
    /// Precondition: the tree was made from this mesh.
    Side side_of(const WideTree& tree, const Vec3d& point,
                 const ClosestPoint& closest) const noexcept;
    /// Precondition: method() is winding_number.
    double winding_number(const Vec3d& point) const noexcept;

private:
    Side by_parity(const WideTree& tree, const Vec3d& point) const noexcept;
    Side by_normal(const WideTree& tree, const Vec3d& point,
                   const ClosestPoint& closest) const noexcept;

    MeshView mesh_;
    SignMethod method_;
    WindingOptions winding_;
    bool is_trustworthy_ = true;
    std::optional<Pseudonormals> normals_;
    std::optional<WindingTree> winding_tree_;
};

/// A distance that is negative inside the mesh.
struct SignedDistance {
    double distance = std::numeric_limits<double>::infinity();
    /// The sign is a guess: the mesh isn't closed or its triangles don't face the same way; with
    /// winding numbers, the point's is more than 1/4 from whole.
    bool is_undefined = true;
    ClosestPoint closest = {};
};

/// That of a point on that side with that closest point.
SignedDistance with_side(const ClosestPoint& closest, const Side& side);

/// The distance of closest_point(), with a sign. O(log n), with ray parity for each crossing.
/// Preconditions: tree and sign were made from this mesh. See docs/algorithms/signed_distance.md.
std::optional<SignedDistance> signed_distance(
    MeshView mesh, const WideTree& tree, const MeshSign& sign, const Vec3d& point,
    double max_radius = std::numeric_limits<double>::infinity()) noexcept;

/// The same for each point, as closest_points() does it. Throws InvalidInput when the sizes differ.
void signed_distances(MeshView mesh, const WideTree& tree, const MeshSign& sign,
                      std::span<const Vec3d> points, std::span<SignedDistance> results,
                      double max_radius = std::numeric_limits<double>::infinity(),
                      const BatchOptions& options = {});

}  // namespace boxwood
