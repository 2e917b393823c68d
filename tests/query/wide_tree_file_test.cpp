// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/wide_tree_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "boxwood/build/block_sah.h"
#include "boxwood/core/hash.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/certified_hits.h"
#include "boxwood/query/refit.h"
#include "boxwood/query/wide_fault.h"
#include "boxwood/query/wide_hits.h"
#include "cases.h"
#include "error_of.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"
#include "laws/random.h"
#include "laws/ray_families.h"
#include "rounded_to_float.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

namespace fs = std::filesystem;

WideTree tree_over(const TriangleMesh& mesh, const WideTreeOptions& options = {}) {
    const auto width = static_cast<std::uint32_t>(lanes(options.instruction_set));
    return WideTree(mesh, build_block_sah(mesh, {.block = width}), options);
}

/// A saved tree and the bytes of its file.
class WideTreeFile : public testing::Test {
protected:
    void SetUp() override {
        mesh_.vertices[mesh_.faces[100][0]].x() = NAN;
        tree_ = tree_over(mesh_);
        save_wide_tree(tree_, mesh_, path_);
        content_ = content_of(path_);
    }

    std::string error_with(const std::string& content, bool trust = false) const {
        dir_.write("changed", content);
        return error_of([&] { open_wide_tree(dir_ / "changed", mesh_, {.trust = trust}); });
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

    const TempDir dir_;
    const fs::path path_ = dir_ / "tree";
    TriangleMesh mesh_ = generate_icosphere(2000);
    WideTree tree_;
    std::string content_;
};

TEST_F(WideTreeFile, opens_as_it_was_saved) {
    for (const bool trust : {false, true}) {
        const WideTree opened = open_wide_tree(path_, mesh_, {.trust = trust});
        ASSERT_EQ(opened.bytes(), tree_.bytes());
        EXPECT_EQ(std::memcmp(opened.view().memory, tree_.view().memory, tree_.bytes()), 0);
        EXPECT_EQ(opened.bounds(), tree_.bounds());
        EXPECT_EQ(opened.scale(), tree_.scale());
        EXPECT_FALSE(opened.has_exact_corners());
        EXPECT_EQ(opened.cost(), tree_.cost());
        EXPECT_EQ(opened.instruction_set(), tree_.instruction_set());
        EXPECT_EQ(opened.view().stack_size, tree_.view().stack_size);
        EXPECT_EQ(opened.parts().left_out, tree_.parts().left_out);
        EXPECT_FALSE(opened.parts().left_out.empty());
    }
}

TEST_F(WideTreeFile, tells_whether_corners_are_exact) {
    mesh_.vertices = rounded_to_float(mesh_.vertices);
    for (const bool compact : {false, true}) {
        save_wide_tree(tree_over(mesh_, {.compact = compact}), mesh_, path_);
        for (const bool trust : {false, true}) {
            const WideTree opened = open_wide_tree(path_, mesh_, {.trust = trust});
            EXPECT_TRUE(opened.has_exact_corners());
            EXPECT_EQ(opened.is_compact(), compact);
        }
    }
}

TEST_F(WideTreeFile, corners_that_are_scaled_are_not_exact) {
    for (Vec3d& vertex : mesh_.vertices) vertex *= 0x1p60;
    save_wide_tree(tree_over(mesh_), mesh_, path_);
    std::string content = content_of(path_);
    const std::uint32_t exact = 2;
    std::memcpy(content.data() + 20, &exact, sizeof exact);
    std::memset(content.data() + 136, 0, 8);
    std::uint64_t begin = 0;
    std::memcpy(&begin, content.data() + 72, sizeof begin);
    const std::uint64_t hash = hash_of(std::as_bytes(std::span(content).first(begin)));
    std::memcpy(content.data() + 136, &hash, sizeof hash);
    for (const bool trust : {false, true})
        EXPECT_EQ(
            error_with(content, trust),
            expected(":byte 20: found corners as they are in a tree with a scale, expected none"));
}

TEST_F(WideTreeFile, outlives_its_name_and_moves) {
    WideTree opened = open_wide_tree(path_, mesh_);
    fs::remove(path_);
    const WideTree moved = std::move(opened);
    const Ray ray = {.origin = {0, 0, -3}, .direction = {0.01, 0, 1}};
    EXPECT_TRUE(closest_hit(mesh_, moved, ray));
    EXPECT_TRUE(are_identical(closest_hit(mesh_, moved, ray), closest_hit(mesh_, tree_, ray)));
}

TEST_F(WideTreeFile, can_be_saved_over_while_it_is_open) {
    const WideTree opened = open_wide_tree(path_, mesh_);
    save_wide_tree(opened, mesh_, path_);
    EXPECT_EQ(content_of(path_), content_);
    EXPECT_EQ(std::memcmp(opened.view().memory, tree_.view().memory, tree_.bytes()), 0);
}

TEST_F(WideTreeFile, is_refitted_in_memory) {
    WideTree opened = open_wide_tree(path_, mesh_);
    TriangleMesh moved = mesh_;
    for (Vec3d& vertex : moved.vertices) vertex.z() *= 2;
    EXPECT_EQ(refit(opened, moved).cost, refit(tree_, moved).cost);
    EXPECT_EQ(std::memcmp(opened.view().memory, tree_.view().memory, tree_.bytes()), 0);
    EXPECT_EQ(content_of(path_), content_);
    save_wide_tree(opened, moved, dir_ / "moved");
    EXPECT_EQ(open_wide_tree(dir_ / "moved", moved).parts().cost_at_build,
              opened.parts().cost_at_build);
}

/// Somebody who means harm makes the checksum fit.
TEST_F(WideTreeFile, bounds_that_lie_are_refused) {
    const auto forged = [&](float scale, float lo, float hi) {
        std::string content = content_;
        std::memcpy(content.data() + 28, &scale, sizeof(scale));
        for (int k = 0; k < 3; ++k) {
            std::memcpy(content.data() + 32 + 4 * k, &lo, sizeof(lo));
            std::memcpy(content.data() + 44 + 4 * k, &hi, sizeof(hi));
        }
        std::uint64_t hash = 0;
        std::memcpy(content.data() + 136, &hash, sizeof(hash));
        hash = hash_of(std::as_bytes(std::span(content).first(field<std::uint64_t>(72))));
        std::memcpy(content.data() + 136, &hash, sizeof(hash));
        return content;
    };
    for (const bool trust : {false, true})
        EXPECT_EQ(error_with(forged(1, -HUGE_VALF, HUGE_VALF), trust),
                  expected(":byte 32: found bounds that aren't finite, expected a box"));
    EXPECT_EQ(error_with(forged(1, -0.5f, 0.5f)),
              expected(": found a tree in which the root has a box outside of the bounds, expected "
                       "a sound one"));
    EXPECT_NE(error_with(forged(1, NAN, NAN)), "no error");
}

TEST_F(WideTreeFile, keeps_a_tree_in_which_nothing_is_finite_for_now) {
    TriangleMesh nothing = mesh_;
    for (Vec3d& vertex : nothing.vertices) vertex.x() = NAN;
    refit(tree_, nothing);
    save_wide_tree(tree_, nothing, path_);
    WideTree opened = open_wide_tree(path_, nothing);
    EXPECT_TRUE(opened.is_empty());
    refit(opened, mesh_);
    EXPECT_TRUE(closest_hit(mesh_, opened, {.origin = {0, 0, -3}, .direction = {0.01, 0, 1}}));
}

TEST_F(WideTreeFile, cut_anywhere_is_refused) {
    const std::size_t tree = field<std::uint64_t>(72);
    const std::size_t left_out = 144 + 4 * field<std::uint64_t>(88);
    for (const std::size_t place :
         {std::size_t{0}, std::size_t{7}, std::size_t{8}, std::size_t{12}, std::size_t{16},
          std::size_t{143}, std::size_t{144}, std::size_t{146}, left_out, left_out + 1, tree - 1,
          tree, tree + 1, tree + 512, content_.size() - 64, content_.size() - 1}) {
        for (const bool trust : {false, true}) {
            const std::string error = error_with(content_.substr(0, place), trust);
            EXPECT_EQ(error.find(expected(":")), 0u) << place << ": " << error;
        }
    }
    EXPECT_EQ(error_with(""), expected(":byte 0: found no saved tree, expected one"));
    EXPECT_EQ(error_with(content_.substr(0, 100)),
              expected(": found 100 bytes, expected at least 144"));
    const std::string bytes = std::to_string(tree_.bytes());
    const std::string fewer = std::to_string(tree_.bytes() - 1);
    EXPECT_EQ(error_with(content_.substr(0, content_.size() - 1)),
              expected(": found " + fewer + " bytes of tree, expected " + bytes));
    EXPECT_EQ(error_with(content_ + "x").find(expected(": found ")), 0u);
}

TEST_F(WideTreeFile, every_changed_byte_in_front_is_refused) {
    const std::size_t tree = field<std::uint64_t>(72);
    for (std::size_t i = 0; i < tree; i += i < 300 ? 1 : 997) {
        for (const int change : {1, 0x80, 0xff}) {
            std::string changed = content_;
            changed[i] = static_cast<char>(changed[i] ^ change);
            for (const bool trust : {false, true})
                ASSERT_NE(error_with(changed, trust), "no error") << "byte " << i;
        }
    }
}

TEST_F(WideTreeFile, changed_trees_are_refused) {
    const std::size_t tree = field<std::uint64_t>(72);
    for (std::uint64_t seed = 0; seed < cases(1000); ++seed) {
        Random random(seed);
        std::string changed = content_;
        const std::size_t place = tree + random.index(content_.size() - tree);
        changed[place] = static_cast<char>(changed[place] ^ (1 + random.index(255)));
        const std::string error = error_with(changed);
        ASSERT_EQ(error.find(expected(":byte 4096: found a tree of checksum ")), 0u)
            << "seed " << seed << ": " << error;
    }
}

TEST_F(WideTreeFile, other_kinds_of_files_are_named) {
    EXPECT_EQ(error_with("OFF\n0 0 0\n"), expected(":byte 0: found no saved tree, expected one"));
    EXPECT_EQ(error_with(std::string(100'000, '\0')),
              expected(":byte 0: found no saved tree, expected one"));
    std::string swapped = content_;
    std::reverse(swapped.begin() + 8, swapped.begin() + 12);
    EXPECT_EQ(error_with(swapped),
              expected(":byte 8: found the byte order of another kind of machine, expected this "
                       "one's"));
    std::string newer = content_;
    newer[12] = 2;
    EXPECT_EQ(error_with(newer), expected(":byte 12: found version 2, expected 1; update Boxwood"));
    EXPECT_EQ(error_of([&] { open_wide_tree(dir_ / "missing", mesh_); }),
              "IoError " + (dir_ / "missing").string() + ": No such file or directory");
    EXPECT_EQ(error_of([&] { open_wide_tree(dir_.path(), mesh_); }),
              "IoError " + dir_.path().string() + ": found a directory, expected a file");
}

TEST_F(WideTreeFile, other_meshes_are_refused) {
    const std::string start = "InvalidInput " + path_.string() + ": found a tree for ";
    TriangleMesh other = mesh_;
    other.vertices[5].y() = std::nextafter(other.vertices[5].y(), 9);
    const auto open_other = [&] { open_wide_tree(path_, other, {.trust = true}); };
    EXPECT_EQ(error_of(open_other), start + "other vertices, expected one for the mesh's");
    other = mesh_;
    std::swap(other.faces[5][0], other.faces[5][1]);
    EXPECT_EQ(error_of(open_other), start + "other faces, expected one for the mesh's");
    other = {};
    EXPECT_EQ(error_of(open_other), start + std::to_string(mesh_.vertices.size()) +
                                        " vertices and " + std::to_string(mesh_.faces.size()) +
                                        " faces, expected one for the mesh's 0 and 0");
    EXPECT_EQ(error_of([&] { save_wide_tree(tree_, other, dir_ / "other"); }),
              "InvalidInput save_wide_tree: the mesh has 0 faces, expected " +
                  std::to_string(mesh_.faces.size()));
    EXPECT_FALSE(fs::exists(dir_ / "other"));
}

/// What checksums can't find, as they are right.
TEST_F(WideTreeFile, values_that_no_tree_has_are_refused) {
    const std::size_t tree = field<std::uint64_t>(72);
    const auto error_after = [&](std::size_t place, std::uint32_t value) {
        std::string changed = content_;
        std::memcpy(changed.data() + place, &value, sizeof(value));
        const auto bytes = std::as_bytes(std::span(changed.data(), changed.size()));
        const std::uint64_t tree_hash = hash_of(bytes.subspan(tree));
        std::memcpy(changed.data() + 128, &tree_hash, sizeof(tree_hash));
        std::memset(changed.data() + 136, 0, 8);
        const std::uint64_t front_hash = hash_of(bytes.first(tree));
        std::memcpy(changed.data() + 136, &front_hash, sizeof(front_hash));
        return error_with(changed);
    };
    EXPECT_EQ(error_after(16, field<std::uint32_t>(16)), "no error");
    EXPECT_EQ(error_after(16, 32),
              "InvalidInput " + (dir_ / "changed").string() +
                  ": found 32 children a node, expected a width that this machine can walk");
    EXPECT_EQ(error_after(20, 4),
              expected(":byte 16: found values out of range, expected a tree's"));
    EXPECT_EQ(error_after(24, 5000),
              expected(":byte 16: found values out of range, expected a tree's"));
    EXPECT_EQ(error_after(24, 0).find(expected(": found a tree in which a walk needs ")), 0u);
    EXPECT_EQ(error_after(28, 0), expected(":byte 28: found scale 0, expected 1"));
    EXPECT_EQ(error_after(144, 5000),
              expected(": found a list of triangles that aren't in order, expected it to be"));
    // Widths of nodes that are taken for others.
    for (const std::uint32_t width : {4u, 8u, 16u}) {
        if (width != field<std::uint32_t>(16)) EXPECT_NE(error_after(16, width), "no error");
    }
    EXPECT_NE(error_after(20, 1), "no error");
    const std::size_t children = tree + 24 * field<std::uint32_t>(16);
    EXPECT_EQ(error_after(children, 0xffffffff).find(expected(": found a tree in which ")), 0u);
    EXPECT_EQ(error_after(children, 0).find(expected(": found a tree in which ")), 0u);
}

TEST_F(WideTreeFile, folder_that_cannot_be_written_to_is_an_io_error) {
    const fs::path folder = dir_ / "folder";
    fs::create_directory(folder);
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
    // Nothing is forbidden to root, but the system's own folders can't be written to.
    const fs::path path = geteuid() != 0 ? folder / "tree" : fs::path("/proc/self/tree");
    if (geteuid() == 0 && !fs::exists(path.parent_path())) GTEST_SKIP() << "root may write";
    EXPECT_EQ(
        error_of([&] { save_wide_tree(tree_, mesh_, path); }).find("IoError " + path.string()), 0u);
    fs::permissions(folder, fs::perms::owner_all);
}

TEST(WideTreeFiles, of_every_family_width_and_layout_answer_the_same) {
    const TempDir dir;
    for (const MeshFamily& family : mesh_families()) {
        const TriangleMesh mesh = family.make();
        for (const auto& [name, set] : instruction_sets()) {
            for (const bool compact : {false, true}) {
                if (!is_supported(set)) continue;
                SCOPED_TRACE(family.name + "/" + std::string(name) + (compact ? "/compact" : ""));
                const WideTree tree = tree_over(mesh, {.instruction_set = set, .compact = compact});
                ASSERT_EQ(find_fault(tree.parts()).value_or("none"), "none");
                save_wide_tree(tree, mesh, dir / "tree");
                const WideTree opened = open_wide_tree(dir / "tree", mesh);
                ASSERT_EQ(opened.width(), tree.width());
                for (std::uint64_t seed = 0; seed < 20; ++seed) {
                    const Ray ray = random_ray(mesh, seed);
                    ASSERT_TRUE(are_identical(closest_hit(mesh, opened, ray),
                                              closest_hit(mesh, tree, ray)));
                }
            }
        }
    }
}

/// Trees that someone changed so that checksums are right: no walk may leave them.
TEST(WideFault, what_it_lets_pass_can_be_walked) {
    const TriangleMesh mesh = generate_icosphere(600);
    int sound = 0;
    for (const auto& [name, set] : instruction_sets()) {
        if (!is_supported(set)) continue;
        for (std::uint64_t seed = 0; seed < cases(1000); ++seed) {
            SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
            Random random(seed);
            WideTreeParts parts =
                tree_over(mesh, {.instruction_set = set, .compact = seed % 2 == 1}).release();
            std::byte* memory = parts.memory.writable();
            // Nodes come first, and are what matters most.
            const std::size_t size = seed % 4 < 2 ? 2048 : parts.memory.size();
            memory[random.index(size)] ^= static_cast<std::byte>(1 + random.index(255));
            if (find_fault(parts)) continue;
            ++sound;
            const WideTree tree(std::move(parts));
            for (std::uint64_t ray = 0; ray < 10; ++ray) {
                closest_hit(mesh, tree, random_ray(mesh, ray));
                any_hit(mesh, tree, random_ray(mesh, ray));
            }
        }
    }
    EXPECT_GT(sound, cases(100));
}

TEST(WideFault, cut_trees_are_found) {
    const TriangleMesh mesh = generate_icosphere(600);
    for (const bool compact : {false, true}) {
        const WideTree tree = tree_over(mesh, {.compact = compact});
        for (std::size_t bytes = 0; bytes < tree.bytes(); bytes += kThinning * kReferenceUnit) {
            WideTreeParts parts = tree_over(mesh, {.compact = compact}).release();
            const std::byte* memory = parts.memory.data();
            const auto whole = std::make_shared<WideMemory>(std::move(parts.memory));
            parts.memory = WideMemory({memory, bytes}, whole);
            ASSERT_TRUE(find_fault(parts)) << bytes;
        }
    }
}

}  // namespace
}  // namespace boxwood
