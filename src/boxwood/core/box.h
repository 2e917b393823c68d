// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "boxwood/core/vec.h"

namespace boxwood {

/// An axis-aligned bounding box (AABB): all points p with lo <= p <= hi in every coordinate.
/// A box made without corners is empty: it contains nothing and extending by it changes nothing.
template <class T>
struct Box {
    using Vec = Eigen::Matrix<T, 3, 1>;

    Vec lo = Vec::Constant(std::numeric_limits<T>::infinity());
    Vec hi = Vec::Constant(-std::numeric_limits<T>::infinity());

    bool is_empty() const { return !(lo.array() <= hi.array()).all(); }

    Box& extend(const Vec& point) {
        lo = lo.cwiseMin(point);
        hi = hi.cwiseMax(point);
        return *this;
    }
    Box& extend(const Box& other) {
        lo = lo.cwiseMin(other.lo);
        hi = hi.cwiseMax(other.hi);
        return *this;
    }

    /// The smallest box that contains both.
    friend Box merged(Box a, const Box& b) { return a.extend(b); }

    bool contains(const Box& other) const {
        return other.is_empty() ||
               ((lo.array() <= other.lo.array()).all() && (other.hi.array() <= hi.array()).all());
    }

    Vec centroid() const { return T(0.5) * lo + T(0.5) * hi; }
    Vec extent() const { return hi - lo; }

    int longest_axis() const {
        int axis = 0;
        extent().maxCoeff(&axis);
        return axis;
    }

    /// In double precision, so that boxes of any float extent have a finite area; 0 when empty.
    double surface_area() const {
        if (is_empty()) return 0;
        const Vec3d e = hi.template cast<double>() - lo.template cast<double>();
        return 2 * (e.x() * e.y() + e.y() * e.z() + e.z() * e.x());
    }
    /// In double precision; 0 when empty.
    double volume() const {
        if (is_empty()) return 0;
        return (hi.template cast<double>() - lo.template cast<double>()).prod();
    }

    friend bool operator==(const Box& a, const Box& b) { return a.lo == b.lo && a.hi == b.hi; }
};

using Box3f = Box<float>;
using Box3d = Box<double>;

/// The largest size of a coordinate. Precondition: it isn't empty.
inline double largest_coordinate(const Box3f& box) {
    return box.lo.cwiseAbs().cwiseMax(box.hi.cwiseAbs()).maxCoeff();
}

}  // namespace boxwood
