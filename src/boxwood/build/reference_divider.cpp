// SPDX-License-Identifier: Apache-2.0
// What the builder of docs/algorithms/spatial_split.md does to its array of references.
#include "boxwood/build/reference_divider.h"

#include <algorithm>
#include <array>

#include "boxwood/build/clip.h"

namespace boxwood {

WideBox ReferenceDivider::centre_bounds(const ReferenceRange& range) const {
    WideBox bounds;
    for (const Reference& reference : in(range)) bounds.extend(sah_.centre(reference.box()));
    return bounds;
}

/// Moves those of which it holds to the front of [begin, end) and tells where they end: an
/// unpredictable branch would cost more than the moves.
template <class Predicate>
std::uint32_t ReferenceDivider::partition(std::uint32_t begin, std::uint32_t end,
                                          const Predicate& holds) const {
    std::uint32_t middle = begin;
    for (std::uint32_t i = begin; i < end; ++i) {
        const Reference reference = references_[i];
        references_[i] = references_[middle];
        references_[middle] = reference;
        middle += holds(reference);
    }
    return middle;
}

/// Both halves, the right one moved so that each has a share of the room that is its share of
/// the cost: where rays are expected to have the most to do, parts help the most.
ReferenceHalves ReferenceDivider::with_shared_room(ReferenceRange left, ReferenceRange right,
                                                   std::uint32_t limit) const {
    const std::uint32_t room = limit - left.begin - left.count() - right.count();
    const double left_cost = sah_.cost(left.box, left.count());
    const double both = left_cost + sah_.cost(right.box, right.count());
    const auto left_room =
        both > 0 ? static_cast<std::uint32_t>(room * (left_cost / both)) : room / 2;
    left.limit = left.end + left_room;
    const std::uint32_t begin = left.limit, end = begin + right.count();
    // Their order is free, so only those move that are in the way.
    const auto first = references_.begin();
    if (begin > right.begin)
        std::copy(first + right.begin, first + std::min(begin, right.end),
                  first + std::max(right.end, begin));
    else
        std::copy(first + std::max(end, right.begin), first + right.end, first + begin);
    right.begin = begin;
    right.end = end;
    right.limit = limit;
    return {left, right};
}

ReferenceHalves ReferenceDivider::cut_at(const ReferenceRange& range, std::uint32_t middle,
                                         const WideBox& left, const WideBox& right) const {
    return with_shared_room({range.begin, middle, 0, left}, {middle, range.end, 0, right},
                            range.limit);
}

ReferenceHalves ReferenceDivider::split_by_bin(const ReferenceRange& range, const Grid& grid,
                                               const ObjectSplit& split) const {
    const auto is_left = [&](const Reference& reference) {
        return grid.bins_of(sah_.centre(reference.box()))[split.axis] <
               static_cast<int>(split.place);
    };
    return cut_at(range, partition(range.begin, range.end, is_left), split.left, split.right);
}

ReferenceHalves ReferenceDivider::split_by_rank(const ReferenceRange& range, const Ranks& ranks,
                                                const ObjectSplit& split) const {
    std::array<Reference, kFew> sorted;
    for (std::uint32_t i = 0; i < range.count(); ++i)
        sorted[ranks[i]] = references_[range.begin + i];
    std::copy_n(sorted.begin(), range.count(), references_.begin() + range.begin);
    return cut_at(range, range.begin + split.place, split.left, split.right);
}

ReferenceHalves ReferenceDivider::halve(const ReferenceRange& range) const {
    const int axis = range.box.is_empty() ? 0 : centre_bounds(range).box().longest_axis();
    const std::uint32_t middle = range.begin + (range.count() + 1) / 2;
    std::nth_element(references_.begin() + range.begin, references_.begin() + middle,
                     references_.begin() + range.end, [&](const Reference& a, const Reference& b) {
                         const float a_place = sah_.centre(a.box())[axis];
                         const float b_place = sah_.centre(b.box())[axis];
                         return a_place != b_place ? a_place < b_place
                                                   : a.primitive() < b.primitive();
                     });
    WideBox left, right;
    for (std::uint32_t i = range.begin; i < range.end; ++i)
        (i < middle ? left : right).extend(references_[i].box());
    return cut_at(range, middle, left, right);
}

/// Gives both parts of a triangle to the side where that is cheaper than a reference on each, which
/// the paper calls unsplitting; the other part becomes empty.
void ReferenceDivider::unsplit_if_cheaper(Reference& left_part, Reference& right_part,
                                          ReferenceRange& left, ReferenceRange& right) const {
    const bool is_left = !left_part.box().is_empty(), is_right = !right_part.box().is_empty();
    if (is_left && is_right) {
        const WideBox whole = merged(left_part.box(), right_part.box());
        const WideBox wider_left = merged(left.box, whole), wider_right = merged(right.box, whole);
        const float both = sah_.cost(left.box, left.end) + sah_.cost(right.box, right.end);
        const float only_left =
            sah_.cost(wider_left, left.end) + sah_.cost(right.box, right.end - 1);
        const float only_right =
            sah_.cost(left.box, left.end - 1) + sah_.cost(wider_right, right.end);
        if (only_left < both && only_left <= only_right && right.end > 1) {
            left_part = {whole, left_part};
            right_part = {WideBox(), right_part};
            left.box = wider_left;
        } else if (only_right < both && left.end > 1) {
            right_part = {whole, right_part};
            left_part = {WideBox(), left_part};
            right.box = wider_right;
        }
    }
    if (left_part.box().is_empty()) --left.end;
    if (right_part.box().is_empty()) --right.end;
}

ReferenceHalves ReferenceDivider::split_space(const ReferenceRange& range, const Grid& space,
                                              const SpatialSplit& split) const {
    // Left of the plane, across it, right of it.
    ReferenceRange left, right;
    left.begin = range.begin;
    left.end = partition(range.begin, range.end, [&](const Reference& reference) {
        const Eigen::Array4i bins = space.bins_of(reference.box().lo);
        return space.last_bins_of(reference.box().hi, bins)[split.axis] < split.bin;
    });
    right.begin = partition(left.end, range.end, [&](const Reference& reference) {
        return space.bins_of(reference.box().lo)[split.axis] < split.bin;
    });
    right.end = range.end;
    for (std::uint32_t i = left.begin; i < left.end; ++i) left.box.extend(references_[i].box());
    for (std::uint32_t i = right.begin; i < right.end; ++i) right.box.extend(references_[i].box());

    // The left parts stay in place, the right parts wait behind the end.
    const float plane = space.face(split.axis, split.bin);
    const std::uint32_t cut = right.begin - left.end;
    WideBox left_box = left.box, right_box = right.box;
    for (std::uint32_t k = 0; k < cut; ++k) {
        const Reference whole = references_[left.end + k];
        const WideBox& box = whole.box();
        const int axis = split.axis;
        Reference& left_part = references_[left.end + k];
        Reference& right_part = references_[range.end + k];
        left_part = {clipped_box(mesh_, whole.primitive(), box, axis, box.lo[axis], plane), whole};
        right_part = {clipped_box(mesh_, whole.primitive(), box, axis, plane, box.hi[axis]), whole};
        if (left_part.box().is_empty() && right_part.box().is_empty()) left_part = whole;
        if (!left_part.box().is_empty()) left_box.extend(left_part.box());
        if (!right_part.box().is_empty()) right_box.extend(right_part.box());
    }

    // The sides as they are when all are split; each that isn't changes them for the next.
    ReferenceRange all_left = {0, left.count() + cut, 0, left_box};
    ReferenceRange all_right = {0, right.count() + cut, 0, right_box};
    std::uint32_t left_end = left.end, right_end = range.end;
    for (std::uint32_t k = 0; k < cut; ++k) {
        Reference left_part = references_[left.end + k];
        Reference right_part = references_[range.end + k];
        unsplit_if_cheaper(left_part, right_part, all_left, all_right);
        if (!left_part.box().is_empty()) {
            left.box.extend(left_part.box());
            references_[left_end++] = left_part;
        }
        if (!right_part.box().is_empty()) {
            right.box.extend(right_part.box());
            references_[right_end++] = right_part;
        }
    }
    left.end = left_end;
    right.end = right_end;
    return with_shared_room(left, right, range.limit);
}

}  // namespace boxwood
