// SPDX-License-Identifier: Apache-2.0
#include "py_scene.h"

#include <algorithm>

#include "boxwood/build/build.h"
#include "boxwood/scene/scene_file.h"
#include "choice.h"
#include "unlocked.h"

namespace boxwood::python {

namespace {

SceneMesh mesh_of(nb::handle vertices, nb::handle faces, bool culls) {
    const auto indices = nb::cast<PackedRows<std::int32_t>>(faces);
    const std::span<const Vec3i> rows = rows_of<const Vec3i>(indices);
    PackedRows<float> single;
    if (nb::try_cast(vertices, single, false))
        return {MeshViewf{rows_of<const Vec3f>(single), rows}, culls};
    const auto precise = nb::cast<PackedRows<double>>(vertices);
    return {MeshView{rows_of<const Vec3d>(precise), rows}, culls};
}

std::vector<Instance> instances_of(const Values<std::uint32_t>& meshes,
                                   const Transforms& transforms,
                                   const Values<std::uint32_t>& visibilities) {
    const std::size_t count = meshes.shape(0);
    if (transforms.shape(0) != count || visibilities.shape(0) != count)
        throw InvalidInput("instances: expected a transform and a visibility for each mesh");
    std::vector<Instance> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        result[i].mesh = meshes(i);
        result[i].visibility = visibilities(i);
        result[i].to_world = affine_map(transforms, i);
    }
    return result;
}

}  // namespace

PyScene::PyScene(const List& vertices, const List& faces, const std::vector<bool>& culls,
                 const Values<std::uint32_t>& mesh_of_instance, const Transforms& transforms,
                 const Values<std::uint32_t>& visibilities, const std::string& preset,
                 const std::optional<std::string>& method, const std::string& cost,
                 bool brute_force) {
    if (faces.size() != vertices.size() || culls.size() != vertices.size())
        throw InvalidInput("meshes: expected vertices, faces and culling of each");
    std::vector<SceneMesh> meshes;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        meshes.push_back(mesh_of(vertices[i], faces[i], culls[i]));
        arrays_.push_back(nb::borrow(vertices[i]));
        arrays_.push_back(nb::borrow(faces[i]));
    }
    SceneOptions options = {.preset = choice("preset", build_presets(), preset),
                            .brute_force = brute_force};
    if (method)
        options.build = BuildOptions{.method = choice("method", build_methods(), *method),
                                     .cost = choice("cost", merge_costs(), cost)};
    std::vector<Instance> instances = instances_of(mesh_of_instance, transforms, visibilities);
    const Unlocked unlocked;
    scene_ = std::make_unique<Scene>(std::move(meshes), std::move(instances), options);
}

PyScene::PyScene(const std::filesystem::path& path, bool trust) {
    const Unlocked unlocked;
    scene_ = std::make_unique<Scene>(open_scene(path, {.trust = trust}));
}

void PyScene::save(const std::filesystem::path& path) const {
    const Unlocked unlocked;
    const Gate::Query query(gate);
    save_scene(*scene_, path);
}

std::vector<double> PyScene::refit() {
    const Unlocked unlocked;
    const Gate::Change change(gate);
    signs_.clear();
    std::vector<double> ratios;
    for (const RefitQuality& quality : scene_->refit()) ratios.push_back(quality.ratio());
    return ratios;
}

void PyScene::set_instances(const Values<std::uint32_t>& mesh_of_instance,
                            const Transforms& transforms,
                            const Values<std::uint32_t>& visibilities) {
    std::vector<Instance> instances = instances_of(mesh_of_instance, transforms, visibilities);
    const Unlocked unlocked;
    const Gate::Change change(gate);
    signs_.clear();
    scene_->set_instances(std::move(instances));
}

const SceneSign& PyScene::sign(const std::string& method, double accuracy) const {
    const std::lock_guard lock(signs_mutex_);
    for (const auto& kept : signs_) {
        if (kept->method == method && kept->accuracy == accuracy) return kept->sign;
    }
    const SignMethod value = choice("method", sign_methods(), method);
    signs_.push_back(std::make_unique<KeptSign>(method, accuracy,
                                                SceneSign(*scene_, value, {.accuracy = accuracy})));
    return signs_.back()->sign;
}

}  // namespace boxwood::python
