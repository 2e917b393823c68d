// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cmath>

#include "arrays.h"
#include "bindings.h"
#include "boxwood/core/parallel.h"
#include "boxwood/image/color_map.h"
#include "boxwood/image/png.h"
#include "boxwood/render/render.h"
#include "boxwood/world/read_world.h"
#include "choice.h"
#include "ray_arrays.h"
#include "unlocked.h"
#include "watch.h"

namespace boxwood::python {

using namespace nanobind::literals;

namespace {

using Vector = nb::ndarray<const double, nb::shape<3>, nb::c_contig, nb::device::cpu>;
using Pixels8 = nb::ndarray<const std::uint8_t, nb::shape<-1, -1, 4>, nb::c_contig>;

constexpr Named<UpAxis> kUpAxes[] = {{"y", UpAxis::y}, {"z", UpAxis::z}};

UpAxis up_axis(const std::string& name) {
    return choice("up", std::span<const Named<UpAxis>>(kUpAxes), name);
}

Vec3d vector_of(const Vector& v) { return {v.data()[0], v.data()[1], v.data()[2]}; }
Triple tuple_of(const Vec3d& v) { return nb::make_tuple(v.x(), v.y(), v.z()); }

/// Angles in radians; without perspective the view is `height` high.
Camera make_camera(const Vector& position, const Vector& target, const Vector& up,
                   bool is_perspective, double field_of_view, double height) {
    Camera camera;
    camera.look_at(vector_of(position), vector_of(target), vector_of(up));
    camera.is_perspective = is_perspective;
    camera.field_of_view = is_perspective ? field_of_view : 2 * std::atan(height / 2);
    camera.pixel_spread = 1;
    return camera;
}

/// The rays through the middles of a film's pixels, row by row from the top.
void camera_rays(const Camera& camera, int width, int height, const RowsOut<double, 3>& origins,
                 const RowsOut<double, 3>& directions) {
    check_places(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), origins,
                 directions);
    const auto from = rows_of<Vec3d>(origins), along = rows_of<Vec3d>(directions);
    const Film film = camera.film(width, height);
    const Unlocked unlocked;
    parallel_for(static_cast<std::size_t>(height), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
            for (int x = 0; x < width; ++x) {
                const Vec2d place(x + 0.5, static_cast<double>(y) + 0.5);
                const Ray ray = camera.ray({.film = place}, film);
                const std::size_t i =
                    y * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
                from[i] = ray.origin;
                along[i] = ray.direction;
            }
        }
    });
}

World read(const std::filesystem::path& path, const std::optional<std::string>& up,
           const std::filesystem::path& data_folder, bool allow_outside_files) {
    WorldOptions options = {.read = {.allow_outside_files = allow_outside_files},
                            .data_folder = data_folder};
    if (up) options.up = up_axis(*up);
    const Unlocked unlocked;
    return read_world(path, options);
}

/// Meshes of clay, or of their own colors.
World studio(const List& meshes, const std::vector<bool>& culls,
             const Values<std::uint32_t>& mesh_of_object, const Transforms& transforms) {
    World world;
    world.picture = studio_picture();
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const auto& mesh = nb::cast<const MeshData&>(meshes[i]);
        Material material = clay();
        material.culls_back_faces = culls[i];
        if (!mesh.attributes.colors.is_empty()) material.ambient = material.diffuse = Color::Ones();
        world.materials.push_back(std::move(material));
        world.meshes.push_back(mesh);
    }
    for (std::size_t i = 0; i < mesh_of_object.shape(0); ++i) {
        MeshObject object = {.mesh = mesh_of_object(i), .materials = {mesh_of_object(i)}};
        object.to_world = affine_map(transforms, i);
        world.objects.push_back(std::move(object));
    }
    return world;
}

void frame_world(World& world, const std::string& up, int width, int height) {
    const UpAxis axis = up_axis(up);
    const Unlocked unlocked;
    world.picture.width = width;
    world.picture.height = height;
    frame(world, axis);
    world.lights.clear();
    light_studio(world, axis);
}

void render_world(World& world, const std::optional<std::string>& integrator,
                  std::optional<int> samples, std::optional<int> bounces,
                  std::optional<std::uint64_t> seed,
                  const nb::ndarray<double, nb::shape<-1, -1, 3>, nb::c_contig>& pixels,
                  nb::handle progress) {
    PictureSettings& picture = world.picture;
    if (integrator) picture.integrator = choice("integrator", integrators(), *integrator);
    RenderOptions options = {.width = static_cast<int>(pixels.shape(1)),
                             .height = static_cast<int>(pixels.shape(0)),
                             .integrator = picture.integrator,
                             .samples = samples.value_or(picture.samples),
                             .seed = seed.value_or(picture.seed),
                             .bounces = bounces.value_or(picture.bounces)};
    constexpr std::size_t kSteps = 1000;
    run_watched(kSteps, progress, [&](Watch& watch) {
        const BatchOptions watched = watch.options(kSteps);
        options.cancellation = watched.cancellation;
        options.progress = watched.progress;
        const Surfaces surfaces(world, {.keep_trees = options.integrator == IntegratorKind::heat});
        const ColorImage image = render(world, surfaces, options);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            for (int k = 0; k < 3; ++k)
                pixels.data()[3 * i + static_cast<std::size_t>(k)] = image.pixels[i][k];
    });
}

Rgba8Image image_of(const Pixels8& pixels) {
    if (!is_image_size(static_cast<int>(pixels.shape(1)), static_cast<int>(pixels.shape(0))))
        throw InvalidInput("pixels: expected from 1 to 2^28 of them");
    Rgba8Image image(static_cast<int>(pixels.shape(1)), static_cast<int>(pixels.shape(0)), {});
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const std::uint8_t* p = pixels.data() + 4 * i;
        image.pixels[i] = {p[0], p[1], p[2], p[3]};
    }
    return image;
}

}  // namespace

void bind_pictures(nb::module_& module) {
    nb::class_<Camera>(module, "Camera")
        .def(
            "__init__",
            [](Camera* self, const Vector& position, const Vector& target, const Vector& up,
               bool is_perspective, double field_of_view, double height) {
                new (self) Camera(
                    make_camera(position, target, up, is_perspective, field_of_view, height));
            },
            "position"_a, "target"_a, "up"_a, "is_perspective"_a, "field_of_view"_a, "height"_a)
        .def_prop_ro("position", [](const Camera& self) { return tuple_of(self.position); })
        .def_prop_ro("back", [](const Camera& self) { return tuple_of(self.back); })
        .def_prop_ro("up", [](const Camera& self) { return tuple_of(self.up); })
        .def_prop_ro("field_of_view", [](const Camera& self) { return self.field_of_view; })
        .def("rays", &camera_rays, "width"_a, "height"_a, "origins"_a.noconvert(),
             "directions"_a.noconvert());

    nb::class_<World>(module, "World")
        .def_static("read", &read, "path"_a, "up"_a.none(), "data_folder"_a,
                    "allow_outside_files"_a)
        .def_static("studio", &studio, "meshes"_a, "culls_back_faces"_a,
                    "mesh_of_object"_a.noconvert(), "transforms"_a.noconvert())
        .def("frame", &frame_world, "up"_a, "width"_a, "height"_a)
        .def_prop_rw(
            "camera", [](const World& self) { return self.camera; },
            [](World& self, const Camera& camera) { self.camera = camera; })
        .def(
            "light_studio",
            [](World& self, const std::string& up) {
                self.lights.clear();
                light_studio(self, up_axis(up));
            },
            "up"_a)
        .def_prop_ro("width", [](const World& self) { return self.picture.width; })
        .def_prop_ro("height", [](const World& self) { return self.picture.height; })
        .def("warnings", [](const World& self) { return list_of(self.warnings); })
        .def("render", &render_world, "integrator"_a.none(), "samples"_a.none(), "bounces"_a.none(),
             "seed"_a.none(), "pixels"_a.noconvert(), "progress"_a.none());

    module.def(
        "to_rgba8",
        [](const PackedRows<double>& colors, const RowsOut<std::uint8_t, 4>& pixels) {
            check_places(colors.shape(0), pixels);
            for (std::size_t i = 0; i < colors.shape(0); ++i) {
                const double* c = colors.data() + 3 * i;
                const Rgba8 pixel = to_rgba8(Vec3d(c[0], c[1], c[2]));
                const std::uint8_t bytes[] = {pixel.r, pixel.g, pixel.b, pixel.a};
                std::copy_n(bytes, 4, pixels.data() + 4 * i);
            }
        },
        "colors"_a.noconvert(), "pixels"_a.noconvert());
    module.def(
        "heat_colors",
        [](const ValuesOut<const double>& values, const RowsOut<double, 3>& colors) {
            const auto given = values_of(values);
            const auto found = rows_of<Vec3d>(colors);
            std::transform(given.begin(), given.end(), found.begin(), &heat_color);
        },
        "values"_a.noconvert(), "colors"_a.noconvert());
    module.def("encode_png", [](const Pixels8& pixels) {
        const std::string bytes = encode_png(image_of(pixels));
        return nb::bytes(bytes.data(), bytes.size());
    });
    module.def("write_png", [](const std::filesystem::path& path, const Pixels8& pixels) {
        write_png(path, image_of(pixels));
    });
}

}  // namespace boxwood::python
