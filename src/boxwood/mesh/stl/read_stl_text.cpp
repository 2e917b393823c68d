// SPDX-License-Identifier: Apache-2.0
// A facet is read word by word, wherever its lines end. But no line begins with "facet" or "solid"
// that doesn't begin a facet or a solid, as names end with their line: so the text is cut there,
// and all cores read. Which solid a facet belongs to is known when all pieces are.
#include <fmt/format.h>

#include <algorithm>
#include <cfloat>
#include <string>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/core/huge_pages.h"
#include "boxwood/mesh/reader_warnings.h"
#include "boxwood/mesh/stl.h"
#include "boxwood/mesh/stl/stl_solids.h"
#include "boxwood/mesh/stl/stl_words.h"
#include "boxwood/mesh/text_chunks.h"

namespace boxwood {

namespace {

struct Chunk {
    std::string_view text;
    std::size_t first_line = 0;
    std::vector<Vec3d> corners = {};
    std::vector<StlMark> marks = {};
    Warnings warnings = {};
    std::size_t first_facet = 0;
};

/// Of a text that begins with a line. No more than the start of that line is looked at.
bool begins_facet_or_solid(std::string_view text) {
    const std::string_view start = text.substr(0, 256);
    const std::string_view word = StlWords(start.substr(0, start.find('\n')), 0).word();
    return is_keyword(word, "facet") || is_keyword(word, "solid");
}

std::vector<Chunk> split(std::string_view text) {
    std::vector<Chunk> chunks;
    while (!text.empty()) {
        std::size_t end = std::min(text.size(), kTextChunkBytes);
        while (end < text.size()) {
            const std::size_t newline = text.find('\n', end);
            end = newline == text.npos ? text.size() : newline + 1;
            if (begins_facet_or_solid(text.substr(end))) break;
        }
        chunks.push_back({.text = text.substr(0, end)});
        text.remove_prefix(end);
    }
    return chunks;
}

class StlTextReader {
public:
    StlTextReader(const MeshSource& source, const Limits& limits)
        : name_(source.name()), text_(source.bytes), limits_(limits) {
        if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    }

    MeshData read() {
        chunks_ = split(text_);
        number_lines();
        for_each_chunk(chunks_, [this](Chunk& chunk) { read_chunk(chunk); });
        for (const Chunk& chunk : chunks_) mesh_.warnings.append(chunk.warnings);
        place_facets();
        place_solids();
        join_facets();
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(const StlWords& words, const std::string& message) const {
        throw ParseError(name_, words.line(), message);
    }

    void number_lines() {
        std::vector<std::size_t> lines(chunks_.size());
        parallel_for(chunks_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) lines[i] = count_line_ends(chunks_[i].text);
        });
        std::size_t line = 1;
        for (std::size_t i = 0; i < chunks_.size(); ++i)
            chunks_[i].first_line = std::exchange(line, line + lines[i]);
    }

    void read_chunk(Chunk& chunk) const {
        StlWords words(chunk.text, chunk.first_line);
        while (true) {
            const std::string_view word = words.accept("facet") ? "facet" : words.word();
            if (word.empty()) return;
            if (is_keyword(word, "facet")) {
                read_facet(words, chunk);
            } else if (is_keyword(word, "solid") || is_keyword(word, "endsolid")) {
                const std::size_t line = words.line();
                chunk.marks.push_back({.facet = chunk.corners.size() / 3,
                                       .line = line,
                                       .is_begin = word.size() == 5,
                                       .name = words.rest_of_line()});
            } else {
                fail(words, fmt::format("found {}, expected facet, solid or endsolid",
                                        StlWords::shown(word)));
            }
        }
    }

    void read_facet(StlWords& words, Chunk& chunk) const {
        const std::size_t line = words.line();
        expect(words, "normal");
        bool has_normal = true;
        Vec3d normal = Vec3d::Zero();
        if (!words.plain_line(normal)) has_normal = read_normal(words, chunk, line, normal);
        expect(words, "outer");
        expect(words, "loop");
        read_corners(words, chunk, line, has_normal ? normal : Vec3d::Zero());
        expect(words, "endfacet");
    }

    /// Whether it's a normal at all.
    bool read_normal(StlWords& words, Chunk& chunk, std::size_t line, Vec3d& normal) const {
        bool has_normal = true;
        for (double& x : normal) {
            const std::string_view word = words.word();
            const auto number = number_of(word);
            // Some programs print what isn't finite in ways of their own: 1.#QNAN.
            if (!number && (word.empty() || is_keyword(word, "outer")))
                fail(words, fmt::format("found {}, expected three numbers of a normal",
                                        StlWords::shown(word)));
            if (!number && std::exchange(has_normal, false))
                warn(chunk, "normals that aren't numbers, ignored", line, [&] {
                    return fmt::format("found {} in a normal, expected a number",
                                       StlWords::shown(word));
                });
            x = number.value_or(0);
        }
        return has_normal;
    }

    void read_vertex(StlWords& words, Vec3d& vertex) const {
        for (double& x : vertex) {
            const std::string_view text = words.word();
            const auto number = number_of(text);
            if (!number)
                fail(words, fmt::format("found {}, expected a number", StlWords::shown(text)));
            x = *number;
        }
    }

    void read_corners(StlWords& words, Chunk& chunk, std::size_t line, const Vec3d& normal) const {
        Vec3d corners[3];
        int count = 0;
        while (true) {
            const std::string_view word = words.accept("vertex") ? "vertex" : words.word();
            if (is_keyword(word, "endloop")) break;
            if (!is_keyword(word, "vertex"))
                fail(words,
                     fmt::format("found {}, expected vertex or endloop", StlWords::shown(word)));
            if (count == 3) fail(words, "found a fourth vertex, expected three a facet");
            const std::size_t vertex_line = words.line();
            if (!words.plain_line(corners[count])) read_vertex(words, corners[count]);
            warn_of_vertex(chunk, vertex_line, corners[count]);
            ++count;
        }
        if (count < 3) {
            warn(chunk, kFewCorners, line,
                 [&] { return fmt::format("the facet has {} vertices, expected 3", count); });
            return;
        }
        chunk.corners.insert(chunk.corners.end(), corners, corners + 3);
        if (normal.dot((corners[1] - corners[0]).cross(corners[2] - corners[0])) < 0)
            warn(chunk, "normals that point to the back of their triangles, ignored", line,
                 [] { return "the facet turns clockwise as seen from where its normal points"; });
    }

    void expect(StlWords& words, std::string_view keyword) const {
        if (words.accept(keyword)) return;
        const std::string_view word = words.word();
        if (!is_keyword(word, keyword))
            fail(words, fmt::format("found {}, expected {}", StlWords::shown(word), keyword));
    }

    template <class Describe>
    void warn(Chunk& chunk, const char* kind, std::size_t line, const Describe& describe) const {
        chunk.warnings.add_lazily(kind, name_, [&] {
            return std::pair<std::string, std::string>(std::to_string(line), describe());
        });
    }

    void warn_of_vertex(Chunk& chunk, std::size_t line, const Vec3d& vertex) const {
        constexpr double kLargest = FLT_MAX;
        if (vertex.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= kLargest) return;
        const bool is_finite = vertex.allFinite();
        warn(chunk, is_finite ? kBeyondFloat : kNotFinite, line, [&] {
            return fmt::format("the vertex is ({}, {}, {}), expected {}", vertex.x(), vertex.y(),
                               vertex.z(), is_finite ? "at most 3.4e38 in size" : "finite numbers");
        });
    }

    void place_facets() {
        std::uint64_t count = 0;
        for (Chunk& chunk : chunks_)
            chunk.first_facet = std::exchange(count, count + chunk.corners.size() / 3);
        const std::uint64_t most = std::min(limits_.max_faces, limits_.max_vertices / 3);
        if (count > most)
            throw ParseError(name_, "",
                             fmt::format("found {} triangles, expected at most {}", count, most));
        resize_on_huge_pages(mesh_.faces, count);
        resize_on_huge_pages(mesh_.vertices, 3 * count);
    }

    void place_solids() {
        std::vector<StlMark> marks;
        for (const Chunk& chunk : chunks_) {
            for (StlMark mark : chunk.marks) {
                mark.facet += chunk.first_facet;
                marks.push_back(mark);
            }
        }
        read_stl_solids(marks, name_, mesh_);
    }

    void join_facets() {
        for_each_chunk(chunks_, [this](Chunk& chunk) {
            std::copy(chunk.corners.begin(), chunk.corners.end(),
                      mesh_.vertices.begin() + static_cast<std::ptrdiff_t>(3 * chunk.first_facet));
            for (std::size_t i = 0; i < chunk.corners.size() / 3; ++i) {
                const int first = static_cast<int>(3 * (chunk.first_facet + i));
                mesh_.faces[chunk.first_facet + i] = {first, first + 1, first + 2};
            }
            std::vector<Vec3d>().swap(chunk.corners);
        });
    }

    std::string name_;
    std::string_view text_;
    Limits limits_;
    std::vector<Chunk> chunks_;
    MeshData mesh_;
};

}  // namespace

MeshData parse_stl_text(const MeshSource& source, const ReadOptions& options) {
    return StlTextReader(source, options.limits).read();
}

}  // namespace boxwood
