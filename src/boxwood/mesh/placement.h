// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/core/ray.h"
#include "boxwood/core/vec.h"

namespace boxwood {

/// An affine map as it is given: not aligned, so that callers compiled for other machines than the
/// library agree with it on where its numbers are. Eigen::Affine3d turns into it.
using AffineMap = Eigen::Transform<double, 3, Eigen::Affine, Eigen::DontAlign>;

/// Where a mesh stands: an affine map from its own, local coordinates to those of the world, with
/// its inverse and bounds on what rounding does to both.
class Placement {
public:
    /// Where it is.
    Placement() = default;
    /// Throws InvalidInput when a number isn't finite, when the map changes lengths by a factor
    /// outside [1e-90, 1e90], or when it flattens space, so that rounding leaves nothing of its
    /// inverse: its condition number is 2^40 or more.
    explicit Placement(const AffineMap& to_world);

    bool is_identity() const { return is_identity_; }
    /// Whether it turns left hands into right ones.
    bool is_mirrored() const { return is_mirrored_; }
    /// Whether all lengths grow by one factor and angles stay, but for rounding.
    bool keeps_angles() const { return keeps_angles_; }

    /// A vertex of the mesh as the world sees it. This rounding is part of what the instance is.
    Vec3d to_world(const Vec3d& p) const {
        Vec3d result;
        for (int k = 0; k < 3; ++k) {
            result[k] =
                linear_(k, 0) * p[0] + linear_(k, 1) * p[1] + linear_(k, 2) * p[2] + offset_[k];
        }
        return result;
    }

    /// A place of the world as the mesh sees it, and a difference of two; off by rounding().
    Vec3d to_local(const Vec3d& p) const { return inverse_ * (p - offset_); }
    Vec3d to_local_direction(const Vec3d& d) const { return inverse_ * d; }

    /// Lengths in the world are at most so many times local ones.
    double most_growth() const { return most_growth_; }
    /// Local lengths are at most so many times those in the world.
    double most_shrinking() const { return most_shrinking_; }

    /// A bound on the coordinates in the world of what has local ones of that size at the most.
    double largest_in_world(double largest_local) const {
        return offset_.lpNorm<Eigen::Infinity>() + 2 * norm_ * largest_local;
    }

    /// How far in local coordinates, at the most, places are from where they should be: of what is
    /// seen from that place of the world, on rays as well as on the mesh, whose local coordinates
    /// are at most the given size. Explained in docs/algorithms/instances.md.
    double rounding(const Vec3d& place, double largest_local) const {
        return error_ * (place.lpNorm<Eigen::Infinity>() + largest_in_world(largest_local));
    }

private:
    Eigen::Matrix3d linear_ = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d inverse_ = Eigen::Matrix3d::Identity();
    Vec3d offset_ = Vec3d::Zero();
    double norm_ = 1;
    double most_growth_ = 1, most_shrinking_ = 1;
    double error_ = 0;
    bool is_identity_ = true, is_mirrored_ = false, keeps_angles_ = true;
};

/// The ray as the mesh sees it: the same t belongs to the same place.
inline Ray local_ray(const Placement& placement, Ray ray) {
    ray.origin = placement.to_local(ray.origin);
    ray.direction = placement.to_local_direction(ray.direction);
    return ray;
}

}  // namespace boxwood
