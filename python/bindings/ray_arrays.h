// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <utility>

#include "arrays.h"
#include "boxwood/core/error.h"
#include "boxwood/core/ray.h"
#include "boxwood/query/ray_columns.h"

namespace boxwood::python {

/// An array that is kept, and read without checks.
template <class Array>
class Kept {
public:
    explicit Kept(const Array& array) : array_(array), view_(array.view()) {}

    std::size_t size() const { return array_.shape(0); }
    template <class... Indices>
    auto operator()(Indices... indices) const {
        return view_(indices...);
    }

private:
    Array array_;
    decltype(std::declval<const Array&>().view()) view_;
};

/// Throws InvalidInput unless all are of that size.
inline void check_sizes(std::size_t size, std::initializer_list<std::size_t> sizes) {
    for (const std::size_t other : sizes)
        if (other != size) throw InvalidInput("rays: expected arrays of one length");
}

/// Rays in double, as arrays.
class RayArrays {
public:
    RayArrays(const Rows<double>& origins, const Rows<double>& directions,
              const Values<double>& t_min, const Values<double>& t_max,
              const Values<std::int32_t>& skip_instance, const Values<std::int32_t>& skip_triangle,
              const Values<std::uint32_t>& visibility)
        : origins_(origins),
          directions_(directions),
          t_min_(t_min),
          t_max_(t_max),
          skip_instance_(skip_instance),
          skip_triangle_(skip_triangle),
          visibility_(visibility) {
        check_sizes(size(), {directions_.size(), t_min_.size(), t_max_.size(),
                             skip_instance_.size(), skip_triangle_.size(), visibility_.size()});
    }

    std::size_t size() const { return origins_.size(); }

    Ray operator[](std::size_t i) const {
        Ray ray;
        for (int k = 0; k < 3; ++k) {
            ray.origin[k] = origins_(i, k);
            ray.direction[k] = directions_(i, k);
        }
        ray.t_min = t_min_(i);
        ray.t_max = t_max_(i);
        // -1 for none.
        ray.skip = {static_cast<std::uint32_t>(skip_instance_(i)),
                    static_cast<std::uint32_t>(skip_triangle_(i))};
        ray.visibility = visibility_(i);
        return ray;
    }

    /// Those from `begin` on.
    void gather(std::size_t begin, std::span<Ray> rays) const {
        for (std::size_t i = 0; i < rays.size(); ++i) rays[i] = (*this)[begin + i];
    }

private:
    Kept<Rows<double>> origins_, directions_;
    Kept<Values<double>> t_min_, t_max_;
    Kept<Values<std::int32_t>> skip_instance_, skip_triangle_;
    Kept<Values<std::uint32_t>> visibility_;
};

/// Rays in float, as arrays that are kept.
class RayArraysf {
public:
    RayArraysf(const Rows<float>& origins, const Rows<float>& directions,
               const Values<float>& t_min, const Values<float>& t_max)
        : origins_(origins), directions_(directions), t_min_(t_min), t_max_(t_max) {
        check_sizes(size(), {directions.shape(0), t_min.shape(0), t_max.shape(0)});
        for (const Rows<float>& rows : {origins, directions})
            if (rows.stride(1) != 1)
                throw InvalidInput("rays: expected rows that lie together in memory");
    }

    std::size_t size() const { return origins_.shape(0); }
    RayColumns columns() const {
        return {size(), column(origins_), column(directions_), column(t_min_), column(t_max_)};
    }

private:
    template <class Array>
    static FloatColumn column(const Array& array) {
        return {array.data(), array.stride(0)};
    }

    Rows<float> origins_, directions_;
    Values<float> t_min_, t_max_;
};

/// Throws InvalidInput unless there is a place for each of so many.
template <class... Arrays>
void check_places(std::size_t count, const Arrays&... places) {
    if (((places.shape(0) != count) || ...))
        throw InvalidInput("results: expected a place for each ray, point or shape");
}

}  // namespace boxwood::python
