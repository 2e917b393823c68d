// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "boxwood/core/vec.h"
#include "boxwood/mesh/text_scanner.h"

namespace boxwood {

/// Reads lines "3 a b c" from here on, faces with corners among so many vertices, which is what
/// most lines are. Returns how many, at most as many as there is room for. For speed.
inline std::size_t read_plain_faces(TextScanner& scanner, std::size_t vertices,
                                    std::span<Vec3i> room) {
    static constexpr LinePrefix kPrefix("3 ");
    if (room.empty()) return 0;
    return scanner.plain_lines([&](PlainText& text) {
        return read_plain_triangles(text, kPrefix, 0, static_cast<std::uint32_t>(vertices),
                                    room[0].data(), room.size());
    });
}

/// The same, at most so many, behind those of a list.
inline std::size_t append_plain_faces(TextScanner& scanner, std::size_t vertices, std::size_t most,
                                      std::vector<Vec3i>& list) {
    std::array<Vec3i, 256> some;
    std::size_t count = 0, last = 0;
    do {
        const std::span<Vec3i> room(some.data(), std::min(some.size(), most - count));
        last = read_plain_faces(scanner, vertices, room);
        list.insert(list.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(last));
        count += last;
    } while (last == some.size());
    return count;
}

/// The triangles of a part of a file, right where they go in the mesh, as long as each of its faces
/// has been a plain one. With the first other one they move to a list of the part's own.
class PlacedFaces {
public:
    PlacedFaces() = default;
    /// In the places of all faces of the part.
    explicit PlacedFaces(std::span<Vec3i> places) : places_(places), is_placed_(true) {}

    /// Whether all faces of the part so far are in their places, and the list is empty.
    bool is_placed() const { return is_placed_; }
    /// How many are in their places.
    std::size_t placed() const { return placed_; }

    /// Reads plain faces, at most so many, into their places or the list; how many.
    std::size_t read(TextScanner& scanner, std::size_t vertices, std::size_t most,
                     std::vector<Vec3i>& list) {
        if (!is_placed_) return append_plain_faces(scanner, vertices, most, list);
        const std::span<Vec3i> room = places_.subspan(placed_);
        const std::size_t count =
            read_plain_faces(scanner, vertices, room.first(std::min(most, room.size())));
        placed_ += count;
        return count;
    }

    /// Before any other face is added to the list.
    void leave(std::vector<Vec3i>& list) {
        if (!std::exchange(is_placed_, false)) return;
        const std::span<Vec3i> placed = places_.first(std::exchange(placed_, 0));
        list.reserve(places_.size());
        list.assign(placed.begin(), placed.end());
    }

private:
    std::span<Vec3i> places_;
    std::size_t placed_ = 0;
    bool is_placed_ = false;
};

}  // namespace boxwood
