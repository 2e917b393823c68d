// SPDX-License-Identifier: Apache-2.0
// Breadth first from the lowest face of each component: a neighbour that runs through the common
// edge the same way is to be turned if the face itself isn't, and the other way round. O(n log n),
// for the sort that finds neighbours.
#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "boxwood/mesh/face_edges.h"
#include "boxwood/mesh/repair.h"
#include "boxwood/mesh/weld.h"

namespace boxwood {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// What is beyond a side of a face.
struct Neighbour {
    std::uint32_t face = kNone;
    bool runs_same_way = false;
};

std::vector<std::array<Neighbour, 3>> neighbours_of(MeshView mesh) {
    std::vector<std::array<Neighbour, 3>> neighbours(mesh.faces.size());
    const std::vector<FaceEdge> edges = sorted_face_edges(mesh, weld(mesh.vertices));
    for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
        while (last < edges.size() && edges[last].ends == edges[first].ends) ++last;
        if (last - first != 2) continue;
        const FaceEdge &a = edges[first], &b = edges[first + 1];
        const bool runs_same_way = a.is_upward == b.is_upward;
        neighbours[a.face][a.side] = {b.face, runs_same_way};
        neighbours[b.face][b.side] = {a.face, runs_same_way};
    }
    return neighbours;
}

class Orienter {
public:
    explicit Orienter(MeshView mesh)
        : mesh_(mesh),
          neighbours_(neighbours_of(mesh)),
          is_reached_(mesh.faces.size(), 0),
          is_turned_(mesh.faces.size(), 0) {}

    /// For each face whether to turn it.
    std::vector<char> faces_to_turn(RepairReport& report) {
        for (std::uint32_t face = 0; face < mesh_.faces.size(); ++face) {
            if (is_reached_[face]) continue;
            reach_component(face);
            if (!is_orientable_) ++report.unorientable_components;
            if (should_turn_all())
                for (const std::uint32_t other : component_) is_turned_[other] ^= 1;
        }
        report.flipped_faces =
            static_cast<std::size_t>(std::count(is_turned_.begin(), is_turned_.end(), 1));
        return std::move(is_turned_);
    }

private:
    void reach_component(std::uint32_t start) {
        component_ = {start};
        is_reached_[start] = 1;
        is_orientable_ = true;
        is_component_closed_ = true;
        for (std::size_t next = 0; next < component_.size(); ++next) {
            const std::uint32_t face = component_[next];
            for (const Neighbour& neighbour : neighbours_[face]) {
                if (neighbour.face == kNone) {
                    is_component_closed_ = false;
                    continue;
                }
                const char turned = is_turned_[face] ^ static_cast<char>(neighbour.runs_same_way);
                if (is_reached_[neighbour.face]) {
                    is_orientable_ &= is_turned_[neighbour.face] == turned;
                    continue;
                }
                is_reached_[neighbour.face] = 1;
                is_turned_[neighbour.face] = turned;
                component_.push_back(neighbour.face);
            }
        }
    }

    bool should_turn_all() const {
        if (is_component_closed_ && is_orientable_) return volume() < 0;
        const auto turned =
            std::count_if(component_.begin(), component_.end(),
                          [&](std::uint32_t face) { return is_turned_[face] == 1; });
        return 2 * static_cast<std::size_t>(turned) > component_.size();
    }

    double volume() const {
        const Vec3d origin = mesh_.corner(component_[0], 0);
        double sum = 0;
        for (const std::uint32_t face : component_) {
            const Vec3d a = mesh_.corner(face, 0) - origin, b = mesh_.corner(face, 1) - origin,
                        c = mesh_.corner(face, 2) - origin;
            const double part = a.dot(b.cross(c));
            sum += is_turned_[face] ? -part : part;
        }
        return sum;
    }

    MeshView mesh_;
    std::vector<std::array<Neighbour, 3>> neighbours_;
    std::vector<char> is_reached_, is_turned_;
    // Of the component that was reached last:
    std::vector<std::uint32_t> component_;
    bool is_orientable_ = true, is_component_closed_ = true;
};

template <class Values>
void turn_corners(const std::vector<char>& is_turned, ValuesOf of, Values& values) {
    if (values.empty() || of != ValuesOf::corners) return;
    for (std::size_t i = 0; i < is_turned.size(); ++i) {
        if (is_turned[i]) std::swap(values[3 * i + 1], values[3 * i + 2]);
    }
}

}  // namespace

RepairReport orient_faces(MeshData& mesh) {
    RepairReport report;
    const std::vector<char> is_turned = Orienter(mesh).faces_to_turn(report);
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        if (is_turned[i]) std::swap(mesh.faces[i][1], mesh.faces[i][2]);
    }
    MeshAttributes& attributes = mesh.attributes;
    turn_corners(is_turned, attributes.normals.of, attributes.normals.values);
    turn_corners(is_turned, attributes.texture_coordinates.of,
                 attributes.texture_coordinates.values);
    turn_corners(is_turned, attributes.colors.of, attributes.colors.values);
    for (MeshField& field : attributes.fields) turn_corners(is_turned, field.of, field.values);
    return report;
}

}  // namespace boxwood
