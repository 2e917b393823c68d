// SPDX-License-Identifier: Apache-2.0
// From far away a patch of triangles looks like a dipole: its solid angle is the sum of area times
// normal, times the field of a dipole in its middle. Two more terms of the Taylor expansion make up
// for the shape of the patch. Near by, the patch is halved; single triangles are exact. Nodes lie
// in the order of a walk, so a query goes on to the next one or jumps over what is below, without a
// stack. Source: Barill et al., 2018. Explained in docs/algorithms/winding_number.md.
#include "boxwood/query/winding_number.h"

#include <algorithm>
#include <cmath>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/query/solid_angle.h"

namespace boxwood {

namespace {

using Node = WindingTree::Node;

/// Triangles of a leaf; half as many at least.
constexpr std::uint32_t kLargestLeaf = 8;
constexpr std::size_t kSmallestTask = 4096;
constexpr std::size_t kPiece = 1024;

std::uint32_t node_count(std::uint32_t triangles) {
    if (triangles <= kLargestLeaf) return 1;
    return 1 + node_count(triangles / 2) + node_count(triangles - triangles / 2);
}

class Builder {
public:
    Builder(MeshView mesh, std::vector<std::uint32_t>& order, std::vector<Node>& nodes)
        : mesh_(mesh), centroids_(triangle_centroids(mesh)), order_(order), nodes_(nodes) {}

    void build(std::uint32_t index, std::uint32_t first, std::uint32_t count) {
        const std::uint32_t after = index + node_count(count);
        Node& node = nodes_[index];
        node = summed_up(first, count);
        node.after = after;
        node.is_leaf = count <= kLargestLeaf;
        if (node.is_leaf) return;
        const std::uint32_t left = count / 2;
        halve(first, count, left);
        invoke_both(
            count > kSmallestTask, [&] { build(index + 1, first, left); },
            [&] { build(index + 1 + node_count(left), first + left, count - left); });
    }

private:
    std::span<std::uint32_t> range(std::uint32_t first, std::uint32_t count) {
        return std::span(order_).subspan(first, count);
    }

    /// The lower ones along the longest axis first.
    void halve(std::uint32_t first, std::uint32_t count, std::uint32_t left) {
        Box3d box;
        for (const std::uint32_t i : range(first, count)) box.extend(centroids_[i]);
        const int axis = box.longest_axis();
        const auto begin = order_.begin() + first;
        std::nth_element(begin, begin + left, begin + count, [&](std::uint32_t a, std::uint32_t b) {
            const double at_a = centroids_[a][axis], at_b = centroids_[b][axis];
            return at_a != at_b ? at_a < at_b : a < b;
        });
    }

    Node summed_up(std::uint32_t first, std::uint32_t count) {
        Node node;
        node.first = first;
        node.count = count;
        double area = 0;
        Vec3d sum = Vec3d::Zero(), mean = Vec3d::Zero();
        for (const std::uint32_t i : range(first, count)) {
            const double size = doubled_area_normal(i).norm();
            area += size;
            sum += size * centroids_[i];
            mean += centroids_[i] / count;
        }
        node.center = area > 0 ? Vec3d(sum / area) : mean;
        for (const std::uint32_t i : range(first, count)) add(i, node);
        return node;
    }

    Vec3d doubled_area_normal(std::uint32_t i) const {
        const Vec3d& a = mesh_.corner(i, 0);
        return (mesh_.corner(i, 1) - a).cross(mesh_.corner(i, 2) - a);
    }

    /// The moments of area times normal, up to the second, of one triangle.
    void add(std::uint32_t i, Node& node) const {
        const Vec3d normal = 0.5 * doubled_area_normal(i);
        const Vec3d middle = centroids_[i] - node.center;
        Eigen::Matrix3d second = middle * middle.transpose();
        for (int k = 0; k < 3; ++k) {
            const Vec3d& corner = mesh_.corner(i, k);
            const Vec3d arm = corner - centroids_[i];
            second += arm * arm.transpose() / 12;
            node.squared_radius =
                std::max(node.squared_radius, (corner - node.center).squaredNorm());
        }
        node.dipole += normal;
        const Eigen::Matrix3d first = middle * normal.transpose();
        const auto both = [&](int j, int k) { return first(j, k) + first(k, j); };
        const std::array<double, 6> linear = {first(0, 0), first(1, 1), first(2, 2),
                                              both(0, 1),  both(1, 2),  both(2, 0)};
        for (std::size_t k = 0; k < 6; ++k) node.linear[k] += linear[k];
        node.quadratic += 2 * second * normal + second.trace() * normal;
        const auto twice = [&](int j, int k) {  // j j k
            return second(j, j) * normal[k] + 2 * second(j, k) * normal[j];
        };
        const std::array<double, 10> cubic = {
            second(0, 0) * normal[0],
            second(1, 1) * normal[1],
            second(2, 2) * normal[2],
            twice(0, 1),
            twice(0, 2),
            twice(1, 0),
            twice(1, 2),
            twice(2, 0),
            twice(2, 1),
            2 * (second(0, 1) * normal[2] + second(1, 2) * normal[0] + second(2, 0) * normal[1])};
        for (std::size_t k = 0; k < 10; ++k) node.cubic[k] += cubic[k];
    }

    MeshView mesh_;
    std::vector<Vec3d> centroids_;
    std::vector<std::uint32_t>& order_;
    std::vector<Node>& nodes_;
};

/// The expansion where the node's center is seen at r.
double expansion(const Node& node, const Vec3d& r, double squared) {
    const double x = r.x(), y = r.y(), z = r.z();
    const auto& l = node.linear;
    const auto& c = node.cubic;
    const double trace = l[0] + l[1] + l[2];
    const double linear =
        l[0] * x * x + l[1] * y * y + l[2] * z * z + l[3] * x * y + l[4] * y * z + l[5] * z * x;
    const double cubic = x * x * (c[0] * x + c[3] * y + c[4] * z) +
                         y * y * (c[1] * y + c[5] * x + c[6] * z) +
                         z * z * (c[2] * z + c[7] * x + c[8] * y) + c[9] * x * y * z;
    const double inverse = 1 / squared;
    const double field = inverse * std::sqrt(inverse);
    const double of_dipole = node.dipole.dot(r) + trace;
    const double of_shape = -3 * linear - 1.5 * node.quadratic.dot(r) + 7.5 * inverse * cubic;
    constexpr double kFourPi = 12.566370614359172;
    return field * (of_dipole + inverse * of_shape) / kFourPi;
}

}  // namespace

WindingTree::WindingTree(MeshView mesh) : mesh_(mesh) {
    for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
        if (!triangle_box(mesh, i).is_empty()) order_.push_back(i);
    }
    if (order_.empty()) return;
    const auto count = static_cast<std::uint32_t>(order_.size());
    nodes_.resize(node_count(count));
    Builder(mesh, order_, nodes_).build(0, 0, count);
}

double winding_number(const WindingTree& tree, const Vec3d& point,
                      const WindingOptions& options) noexcept {
    if (!point.allFinite()) return 0;
    const double accuracy = options.accuracy > 1 ? options.accuracy : 1;
    const std::span<const Node> nodes = tree.nodes();
    const MeshView mesh = tree.mesh();
    double sum = 0;
    for (std::uint32_t i = 0; i < nodes.size();) {
        const Node& node = nodes[i];
        const Vec3d r = node.center - point;
        const double squared = r.squaredNorm();
        if (squared > accuracy * accuracy * node.squared_radius) {
            sum += expansion(node, r, squared);
            i = node.after;
            continue;
        }
        if (node.is_leaf) {
            for (const std::uint32_t triangle : tree.triangles(node))
                sum += solid_angle(point, mesh.corner(triangle, 0), mesh.corner(triangle, 1),
                                   mesh.corner(triangle, 2));
        }
        ++i;
    }
    return sum;
}

void winding_numbers(const WindingTree& tree, std::span<const Vec3d> points,
                     std::span<double> results, const WindingOptions& options,
                     const BatchOptions& batch) {
    if (points.size() != results.size())
        throw InvalidInput("winding_numbers: expected as many places for results as points");
    for_each_piece(points.size(), kPiece, batch, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            results[i] = winding_number(tree, points[i], options);
    });
}

}  // namespace boxwood
