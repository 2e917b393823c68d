// SPDX-License-Identifier: Apache-2.0
// Where triangles that follow one another lie side by side, a builder may take four for one. Runs
// that lie apart are cut in halves, down to single triangles: one of ten thousand that spans a hall
// would cost rays more than all others. Explained in docs/algorithms/runs.md.
#include "boxwood/build/runs.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include "boxwood/core/huge_pages.h"
#include "boxwood/core/parallel.h"
#include "boxwood/core/vector_box.h"

namespace boxwood {

namespace {

constexpr std::uint32_t kLongest = 4;

/// Runs that run_length() looks at, and the share of them that may lie apart.
constexpr std::size_t kSamples = 512;
constexpr double kFewApart = 0.05;

/// Runs that a task makes.
constexpr std::size_t kPiece = 4096;

struct Measured {
    VectorBox box;
    double area;  ///< of the boxes of its triangles, halved
};

/// In double, as extents may be too large for float, and their products too small.
inline double half_area(const VectorBox& box) {
    if (!(box.lo[0] <= box.hi[0])) return 0;
    const auto extent = [&](int lane) { return double{box.hi[lane]} - double{box.lo[lane]}; };
    const double x = extent(0), y = extent(1), z = extent(3);
    return x * y + (x + y) * z;
}

/// Whether a box around both is no larger than what is inside.
inline bool lie_together(const Measured& a, const Measured& b) {
    return half_area(merged(a.box, b.box)) <= a.area + b.area;
}

inline Measured together(const Measured& a, const Measured& b) {
    return {merged(a.box, b.box), a.area + b.area};
}

inline Measured measured(const VectorBox& box) { return {box, half_area(box)}; }

inline Measured measured(MeshView mesh, std::size_t triangle) {
    return measured(triangle_vector_box(mesh, triangle));
}

}  // namespace

std::uint32_t run_length(MeshView mesh, std::uint32_t longest) {
    const std::size_t runs = mesh.faces.size() / kLongest, samples = std::min(runs, kSamples);
    std::size_t pairs_apart = 0, fours_apart = 0;
    for (std::size_t s = 0; s < samples; ++s) {
        const std::size_t first = s * runs / samples * kLongest;
        Measured pairs[2];
        bool is_apart = false;
        for (std::size_t i = 0; i < 2; ++i) {
            const Measured a = measured(mesh, first + 2 * i), b = measured(mesh, first + 2 * i + 1);
            const bool is_pair_apart = !lie_together(a, b);
            pairs_apart += is_pair_apart;
            is_apart |= is_pair_apart;
            pairs[i] = together(a, b);
        }
        fours_apart += is_apart || !lie_together(pairs[0], pairs[1]);
    }
    const auto few = [&](std::size_t apart, std::size_t count) {
        return static_cast<double>(apart) < kFewApart * static_cast<double>(count);
    };
    if (longest >= 4 && few(fours_apart, samples)) return 4;
    if (longest >= 2 && few(pairs_apart, 2 * samples)) return 2;
    return 1;
}

/// What a task makes besides one run for each place: those that are cut off.
struct TriangleRuns::Cutter {
    MeshView mesh;
    std::vector<Run> more = {};
    std::vector<Box3f> more_boxes = {};

    /// The first run of the triangles from the first one on; what is left of them goes to more.
    template <std::uint32_t kCount>
    Measured cut(std::uint32_t first, Run& run) {
        if constexpr (kCount == 1) {
            run = {first, 1};
            return measured(mesh, first);
        } else {
            constexpr std::uint32_t kHalf = kCount / 2;
            Run right_run = {};
            const Measured left = cut<kHalf>(first, run);
            const Measured right = cut<kHalf>(first + kHalf, right_run);
            if (run.count == kHalf && right_run.count == kHalf && lie_together(left, right)) {
                run.count = kCount;
                return together(left, right);
            }
            add(right_run, right.box.box());
            return left;
        }
    }

    void add(const Run& run, const Box3f& box) {
        more.push_back(run);
        more_boxes.push_back(box);
    }
};

TriangleRuns::TriangleRuns(MeshView mesh, std::uint32_t length, std::span<std::byte> memory)
    : triangles_(mesh.faces.size()) {
    if (length == 4) {
        make<4>(mesh, memory);
    } else if (length == 2) {
        make<2>(mesh, memory);
    } else {
        boxes_ = triangle_boxes(mesh, memory);
    }
}

TriangleRuns::TriangleRuns(std::span<const Box3f> boxes, std::span<const std::uint32_t> numbers,
                           std::uint32_t length)
    : triangles_(boxes.size()) {
    own_boxes_.reserve(boxes.size());
    runs_.reserve(boxes.size());
    for (std::uint32_t first = 0, last = 0; first < boxes.size(); first = last) {
        while (last < boxes.size() && numbers[last] / length == numbers[first] / length) ++last;
        add(boxes, numbers, first, last, length);
    }
    boxes_ = own_boxes_;
}

/// What lies at [first, last), all of one run in the mesh, as one run or in halves.
void TriangleRuns::add(std::span<const Box3f> boxes, std::span<const std::uint32_t> numbers,
                       std::uint32_t first, std::uint32_t last, std::uint32_t length) {
    const auto middle_of = [&](std::uint32_t begin, std::uint32_t end, std::uint32_t half) {
        std::uint32_t middle = begin;
        while (middle < end && numbers[middle] / half == numbers[begin] / half) ++middle;
        return middle;
    };
    // As Cutter: whole where the halves are, and lie together.
    const auto whole = [&](const auto& self, std::uint32_t begin, std::uint32_t end,
                           std::uint32_t size) -> std::optional<Measured> {
        if (end - begin == 1) return measured(VectorBox(boxes[begin]));
        const std::uint32_t middle = middle_of(begin, end, size / 2);
        if (middle == end) return self(self, begin, end, size / 2);
        const auto left = self(self, begin, middle, size / 2);
        const auto right = self(self, middle, end, size / 2);
        if (!left || !right || !lie_together(*left, *right)) return std::nullopt;
        return together(*left, *right);
    };
    if (const auto all = whole(whole, first, last, length)) {
        runs_.push_back({first, last - first});
        own_boxes_.push_back(all->box.box());
        return;
    }
    const std::uint32_t middle = middle_of(first, last, length / 2);
    add(boxes, numbers, first, middle, length / 2);
    if (middle < last) add(boxes, numbers, middle, last, length / 2);
}

template <std::uint32_t kLength>
void TriangleRuns::make(MeshView mesh, std::span<std::byte> memory) {
    auto* const boxes = reinterpret_cast<Box3f*>(memory.data());
    const std::size_t whole = triangles_ / kLength;
    resize_on_huge_pages(runs_, whole);
    std::vector<Cutter> cutters((whole + kPiece - 1) / kPiece, {mesh});
    parallel_for(cutters.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t c = first; c < last; ++c) {
            for (std::size_t i = c * kPiece; i < std::min(whole, (c + 1) * kPiece); ++i) {
                const auto begin = static_cast<std::uint32_t>(i * kLength);
                for (std::uint32_t j = 0; j < kLength; ++j) fetch_vertices_ahead(mesh, begin + j);
                new (boxes + i) Box3f(cutters[c].template cut<kLength>(begin, runs_[i]).box.box());
            }
        }
    });
    cutters.push_back({mesh});
    for (auto i = static_cast<std::uint32_t>(whole * kLength); i < triangles_; ++i)
        cutters.back().add({i, 1}, triangle_box(mesh, i));
    std::size_t count = whole;
    for (const Cutter& cutter : cutters) {
        runs_.insert(runs_.end(), cutter.more.begin(), cutter.more.end());
        std::uninitialized_copy(cutter.more_boxes.begin(), cutter.more_boxes.end(), boxes + count);
        count += cutter.more.size();
    }
    boxes_ = {boxes, count};
}

Tree TriangleRuns::over_triangles(Tree tree) const {
    if (runs_.empty()) return tree;
    const std::vector<std::uint32_t> order = std::exchange(tree.order, {});
    std::vector<std::uint32_t> place(order.size() + 1);
    for (std::size_t i = 0; i < order.size(); ++i) place[i + 1] = place[i] + runs_[order[i]].count;
    resize_on_huge_pages(tree.order, triangles_);
    parallel_for(order.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto [first, count] = runs_[order[i]];
            for (std::uint32_t j = 0; j < count; ++j) tree.order[place[i] + j] = first + j;
        }
    });
    parallel_for(tree.nodes.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Node& node = tree.nodes[i];
            if (!node.is_leaf()) continue;
            const std::uint32_t last = place[node.first + node.count];
            node.first = place[node.first];
            node.count = last - node.first;
        }
    });
    return tree;
}

}  // namespace boxwood
