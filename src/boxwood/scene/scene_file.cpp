// SPDX-License-Identifier: Apache-2.0
// A header, tables of meshes and instances, the faults that were reported, zeros up to a page's
// end; then for each mesh its vertices, its faces and a saved tree. Explained in
// docs/guide/saved_trees.md.
#include "boxwood/scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/core/files.h"
#include "boxwood/query/saved_file.h"
#include "boxwood/query/wide_tree_file.h"

namespace boxwood {

namespace fs = std::filesystem;

namespace {

struct Header {
    SavedStart start = SavedStart::of('S');
    std::uint64_t meshes = 0, instances = 0;
    std::uint64_t front_bytes = 0;  ///< where the first mesh begins
    std::uint64_t file_bytes = 0;
    std::uint64_t front_hash = 0;  ///< of all in front of the meshes, with 0 here
};
static_assert(sizeof(Header) == 56);

/// Its arrays follow one another from `place` on, each from a multiple of kSavedAlignment.
struct MeshEntry {
    std::uint64_t place = 0;
    std::uint64_t vertices = 0, faces = 0;
    std::uint64_t tree_bytes = 0;
    std::uint64_t not_finite = 0, zero_area = 0;  ///< faults, listed behind the tables
    std::uint64_t culls_back_faces = 0;
};
static_assert(sizeof(MeshEntry) == 56);

struct InstanceEntry {
    std::uint32_t mesh = 0, visibility = 0;
    double to_world[12] = {};  ///< three rows of four
};
static_assert(sizeof(InstanceEntry) == 104);

template <class T>
void append(std::vector<std::byte>& bytes, std::span<const T> values) {
    const auto more = std::as_bytes(values);
    bytes.insert(bytes.end(), more.begin(), more.end());
}

/// Writes zeros up to a multiple of kSavedAlignment.
void fill_up(OutputFile& file, std::uint64_t bytes) {
    static constexpr std::array<std::byte, kSavedAlignment> kZeros = {};
    file.write(std::span(kZeros).first(aligned_to_page(bytes) - bytes));
}

template <class T>
void write_aligned(OutputFile& file, std::span<const T> values) {
    file.write(std::as_bytes(values));
    fill_up(file, values.size_bytes());
}

InstanceEntry entry_of(const Instance& instance) {
    InstanceEntry entry = {.mesh = instance.mesh, .visibility = instance.visibility};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            entry.to_world[4 * row + column] = instance.to_world(row, column);
    return entry;
}

Instance instance_of(const InstanceEntry& entry) {
    Instance instance = {.mesh = entry.mesh, .visibility = entry.visibility};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            instance.to_world(row, column) = entry.to_world[4 * row + column];
    return instance;
}

/// Reads the file's front, and throws what is wrong with it.
class Reader {
public:
    explicit Reader(const fs::path& path)
        : name_(path.string()), file_(std::make_shared<MappedFile>(path, FileAccess::random)) {
        bytes_ = std::as_bytes(std::span(file_->text()));
        header_ = read_saved_header<Header>(
            bytes_, "scene", [&](const auto& place, const auto& message) { fail(place, message); });
        if (header_.file_bytes != bytes_.size())
            fail("", fmt::format("found {} bytes, expected {}", bytes_.size(), header_.file_bytes));
        check_front();
        read_tables();
    }

    const std::vector<MeshEntry>& meshes() const { return meshes_; }
    const std::vector<Instance>& instances() const { return instances_; }
    const BuildReport& report() const { return report_; }
    std::shared_ptr<const void> file() const { return file_; }

    MeshView mesh(std::size_t i) const {
        const MeshEntry& entry = meshes_[i];
        return {array<Vec3d>(entry.place, entry.vertices),
                array<Vec3i>(faces_at(entry), entry.faces)};
    }
    PartOfFile tree(std::size_t i) const {
        const MeshEntry& entry = meshes_[i];
        return {fmt::format("{}: tree {}", name_, i),
                bytes_.subspan(tree_at(entry), entry.tree_bytes), file_};
    }

    [[noreturn]] void fail(const std::string& place, const std::string& message) const {
        throw ParseError(name_, place, message);
    }

private:
    static std::uint64_t faces_at(const MeshEntry& entry) {
        return entry.place + aligned_to_page(entry.vertices * sizeof(Vec3d));
    }
    static std::uint64_t tree_at(const MeshEntry& entry) {
        return faces_at(entry) + aligned_to_page(entry.faces * sizeof(Vec3i));
    }

    template <class T>
    std::span<const T> array(std::uint64_t place, std::uint64_t count) const {
        return {reinterpret_cast<const T*>(bytes_.data() + place), count};
    }

    void check_front() const {
        if (header_.front_bytes > bytes_.size() || header_.front_bytes < sizeof(Header))
            fail("byte 32", fmt::format("found {} bytes in front of the meshes, expected {} to {}",
                                        header_.front_bytes, sizeof(Header), bytes_.size()));
        check_front_hash(bytes_.first(header_.front_bytes), offsetof(Header, front_hash),
                         [&](const auto& place, const auto& message) { fail(place, message); });
    }

    /// The next values of the front.
    template <class T>
    std::vector<T> take(std::uint64_t count) {
        if (count > (header_.front_bytes - taken_) / sizeof(T))
            fail(fmt::format("byte {}", taken_),
                 fmt::format("found {} entries, expected no more than fit in front of byte {}",
                             count, header_.front_bytes));
        std::vector<T> values(count);
        if (count > 0) std::memcpy(values.data(), bytes_.data() + taken_, count * sizeof(T));
        taken_ += count * sizeof(T);
        return values;
    }

    void read_tables() {
        taken_ = sizeof(Header);
        meshes_ = take<MeshEntry>(header_.meshes);
        for (const InstanceEntry& entry : take<InstanceEntry>(header_.instances))
            instances_.push_back(instance_of(entry));
        std::uint64_t place = header_.front_bytes;
        for (std::size_t i = 0; i < meshes_.size(); ++i) {
            check_place(i, place);
            MeshFaults faults;
            faults.not_finite = take_faces(meshes_[i].not_finite, meshes_[i].faces);
            faults.zero_area = take_faces(meshes_[i].zero_area, meshes_[i].faces);
            report_.meshes.push_back(std::move(faults));
        }
        if (place != bytes_.size())
            fail("", fmt::format("found {} bytes, expected {}", bytes_.size(), place));
    }

    /// The next list of faces.
    std::vector<std::uint32_t> take_faces(std::uint64_t count, std::uint64_t faces) {
        const auto place = taken_;
        std::vector<std::uint32_t> list = take<std::uint32_t>(count);
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (list[i] >= faces || (i > 0 && list[i] <= list[i - 1]))
                fail(fmt::format("byte {}", place + i * sizeof(list[0])),
                     fmt::format("found face {} in a list, expected it in order and less than {}",
                                 list[i], faces));
        }
        return list;
    }

    /// Moves the place behind the mesh.
    void check_place(std::size_t i, std::uint64_t& place) const {
        const MeshEntry& entry = meshes_[i];
        const std::uint64_t room = bytes_.size() - place;
        const bool fits = entry.place == place && place % kSavedAlignment == 0 &&
                          entry.vertices <= room / sizeof(Vec3d) &&
                          entry.faces <= room / sizeof(Vec3i) && entry.tree_bytes <= room;
        // Each is less than 2^60 now, so sums don't overflow.
        const std::uint64_t end = fits ? tree_at(entry) + aligned_to_page(entry.tree_bytes) : 0;
        if (!fits || end > bytes_.size())
            fail(fmt::format("byte {}", sizeof(Header) + i * sizeof(MeshEntry)),
                 fmt::format("found mesh {} at byte {} with {} vertices, {} faces and a tree of {} "
                             "bytes, expected it at byte {} and within {}",
                             i, entry.place, entry.vertices, entry.faces, entry.tree_bytes, place,
                             bytes_.size()));
        place = end;
    }

    std::string name_;
    std::shared_ptr<const MappedFile> file_;
    std::span<const std::byte> bytes_;
    Header header_;
    std::uint64_t taken_ = 0;
    std::vector<MeshEntry> meshes_;
    std::vector<Instance> instances_;
    BuildReport report_;
};

}  // namespace

void save_scene(const Scene& scene, const fs::path& path) {
    if (scene.wide_trees().size() != scene.meshes().size())
        throw InvalidInput("save_scene: found a scene by brute force, expected one with trees");
    Header header;
    header.meshes = scene.meshes().size();
    header.instances = scene.instances().size();
    std::vector<MeshEntry> meshes(header.meshes);
    std::vector<InstanceEntry> instances;
    std::uint64_t faults = 0;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const MeshFaults& found = scene.report().meshes[i];
        meshes[i] = {.vertices = scene.meshes()[i].vertices.size(),
                     .faces = scene.meshes()[i].faces.size(),
                     .tree_bytes = saved_bytes(scene.wide_trees()[i]),
                     .not_finite = found.not_finite.size(),
                     .zero_area = found.zero_area.size(),
                     .culls_back_faces = scene.culls_back_faces(i)};
        faults += found.not_finite.size() + found.zero_area.size();
    }
    for (const Instance& instance : scene.instances()) instances.push_back(entry_of(instance));

    header.front_bytes =
        aligned_to_page(sizeof(Header) + meshes.size() * sizeof(MeshEntry) +
                        instances.size() * sizeof(InstanceEntry) + faults * sizeof(std::uint32_t));
    std::uint64_t place = header.front_bytes;
    for (MeshEntry& entry : meshes) {
        entry.place = place;
        place += aligned_to_page(entry.vertices * sizeof(Vec3d)) +
                 aligned_to_page(entry.faces * sizeof(Vec3i)) + aligned_to_page(entry.tree_bytes);
    }
    header.file_bytes = place;

    std::vector<std::byte> front;
    front.reserve(header.front_bytes);
    append(front, std::span<const Header>(&header, 1));
    append(front, std::span<const MeshEntry>(meshes));
    append(front, std::span<const InstanceEntry>(instances));
    for (const MeshFaults& found : scene.report().meshes) {
        append(front, std::span<const std::uint32_t>(found.not_finite));
        append(front, std::span<const std::uint32_t>(found.zero_area));
    }
    front.resize(header.front_bytes);
    header.front_hash = hash_of_front(front, offsetof(Header, front_hash));
    std::memcpy(front.data(), &header, sizeof(header));

    OutputFile file(path);
    file.write(front);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const MeshView mesh = scene.meshes()[i];
        write_aligned(file, mesh.vertices);
        write_aligned(file, mesh.faces);
        write_wide_tree(file, scene.wide_trees()[i], mesh);
        fill_up(file, saved_bytes(scene.wide_trees()[i]));
    }
    file.commit();
}

Scene open_scene(const fs::path& path, const OpenSceneOptions& options) {
    const Reader reader(path);
    std::vector<SceneMesh> meshes;
    std::vector<WideTree> trees;
    for (std::size_t i = 0; i < reader.meshes().size(); ++i) {
        const MeshView mesh = reader.mesh(i);
        trees.push_back(wide_tree_in(reader.tree(i), mesh,
                                     {.trust = options.trust, .mesh_in_same_file = true}));
        meshes.emplace_back(mesh, reader.meshes()[i].culls_back_faces != 0);
    }
    try {
        return Scene(std::move(meshes), reader.instances(), std::move(trees), reader.report(),
                     reader.file(), options.trust);
    } catch (const InvalidInput& error) {
        reader.fail("", error.what());
    }
}

}  // namespace boxwood
