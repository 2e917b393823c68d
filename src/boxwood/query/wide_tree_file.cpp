// SPDX-License-Identifier: Apache-2.0
// A header, the triangles without a place, zeros up to a page's end, and the tree's memory as it
// is. Explained in docs/guide/saved_trees.md.
#include "boxwood/query/wide_tree_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/core/files.h"
#include "boxwood/core/hash.h"
#include "boxwood/query/kernels/wide_walk.h"
#include "boxwood/query/saved_file.h"
#include "boxwood/query/wide_fault.h"

namespace boxwood {

namespace fs = std::filesystem;

namespace {

/// What Header::leaves says of the leaves.
constexpr std::uint32_t kCompactLeaves = 1, kExactCorners = 2;

struct Header {
    SavedStart start = SavedStart::of('W');
    std::uint32_t width = 0;
    std::uint32_t leaves = 0;
    std::uint32_t stack_size = 0;
    float scale = 1;
    float lo[3] = {}, hi[3] = {};
    double cost = 0, cost_at_build = 0;
    std::uint64_t tree_offset = 0, tree_bytes = 0;
    std::uint64_t left_out = 0;
    std::uint64_t vertices = 0, faces = 0;
    std::uint64_t vertices_hash = 0, faces_hash = 0;
    std::uint64_t tree_hash = 0;
    std::uint64_t front_hash = 0;  ///< of all in front of the tree, with 0 here
};
static_assert(sizeof(Header) == 144);

template <class T>
std::uint64_t hash_of_all(std::span<const T> values) {
    return hash_of(std::as_bytes(values));
}

std::size_t offset_after(std::size_t left_out) {
    const std::size_t bytes = sizeof(Header) + left_out * sizeof(std::uint32_t);
    return aligned_to_page(bytes);
}

/// Reads the file's front, and throws what is wrong with it.
class Reader {
public:
    explicit Reader(const PartOfFile& part)
        : part_(part),
          header_(read_saved_header<Header>(
              part.bytes, "tree",
              [&](const auto& place, const auto& message) { fail(place, message); })) {
        check_front();
    }

    const Header& header() const { return header_; }

    std::vector<std::uint32_t> left_out() const {
        std::vector<std::uint32_t> result(header_.left_out);
        if (!result.empty())
            std::memcpy(result.data(), part_.bytes.data() + sizeof(Header),
                        result.size() * sizeof(result[0]));
        for (std::size_t i = 0; i < result.size(); ++i) {
            if (result[i] >= header_.faces || (i > 0 && result[i] <= result[i - 1]))
                fail("", "found a list of triangles that aren't in order, expected it to be");
        }
        return result;
    }

    WideMemory memory() const {
        return {part_.bytes.subspan(header_.tree_offset, header_.tree_bytes), part_.owner};
    }

    [[noreturn]] void fail(const std::string& place, const std::string& message) const {
        throw ParseError(part_.name, place, message);
    }
    [[noreturn]] void refuse(const std::string& message) const {
        throw InvalidInput(part_.name + ": " + message);
    }

private:
    void check_front() const {
        const std::size_t size = part_.bytes.size();
        if (header_.tree_offset > size || header_.tree_offset < sizeof(Header) ||
            header_.left_out > size || header_.tree_offset != offset_after(header_.left_out))
            fail("byte 72", fmt::format("found {} bytes and a tree at byte {}, expected it within",
                                        size, header_.tree_offset));
        check_front_hash(part_.bytes.first(header_.tree_offset), offsetof(Header, front_hash),
                         [&](const auto& place, const auto& message) { fail(place, message); });
        if (size - header_.tree_offset != header_.tree_bytes)
            fail("", fmt::format("found {} bytes of tree, expected {}", size - header_.tree_offset,
                                 header_.tree_bytes));
        if (header_.leaves > (kCompactLeaves | kExactCorners) || header_.stack_size > kStackSize)
            fail("byte 16", "found values out of range, expected a tree's");
    }

    const PartOfFile& part_;
    Header header_;
};

std::optional<InstructionSet> set_of_width(std::uint32_t width) {
    const InstructionSet preferred = preferred_instruction_set();
    std::optional<InstructionSet> best;
    for (const auto& [name, set] : instruction_sets()) {
        const bool fits = static_cast<std::uint32_t>(lanes(set)) == width && is_supported(set);
        if (fits && best != preferred) best = set;
    }
    return best;
}

void check_mesh(const Reader& reader, MeshView mesh, const OpenTreeOptions& options) {
    const Header& header = reader.header();
    // One that lies beside the tree is no other mesh, but what is left of its own.
    const auto refuse = [&](const std::string& message) {
        if (options.mesh_in_same_file) reader.fail("", message);
        reader.refuse(message);
    };
    if (header.faces != mesh.faces.size() || header.vertices != mesh.vertices.size())
        refuse(
            fmt::format("found a tree for {} vertices and {} faces, expected one for the "
                        "mesh's {} and {}",
                        header.vertices, header.faces, mesh.vertices.size(), mesh.faces.size()));
    if (options.trust && options.mesh_in_same_file) return;
    if (header.faces_hash != hash_of_all(mesh.faces))
        refuse("found a tree for other faces, expected one for the mesh's");
    if (header.vertices_hash != hash_of_all(mesh.vertices))
        refuse("found a tree for other vertices, expected one for the mesh's");
}

}  // namespace

std::size_t saved_bytes(const WideTree& tree) {
    return offset_after(tree.parts().left_out.size()) + tree.bytes();
}

void write_wide_tree(OutputFile& file, const WideTree& tree, MeshView mesh) {
    const WideTreeParts& parts = tree.parts();
    if (mesh.faces.size() != parts.faces)
        throw InvalidInput(fmt::format("save_wide_tree: the mesh has {} faces, expected {}",
                                       mesh.faces.size(), parts.faces));
    const std::span<const std::byte> bytes(parts.memory.data(), parts.memory.size());
    Header header;
    header.width = static_cast<std::uint32_t>(tree.width());
    header.leaves =
        (parts.is_compact ? kCompactLeaves : 0) | (parts.has_exact_corners ? kExactCorners : 0);
    header.stack_size = static_cast<std::uint32_t>(parts.stack_size);
    header.scale = parts.scale;
    for (int k = 0; k < 3; ++k) {
        header.lo[k] = parts.bounds.lo[k];
        header.hi[k] = parts.bounds.hi[k];
    }
    header.cost = parts.cost;
    header.cost_at_build = parts.cost_at_build;
    header.tree_offset = offset_after(parts.left_out.size());
    header.tree_bytes = bytes.size();
    header.left_out = parts.left_out.size();
    header.vertices = mesh.vertices.size();
    header.faces = mesh.faces.size();
    header.vertices_hash = hash_of_all(mesh.vertices);
    header.faces_hash = hash_of_all(mesh.faces);
    header.tree_hash = hash_of(bytes);

    std::vector<std::byte> front(header.tree_offset);
    std::memcpy(front.data(), &header, sizeof(header));
    if (!parts.left_out.empty())
        std::memcpy(front.data() + sizeof(header), parts.left_out.data(),
                    parts.left_out.size() * sizeof(parts.left_out[0]));
    header.front_hash = hash_of_front(front, offsetof(Header, front_hash));
    std::memcpy(front.data(), &header, sizeof(header));
    file.write(front);
    file.write(bytes);
}

void save_wide_tree(const WideTree& tree, MeshView mesh, const fs::path& path) {
    OutputFile file(path);
    write_wide_tree(file, tree, mesh);
    file.commit();
}

WideTree wide_tree_in(const PartOfFile& part, MeshView mesh, const OpenTreeOptions& options) {
    const Reader reader(part);
    const Header& header = reader.header();
    const auto set = set_of_width(header.width);
    if (!set)
        reader.refuse(fmt::format(
            "found {} children a node, expected a width that this machine can walk", header.width));
    check_mesh(reader, mesh, options);
    WideTreeParts parts;
    parts.instruction_set = *set;
    parts.memory = reader.memory();
    parts.is_compact = (header.leaves & kCompactLeaves) != 0;
    parts.has_exact_corners = (header.leaves & kExactCorners) != 0;
    parts.stack_size = static_cast<int>(header.stack_size);
    for (int k = 0; k < 3; ++k) {
        parts.bounds.lo[k] = header.lo[k];
        parts.bounds.hi[k] = header.hi[k];
    }
    parts.scale = header.scale;
    parts.cost = header.cost;
    parts.cost_at_build = header.cost_at_build;
    parts.faces = header.faces;
    parts.left_out = reader.left_out();
    if (!parts.bounds.is_empty() && !(parts.bounds.lo.allFinite() && parts.bounds.hi.allFinite()))
        reader.fail("byte 32", "found bounds that aren't finite, expected a box");
    if (parts.scale != scale_for(parts.bounds))
        reader.fail("byte 28", fmt::format("found scale {}, expected {}", parts.scale,
                                           scale_for(parts.bounds)));
    if (parts.has_exact_corners && parts.scale != 1)
        reader.fail("byte 20", "found corners as they are in a tree with a scale, expected none");
    if (!options.trust) {
        const std::uint64_t found = hash_of({parts.memory.data(), parts.memory.size()});
        if (found != header.tree_hash)
            reader.fail(fmt::format("byte {}", header.tree_offset),
                        fmt::format("found a tree of checksum {:016x}, expected {:016x}", found,
                                    header.tree_hash));
        if (const auto fault = find_fault(parts))
            reader.fail("", "found a tree in which " + *fault + ", expected a sound one");
    }
    return WideTree(std::move(parts));
}

WideTree open_wide_tree(const fs::path& path, MeshView mesh, const OpenTreeOptions& options) {
    const auto file = std::make_shared<MappedFile>(path, FileAccess::random);
    return wide_tree_in({path.string(), std::as_bytes(std::span(file->text())), file}, mesh,
                        options);
}

}  // namespace boxwood
