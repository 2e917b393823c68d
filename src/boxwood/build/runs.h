// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

/// How many triangles that follow one another in the mesh a builder may take for one primitive: 4
/// or 2, at most the longest, where nearly all lie close together, else 1. Walls and swept
/// surfaces, which are written quad by quad, are built in half the time so. Looks at places that
/// are the same each time. O(1).
std::uint32_t run_length(MeshView mesh, std::uint32_t longest);

/// Runs of up to so many triangles that follow one another: those that lie far apart are cut into
/// shorter ones, down to single triangles. The same for any number of threads. O(n), all cores.
class TriangleRuns {
public:
    /// Preconditions: length is 1, 2 or 4; memory for a box a triangle, aligned as those are, which
    /// is nobody else's as long as boxes() are looked at.
    TriangleRuns(MeshView mesh, std::uint32_t length, std::span<std::byte> memory);

    /// Runs of some triangles, or parts of them, given by their boxes and their numbers in the
    /// mesh; over_triangles() then gives places in these spans, not numbers. By the thread that
    /// calls. Preconditions: length is 1, 2 or 4; numbers ascend, none is there twice.
    TriangleRuns(std::span<const Box3f> boxes, std::span<const std::uint32_t> numbers,
                 std::uint32_t length);
    TriangleRuns(const TriangleRuns&) = delete;
    TriangleRuns& operator=(const TriangleRuns&) = delete;

    /// One for each run: of those of its triangles that have boxes.
    std::span<const Box3f> boxes() const { return boxes_; }

    /// A tree over the runs as one over the triangles. O(n).
    Tree over_triangles(Tree tree) const;

private:
    struct Run {
        std::uint32_t first, count;
    };
    struct Cutter;

    void add(std::span<const Box3f> boxes, std::span<const std::uint32_t> numbers,
             std::uint32_t first, std::uint32_t last, std::uint32_t length);
    template <std::uint32_t kLength>
    void make(MeshView mesh, std::span<std::byte> memory);

    std::size_t triangles_;
    std::vector<Box3f> own_boxes_;
    std::span<const Box3f> boxes_;
    std::vector<Run> runs_;  ///< none when each triangle is one
};

}  // namespace boxwood
