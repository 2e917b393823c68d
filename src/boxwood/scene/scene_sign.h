// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "boxwood/query/signed_distance.h"
#include "boxwood/scene/scene.h"

namespace boxwood {

/// What telling the inside of a scene from its outside takes. Refers to the scene, which must
/// outlive it and stay where and as it is, instances and all. A point that is as near to the
/// surface as rounding is has either sign. O(n log n) to make. Instances share what is known of
/// their mesh where their transforms keep angles; others get copies of theirs.
class SceneSign {
public:
    explicit SceneSign(const Scene& scene, SignMethod method = SignMethod::pseudonormal,
                       const WindingOptions& winding = {});
    SceneSign(SceneSign&&) noexcept;
    SceneSign& operator=(SceneSign&&) noexcept;
    ~SceneSign();

    SignMethod method() const { return method_; }
    /// Whether that of every instance is: see MeshSign.
    bool is_trustworthy() const;

    /// The distance of Scene::closest_point(), with a sign: negative inside. Instances count as one
    /// surface: for pseudonormals the nearest one decides, winding numbers are added up, and
    /// by ray parity a point is inside that is inside any. So where instances overlap, take winding
    /// numbers or parity.
    std::optional<SignedDistance> signed_distance(
        const Vec3d& point,
        double max_radius = std::numeric_limits<double>::infinity()) const noexcept;
    /// The same for each point, on all cores. Throws InvalidInput when the sizes differ, Cancelled.
    void signed_distances(std::span<const Vec3d> points, std::span<SignedDistance> results,
                          double max_radius = std::numeric_limits<double>::infinity(),
                          const BatchOptions& options = {}) const;

    /// How often all instances together wind around the point: see winding_number.h.
    /// O(log n) for each instance, as is ray parity. Precondition: method() is winding_number.
    double winding_number(const Vec3d& point) const noexcept;
    void winding_numbers(std::span<const Vec3d> points, std::span<double> results,
                         const BatchOptions& options = {}) const;

private:
    struct Solid;
    struct Part;

    Side side_of(const Vec3d& point, const ClosestPoint& closest) const noexcept;

    const Scene* scene_;
    SignMethod method_;
    std::vector<std::unique_ptr<Solid>> solids_;
    std::vector<Part> parts_;  ///< one an instance
};

}  // namespace boxwood
