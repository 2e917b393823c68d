// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <cstddef>

#include "arrays.h"
#include "bindings.h"
#include "boxwood/build/build.h"
#include "boxwood/tree/statistics.h"
#include "choice.h"
#include "unlocked.h"

namespace boxwood::python {

using namespace nanobind::literals;

namespace {

Tree build(const PackedRows<double>& vertices, const PackedRows<std::int32_t>& faces,
           const std::string& method, const std::string& cost) {
    const MeshView mesh = {rows_of<const Vec3d>(vertices), rows_of<const Vec3i>(faces)};
    const BuildOptions options = {.method = choice("method", build_methods(), method),
                                  .cost = choice("cost", merge_costs(), cost)};
    const Unlocked unlocked;
    check_indices(mesh);
    return build_tree(mesh, options);
}

/// A view of one member of all nodes.
template <class T>
nb::ndarray<nb::numpy, const T> member_of_nodes(nb::handle self, std::size_t place,
                                                std::size_t columns) {
    static_assert(sizeof(Node) % sizeof(T) == 0);
    constexpr auto kStride = static_cast<std::int64_t>(sizeof(Node) / sizeof(T));
    const std::vector<Node>& nodes = nb::cast<const Tree&>(self).nodes;
    const void* first = reinterpret_cast<const std::byte*>(nodes.data()) + place;
    if (nodes.empty()) first = nullptr;
    if (columns == 1) return {static_cast<const T*>(first), {nodes.size()}, self, {kStride}};
    return {static_cast<const T*>(first), {nodes.size(), columns}, self, {kStride, 1}};
}

Dict statistics_of(const Tree& tree) {
    const TreeStatistics found = statistics(tree);
    Dict result;
    result["nodes"] = found.nodes;
    result["leaves"] = found.leaves;
    result["depth"] = found.depth;
    result["largest_leaf"] = found.largest_leaf;
    result["bytes"] = found.bytes;
    result["sah_cost"] = found.sah_cost;
    return result;
}

}  // namespace

void bind_trees(nb::module_& module) {
    nb::class_<Tree>(module, "Tree")
        .def_prop_ro("lower",
                     [](nb::handle_t<Tree> self) {
                         return member_of_nodes<float>(self, offsetof(Node, box.lo), 3);
                     })
        .def_prop_ro("upper",
                     [](nb::handle_t<Tree> self) {
                         return member_of_nodes<float>(self, offsetof(Node, box.hi), 3);
                     })
        .def_prop_ro("first",
                     [](nb::handle_t<Tree> self) {
                         return member_of_nodes<std::uint32_t>(self, offsetof(Node, first), 1);
                     })
        .def_prop_ro("count",
                     [](nb::handle_t<Tree> self) {
                         return member_of_nodes<std::uint32_t>(self, offsetof(Node, count), 1);
                     })
        .def_prop_ro("order",
                     [](nb::handle_t<Tree> self) {
                         const auto& order = nb::cast<const Tree&>(self).order;
                         return view_of(order.data(), {order.size()}, self);
                     })
        .def("depths", [](const Tree& tree) { return array_of(node_depths(tree)); })
        .def("statistics", &statistics_of);
    module.def("build", &build, "vertices"_a.noconvert(), "faces"_a.noconvert(), "method"_a,
               "cost"_a);
    module.def("warning_before_build", [](std::size_t triangles, const std::string& method) {
        return warning_before_build(triangles,
                                    {.method = choice("method", build_methods(), method)});
    });
}

}  // namespace boxwood::python
