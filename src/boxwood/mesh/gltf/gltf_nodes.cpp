// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/gltf/gltf_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace boxwood {

namespace {

/// A "matrix", column by column, or "translation", "rotation" as a quaternion, and "scale".
AffineMap local_map(const JsonReader& node) {
    AffineMap map = AffineMap::Identity();
    if (const auto matrix = node.find("matrix")) {
        const std::vector<double> m = matrix->numbers(16);
        if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
            matrix->fail("an affine matrix, with 0, 0, 0 and 1 in its last row");
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column)
                map.matrix()(row, column) = m[static_cast<std::size_t>(4 * column + row)];
        return map;
    }
    if (const auto translation = node.find("translation")) map.translate(translation->vec3());
    if (const auto rotation = node.find("rotation")) {
        const std::vector<double> q = rotation->numbers(4);
        const Eigen::Quaternion<double, Eigen::DontAlign> quaternion(q[3], q[0], q[1], q[2]);
        const double norm = quaternion.norm();
        if (!(norm > 0 && std::isfinite(norm))) rotation->fail("a quaternion that isn't zero");
        map.rotate(quaternion.normalized());
    }
    if (const auto scale = node.find("scale")) map.scale(scale->vec3());
    return map;
}

class Walk {
public:
    Walk(const GltfDocument& document,
         const std::function<void(const JsonReader&, const AffineMap&)>& visit)
        : document_(document), visit_(visit), is_visited_(document.count("nodes")) {}

    void walk() {
        const std::size_t scenes = document_.count("scenes");
        if (const auto first = document_.json().find("scene"); first || scenes > 0) {
            const std::size_t scene = first ? document_.index(*first, "scenes") : 0;
            if (const auto nodes = document_.item("scenes", scene).find("nodes")) visit_all(*nodes);
            return;
        }
        std::vector<bool> is_child(document_.count("nodes"));
        for (std::size_t i = 0; i < is_child.size(); ++i) {
            if (const auto children = document_.item("nodes", i).find("children")) {
                for (const JsonReader& child : children->array())
                    is_child[document_.index(child, "nodes")] = true;
            }
        }
        for (std::size_t i = 0; i < is_child.size(); ++i) {
            if (!is_child[i]) visit_from(i, document_.item("nodes", i), AffineMap::Identity());
        }
    }

private:
    void visit_all(const JsonReader& nodes) {
        for (const JsonReader& value : nodes.array())
            visit_from(document_.index(value, "nodes"), value, AffineMap::Identity());
    }

    struct Step {
        std::size_t node;
        JsonReader named;  ///< where the file names it
        AffineMap to_world;
        std::uint64_t depth;
    };

    void visit_from(std::size_t root, const JsonReader& named, const AffineMap& to_world) {
        std::vector<Step> steps = {{root, named, to_world, 1}};
        while (!steps.empty()) {
            const Step step = std::move(steps.back());
            steps.pop_back();
            if (is_visited_[step.node])
                step.named.fail("a node with one parent, and no circle of nodes");
            is_visited_[step.node] = true;
            if (step.depth > document_.limits().max_depth)
                step.named.fail(
                    fmt::format("at most {} nodes in one another", document_.limits().max_depth));
            const JsonReader node = document_.item("nodes", step.node);
            const AffineMap to_world_here = step.to_world * local_map(node);
            visit_(node, to_world_here);
            if (const auto children = node.find("children")) {
                std::vector<JsonReader> items = children->array();
                std::reverse(items.begin(), items.end());
                for (const JsonReader& child : items)
                    steps.push_back(
                        {document_.index(child, "nodes"), child, to_world_here, step.depth + 1});
            }
        }
    }

    const GltfDocument& document_;
    const std::function<void(const JsonReader&, const AffineMap&)>& visit_;
    std::vector<bool> is_visited_;
};

}  // namespace

void for_each_gltf_node(const GltfDocument& document,
                        const std::function<void(const JsonReader&, const AffineMap&)>& visit) {
    Walk(document, visit).walk();
}

}  // namespace boxwood
