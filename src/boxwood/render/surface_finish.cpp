// SPDX-License-Identifier: Apache-2.0
#include "boxwood/render/surface_finish.h"

namespace boxwood {

namespace {

/// A hit's place in its mesh, to look up what the mesh knows there.
struct MeshPlace {
    const MeshData& mesh;
    const Hit& hit;

    /// Between the values of the corners, by the barycentric coordinates.
    template <class Result, class Value>
    Result between(const MeshValues<Value>& values) const {
        if (values.of == ValuesOf::faces)
            return values.values[hit.triangle].template cast<double>();
        const auto corner = [&](int k) -> Result {
            const std::size_t i = values.of == ValuesOf::vertices
                                      ? static_cast<std::size_t>(mesh.faces[hit.triangle][k])
                                      : std::size_t{3} * hit.triangle + static_cast<std::size_t>(k);
            return values.values[i].template cast<double>();
        };
        return (1 - hit.u - hit.v) * corner(0) + hit.u * corner(1) + hit.v * corner(2);
    }
};

/// Normals go by the inverse transpose, which are the cofactors but for their size. The fronts of
/// a mirrored mesh stay those that its corners' order makes, which turns with it.
Vec3d normal_in_world(const AffineMap& to_world, const Vec3d& normal) {
    const Eigen::Matrix3d m = to_world.linear();
    return normal.x() * m.col(1).cross(m.col(2)) + normal.y() * m.col(2).cross(m.col(0)) +
           normal.z() * m.col(0).cross(m.col(1));
}

Vec3d shading_normal(const MeshPlace& place, const AffineMap& to_world, const Vec3d& geometric) {
    const auto& normals = place.mesh.attributes.normals;
    if (normals.is_empty()) return geometric;
    const Vec3d normal = normal_in_world(to_world, place.between<Vec3d>(normals));
    const double length = normal.norm();
    if (!(length > 0 && std::isfinite(length))) return geometric;
    return (normal.dot(geometric) < 0 ? -1 : 1) / length * normal;
}

}  // namespace

SurfaceFinish finish_at(const World& world, const Scene& scene, const Ray& ray, const Hit& hit) {
    const MeshObject& object = world.objects[hit.instance];
    const MeshPlace place = {world.meshes[object.mesh], hit};
    const MeshAttributes& attributes = place.mesh.attributes;
    const std::size_t label =
        object.materials.size() > 1 ? attributes.materials.of_face[hit.triangle] : 0;
    const Material& material = world.materials[object.materials[label]];

    SurfaceFinish finish;
    finish.material = &material;
    finish.emission = material.emission;
    finish.normal = scene.geometric_normal(hit);
    finish.shading_normal = shading_normal(place, object.to_world, finish.normal);
    const bool is_from_behind = finish.normal.dot(ray.direction) > 0;
    if (is_from_behind && material.is_two_sided) finish.shading_normal = -finish.shading_normal;

    Eigen::Vector4d color = Eigen::Vector4d::Ones();
    if (material.uses_vertex_colors && !attributes.colors.is_empty())
        color = place.between<Eigen::Vector4d>(attributes.colors);
    if (!attributes.texture_coordinates.is_empty()) {
        const auto look_up = [&](const TextureUse& use) {
            const Vec2d uv = place.between<Vec2d>(attributes.texture_coordinates);
            return color_at(world.textures[use.texture], use.place(uv));
        };
        if (material.color_texture)
            color = color.cwiseProduct(look_up(*material.color_texture)).eval();
        if (material.emission_texture)
            finish.emission =
                finish.emission.cwiseProduct(look_up(*material.emission_texture).head<3>()).eval();
    }
    finish.color = color.head<3>();

    const double opacity = material.opacity * color[3];
    if (material.opacity_cutoff) {
        finish.opacity = opacity < *material.opacity_cutoff ? 0 : 1;
    } else {
        finish.opacity = material.blends ? opacity : material.opacity;
    }
    finish.is_seen = !(material.opacity_cutoff && finish.opacity == 0) &&
                     !(is_from_behind && material.culls_back_faces);
    return finish;
}

}  // namespace boxwood
