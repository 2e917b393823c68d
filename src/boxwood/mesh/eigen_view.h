// SPDX-License-Identifier: Apache-2.0
// Meshes that are kept as a matrix of vertices and one of faces, a row each.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <type_traits>

#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

namespace detail {

/// The rows as an array of Row, where they lie. Precondition: they lie one after another.
template <class Row, class Matrix>
std::span<const Row> rows_of(const Matrix& matrix) {
    static_assert(Matrix::IsRowMajor && Matrix::ColsAtCompileTime == 3,
                  "a view needs rows of three that lie one after another: "
                  "Eigen::Matrix<T, Eigen::Dynamic, 3, Eigen::RowMajor>; others go to to_mesh()");
    static_assert(std::is_same_v<typename Matrix::Scalar, typename Row::Scalar>);
    static_assert(sizeof(Row) == 3 * sizeof(typename Row::Scalar));
    return {reinterpret_cast<const Row*>(matrix.data()), static_cast<std::size_t>(matrix.rows())};
}

}  // namespace detail

/// A view on a mesh that is kept as matrices n x 3, row by row: vertices in double or float and
/// faces in int. They must outlive it.
template <class Vertices, class Faces>
auto view(const Eigen::PlainObjectBase<Vertices>& vertices,
          const Eigen::PlainObjectBase<Faces>& faces) {
    const auto rows = detail::rows_of<Vec3i>(faces.derived());
    if constexpr (std::is_same_v<typename Vertices::Scalar, float>)
        return MeshViewf{detail::rows_of<Vec3f>(vertices.derived()), rows};
    else
        return MeshView{detail::rows_of<Vec3d>(vertices.derived()), rows};
}

/// A copy of a mesh that is kept as matrices of three columns, in whatever order and of whatever
/// numbers. O(n). Precondition: three columns, faces within the range of int.
template <class Vertices, class Faces>
TriangleMesh to_mesh(const Eigen::DenseBase<Vertices>& vertices,
                     const Eigen::DenseBase<Faces>& faces) {
    TriangleMesh mesh;
    mesh.vertices.reserve(static_cast<std::size_t>(vertices.rows()));
    mesh.faces.reserve(static_cast<std::size_t>(faces.rows()));
    for (Eigen::Index i = 0; i < vertices.rows(); ++i)
        mesh.vertices.push_back(vertices.row(i).template cast<double>());
    for (Eigen::Index i = 0; i < faces.rows(); ++i)
        mesh.faces.push_back(faces.row(i).template cast<int>());
    return mesh;
}

}  // namespace boxwood
