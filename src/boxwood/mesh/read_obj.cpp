// SPDX-License-Identifier: Apache-2.0
// The file is cut into chunks of whole statements, which are read on all cores; obj_chunk.h says
// how. What they read is joined in the order of the file.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/core/huge_pages.h"
#include "boxwood/mesh/obj.h"
#include "boxwood/mesh/obj/obj_chunk.h"
#include "boxwood/mesh/text_chunks.h"

namespace boxwood {

namespace {

class ObjReader {
public:
    ObjReader(const MeshSource& source, const Limits& limits) : text_(source.bytes) {
        constexpr std::uint64_t kMostIndices = std::numeric_limits<int>::max();
        body_.name = source.name();
        body_.max_faces =
            static_cast<std::size_t>(std::min<std::uint64_t>(limits.max_faces, kMostIndices));
        max_vertices_ = std::min<std::uint64_t>(limits.max_vertices, kMostIndices);
    }

    MeshData read() {
        if (text_.empty())
            throw ParseError(body_.name, 1, "the file is empty, expected vertices and faces");
        split();
        for_each_chunk(chunks_, count_obj_chunk);
        place_chunks();
        for_each_chunk(chunks_, [this](ObjChunk& chunk) { read_obj_chunk(chunk, body_); });
        check_keywords();
        join();
        return std::move(mesh_);
    }

private:
    void split() {
        if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);  // a byte order mark
        for (const std::string_view text : split_at_lines(text_)) {
            const auto goes_on = [](std::string_view before) {
                return before.ends_with("\\\n") || before.ends_with("\\\r\n");
            };
            if (!chunks_.empty() && goes_on(chunks_.back().text)) {
                std::string_view& before = chunks_.back().text;
                before = {before.data(), before.size() + text.size()};
            } else {
                chunks_.emplace_back().text = text;
            }
        }
    }

    void place_chunks() {
        std::size_t line = 1;
        ObjCounts& all = body_.counts;
        for (ObjChunk& chunk : chunks_) {
            chunk.first_line = std::exchange(line, line + chunk.lines);
            chunk.first = all;
            all.vertices += chunk.counts.vertices;
            all.texture_coordinates += chunk.counts.texture_coordinates;
            all.normals += chunk.counts.normals;
        }
        check_count(all.vertices, "vertices");
        check_count(all.texture_coordinates, "texture coordinates");
        check_count(all.normals, "normals");
        resize_on_huge_pages(mesh_.vertices, all.vertices);
        body_.vertices = mesh_.vertices;
        resize_on_huge_pages(body_.texture_coordinates, all.texture_coordinates);
        resize_on_huge_pages(body_.normals, all.normals);
    }

    void check_count(std::size_t count, const char* what) const {
        if (count > max_vertices_)
            throw ParseError(
                body_.name, "",
                fmt::format("found {} {}, expected at most {}", count, what, max_vertices_));
    }

    /// Anything at all might be taken for statements of unknown keywords.
    void check_keywords() const {
        const ObjChunk* unknown = nullptr;
        for (const ObjChunk& chunk : chunks_) {
            if (chunk.has_known_keyword) return;
            if (!unknown && chunk.first_unknown_line > 0) unknown = &chunk;
        }
        if (unknown)
            throw ParseError(body_.name, unknown->first_unknown_line,
                             fmt::format("found {}, expected v, f or another keyword of OBJ",
                                         unknown->first_unknown_word));
    }

    void join() {
        std::size_t count = 0;
        for (ObjChunk& chunk : chunks_)
            chunk.first_face = std::exchange(count, count + chunk.faces.size());
        if (count > body_.max_faces)
            throw ParseError(
                body_.name, "",
                fmt::format("found {} faces, expected at most {}", count, body_.max_faces));
        for_each_chunk(chunks_, [this](ObjChunk& chunk) { mend(chunk); });

        resize_on_huge_pages(mesh_.faces, count);
        MeshAttributes& attributes = mesh_.attributes;
        attributes.texture_coordinates = values_of_corners(
            body_.texture_coordinates, &ObjChunk::texture_faces, "texture coordinate");
        attributes.normals = values_of_corners(body_.normals, &ObjChunk::normal_faces, "normal");
        join_faces();
        join_colors();
        attributes.groups = labels(&ObjChunk::groups);
        attributes.materials = labels(&ObjChunk::materials);
        for (const ObjChunk& chunk : chunks_) {
            for (const std::string& file : chunk.material_files) add_material_file(file);
            mesh_.warnings.append(chunk.warnings);
        }
        mesh_.warnings.append(warnings_);
    }

    void mend(ObjChunk& chunk) const {
        std::vector<std::vector<Vec3i>*> others;
        for (std::vector<Vec3i>* part : {&chunk.texture_faces, &chunk.normal_faces}) {
            if (!part->empty()) others.push_back(part);
        }
        const std::size_t unmended = mend_fans(mesh_.vertices, chunk.fans, chunk.faces, others);
        for (std::size_t i = 0; i < unmended; ++i)
            chunk.warnings.add("concave polygons of too many corners, cut into fans", body_.name,
                               "",
                               fmt::format("found a concave polygon of more than {} corners",
                                           kMostClippedCorners));
        std::vector<PolygonFan>().swap(chunk.fans);
    }

    /// The values that the indices name, one a corner; or as they are, one a vertex, where each
    /// corner's index is that of its vertex.
    template <class Value>
    MeshValues<Value> values_of_corners(std::vector<Value>& values,
                                        std::vector<Vec3i> ObjChunk::*indices, const char* what) {
        MeshValues<Value> result;
        if (values.size() == mesh_.vertices.size() && are_all(indices, &ObjChunk::faces)) {
            result.values = std::move(values);
        } else if (are_all(indices, nullptr)) {
            const std::string kind = fmt::format("{}s, none of them used, skipped", what);
            for (std::size_t i = 0; i < values.size(); ++i)
                warnings_.add_lazily(kind, body_.name, [&] {
                    return std::pair(std::string(),
                                     fmt::format("{} {} belongs to no face", what, i + 1));
                });
        } else {
            result.of = ValuesOf::corners;
            resize_on_huge_pages(result.values, 3 * mesh_.faces.size());
            for_each_chunk(chunks_, [&](ObjChunk& chunk) {
                spread(values, chunk.*indices, chunk, what, result.values);
            });
        }
        for (ObjChunk& chunk : chunks_) std::vector<Vec3i>().swap(chunk.*indices);
        return result;
    }

    /// Whether the indices are the same as others in all chunks, or empty for null.
    bool are_all(std::vector<Vec3i> ObjChunk::*indices, std::vector<Vec3i> ObjChunk::*others) {
        std::atomic<bool> are_same = true;
        for_each_chunk(chunks_, [&](const ObjChunk& chunk) {
            if (others ? chunk.*indices != chunk.*others : !(chunk.*indices).empty())
                are_same = false;
        });
        return are_same;
    }

    template <class Value>
    void spread(const std::vector<Value>& values, const std::vector<Vec3i>& indices,
                ObjChunk& chunk, const char* what, std::vector<Value>& of_corners) const {
        const std::string kind = fmt::format("faces without {}s, given zeros", what);
        Value* corner = of_corners.data() + 3 * chunk.first_face;
        for (std::size_t i = 0; i < chunk.faces.size(); ++i) {
            const Vec3i face = indices.empty() ? Vec3i::Constant(kNoIndex) : indices[i];
            for (const int index : face)
                *corner++ = index == kNoIndex ? Value(Value::Zero())
                                              : values[static_cast<std::size_t>(index)];
            if ((face.array() == kNoIndex).any())
                chunk.warnings.add_lazily(kind, body_.name, [&] {
                    return std::pair(fmt::format("face {}", chunk.first_face + i),
                                     fmt::format("found no {}, expected one a corner", what));
                });
        }
    }

    void join_faces() {
        for_each_chunk(chunks_, [this](ObjChunk& chunk) {
            std::copy(chunk.faces.begin(), chunk.faces.end(),
                      mesh_.faces.begin() + static_cast<std::ptrdiff_t>(chunk.first_face));
            std::vector<Vec3i>().swap(chunk.faces);
        });
    }

    void join_colors() {
        std::vector<VertexColor>& colors = mesh_.attributes.colors.values;
        for (const ObjChunk& chunk : chunks_) {
            if (!chunk.colors.empty()) colors.resize(mesh_.vertices.size(), kNoColor);
        }
        if (colors.empty()) return;
        for_each_chunk(chunks_, [&](ObjChunk& chunk) {
            std::copy(chunk.colors.begin(), chunk.colors.end(),
                      colors.begin() + static_cast<std::ptrdiff_t>(chunk.first.vertices));
            std::vector<VertexColor>().swap(chunk.colors);
        });
        for (std::size_t i = 0; i < colors.size(); ++i) {
            if (!colors[i].array().isNaN().all()) continue;
            colors[i] = VertexColor::Ones();
            warnings_.add_lazily("vertices without a colour, made white", body_.name, [&] {
                return std::pair(std::string(),
                                 fmt::format("vertex {}: found no colour, expected one", i + 1));
            });
        }
    }

    FaceLabels labels(std::vector<ObjLabel> ObjChunk::*part) const {
        FaceLabels result;
        bool is_empty = true;
        for (const ObjChunk& chunk : chunks_) is_empty = is_empty && (chunk.*part).empty();
        if (is_empty) return result;

        result.of_face.resize(mesh_.faces.size());
        std::unordered_map<std::string_view, std::uint32_t> numbers;
        std::string_view name;
        std::size_t face = 0;
        const auto label_up_to = [&](std::size_t end) {
            if (face == end) return;
            const auto [number, is_new] =
                numbers.emplace(name, static_cast<std::uint32_t>(numbers.size()));
            if (is_new) result.names.emplace_back(name);
            while (face < end) result.of_face[face++] = number->second;
        };
        for (const ObjChunk& chunk : chunks_) {
            for (const ObjLabel& label : chunk.*part) {
                label_up_to(chunk.first_face + label.face);
                name = label.name;
            }
        }
        label_up_to(mesh_.faces.size());
        return result;
    }

    void add_material_file(const std::string& file) {
        std::vector<std::string>& files = mesh_.attributes.material_files;
        if (material_files_.insert(file).second) files.push_back(file);
    }

    std::string_view text_;
    std::uint64_t max_vertices_;
    std::vector<ObjChunk> chunks_;
    std::unordered_set<std::string> material_files_;
    ObjBody body_;
    MeshData mesh_;
    Warnings warnings_;  ///< of the mesh as a whole
};

}  // namespace

MeshData parse_obj(const MeshSource& source, const ReadOptions& options) {
    return ObjReader(source, options.limits).read();
}

}  // namespace boxwood
