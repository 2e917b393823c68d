// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/eigen_view.h"

#include <gtest/gtest.h>

namespace boxwood {
namespace {

template <class T, int kOrder>
using Rows = Eigen::Matrix<T, Eigen::Dynamic, 3, kOrder>;

TEST(EigenView, rows_are_seen_where_they_lie) {
    Rows<double, Eigen::RowMajor> vertices(4, 3);
    vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    Rows<int, Eigen::RowMajor> faces(2, 3);
    faces << 0, 1, 2, 3, 2, 1;
    const MeshView mesh = view(vertices, faces);
    ASSERT_EQ(mesh.vertices.size(), 4u);
    ASSERT_EQ(mesh.faces.size(), 2u);
    EXPECT_EQ(mesh.corner(1, 0), Vec3d(0, 0, 1));
    vertices(3, 2) = 7;
    EXPECT_EQ(mesh.corner(1, 0), Vec3d(0, 0, 7));

    const Rows<float, Eigen::RowMajor> floats = vertices.cast<float>();
    const MeshViewf in_float = view(floats, faces);
    EXPECT_EQ(in_float.vertices[3], Vec3f(0, 0, 7));
    EXPECT_EQ(in_float.faces.data(), mesh.faces.data());
}

TEST(EigenView, other_matrices_are_copied) {
    const Eigen::MatrixXf vertices = Eigen::MatrixXf::Random(5, 3);
    Eigen::Matrix<long, Eigen::Dynamic, Eigen::Dynamic> faces(1, 3);
    faces << 4, 0, 2;
    const TriangleMesh mesh = to_mesh(vertices, faces);
    ASSERT_EQ(mesh.vertices.size(), 5u);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(mesh.vertices[i], Vec3d(vertices.row(i).cast<double>()));
    EXPECT_EQ(mesh.faces, (std::vector<Vec3i>{{4, 0, 2}}));
}

}  // namespace
}  // namespace boxwood
