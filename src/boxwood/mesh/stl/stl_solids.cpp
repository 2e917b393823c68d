// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/stl/stl_solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace boxwood {

namespace {

/// Walks from mark to mark and looks at what is between them.
class SolidReader {
public:
    SolidReader(const std::string& file, MeshData& mesh) : file_(file), mesh_(mesh) {}

    void read(std::span<const StlMark> marks) {
        for (const StlMark& mark : marks) {
            if (open_line_ == 0) warn_of_facets_outside(mark.facet);
            if (mark.is_begin) {
                begin(mark);
            } else {
                end(mark);
            }
        }
        if (open_line_ == 0) warn_of_facets_outside(mesh_.faces.size());
        if (open_line_ > 0) warn_of_no_end("the end of the file");
        if (groups_.names.size() > 1) label_facets();
    }

private:
    void begin(const StlMark& mark) {
        if (open_line_ > 0) warn_of_no_end("the next one");
        begins_.push_back(mark.facet);
        groups_.names.emplace_back(mark.name);
        open_line_ = mark.line;
    }

    void end(const StlMark& mark) {
        if (open_line_ == 0)
            mesh_.warnings.add_lazily("ends of no solid, ignored", file_, [&] {
                return std::pair(std::to_string(mark.line),
                                 std::string("found endsolid, expected solid before it"));
            });
        open_line_ = 0;
        end_line_ = mark.line;
        end_facet_ = mark.facet;
    }

    void warn_of_no_end(const char* before) {
        mesh_.warnings.add_lazily("solids without an end", file_, [&] {
            return std::pair(
                std::to_string(open_line_),
                fmt::format("the solid has no end, expected endsolid before {}", before));
        });
    }

    void warn_of_facets_outside(std::size_t end) {
        for (std::size_t i = end_facet_; i < end; ++i)
            mesh_.warnings.add_lazily("facets outside of solids", file_, [&] {
                return std::pair(
                    std::to_string(end_line_),
                    fmt::format("facet {} comes after the end of its solid, expected solid before "
                                "it",
                                i));
            });
    }

    void label_facets() {
        groups_.of_face.resize(mesh_.faces.size());
        for (std::size_t i = 0; i < begins_.size(); ++i) {
            const std::size_t end = i + 1 < begins_.size() ? begins_[i + 1] : mesh_.faces.size();
            std::fill(groups_.of_face.begin() + static_cast<std::ptrdiff_t>(begins_[i]),
                      groups_.of_face.begin() + static_cast<std::ptrdiff_t>(end),
                      static_cast<std::uint32_t>(i));
        }
        mesh_.attributes.groups = std::move(groups_);
    }

    const std::string& file_;
    MeshData& mesh_;
    FaceLabels groups_;
    std::vector<std::size_t> begins_;  ///< the first facet of each solid
    std::size_t open_line_ = 0;        ///< where the solid begins that hasn't ended; 0 for none
    std::size_t end_line_ = 0;         ///< of the last endsolid
    std::size_t end_facet_ = 0;        ///< the facets before that
};

}  // namespace

void read_stl_solids(std::span<const StlMark> marks, const std::string& file, MeshData& mesh) {
    SolidReader(file, mesh).read(marks);
}

}  // namespace boxwood
