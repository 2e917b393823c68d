// SPDX-License-Identifier: Apache-2.0
// An instance answers as the mesh would whose vertices were moved there, to the last bit, whatever
// the transform, and whatever finds the hits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <string>
#include <vector>

#include "boxwood/query/brute_force.h"
#include "boxwood/scene/scene.h"
#include "laws/accelerators.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"
#include "laws/random.h"
#include "laws/ray_families.h"

namespace boxwood {
namespace {

Vec3d place(Random& random, double size) { return random.point(-size, size); }

/// Rotations, mirrors, shears, needles, and maps that are nearly flat; some far away.
Eigen::Affine3d random_transform(std::uint64_t seed) {
    Random random(seed);
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    const auto kind = random.index(6);
    if (kind == 0) return map;
    map.translate(place(random, random.index(4) == 0 ? 1e6 : 2));
    if (kind == 1) return map;
    map.rotate(Eigen::AngleAxisd(random.number(0, 6), random.direction()));
    if (kind == 2) return map;
    if (kind == 3) return map.scale(std::pow(10.0, random.number(-6, 6)));
    if (kind == 4) {
        const double thin = std::pow(10.0, random.number(-5, 0));
        return map.scale(Vec3d(1, -1, random.index(2) == 0 ? thin : 1 / thin));
    }
    Eigen::Matrix3d matrix;
    for (int k = 0; k < 3; ++k) matrix.col(k) = place(random, 1);
    map.linear() = matrix;
    return map;
}

/// The mesh as the instance is meant. What trees over the mesh have no place for has none in an
/// instance that is smaller, either.
TriangleMesh placed(TriangleMesh mesh, const Eigen::Affine3d& map) {
    const Placement placement(map);
    for (Vec3d& vertex : mesh.vertices) {
        const bool has_place = (vertex.array().abs() <= FLT_MAX).all();
        vertex = has_place ? placement.to_world(vertex) : Vec3d::Constant(std::nan(""));
    }
    return mesh;
}

const std::vector<std::string> kFamilies = {"soup",         "cube", "needles",
                                            "icosphere",    "grid", "with_bad_vertices",
                                            "one_triangle", "with_degenerate_ones"};

TriangleMesh family(const std::string& name) {
    for (const MeshFamily& each : mesh_families())
        if (each.name == name) return each.make();
    ADD_FAILURE() << "no family " << name;
    return {};
}

struct Placed {
    std::vector<TriangleMesh> meshes;
    std::vector<Instance> instances;
    std::vector<TriangleMesh> flat;  ///< one an instance
};

Placed some_instances(std::size_t count, std::uint64_t seed) {
    Placed result;
    for (const std::string& name : kFamilies) result.meshes.push_back(family(name));
    for (std::size_t i = 0; i < count; ++i) {
        Instance instance;
        instance.mesh = static_cast<std::uint32_t>((seed + i) % result.meshes.size());
        instance.to_world = random_transform(100 * seed + i);
        result.flat.push_back(placed(result.meshes[instance.mesh], instance.to_world));
        result.instances.push_back(instance);
    }
    return result;
}

std::vector<SceneMesh> scene_meshes(const std::vector<TriangleMesh>& meshes) {
    return {meshes.begin(), meshes.end()};
}

Ray asked(Ray ray, std::uint32_t instance) {
    if (ray.skip.instance != instance) ray.skip = {};
    return ray;
}

std::optional<Hit> closest_of_flat(const Placed& placed, const Ray& ray) {
    std::optional<Hit> closest;
    for (std::uint32_t i = 0; i < placed.flat.size(); ++i) {
        auto hit = closest_hit_brute_force(MeshView(placed.flat[i]), asked(ray, i));
        if (!hit) continue;
        hit->instance = i;
        if (!closest || is_closer(*hit, *closest)) closest = hit;
    }
    return closest;
}

std::vector<Hit> all_of_flat(const Placed& placed, const Ray& ray) {
    std::vector<Hit> hits;
    for (std::uint32_t i = 0; i < placed.flat.size(); ++i) {
        for (Hit hit : all_hits_brute_force(placed.flat[i], asked(ray, i))) {
            hit.instance = i;
            hits.push_back(hit);
        }
    }
    std::sort(hits.begin(), hits.end(), [](auto& a, auto& b) { return is_closer(a, b); });
    return hits;
}

void expect_all_answers(const Scene& scene, const Placed& placed, const Ray& ray,
                        const std::string& name) {
    const auto expected = closest_of_flat(placed, ray);
    const auto found = scene.closest_hit(ray);
    ASSERT_TRUE(are_identical(found, expected))
        << name << "\n"
        << testing::PrintToString(ray) << "\nfound    " << testing::PrintToString(found)
        << "\nexpected " << testing::PrintToString(expected);
    ASSERT_EQ(scene.any_hit(ray), expected.has_value()) << name;
    if (scene.counts_steps()) {
        TraversalCounts counts;
        ASSERT_TRUE(are_identical(scene.closest_hit(ray, counts), expected)) << name;
    }
    const std::vector<Hit> all = scene.all_hits(ray), all_expected = all_of_flat(placed, ray);
    ASSERT_EQ(all.size(), all_expected.size()) << name << "\n" << testing::PrintToString(ray);
    for (std::size_t i = 0; i < all.size(); ++i)
        ASSERT_TRUE(are_identical(all[i], all_expected[i])) << name << ", hit " << i;
    std::vector<Hit> first(2);
    const std::size_t count = scene.first_k_hits(ray, first);
    ASSERT_EQ(count, std::min<std::size_t>(2, all.size())) << name;
    for (std::size_t i = 0; i < count; ++i) ASSERT_TRUE(are_identical(first[i], all[i])) << name;
}

TEST(InstanceLaws, answers_are_those_of_the_moved_mesh_to_the_last_bit) {
    std::size_t hits = 0;
    for (std::uint64_t seed = 0; seed < 240; ++seed) {
        const Placed one = some_instances(1, seed);
        const Scene scene(scene_meshes(one.meshes), one.instances, {.keep_trees = true});
        const Scene brute(scene_meshes(one.meshes), one.instances, {.brute_force = true});
        for (std::uint64_t k = 0; k < 60; ++k) {
            const Ray ray = random_ray(one.flat[0], 1000 * seed + k);
            const std::string name = "seed " + std::to_string(seed) + " " + std::to_string(k);
            ASSERT_NO_FATAL_FAILURE(expect_all_answers(scene, one, ray, name));
            ASSERT_NO_FATAL_FAILURE(expect_all_answers(brute, one, ray, "brute force, " + name));
            hits += scene.any_hit(ray);
        }
    }
    EXPECT_GT(hits, 2000u);
}

TEST(InstanceLaws, many_instances_under_every_accelerator) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const Placed many = some_instances(24, 1000 + seed);
        for (const NamedAccelerator& accelerator : all_accelerators()) {
            const Scene scene(scene_meshes(many.meshes), many.instances, accelerator.options);
            for (std::uint64_t k = 0; k < 60; ++k) {
                Random random(1000 * seed + k);
                const std::size_t target = random.index(many.flat.size());
                Ray ray = random_ray(many.flat[target], 1000 * seed + k);
                ray.skip.instance = static_cast<std::uint32_t>(target);
                ASSERT_NO_FATAL_FAILURE(expect_all_answers(
                    scene, many, ray, accelerator.name + ", seed " + std::to_string(k)));
            }
        }
    }
}

/// One vertex of the sphere has the same place in all its triangles, wherever the sphere stands.
TEST(InstanceLaws, no_ray_escapes_from_a_closed_instance) {
    const TriangleMesh sphere = family("icosphere");
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const Instance instance = {.to_world = random_transform(seed)};
        const Scene scene({sphere}, {instance}, {});
        const TriangleMesh flat = placed(sphere, instance.to_world);
        const Vec3d middle = Placement(instance.to_world).to_world(Vec3d::Zero());
        for (const Vec3i& face : flat.faces) {
            const Vec3d edge = 0.5 * (flat.vertices[face[0]] + flat.vertices[face[1]]);
            for (const Vec3d& target : {flat.vertices[face[0]], edge}) {
                const Ray ray = {.origin = middle, .direction = target - middle};
                ASSERT_TRUE(scene.any_hit(ray)) << "seed " << seed;
            }
        }
    }
}

}  // namespace
}  // namespace boxwood
