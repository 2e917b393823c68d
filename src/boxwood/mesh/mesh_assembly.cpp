// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/mesh_assembly.h"

#include <utility>

namespace boxwood {

namespace {

/// Normals go by the inverse transpose; cofactors are that, times the determinant.
MeshValues<Vec3f> moved(MeshValues<Vec3f> normals, const AffineMap& to_world) {
    const Eigen::Matrix3d m = to_world.linear();
    Eigen::Matrix3d cofactors;
    cofactors << m.col(1).cross(m.col(2)), m.col(2).cross(m.col(0)), m.col(0).cross(m.col(1));
    if (m.determinant() < 0) cofactors = -cofactors;
    for (Vec3f& n : normals.values) n = (cofactors * n.cast<double>()).normalized().cast<float>();
    return normals;
}

template <class Value>
void fill_up(MeshValues<Value>& all, std::size_t count, const Value& none) {
    if (!all.is_empty()) all.values.resize(count, none);
}

}  // namespace

bool MeshAssembly::has_room_for(const MeshData& part, const Limits& limits) const {
    return part.vertices.size() <= limits.max_vertices - mesh_.vertices.size() &&
           part.faces.size() <= limits.max_faces - mesh_.faces.size();
}

void MeshAssembly::add(const MeshData& part, const AffineMap& to_world, const std::string& name) {
    const Vec3i shift = Vec3i::Constant(static_cast<int>(mesh_.vertices.size()));
    const bool is_moved = to_world.matrix() != AffineMap::Identity().matrix();
    for (const Vec3d& p : part.vertices)
        mesh_.vertices.push_back(is_moved ? Vec3d(to_world * p) : p);
    // A mirrored mesh keeps its fronts outside.
    const bool is_mirrored = to_world.linear().determinant() < 0;
    for (const Vec3i& f : part.faces)
        mesh_.faces.emplace_back((is_mirrored ? Vec3i(f[0], f[2], f[1]) : f) + shift);
    add_attributes(part.attributes, to_world, is_moved);
    FaceLabels& groups = mesh_.attributes.groups;
    groups.names.push_back(name);
    groups.of_face.resize(mesh_.faces.size(), static_cast<std::uint32_t>(groups.names.size() - 1));
}

MeshData MeshAssembly::finish() {
    MeshAttributes& all = mesh_.attributes;
    const std::size_t count = mesh_.vertices.size();
    fill_up(all.normals, count, Vec3f(0, 0, 0));
    fill_up(all.texture_coordinates, count, Vec2f(0, 0));
    fill_up(all.colors, count, VertexColor(VertexColor::Ones()));
    if (all.groups.names.size() < 2) all.groups = {};
    if (all.materials.names.size() < 2) all.materials = {};
    return std::move(mesh_);
}

void MeshAssembly::add_attributes(const MeshAttributes& part, const AffineMap& to_world,
                                  bool is_moved) {
    MeshAttributes& all = mesh_.attributes;
    append(all.normals, is_moved ? moved(part.normals, to_world) : part.normals, Vec3f(0, 0, 0));
    append(all.texture_coordinates, part.texture_coordinates, Vec2f(0, 0));
    append(all.colors, part.colors, VertexColor(VertexColor::Ones()));
    all.materials.names = part.materials.names;
    all.materials.of_face.insert(all.materials.of_face.end(), part.materials.of_face.begin(),
                                 part.materials.of_face.end());
    vertices_ = mesh_.vertices.size();
}

/// Vertices before that have no such values get the one for none.
template <class Value>
void MeshAssembly::append(MeshValues<Value>& all, const MeshValues<Value>& part,
                          const Value& none) {
    if (part.is_empty()) return;
    all.values.resize(vertices_, none);
    all.values.insert(all.values.end(), part.values.begin(), part.values.end());
}

}  // namespace boxwood
