// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/obj/obj_chunk.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "boxwood/core/error.h"
#include "boxwood/mesh/obj/obj_scanner.h"
#include "boxwood/mesh/reader_warnings.h"
#include "boxwood/mesh/text_scanner.h"

namespace boxwood {

namespace {

enum class Keyword {
    vertex,
    texture_coordinate,
    normal,
    face,
    group,
    material,
    material_file,
    smoothing_group,
    point,
    line,
    curve,
    display,
    unknown
};

Keyword keyword_of(std::string_view word) {
    struct Entry {
        std::string_view word;
        Keyword keyword;
    };
    static constexpr Entry kCommon[] = {{"v", Keyword::vertex},
                                        {"f", Keyword::face},
                                        {"vt", Keyword::texture_coordinate},
                                        {"vn", Keyword::normal},
                                        {"s", Keyword::smoothing_group},
                                        {"g", Keyword::group},
                                        {"o", Keyword::group},
                                        {"usemtl", Keyword::material},
                                        {"mtllib", Keyword::material_file},
                                        {"p", Keyword::point},
                                        {"l", Keyword::line}};
    for (const Entry& entry : kCommon) {
        if (word == entry.word) return entry.keyword;
    }
    static constexpr std::string_view kCurves[] = {
        "vp",   "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim",
        "hole", "scrv",   "sp",  "end",  "con",  "bsp",  "bzp",   "cdc",  "cdp",  "res"};
    static constexpr std::string_view kDisplay[] = {"mg",    "bevel",      "c_interp",  "d_interp",
                                                    "lod",   "shadow_obj", "trace_obj", "ctech",
                                                    "stech", "usemap",     "maplib"};
    if (std::find(std::begin(kCurves), std::end(kCurves), word) != std::end(kCurves))
        return Keyword::curve;
    if (std::find(std::begin(kDisplay), std::end(kDisplay), word) != std::end(kDisplay))
        return Keyword::display;
    return Keyword::unknown;
}

/// Indices of a vertex, a texture coordinate and a normal.
struct Corner {
    int vertex = kNoIndex, texture_coordinate = kNoIndex, normal = kNoIndex;
};

class ObjChunkReader {
public:
    ObjChunkReader(ObjChunk& chunk, ObjBody& body)
        : chunk_(chunk), body_(body), scanner_(chunk.text, chunk.first_line), next_(chunk.first) {}

    void read() {
        chunk_.faces.reserve(chunk_.polygons);
        while (true) {
            while (read_vertex_lines() || read_face_lines()) chunk_.has_known_keyword = true;
            if (!scanner_.find_statement()) return;
            read_statement();
            scanner_.finish_statement();
        }
    }

private:
    /// The next lines if they are vertices and plain; whether there were any.
    bool read_vertex_lines() {
        static constexpr LinePrefix kPrefix("v ");
        const std::size_t most = chunk_.first.vertices + chunk_.counts.vertices - next_.vertices;
        if (most == 0) return false;
        double* const vertex = body_.vertices[next_.vertices].data();
        const std::size_t count = scanner_.plain_lines(
            [&](PlainText& text) { return read_plain_rows(text, kPrefix, 3, vertex, most); });
        next_.vertices += count;
        return count > 0;
    }

    /// Likewise, triangles of vertices alone, by their numbers from 1 on.
    bool read_face_lines() {
        static constexpr LinePrefix kPrefix("f ");
        std::array<Vec3i, 256> some;
        const std::size_t most = std::min(some.size(), body_.max_faces - chunk_.faces.size());
        const std::size_t count = scanner_.plain_lines([&](PlainText& text) {
            return read_plain_triangles(text, kPrefix, 1,
                                        static_cast<std::uint32_t>(body_.counts.vertices),
                                        some[0].data(), most);
        });
        for (const Vec3i& triangle : std::span(some).first(count))
            add_triangle({triangle[0]}, {triangle[1]}, {triangle[2]});
        return count > 0;
    }

    void read_statement() {
        const std::string_view word = scanner_.word();
        const Keyword keyword = keyword_of(word);
        if (keyword != Keyword::unknown) {
            chunk_.has_known_keyword = true;
        } else if (chunk_.first_unknown_line == 0) {
            chunk_.first_unknown_line = scanner_.line();
            chunk_.first_unknown_word = quoted(word);
        }
        switch (keyword) {
            case Keyword::vertex:
                return read_vertex();
            case Keyword::texture_coordinate:
                return read_texture_coordinate();
            case Keyword::normal:
                return read_normal();
            case Keyword::face:
                return read_face();
            case Keyword::group:
                return add_label(chunk_.groups);
            case Keyword::material:
                return add_label(chunk_.materials);
            case Keyword::material_file:
                return add_material_files();
            case Keyword::smoothing_group:
                return;
            case Keyword::point:
                return skip("points, skipped", word);
            case Keyword::line:
                return skip("lines, skipped", word);
            case Keyword::curve:
                return skip("statements of curves and surfaces, skipped", word);
            case Keyword::display:
                return skip("display settings, skipped", word);
            case Keyword::unknown:
                return skip("statements of unknown keywords, skipped", word);
        }
    }

    void skip(const char* kind, std::string_view word) { warn(kind, "found " + quoted(word)); }

    void warn(const char* kind, const std::string& message) {
        chunk_.warnings.add(kind, body_.name, scanner_.line(), message);
    }

    [[noreturn]] void fail(const std::string& message) const {
        throw ParseError(body_.name, scanner_.line(), message);
    }

    [[noreturn]] void fail_number() {
        const std::size_t line = scanner_.line();
        throw ParseError(body_.name, line,
                         fmt::format("found {}, expected a number", quoted(scanner_.word())));
    }

    /// The numbers that a statement must have.
    template <class Values>
    void read_numbers(Values& values, int count, const char* what, std::size_t index) {
        using Value = std::decay_t<decltype(values[0])>;
        for (int k = 0; k < count; ++k) {
            const auto number = scanner_.number<Value>();
            if (!number && scanner_.at_end_of_statement())
                fail(fmt::format("{} {} has {} coordinates, expected {}", what, index + 1, k,
                                 count));
            if (!number) fail_number();
            values[k] = *number;
        }
    }

    /// Numbers that may follow, up to as many as there is room for; how many do.
    template <std::size_t N>
    std::size_t read_more(std::array<float, N>& values) {
        std::size_t count = 0;
        for (; !scanner_.at_end_of_statement(); ++count) {
            const auto number = scanner_.number<float>();
            if (!number) fail_number();
            if (count < N) values[count] = *number;
        }
        return count;
    }

    void warn_of_more() {
        warn("numbers that mean nothing, skipped", "found more numbers than expected");
    }

    void read_vertex() {
        const std::size_t i = next_.vertices++;
        Vec3d& vertex = body_.vertices[i];
        read_numbers(vertex, 3, "vertex", i);
        if (!vertex.allFinite())
            warn(kNotFinite, fmt::format("vertex {}: found ({}, {}, {}), expected finite numbers",
                                         i + 1, vertex.x(), vertex.y(), vertex.z()));
        if (scanner_.at_end_of_statement()) return;
        std::array<float, 4> more = {0, 0, 0, 1};
        const std::size_t count = read_more(more);
        if (count == 3 || count == 4) return set_color(i, more);
        if (count != 1) return warn_of_more();
        if (more[0] != 1)
            warn("weights of vertices, skipped",
                 fmt::format("vertex {}: found weight {}, expected 1", i + 1, more[0]));
    }

    void set_color(std::size_t i, const std::array<float, 4>& color) {
        const std::size_t place = i - chunk_.first.vertices;
        if (chunk_.colors.empty()) chunk_.colors.assign(chunk_.counts.vertices, kNoColor);
        chunk_.colors[place] = VertexColor(color[0], color[1], color[2], color[3]);
        for (const float part : color) {
            if (part >= 0 && part <= 1) continue;
            return warn("colours outside of 0 to 1",
                        fmt::format("vertex {}: found {}, expected 0 to 1", i + 1, part));
        }
    }

    void read_texture_coordinate() {
        const std::size_t i = next_.texture_coordinates++;
        Vec2f& coordinate = body_.texture_coordinates[i];
        coordinate.y() = 0;  // a curve's texture has one coordinate
        read_numbers(coordinate, 1, "texture coordinate", i);
        std::array<float, 2> more = {0, 0};
        const std::size_t count = read_more(more);
        coordinate.y() = more[0];
        if (count > 2) warn_of_more();
        if (more[1] != 0)
            warn("third texture coordinates, skipped",
                 fmt::format("found {}, expected 0 or nothing", more[1]));
    }

    void read_normal() {
        const std::size_t i = next_.normals++;
        if (scanner_.plain_line(body_.normals[i].data(), 3)) return;
        read_numbers(body_.normals[i], 3, "normal", i);
        std::array<float, 1> more = {};
        if (read_more(more) > 0) warn_of_more();
    }

    void read_face() {
        Corner first, before;
        std::size_t count = 0;
        for (; !scanner_.at_end_of_statement(); ++count) {
            const Corner corner = read_corner();
            if (count == 0) first = corner;
            if (count >= 2) add_triangle(first, before, corner);
            before = corner;
        }
        if (count < 3)
            warn(kFewCorners,
                 fmt::format("found a face of {} corners, expected at least 3", count));
        if (count > 3)
            chunk_.fans.push_back(
                {chunk_.faces.size() - (count - 2), static_cast<std::uint32_t>(count)});
    }

    Corner read_corner() {
        const ObjScanner before = scanner_;
        const auto vertex = scanner_.integer();
        std::optional<std::int64_t> texture_coordinate, normal;
        if (vertex && scanner_.accept('/')) {
            texture_coordinate = scanner_.integer();
            if (scanner_.accept('/')) normal = scanner_.integer();
        }
        if (!vertex || !scanner_.at_end_of_word()) {
            scanner_ = before;
            fail(fmt::format("found {}, expected a corner: v, v/vt, v//vn or v/vt/vn",
                             quoted(ObjScanner(scanner_).word())));
        }
        Corner corner;
        corner.vertex =
            resolved(*vertex, next_.vertices, body_.counts.vertices, "vertex", "vertices");
        if (texture_coordinate)
            corner.texture_coordinate = resolved(*texture_coordinate, next_.texture_coordinates,
                                                 body_.counts.texture_coordinates,
                                                 "texture coordinate", "texture coordinates");
        if (normal)
            corner.normal =
                resolved(*normal, next_.normals, body_.counts.normals, "normal", "normals");
        return corner;
    }

    /// Positive indices count from 1 over the whole file, negative ones back from what was last
    /// defined before the face.
    int resolved(std::int64_t index, std::size_t before, std::size_t all, const char* what,
                 const char* plural) const {
        if (index > 0 && static_cast<std::uint64_t>(index) <= all)
            return static_cast<int>(index - 1);
        const auto signed_before = static_cast<std::int64_t>(before);
        if (index < 0 && index >= -signed_before) return static_cast<int>(signed_before + index);
        fail(fmt::format("found {} index {}, {}", what, index,
                         all == 0 ? fmt::format("but there are no {}", plural)
                         : before == 0
                             ? fmt::format("expected 1 to {}", all)
                             : fmt::format("expected 1 to {} or -{} to -1", all, before)));
    }

    void add_triangle(const Corner& a, const Corner& b, const Corner& c) {
        if (chunk_.faces.size() == body_.max_faces)
            fail(fmt::format("found more than {} faces, expected at most that", body_.max_faces));
        add_indices(chunk_.texture_faces,
                    {a.texture_coordinate, b.texture_coordinate, c.texture_coordinate});
        add_indices(chunk_.normal_faces, {a.normal, b.normal, c.normal});
        chunk_.faces.emplace_back(a.vertex, b.vertex, c.vertex);
    }

    void add_indices(std::vector<Vec3i>& faces, const Vec3i& indices) {
        if (faces.empty()) {
            if ((indices.array() == kNoIndex).all()) return;
            faces.reserve(chunk_.faces.capacity());
            faces.assign(chunk_.faces.size(), Vec3i::Constant(kNoIndex));
        }
        faces.push_back(indices);
    }

    void add_label(std::vector<ObjLabel>& labels) {
        // Labels that no face bears leave no trace.
        if (!labels.empty() && labels.back().face == chunk_.faces.size()) labels.pop_back();
        labels.push_back({chunk_.faces.size(), scanner_.name()});
    }

    /// Names are parted by blanks and may hold some. Where they end in .mtl, as nearly all do, it
    /// is plain which they are.
    void add_material_files() {
        const std::string names = scanner_.name();
        for (std::size_t begin = 0, end = 0; end < names.size();) {
            const std::size_t word_end = std::min(names.find_first_of(" \t", end), names.size());
            end = std::min(names.find_first_not_of(" \t", word_end), names.size());
            const std::string_view name(names.data() + begin, word_end - begin);
            if (end < names.size() && !name.ends_with(".mtl") && !name.ends_with(".MTL")) continue;
            chunk_.material_files.emplace_back(name);
            begin = end;
        }
    }

    ObjChunk& chunk_;
    ObjBody& body_;
    ObjScanner scanner_;
    ObjCounts next_;
};

}  // namespace

void count_obj_chunk(ObjChunk& chunk) {
    ObjScanner scanner(chunk.text, 0);
    for (; scanner.find_statement(); scanner.finish_statement()) {
        switch (keyword_of(scanner.word())) {
            case Keyword::vertex:
                ++chunk.counts.vertices;
                break;
            case Keyword::texture_coordinate:
                ++chunk.counts.texture_coordinates;
                break;
            case Keyword::normal:
                ++chunk.counts.normals;
                break;
            case Keyword::face:
                ++chunk.polygons;
                break;
            default:
                break;
        }
    }
    chunk.lines = scanner.line();
}

void read_obj_chunk(ObjChunk& chunk, ObjBody& body) { ObjChunkReader(chunk, body).read(); }

}  // namespace boxwood
