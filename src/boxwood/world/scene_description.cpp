// SPDX-License-Identifier: Apache-2.0
// A first walk over the file and what it includes reads materials and meshes, by name; objects may
// come before what they name, so they wait for a second walk.
#include "boxwood/world/scene_description.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/mesh/file_content.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/mesh_file.h"
#include "boxwood/mesh/repair.h"
#include "boxwood/world/degrees.h"
#include "boxwood/world/description_camera.h"
#include "boxwood/world/description_files.h"
#include "boxwood/world/description_materials.h"
#include "boxwood/world/parallelogram.h"
#include "boxwood/world/studio.h"

namespace boxwood {

namespace fs = std::filesystem;

namespace {

/// The name among those known, which a message lists when they are few.
std::size_t known(const JsonReader& value, const std::map<std::string, std::size_t>& places,
                  const char* what) {
    const auto found = places.find(value.string());
    if (found != places.end()) return found->second;
    std::vector<std::string> names;
    names.reserve(places.size());
    for (const auto& [name, place] : places) names.push_back(name);
    if (names.empty() || names.size() > 10) value.fail(fmt::format("the name of a {}", what));
    value.fail(fmt::format("the name of a {}: {}", what, fmt::join(names, ", ")));
}

AffineMap read_step(const JsonReader& json) {
    AffineMap map = AffineMap::Identity();
    json.expect_keys({}, {"translate", "rotate", "scale", "matrix"});
    if (json.members().size() != 1)
        json.fail("one of \"translate\", \"rotate\", \"scale\" and \"matrix\"");
    if (const auto translate = json.find("translate")) map.translate(translate->vec3());
    if (const auto rotate = json.find("rotate")) {
        rotate->expect_keys({"axis", "angle"});
        const Vec3d axis = (*rotate)["axis"].vec3();
        if (!(axis.norm() > 0)) (*rotate)["axis"].fail("a direction that isn't zero");
        map.rotate(Eigen::AngleAxisd(radians((*rotate)["angle"].number()), axis.normalized()));
    }
    if (const auto scale = json.find("scale"))
        map.scale(scale->is_number() ? Vec3d(Vec3d::Constant(scale->number())) : scale->vec3());
    if (const auto matrix = json.find("matrix")) {
        const std::vector<double> m = matrix->numbers(16);
        for (int i = 0; i < 12; ++i) map.matrix()(i / 4, i % 4) = m[static_cast<std::size_t>(i)];
        if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1)
            matrix->fail("an affine matrix, row by row, with 0, 0, 0, 1 at the end");
    }
    return map;
}

/// A step, or a list of them, the first one first.
AffineMap read_transform(const JsonReader& json) {
    if (!json.is_array()) return read_step(json);
    AffineMap map = AffineMap::Identity();
    for (const JsonReader& step : json.array()) map = AffineMap(read_step(step) * map);
    return map;
}

std::vector<RepairStep> read_repair(const JsonReader& json) {
    std::vector<RepairStep> steps;
    for (const JsonReader& step : json.array()) steps.push_back(step.choice(repair_steps()));
    return steps;
}

class DescriptionReader {
public:
    DescriptionReader(const fs::path& path, const ReadOptions& options, const fs::path& data_folder)
        : path_(path), files_(path, data_folder, options) {}

    World read(const JsonReader& json) {
        json.expect_keys({"boxwood"},
                         {"include", "film", "integrator", "sampler", "background", "ambient",
                          "camera", "materials", "meshes", "objects", "lights"});
        if (json["boxwood"].integer(0, 1'000'000) != 2)
            json["boxwood"].fail("2, the version of scene files that is read");
        read_settings(json);
        read_parts(json, path_, {});
        for (const auto& [objects, folder] : objects_)
            for (const JsonReader& object : objects.array()) read_object(object);

        if (!has_lights_ || !json.find("camera")) complete(json);
        if (const auto background = json.find("background")) world_.background = background->vec3();
        if (const auto ambient = json.find("ambient")) world_.ambient = ambient->vec3();
        return std::move(world_);
    }

private:
    void read_settings(const JsonReader& json) {
        PictureSettings& picture = world_.picture;
        picture = studio_picture();
        picture.samples = 1;
        if (const auto film = json.find("film")) {
            film->expect_keys({}, {"width", "height", "encoding"});
            constexpr std::uint64_t kMost = 1 << 28;
            const auto size = [&](const char* key, int otherwise) {
                const auto value = film->find(key);
                return value ? static_cast<int>(value->integer(1, kMost)) : otherwise;
            };
            picture.width = size("width", picture.width);
            picture.height = size("height", picture.height);
            if (!is_image_size(picture.width, picture.height))
                film->fail("a picture of at most 2^28 pixels");
            if (const auto encoding = film->find("encoding"))
                picture.encoding = encoding->choice(color_encodings());
        }
        if (const auto integrator = json.find("integrator")) {
            integrator->expect_keys({"type"}, {"bounces"});
            picture.integrator = (*integrator)["type"].choice(integrators());
            if (const auto bounces = integrator->find("bounces"))
                picture.bounces = static_cast<int>(bounces->integer(0, 1000));
        }
        if (const auto sampler = json.find("sampler")) {
            sampler->expect_keys({}, {"samples", "seed"});
            if (const auto samples = sampler->find("samples"))
                picture.samples = static_cast<int>(samples->integer(1, 65536));
            if (const auto seed = sampler->find("seed"))
                picture.seed = seed->integer(0, ~std::uint64_t{0});
        }
        if (const auto camera = json.find("camera"))
            world_.camera = read_description_camera(*camera);
    }

    /// What files that are included may hold as well. The folder is the file's, seen from the
    /// scene's.
    void read_parts(const JsonReader& json, const fs::path& path, const fs::path& folder) {
        open_.push_back(fs::weakly_canonical(path));
        is_read_.insert(open_.back());
        if (const auto includes = json.find("include")) {
            for (const JsonReader& name : includes->array()) include(name, folder);
        }
        if (const auto materials = json.find("materials")) {
            for (const auto& [name, value] : materials->members()) {
                if (!materials_.emplace(name, world_.materials.size()).second)
                    value.fail("a name that no other file has for a material");
                Material material = read_description_material(value, files_, folder, world_);
                material.name = name;
                world_.materials.push_back(std::move(material));
            }
        }
        if (const auto meshes = json.find("meshes")) {
            for (const auto& [name, value] : meshes->members()) {
                if (!meshes_.emplace(name, world_.meshes.size()).second)
                    value.fail("a name that no other file has for a mesh");
                MeshData mesh = read_mesh_of(value, folder);
                if (const auto steps = value.find("repair")) repair(mesh, read_repair(*steps));
                world_.warnings.append(std::exchange(mesh.warnings, {}));
                world_.meshes.push_back(std::move(mesh));
            }
        }
        if (const auto objects = json.find("objects")) objects_.emplace_back(*objects, folder);
        if (const auto lights = json.find("lights")) {
            has_lights_ = true;
            for (const JsonReader& light : lights->array())
                world_.lights.push_back(read_description_light(light));
        }
        open_.pop_back();
    }

    void include(const JsonReader& name, const fs::path& folder) {
        const fs::path path = files_.find(name, folder);
        const fs::path whole = fs::weakly_canonical(path);
        if (std::find(open_.begin(), open_.end(), whole) != open_.end())
            name.fail("a file that doesn't include itself");
        if (open_.size() > files_.options().limits.max_depth)
            name.fail(
                fmt::format("at most {} files in one another", files_.options().limits.max_depth));
        if (is_read_.count(whole) > 0) return;
        const FileContent content(path, files_.options().limits);
        const JsonReader json =
            JsonReader::parse(content.bytes(), path.string(), files_.options().limits);
        json.expect_keys({"boxwood"}, {"include", "materials", "meshes", "objects", "lights"});
        if (json["boxwood"].integer(0, 1'000'000) != 2)
            json["boxwood"].fail("2, the version of scene files that is read");
        read_parts(json, path, (folder / name.string()).parent_path());
    }

    MeshData read_mesh_of(const JsonReader& json, const fs::path& folder) const {
        if (const auto file = json.find("file")) {
            json.expect_keys({"file"}, {"repair"});
            return read_mesh(files_.find(*file, folder), files_.options());
        }
        if (const auto shape = json.find("shape")) {
            json.expect_keys({"shape", "triangles"}, {"repair"});
            const std::vector<std::string_view>& shapes = generated_shapes();
            if (std::find(shapes.begin(), shapes.end(), shape->string()) == shapes.end())
                shape->fail(fmt::format("one of {}", fmt::join(shapes, ", ")));
            const std::uint64_t most =
                std::min<std::uint64_t>(files_.options().limits.max_faces, 1'000'000'000);
            return {generate(shape->string(), json["triangles"].integer(1, most)), {}, {}};
        }
        if (const auto parallelogram = json.find("parallelogram")) {
            json.expect_keys({"parallelogram"}, {"repair"});
            parallelogram->expect_keys({"origin", "u", "v"});
            return {make_parallelogram((*parallelogram)["origin"].vec3(),
                                       (*parallelogram)["u"].vec3(), (*parallelogram)["v"].vec3()),
                    {},
                    {}};
        }
        json.expect_keys({"vertices", "faces"}, {"repair"});
        MeshData mesh;
        for (const JsonReader& vertex : json["vertices"].array())
            mesh.vertices.push_back(vertex.vec3());
        for (const JsonReader& face : json["faces"].array()) {
            const std::vector<JsonReader> corners = face.array();
            if (corners.size() != 3) face.fail("an array of 3 indices of vertices");
            Vec3i& triangle = mesh.faces.emplace_back();
            for (int k = 0; k < 3; ++k)
                triangle[k] = static_cast<int>(
                    corners[static_cast<std::size_t>(k)].index(mesh.vertices.size()));
        }
        return mesh;
    }

    void read_object(const JsonReader& json) {
        const auto material = json.find("material");
        const std::size_t place =
            material ? known(*material, materials_, "material") : clay_material();
        if (const auto sphere = json.find("sphere")) {
            json.expect_keys({"sphere"}, {"material"});
            sphere->expect_keys({"center", "radius"});
            world_.spheres.push_back({.center = (*sphere)["center"].vec3(),
                                      .radius = (*sphere)["radius"].number_above(0),
                                      .material = place});
            return;
        }
        json.expect_keys({"mesh"}, {"material", "transform"});
        MeshObject object;
        object.mesh = known(json["mesh"], meshes_, "mesh");
        object.materials = {place};
        if (const auto transform = json.find("transform")) {
            object.to_world = read_transform(*transform);
            try {
                (void)Placement(object.to_world);
            } catch (const InvalidInput& error) {
                transform->fail(fmt::format("a transform that can be undone ({})", error.what()));
            }
        }
        world_.objects.push_back(std::move(object));
    }

    std::size_t clay_material() {
        if (!clay_) {
            clay_ = world_.materials.size();
            world_.materials.push_back(clay());
        }
        return *clay_;
    }

    /// Finds a camera and lights where the file has none.
    void complete(const JsonReader& json) {
        if (!json.find("camera")) frame(world_, UpAxis::y);
        if (!has_lights_) light_studio(world_, UpAxis::y);
    }

    fs::path path_;
    DescriptionFiles files_;
    World world_;
    std::map<std::string, std::size_t> materials_, meshes_;
    std::vector<std::pair<JsonReader, fs::path>> objects_;
    std::vector<fs::path> open_;  ///< files that are being read, one in another
    std::set<fs::path> is_read_;
    bool has_lights_ = false;
    std::optional<std::size_t> clay_;
};

}  // namespace

World read_scene_description(const JsonReader& json, const fs::path& path,
                             const ReadOptions& options, const fs::path& data_folder) {
    return DescriptionReader(path, options, data_folder).read(json);
}

}  // namespace boxwood
