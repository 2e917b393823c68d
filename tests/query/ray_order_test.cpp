// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/ray_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "boxwood/core/random.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/wide_hits.h"
#include "boxwood/scene/build_wide_tree.h"
#include "laws/columns.h"

namespace boxwood {
namespace {

/// A pinhole camera's rays, row by row; directions are off by so many steps from pixel to pixel.
std::vector<Rayf> camera_rays(int width, int height, float jitter = 0) {
    std::vector<Rayf> rays;
    std::uint64_t drawn = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto off = [&] {
                return jitter * static_cast<float>(uniform(5, drawn++, 0) - 0.5);
            };
            Rayf ray;
            ray.origin[2] = 3;
            ray.direction[0] = (static_cast<float>(x) + off()) / static_cast<float>(width) - 0.5f;
            ray.direction[1] = 0.5f - (static_cast<float>(y) + off()) / static_cast<float>(width);
            ray.direction[2] = -1.2f;
            rays.push_back(ray);
        }
    }
    return rays;
}

std::size_t row_length_of(const std::vector<Rayf>& rays) {
    return row_length(rays.size(), [&](std::size_t i) { return rays[i]; });
}

TEST(RowLength, is_the_width_of_a_cameras_picture) {
    for (const int width : {64, 97, 100, 640, 1000})
        EXPECT_EQ(row_length_of(camera_rays(width, 9000 / width + 3)),
                  static_cast<std::size_t>(width));
    EXPECT_EQ(row_length_of(camera_rays(200, 100, 1)), 200u) << "samples all over the pixels";
}

TEST(RowLength, is_found_where_the_last_row_is_cut_off) {
    std::vector<Rayf> rays = camera_rays(200, 100);
    rays.resize(rays.size() - 77);
    EXPECT_EQ(row_length_of(rays), 200u);
}

TEST(RowLength, is_none_where_rays_are_in_no_rows) {
    EXPECT_EQ(row_length_of(camera_rays(9000, 1)), 0u) << "one row";
    EXPECT_EQ(row_length_of(camera_rays(100, 20)), 0u) << "few rays";

    std::vector<Rayf> rays = camera_rays(200, 100);
    rays.erase(rays.begin() + 4050, rays.begin() + 4100);
    EXPECT_EQ(row_length_of(rays), 0u) << "a row is shorter than the others";

    rays = camera_rays(200, 100);
    rays.back().origin[0] = 1;
    EXPECT_EQ(row_length_of(rays), 0u) << "another origin";

    rays.assign(10000, Rayf{});
    EXPECT_EQ(row_length_of(rays), 0u) << "one direction";
    for (Rayf& ray : rays) ray.direction[0] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(row_length_of(rays), 0u) << "no direction";

    std::uint64_t drawn = 0;
    for (Rayf& ray : rays)
        for (float& x : ray.direction) x = static_cast<float>(2 * uniform(6, drawn++, 0) - 1);
    EXPECT_EQ(row_length_of(rays), 0u) << "random directions";

    for (Rayf& ray : rays) ray.direction[2] = -30;
    std::size_t looks = 0;
    EXPECT_EQ(row_length(rays.size(), [&](std::size_t i) { return ++looks, rays[i]; }), 0u);
    EXPECT_LT(looks, 50u) << "a narrow cone of them, which takes no time to see";
}

TEST(RayOrder, visits_each_ray_once) {
    for (const std::size_t row : {32, 63, 64, 65, 200, 5000}) {
        for (const std::size_t count : {1, 4095, 4096, 4097, 20000}) {
            const RayOrder order(count, row);
            std::vector<int> visits(count, 0);
            RayPiece<Rayf, Hitf> piece;
            for (std::size_t k = 0; k < order.pieces(); ++k) {
                piece.take(order, k, [](std::size_t) { return Rayf{}; });
                std::vector<int> taken(piece.rays.size(), 0);
                piece.for_each([&](std::size_t in_batch, std::size_t in_piece) {
                    ++visits.at(in_batch);
                    ++taken.at(in_piece);
                });
                ASSERT_EQ(std::count(taken.begin(), taken.end(), 1), taken.size());
            }
            EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), count)
                << row << " in a row, " << count << " rays";
        }
    }
}

/// Whether batches, of arrays and of columns, find what each ray alone does.
void expect_hits_of_single_rays(const WideTree& tree, const std::vector<Rayf>& rays) {
    std::vector<Hitf> hits(rays.size());
    closest_hits(tree, rays, hits);
    std::size_t found = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        Hitf alone;
        closest_hit(tree, rays[i], alone);
        found += alone.is_hit();
        ASSERT_EQ(std::memcmp(&alone, &hits[i], sizeof alone), 0) << "ray " << i;
    }
    EXPECT_GT(found, rays.size() / 10);

    Columns columns(rays);
    closest_hits(tree, columns.rays(), columns.hits());
    EXPECT_TRUE(columns.hold(hits));
}

TEST(RayOrder, leaves_no_trace_in_the_hits) {
    const TriangleMesh mesh = generate_torus_knot(5000);
    const WideTree tree = build_wide_tree(mesh);
    const std::vector<Rayf> rays = camera_rays(150, 77);
    ASSERT_EQ(row_length_of(rays), 150u);
    expect_hits_of_single_rays(tree, rays);
}

/// Several cameras, whose groups of rays don't begin where a piece or a group does.
TEST(RayOrder, many_small_cameras_are_told_apart) {
    const TriangleMesh mesh = generate_torus_knot(5000);
    const WideTree tree = build_wide_tree(mesh);
    std::vector<Rayf> rays;
    for (int camera = 0; camera < 30; ++camera) {
        for (Rayf ray : camera_rays(16, 16 + camera)) {
            ray.origin[1] += 0.01f * static_cast<float>(camera);
            rays.push_back(ray);
        }
    }
    ASSERT_EQ(row_length_of(rays), 0u);
    expect_hits_of_single_rays(tree, rays);
}

/// Too few for rows, but from one point: given once, again and again, or from the end.
TEST(RayOrder, rays_from_one_point_may_share_it) {
    const TriangleMesh mesh = generate_torus_knot(5000);
    const WideTree tree = build_wide_tree(mesh);
    const std::vector<Rayf> rays = camera_rays(100, 70);
    std::vector<Hitf> hits(rays.size());
    closest_hits(tree, rays, hits);
    Columns columns(rays);
    closest_hits(tree, columns.rays(), columns.hits());
    EXPECT_TRUE(columns.hold(hits));

    std::vector<Rayf> backward(rays.rbegin(), rays.rend());
    Columns reversed(backward);
    RayColumns from_the_end = reversed.rays();
    for (FloatColumn* column : {&from_the_end.origin, &from_the_end.direction, &from_the_end.t_min,
                                &from_the_end.t_max}) {
        column->first = (*column)[rays.size() - 1];
        column->step *= -1;
    }
    closest_hits(tree, from_the_end, columns.hits());
    EXPECT_TRUE(columns.hold(hits));

    RayColumns shared = columns.rays();
    shared.origin.step = shared.t_min.step = shared.t_max.step = 0;
    closest_hits(tree, shared, columns.hits());
    EXPECT_TRUE(columns.hold(hits));
}

}  // namespace
}  // namespace boxwood
