// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/placement.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

#include "boxwood/core/error.h"

namespace boxwood {

namespace {

constexpr double kWorstCondition = 0x1p40;

}  // namespace

Placement::Placement(const AffineMap& to_world)
    : linear_(to_world.linear()), offset_(to_world.translation()) {
    if (!linear_.allFinite() || !offset_.allFinite())
        throw InvalidInput("found a transform with a number that isn't finite, expected none");
    is_identity_ = linear_.isIdentity(0) && offset_.isZero(0);
    if (is_identity_) return;

    // Scaled by a power of two, so that determinants neither overflow nor vanish.
    const double largest = linear_.cwiseAbs().maxCoeff();
    if (largest > 1e90 || (largest > 0 && largest < 1e-90))
        throw InvalidInput(fmt::format(
            "found a transform that changes lengths by {:.3g}, expected 1e-90 to 1e90", largest));
    const double scale = largest > 0 ? std::ldexp(1.0, -std::ilogb(largest)) : 1;
    const Eigen::Matrix3d scaled = scale * linear_;
    const Eigen::FullPivLU<Eigen::Matrix3d> lu(scaled);
    const Eigen::Matrix3d inverse = lu.inverse();
    const double condition = scaled.norm() * inverse.norm();
    // What the inverse is off by, as it was found: the exact one is (1 + residual)^-1 times it.
    const double residual = (inverse * scaled - Eigen::Matrix3d::Identity()).norm();
    const bool has_inverse = condition < kWorstCondition && residual < 0.01;
    if (!has_inverse)
        throw InvalidInput("found a transform that flattens space, expected one with an inverse");
    inverse_ = scale * inverse;
    norm_ = linear_.norm();
    error_ = (8 * residual + 0x1p-46 * condition) * inverse_.norm() * (1 + 2 * residual);
    const Vec3d lengths = Eigen::JacobiSVD<Eigen::Matrix3d>(scaled).singularValues();
    most_growth_ = lengths[0] * (1 + 0x1p-46) / scale;
    most_shrinking_ = scale / (lengths[2] - 0x1p-46 * lengths[0]);
    is_mirrored_ = lu.determinant() < 0;
    keeps_angles_ = lengths[0] <= lengths[2] * (1 + 1e-12);
}

}  // namespace boxwood
