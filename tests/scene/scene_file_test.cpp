// SPDX-License-Identifier: Apache-2.0
#include "boxwood/scene/scene_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "boxwood/core/hash.h"
#include "boxwood/mesh/generate.h"
#include "error_of.h"
#include "laws/hits.h"
#include "laws/random.h"
#include "laws/ray_families.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

namespace fs = std::filesystem;

/// A scene of three meshes, one of them empty, and five instances, saved.
class SceneFile : public testing::Test {
protected:
    SceneFile() {
        sphere_.vertices[sphere_.faces[7][0]].x() = NAN;
        sphere_.faces.push_back({1, 1, 2});
        for (int i = 0; i < 5; ++i) {
            Instance instance = {.mesh = static_cast<std::uint32_t>(i % 3)};
            instance.to_world.translate(Vec3d(2.5 * i, 0, 0))
                .rotate(Eigen::AngleAxisd(i, Vec3d(1, 2, 3).normalized()))
                .scale(Vec3d(1, 1 + 0.1 * i, -1));
            instance.visibility = 1u << i | 1;
            instances_.push_back(instance);
        }
        instances_[0].to_world.setIdentity();
        save_scene(scene(), path_);
        content_ = content_of(path_);
    }

    Scene scene() const { return {meshes(), instances_, {}}; }
    std::vector<SceneMesh> meshes() const { return {sphere_, SceneMesh(knot_, true), nothing_}; }

    std::string error_with(const std::string& content, bool trust = false) const {
        dir_.write("changed", content);
        return error_of([&] { open_scene(dir_ / "changed", {.trust = trust}); });
    }
    std::string expected(const std::string& message) const {
        return "ParseError " + (dir_ / "changed").string() + message;
    }

    template <class T>
    T field(std::size_t place) const {
        T value;
        std::memcpy(&value, content_.data() + place, sizeof(value));
        return value;
    }
    /// The file with another value in its front, and a checksum that fits.
    template <class T>
    std::string forged(std::size_t place, T value) const {
        std::string content = content_;
        std::memcpy(content.data() + place, &value, sizeof(value));
        std::uint64_t hash = 0;
        std::memcpy(content.data() + 48, &hash, sizeof(hash));
        hash = hash_of(std::as_bytes(std::span(content).first(field<std::uint64_t>(32))));
        std::memcpy(content.data() + 48, &hash, sizeof(hash));
        return content;
    }

    const TempDir dir_;
    const fs::path path_ = dir_ / "scene";
    TriangleMesh sphere_ = generate_icosphere(500), knot_ = generate_torus_knot(800), nothing_;
    std::vector<Instance> instances_;
    std::string content_;
};

TEST_F(SceneFile, opens_as_it_was_saved) {
    const Scene built = scene();
    for (const bool trust : {false, true}) {
        const Scene opened = open_scene(path_, {.trust = trust});
        ASSERT_EQ(opened.instances().size(), 5u);
        ASSERT_EQ(opened.meshes().size(), 3u);
        EXPECT_EQ(opened.report().meshes[0].not_finite, built.report().meshes[0].not_finite);
        EXPECT_FALSE(opened.report().meshes[0].not_finite.empty());
        EXPECT_EQ(
            opened.report().meshes[0].zero_area,
            (std::vector<std::uint32_t>{static_cast<std::uint32_t>(sphere_.faces.size() - 1)}));
        EXPECT_TRUE(opened.culls_back_faces(1));
        std::size_t hits = 0;
        for (std::uint64_t seed = 0; seed < 2000; ++seed) {
            Ray ray = random_ray(knot_, seed);
            ray.origin.x() += static_cast<double>(seed % 5);
            ray.visibility = static_cast<std::uint32_t>(seed % 32);
            const auto expected = built.closest_hit(ray);
            ASSERT_TRUE(are_identical(opened.closest_hit(ray), expected)) << seed;
            ASSERT_EQ(opened.count_hits(ray), built.count_hits(ray)) << seed;
            hits += expected.has_value();
            const auto near = opened.closest_point(ray.origin);
            ASSERT_EQ(near->distance, built.closest_point(ray.origin)->distance);
        }
        EXPECT_GT(hits, 300u);
    }
}

TEST_F(SceneFile, outlives_its_name_its_meshes_and_moves) {
    Scene opened = open_scene(path_);
    fs::remove(path_);
    const Scene moved = std::move(opened);
    EXPECT_TRUE(moved.any_hit({.origin = {0, 0, 5}}));
}

TEST_F(SceneFile, can_be_saved_over_while_it_is_open_and_refitted_in_memory) {
    Scene opened = open_scene(path_);
    save_scene(opened, path_);
    EXPECT_EQ(content_of(path_), content_);
    EXPECT_EQ(opened.refit().size(), 3u);
    EXPECT_TRUE(opened.any_hit({.origin = {0, 0, 5}}));
    EXPECT_EQ(content_of(path_), content_);
}

TEST_F(SceneFile, nothing_at_all_is_a_scene_too) {
    save_scene(Scene({}), path_);
    EXPECT_FALSE(open_scene(path_).any_hit({}));
}

TEST_F(SceneFile, scenes_by_brute_force_are_refused) {
    EXPECT_EQ(error_of([&] { save_scene(Scene({sphere_}, {.brute_force = true}), path_); }),
              "InvalidInput save_scene: found a scene by brute force, expected one with trees");
    EXPECT_EQ(content_of(path_), content_);
}

TEST_F(SceneFile, files_that_are_none_are_refused) {
    EXPECT_EQ(error_with(""), expected(":byte 0: found no saved scene, expected one"));
    EXPECT_EQ(error_with("OFF\n3 1 0\n"), expected(":byte 0: found no saved scene, expected one"));
    EXPECT_EQ(error_with(content_.substr(0, 20)),
              expected(": found 20 bytes, expected at least 56"));
    EXPECT_EQ(error_of([&] { open_scene(dir_ / "missing"); }).find("IoError"), 0u);
    EXPECT_EQ(error_of([&] { open_scene(dir_ / "."); }).find("IoError"), 0u);
}

TEST_F(SceneFile, other_machines_and_versions_are_refused) {
    EXPECT_EQ(error_with(forged<std::uint32_t>(8, 0x04030201)),
              expected(":byte 8: found the byte order of another kind of machine, expected this "
                       "one's"));
    EXPECT_EQ(error_with(forged<std::uint32_t>(12, 2)),
              expected(":byte 12: found version 2, expected 1; update Boxwood"));
    EXPECT_EQ(error_with(forged<std::uint32_t>(12, 0)),
              expected(":byte 12: found version 0, expected 1"));
}

TEST_F(SceneFile, truncated_files_are_refused_wherever_they_end) {
    for (const bool trust : {false, true}) {
        for (std::size_t size = 56; size < content_.size(); size += 1009)
            ASSERT_NE(error_with(content_.substr(0, size), trust), "no error") << size;
        EXPECT_NE(error_with(content_ + "x", trust), "no error");
    }
}

TEST_F(SceneFile, flipped_bits_are_found_wherever_they_are) {
    // What pads arrays to whole pages is in no checksum.
    const auto front = field<std::uint64_t>(32);
    Random random(1);
    std::size_t refused = 0, tried = 0;
    const Scene built = scene();
    for (int i = 0; i < 400; ++i) {
        std::string content = content_;
        const std::size_t place = random.index(i % 2 == 0 ? front : content.size());
        content[place] = static_cast<char>(content[place] ^ (1 << random.index(8)));
        const bool is_refused = error_with(content) != "no error";
        if (place < front) {
            ASSERT_TRUE(is_refused) << place;
            ASSERT_NE(error_with(content, true), "no error") << place;
        }
        ++tried;
        refused += is_refused;
        if (is_refused) continue;
        const Scene opened = open_scene(dir_ / "changed");
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const Ray ray = random_ray(sphere_, seed);
            ASSERT_TRUE(are_identical(opened.closest_hit(ray), built.closest_hit(ray))) << place;
        }
    }
    EXPECT_GT(refused, tried * 3 / 4);
}

/// Somebody who means harm makes checksums fit.
TEST_F(SceneFile, counts_and_places_that_lie_are_refused) {
    constexpr std::size_t kMeshes = 56, kMesh = 56, kInstances = kMeshes + 3 * kMesh;
    constexpr std::uint64_t kHuge = ~std::uint64_t{0};
    for (const std::size_t place : {16, 24, 40}) {
        for (const std::uint64_t value : {kHuge, kHuge / 2, kHuge / 56 + 2, std::uint64_t{1} << 33})
            EXPECT_EQ(error_with(forged(place, value)).find("ParseError"), 0u) << place;
    }
    for (std::size_t place = kMeshes; place < kMeshes + kMesh - 8; place += 8) {
        const auto old = field<std::uint64_t>(place);
        // A list that is longer by one may be right, for all that anybody can tell.
        const std::uint64_t more = place < kMeshes + 32 ? old + 1 : kHuge - 1;
        for (const std::uint64_t value :
             {kHuge, kHuge / 24 + 2, kHuge / 12 + 2, old + 4096, more, std::uint64_t{1} << 40}) {
            const std::string error = error_with(forged(place, value));
            EXPECT_TRUE(error.find("ParseError") == 0 || error.find("InvalidInput") == 0)
                << place << " " << value << " " << error;
        }
    }
    EXPECT_EQ(error_with(forged<std::uint32_t>(kInstances, 3)),
              expected(": instance 0: found mesh 3, expected less than 3"));
    EXPECT_EQ(error_with(forged<double>(kInstances + 8, NAN)),
              expected(": instance 0: found a transform with a number that isn't finite, expected "
                       "none"));
}

}  // namespace
}  // namespace boxwood
