// SPDX-License-Identifier: Apache-2.0
// The cheapest way to give each reference to one of two sides. Many are sorted into bins, see
// docs/algorithms/binned_sah.md; of few, every split is tried.
#include "boxwood/build/object_split.h"

namespace boxwood {

namespace {

struct Bin {
    WideBox box;
    std::uint32_t count = 0;
};

/// Two sweeps over a line of things: the costs of what is right of each border, then of what is
/// left. Calls box(i) and count(i) for the thing i. Neither outermost one is empty.
template <class BoxOf, class CountOf>
void try_borders(std::uint32_t things, int axis, const Sah& sah, const BoxOf& box,
                 const CountOf& count, ObjectSplit& best) {
    std::array<float, kMostBins> right_cost;
    WideBox sum;
    std::uint32_t counted = 0;
    for (std::uint32_t i = things - 1; i > 0; --i) {
        sum.extend(box(i));
        counted += count(i);
        right_cost[i] = sah.cost(sum, counted);
    }
    sum = {};
    counted = 0;
    for (std::uint32_t i = 1; i < things; ++i) {
        sum.extend(box(i - 1));
        counted += count(i - 1);
        const float cost = sah.cost(sum, counted) + right_cost[i];
        if (cost < best.cost) {
            best.cost = cost;
            best.axis = axis;
            best.place = i;
        }
    }
}

template <class BoxOf>
void sum_up_sides(std::uint32_t things, const BoxOf& box, ObjectSplit& split) {
    for (std::uint32_t i = 0; i < split.place; ++i) split.left.extend(box(i));
    for (std::uint32_t i = split.place; i < things; ++i) split.right.extend(box(i));
}

/// Counts, for each key, those that come before it: all comparisons, no branches. The last bits of
/// keys give way to their places, so that no two are equal.
Ranks rank(const std::array<float, kFew>& keys, std::uint32_t count) {
    std::array<std::int32_t, kFew> ordered, before = {};
    for (std::uint32_t i = 0; i < kFew; ++i) {
        const auto bits = same_bits_as<std::int32_t>(keys[i]);
        ordered[i] = ((bits ^ ((bits >> 31) & 0x7fffffff)) & ~(static_cast<int>(kFew) - 1)) |
                     static_cast<int>(i);
    }
    for (std::uint32_t j = 0; j < count; ++j) {
        for (std::uint32_t i = 0; i < kFew; ++i) before[i] += ordered[j] < ordered[i];
    }
    return before;
}

}  // namespace

ObjectSplit best_binned_split(std::span<const Reference> references, const Sah& sah,
                              const Grid& grid, std::uint32_t bins) {
    std::array<std::array<Bin, kMostBins>, 3> binned;
    for (const Reference& reference : references) {
        const Eigen::Array4i bin = grid.bins_of(sah.centre(reference.box()));
        for (int axis = 0; axis < 3; ++axis) {
            Bin& hit = binned[axis][bin[axis]];
            hit.box.extend(reference.box());
            ++hit.count;
        }
    }
    ObjectSplit best;
    const auto box = [&](int axis) {
        return [&line = binned[axis]](std::uint32_t i) -> const WideBox& { return line[i].box; };
    };
    for (int axis = 0; axis < 3; ++axis) {
        if (grid.is_flat(axis)) continue;
        try_borders(
            bins, axis, sah, box(axis), [&](std::uint32_t i) { return binned[axis][i].count; },
            best);
    }
    if (best.axis >= 0) sum_up_sides(bins, box(best.axis), best);
    return best;
}

ObjectSplit best_swept_split(std::span<const Reference> references, const Sah& sah, Ranks& ranks) {
    const auto count = static_cast<std::uint32_t>(references.size());
    std::array<std::array<float, kFew>, 3> keys = {};
    for (std::uint32_t i = 0; i < count; ++i) {
        const Eigen::Array4f centre = sah.centre(references[i].box());
        for (int axis = 0; axis < 3; ++axis) keys[axis][i] = centre[axis];
    }
    ObjectSplit best;
    std::array<std::array<const WideBox*, kFew>, 3> lines;
    const auto box = [&](int axis) {
        return [&line = lines[axis]](std::uint32_t i) -> const WideBox& { return *line[i]; };
    };
    for (int axis = 0; axis < 3; ++axis) {
        const Ranks of_axis = rank(keys[axis], count);
        for (std::uint32_t i = 0; i < count; ++i) lines[axis][of_axis[i]] = &references[i].box();
        try_borders(
            count, axis, sah, box(axis), [](std::uint32_t) { return 1u; }, best);
        if (best.axis == axis) ranks = of_axis;
    }
    if (best.axis >= 0) sum_up_sides(count, box(best.axis), best);
    return best;
}

}  // namespace boxwood
