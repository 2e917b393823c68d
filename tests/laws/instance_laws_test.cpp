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
#include "boxwood/scene/scene_sign.h"
#include "cases.h"
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

const std::vector<std::string> kFamilies = {"soup",         "cube",
                                            "needles",      "icosphere",
                                            "grid",         "with_bad_vertices",
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
    for (std::uint64_t seed = 0; seed < cases(240); ++seed) {
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
    EXPECT_GT(hits, cases(2000u));
}

TEST(InstanceLaws, many_instances_under_every_accelerator) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const Placed many = some_instances(24, 1000 + seed);
        for (const NamedAccelerator& accelerator : all_accelerators()) {
            const Scene scene(scene_meshes(many.meshes), many.instances, accelerator.options);
            for (std::uint64_t k = 0; k < cases(60); ++k) {
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
    for (std::uint64_t seed = 0; seed < cases(60); ++seed) {
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

/// About the instances, on them, and far from them.
Vec3d random_point(const Placed& placed, Random& random) {
    const TriangleMesh& mesh = placed.flat[random.index(placed.flat.size())];
    if (mesh.vertices.empty()) return random.point(-2, 2);
    const Vec3d vertex = mesh.vertices[random.index(mesh.vertices.size())];
    switch (random.index(4)) {
        case 0:
            return vertex;
        case 1:
            return random.point(-1e3, 1e3);
        default:
            return vertex + random.number() * random.point(-1, 1);
    }
}

TEST(InstanceLaws, closest_points_are_those_of_the_moved_meshes_to_the_last_bit) {
    std::size_t found_any = 0;
    for (std::uint64_t seed = 0; seed < cases(160); ++seed) {
        const Placed several = some_instances(1 + seed % 5, seed);
        const Scene scene(scene_meshes(several.meshes), several.instances, {});
        const Scene brute(scene_meshes(several.meshes), several.instances, {.brute_force = true});
        Random random(seed);
        std::vector<Vec3d> points;
        std::vector<ClosestPoint> expected;
        const double radius = random.index(3) == 0 ? random.number() : HUGE_VAL;
        for (int k = 0; k < 60; ++k) {
            points.push_back(random_point(several, random));
            ClosestPoint best;
            for (std::uint32_t i = 0; i < several.flat.size(); ++i) {
                auto each =
                    closest_point_brute_force(MeshView(several.flat[i]), points.back(), radius);
                if (!each) continue;
                each->instance = i;
                if (!best.is_found() || is_closer(*each, best)) best = *each;
            }
            expected.push_back(best);
        }
        std::vector<ClosestPoint> batch(points.size());
        scene.closest_points(points, batch, radius);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const ClosestPoint one =
                scene.closest_point(points[k], radius).value_or(ClosestPoint{});
            const ClosestPoint by_force =
                brute.closest_point(points[k], radius).value_or(ClosestPoint{});
            for (const ClosestPoint& found : {one, batch[k], by_force}) {
                ASSERT_EQ(found.triangle, expected[k].triangle) << "seed " << seed << " " << k;
                ASSERT_EQ(found.instance, expected[k].instance) << "seed " << seed << " " << k;
                ASSERT_TRUE(same_bits(found.distance, expected[k].distance));
                ASSERT_TRUE(same_bits(found.u, expected[k].u));
                ASSERT_EQ(found.point, expected[k].point);
            }
            found_any += one.is_found();
        }
    }
    EXPECT_GT(found_any, cases(5000u));
}

/// What of the moved meshes the test says yes to.
template <class Test>
std::vector<TriangleId> all_touching(const Placed& placed, const Test& test) {
    std::vector<TriangleId> found;
    for (std::uint32_t i = 0; i < placed.flat.size(); ++i)
        for (const std::uint32_t triangle : test(placed.flat[i])) found.push_back({i, triangle});
    return found;
}

TEST(InstanceLaws, overlaps_are_those_of_the_moved_meshes) {
    std::size_t touching = 0;
    for (std::uint64_t seed = 0; seed < cases(160); ++seed) {
        const Placed several = some_instances(1 + seed % 5, seed);
        const Scene scene(scene_meshes(several.meshes), several.instances, {});
        Random random(seed);
        std::vector<Box3d> boxes;
        std::vector<Sphere3d> spheres;
        for (int k = 0; k < 20; ++k) {
            const Vec3d point = random_point(several, random);
            const double size = std::pow(10.0, random.number(-4, 2));
            Box3d box;
            box.extend(point).extend(point + size * random.point(0, 1));
            const Sphere3d sphere = {point, size};
            const auto in_box = all_touching(
                several, [&](MeshView mesh) { return box_overlap_brute_force(mesh, box); });
            const auto in_sphere = all_touching(
                several, [&](MeshView mesh) { return sphere_overlap_brute_force(mesh, sphere); });
            ASSERT_EQ(scene.box_overlap(box), in_box) << "seed " << seed << " " << k;
            ASSERT_EQ(scene.sphere_overlap(sphere), in_sphere) << "seed " << seed << " " << k;
            const TriangleCorners corners = {point, random_point(several, random),
                                             random_point(several, random)};
            bool touches = false;
            for (const TriangleMesh& mesh : several.flat)
                touches = touches || triangle_overlap_brute_force(MeshView(mesh), corners);
            ASSERT_EQ(scene.triangle_overlap(corners), touches) << "seed " << seed << " " << k;
            touching += in_box.size() + in_sphere.size() + touches;
            boxes.push_back(box);
            spheres.push_back(sphere);
        }
        const TriangleLists<TriangleId> by_box = scene.box_overlaps(boxes);
        const TriangleLists<TriangleId> by_sphere = scene.sphere_overlaps(spheres);
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            const auto box = by_box[k], sphere = by_sphere[k];
            ASSERT_EQ(std::vector(box.begin(), box.end()), scene.box_overlap(boxes[k]));
            ASSERT_EQ(std::vector(sphere.begin(), sphere.end()), scene.sphere_overlap(spheres[k]));
        }
    }
    EXPECT_GT(touching, cases(5000u));
}

/// Ellipsoids that don't touch, some of them mirrored: who is inside is known.
TEST(InstanceLaws, signs_are_right_whatever_the_transform) {
    const TriangleMesh sphere = family("icosphere");
    std::vector<Instance> instances;
    for (int i = 0; i < 8; ++i) {
        Instance instance;
        instance.to_world.translate(Vec3d(10.0 * i, 0, 0));
        if (i % 2 == 1) instance.to_world.scale(Vec3d(1, -1, 1));
        instance.to_world.rotate(Eigen::AngleAxisd(i, Vec3d(1, 2, 3).normalized()));
        if (i >= 4) instance.to_world.scale(Vec3d(1, 0.2 * i, 0.5));
        instances.push_back(instance);
    }
    for (const auto& method : sign_methods()) {
        for (const bool brute_force : {false, true}) {
            const Scene scene({sphere}, instances, {.brute_force = brute_force});
            const SceneSign sign(scene, method.value);
            EXPECT_TRUE(sign.is_trustworthy());
            Random random(3);
            std::vector<Vec3d> points;
            std::vector<bool> inside;
            while (points.size() < cases(400u)) {
                const std::size_t i = random.index(instances.size());
                const Vec3d local = random.point(-2, 2);
                // Between the sphere and what its flat faces leave of it nobody knows.
                if (local.norm() > 0.9 && local.norm() < 1.01) continue;
                points.push_back(instances[i].to_world * local);
                inside.push_back(local.norm() < 1);
            }
            std::vector<SignedDistance> results(points.size());
            sign.signed_distances(points, results);
            for (std::size_t k = 0; k < points.size(); ++k) {
                ASSERT_FALSE(results[k].is_undefined) << method.name << " " << k;
                ASSERT_EQ(results[k].distance < 0, inside[k]) << method.name << " " << k;
                const auto one = sign.signed_distance(points[k]);
                ASSERT_TRUE(one);
                ASSERT_EQ(one->distance, results[k].distance) << method.name << " " << k;
                if (method.value == SignMethod::winding_number)
                    ASSERT_NEAR(sign.winding_number(points[k]), inside[k] ? 1 : 0, 0.02) << k;
            }
        }
    }
}

}  // namespace
}  // namespace boxwood
