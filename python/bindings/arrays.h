// SPDX-License-Identifier: Apache-2.0
// Arrays of numpy as the bindings take and give them.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "boxwood/core/vec.h"
#include "boxwood/core/warnings.h"
#include "boxwood/mesh/placement.h"

namespace boxwood::python {

namespace nb = nanobind;

// What the stub says of them.
using Dict = nb::typed<nb::dict, nb::str, nb::any>;
using List = nb::typed<nb::list, nb::any>;
using Triple = nb::typed<nb::tuple, double, double, double>;

/// One value for each of something, or one for all of them by a stride of 0.
template <class T>
using Values = nb::ndarray<const T, nb::ndim<1>, nb::device::cpu>;
/// Rows of three, likewise.
template <class T>
using Rows = nb::ndarray<const T, nb::shape<-1, 3>, nb::device::cpu>;
/// Rows of three that lie one after another.
template <class T>
using PackedRows = nb::ndarray<const T, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

// Where results go.
template <class T>
using ValuesOut = nb::ndarray<T, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
template <class T, int columns>
using RowsOut = nb::ndarray<T, nb::shape<-1, columns>, nb::c_contig, nb::device::cpu>;

/// The rows as an array of Row.
template <class Row, class Array>
std::span<Row> rows_of(const Array& array) {
    static_assert(sizeof(Row) == 3 * sizeof(typename Array::Scalar));
    return {reinterpret_cast<Row*>(array.data()), array.shape(0)};
}

template <class Array>
auto values_of(const Array& array) {
    return std::span(array.data(), array.shape(0));
}

/// A view of what the owner holds, which lives as long as the view: read-only.
template <class T>
nb::ndarray<nb::numpy, const T> view_of(const T* data, std::initializer_list<std::size_t> shape,
                                        nb::handle owner) {
    return nb::ndarray<nb::numpy, const T>(data, shape, owner);
}

/// An array that takes the values over.
template <class T>
nb::ndarray<nb::numpy, T> array_of(std::vector<T> values) {
    auto* kept = new std::vector<T>(std::move(values));
    const nb::capsule owner(kept, [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
    return nb::ndarray<nb::numpy, T>(kept->data(), {kept->size()}, owner);
}

/// Matrices of affine maps, row by row; the last row isn't looked at.
using Transforms = nb::ndarray<const double, nb::shape<-1, 4, 4>, nb::c_contig>;

inline AffineMap affine_map(const Transforms& transforms, std::size_t i) {
    AffineMap map = AffineMap::Identity();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            map.matrix()(row, column) =
                transforms.data()[16 * i + static_cast<std::size_t>(4 * row + column)];
    return map;
}

/// Kind, count and examples of each.
inline List list_of(const Warnings& warnings) {
    List result;
    for (const Warning& warning : warnings.kinds())
        result.append(nb::make_tuple(warning.kind, warning.count, warning.shown));
    return result;
}

}  // namespace boxwood::python
