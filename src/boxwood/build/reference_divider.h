// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "boxwood/build/object_split.h"
#include "boxwood/build/reference.h"
#include "boxwood/build/sah.h"
#include "boxwood/build/spatial_bins.h"
#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// The references [begin, end), with room up to limit for those that splits will add.
struct ReferenceRange {
    std::uint32_t begin = 0, end = 0, limit = 0;
    WideBox box;

    std::uint32_t count() const { return end - begin; }
    std::uint32_t room() const { return limit - end; }
};

struct ReferenceHalves {
    ReferenceRange left, right;
};

/// Divides ranges of references in place, each into two with a share of its room: by an object
/// split, by a plane through space, or in the middle. Tasks may divide ranges side by side that
/// have nothing in common, room included.
class ReferenceDivider {
public:
    /// Preconditions: all three live as long as this.
    ReferenceDivider(MeshView mesh, const Sah& sah, std::span<Reference> references)
        : mesh_(mesh), sah_(sah), references_(references) {}

    std::span<const Reference> in(const ReferenceRange& range) const {
        return references_.subspan(range.begin, range.count());
    }
    WideBox centre_bounds(const ReferenceRange& range) const;

    ReferenceHalves split_by_bin(const ReferenceRange& range, const Grid& grid,
                                 const ObjectSplit& split) const;
    /// Precondition: at most kFew references.
    ReferenceHalves split_by_rank(const ReferenceRange& range, const Ranks& ranks,
                                  const ObjectSplit& split) const;
    ReferenceHalves halve(const ReferenceRange& range) const;
    /// A triangle across the plane goes to both sides in two parts, but where that doesn't pay.
    /// Clipping may show that one side is empty. Precondition: room for what the plane cuts.
    ReferenceHalves split_space(const ReferenceRange& range, const Grid& space,
                                const SpatialSplit& split) const;

private:
    template <class Predicate>
    std::uint32_t partition(std::uint32_t begin, std::uint32_t end, const Predicate& holds) const;
    ReferenceHalves with_shared_room(ReferenceRange left, ReferenceRange right,
                                     std::uint32_t limit) const;
    ReferenceHalves cut_at(const ReferenceRange& range, std::uint32_t middle, const WideBox& left,
                           const WideBox& right) const;
    void unsplit_if_cheaper(Reference& left_part, Reference& right_part, ReferenceRange& left,
                            ReferenceRange& right) const;

    MeshView mesh_;
    const Sah& sah_;
    std::span<Reference> references_;
};

}  // namespace boxwood
