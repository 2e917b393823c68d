// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/gltf/gltf_mesh.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/mesh/gltf/accessor.h"
#include "boxwood/mesh/warn_of_vertices.h"

namespace boxwood {

namespace {

enum Topology { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };

/// The corners of triangle i of a strip: of every second one the last two change places, so that
/// all face the same side.
Vec3i strip_triangle(const std::vector<std::uint32_t>& at, std::size_t i) {
    const bool is_odd = i % 2 == 1;
    return {static_cast<int>(at[i]), static_cast<int>(at[is_odd ? i + 2 : i + 1]),
            static_cast<int>(at[is_odd ? i + 1 : i + 2])};
}

class MeshReader {
public:
    MeshReader(const GltfDocument& document, std::size_t i)
        : document_(document), value_(document.item("meshes", i)) {}

    MeshData read() {
        MeshAttributes& all = mesh_.attributes;
        const std::size_t materials = document_.count("materials");
        for (std::size_t i = 0; i < materials; ++i) {
            const auto name = document_.item("materials", i).find("name");
            all.materials.names.push_back(name ? name->string() : fmt::format("material {}", i));
        }
        all.materials.names.emplace_back("none");
        for (const JsonReader& primitive : value_["primitives"].array()) read_primitive(primitive);
        fill_up();
        warn_of_vertices(document_.name(), mesh_);
        return std::move(mesh_);
    }

private:
    void read_primitive(const JsonReader& primitive) {
        const auto mode_value = primitive.find("mode");
        const std::uint64_t mode =
            mode_value ? mode_value->integer(0, 6) : std::uint64_t{triangles};
        const JsonReader attributes = primitive["attributes"];
        if (mode < triangles) {
            mesh_.warnings.add("primitives that aren't made of triangles, left out",
                               document_.name(), primitive.path(),
                               fmt::format("found mode {}, expected 4, 5 or 6", mode));
            return;
        }
        if (primitive.find("targets"))
            mesh_.warnings.add("morph targets, left out", document_.name(), primitive.path(),
                               "found targets, expected none");
        const auto position = attributes.find("POSITION");
        if (!position) {
            mesh_.warnings.add("primitives without positions, left out", document_.name(),
                               primitive.path(), "found no POSITION, expected one");
            return;
        }
        read_vertices(attributes, *position);
        add_faces(primitive, mode);
    }

    /// Those of the primitive, which others may have as well.
    void read_vertices(const JsonReader& attributes, const JsonReader& position) {
        std::vector<std::size_t> accessors;
        for (const char* name : {"POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0"}) {
            const auto value = attributes.find(name);
            accessors.push_back(value ? document_.index(*value, "accessors")
                                      : document_.count("accessors"));
        }
        const auto known = vertices_.find(accessors);
        if (known != vertices_.end()) {
            std::tie(first_, count_) = known->second;
            return;
        }
        const GltfNumbers positions = read_numbers(document_, position, 3, 3);
        first_ = mesh_.vertices.size();
        count_ = positions.count();
        vertices_[accessors] = {first_, count_};
        if (count_ > document_.limits().max_vertices - first_)
            position.fail(
                fmt::format("at most {} vertices in all", document_.limits().max_vertices));
        const float* p = positions.values.data();
        for (std::size_t i = 0; i < count_; ++i, p += 3)
            mesh_.vertices.emplace_back(p[0], p[1], p[2]);
        if (const auto value = attributes.find("NORMAL")) {
            const GltfNumbers normals = expected(*value, 3, 3);
            fill(mesh_.attributes.normals, first_, Vec3f(0, 0, 0));
            for (std::size_t i = 0; i < count_; ++i) {
                const float* n = normals.values.data() + 3 * i;
                mesh_.attributes.normals.values.emplace_back(n[0], n[1], n[2]);
            }
        }
        if (const auto value = attributes.find("TEXCOORD_0")) {
            const GltfNumbers uv = expected(*value, 2, 2);
            fill(mesh_.attributes.texture_coordinates, first_, Vec2f(0, 0));
            // glTF counts v downwards from the upper left corner.
            for (std::size_t i = 0; i < count_; ++i)
                mesh_.attributes.texture_coordinates.values.emplace_back(uv.values[2 * i],
                                                                         1 - uv.values[2 * i + 1]);
        }
        if (const auto value = attributes.find("COLOR_0")) {
            const GltfNumbers colors = expected(*value, 3, 4);
            fill(mesh_.attributes.colors, first_, kWhite);
            for (std::size_t i = 0; i < count_; ++i) {
                const float* c = colors.values.data() + colors.components * i;
                mesh_.attributes.colors.values.emplace_back(c[0], c[1], c[2],
                                                            colors.components == 4 ? c[3] : 1);
            }
        }
    }

    void add_faces(const JsonReader& primitive, std::uint64_t mode) {
        std::vector<std::uint32_t> at;
        if (const auto indices = primitive.find("indices")) {
            at = read_indices(document_, *indices, count_);
        } else {
            at.resize(count_);
            std::iota(at.begin(), at.end(), std::uint32_t{0});
        }
        const std::size_t faces = mode == triangles ? at.size() / 3
                                  : at.size() < 3   ? 0
                                                    : at.size() - 2;
        if (faces > document_.limits().max_faces - mesh_.faces.size())
            primitive.fail(fmt::format("at most {} faces in all", document_.limits().max_faces));
        if (mode == triangles && at.size() % 3 != 0)
            mesh_.warnings.add(
                "corners that make no triangle, left out", document_.name(), primitive.path(),
                fmt::format("found {} corners, expected a multiple of 3", at.size()));
        const Vec3i shift = Vec3i::Constant(static_cast<int>(first_));
        for (std::size_t i = 0; i < faces; ++i) {
            Vec3i face;
            if (mode == triangle_strip) {
                face = strip_triangle(at, i);
            } else {
                const std::size_t second = mode == triangles ? 3 * i + 1 : i + 1;
                face = {static_cast<int>(at[mode == triangles ? 3 * i : 0]),
                        static_cast<int>(at[second]), static_cast<int>(at[second + 1])};
            }
            mesh_.faces.emplace_back(face + shift);
        }

        const auto material = primitive.find("material");
        const std::size_t label =
            material ? document_.index(*material, "materials") : document_.count("materials");
        mesh_.attributes.materials.of_face.resize(mesh_.faces.size(),
                                                  static_cast<std::uint32_t>(label));
    }

    GltfNumbers expected(const JsonReader& value, std::size_t least, std::size_t most) const {
        GltfNumbers numbers = read_numbers(document_, value, least, most);
        if (numbers.count() != count_)
            value.fail(fmt::format("an accessor of {} elements, as there are positions, and not {}",
                                   count_, numbers.count()));
        return numbers;
    }

    template <class Value>
    void fill(MeshValues<Value>& values, std::size_t count, const Value& value) {
        values.values.resize(count, value);
    }

    /// Gives what the last primitives don't have to their vertices too.
    void fill_up() {
        MeshAttributes& all = mesh_.attributes;
        const std::size_t count = mesh_.vertices.size();
        if (!all.normals.is_empty()) fill(all.normals, count, Vec3f(0, 0, 0));
        if (!all.texture_coordinates.is_empty()) fill(all.texture_coordinates, count, Vec2f(0, 0));
        if (!all.colors.is_empty()) fill(all.colors, count, kWhite);
    }

    static inline const VertexColor kWhite = VertexColor::Ones();

    const GltfDocument& document_;
    JsonReader value_;
    MeshData mesh_;
    std::size_t first_ = 0, count_ = 0;  ///< vertices of the primitive at hand
    /// The same for each set of accessors that was read.
    std::map<std::vector<std::size_t>, std::pair<std::size_t, std::size_t>> vertices_;
};

}  // namespace

MeshData read_gltf_mesh(const GltfDocument& document, std::size_t i) {
    return MeshReader(document, i).read();
}

}  // namespace boxwood
