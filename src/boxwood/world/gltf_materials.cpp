// SPDX-License-Identifier: Apache-2.0
// Metal and roughness in Phong's terms. A surface that isn't metal is diffuse in its color and
// reflects 4 % of the light; metal reflects its color. Highlights are as wide as those of the
// microfacets that glTF means, by the exponent 2 / roughness^4 - 2. As nothing but lights and other
// objects is around to be mirrored, metal keeps half of its color as a diffuse one, so that it
// isn't black, and only what is nearly smooth becomes a mirror. Source: Walter et al., "Microfacet
// models for refraction through rough surfaces", EGSR 2007.
#include "boxwood/world/gltf_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "boxwood/core/error.h"
#include "boxwood/image/read_image.h"

namespace boxwood {

namespace {

std::optional<JsonReader> extension(const JsonReader& value, const std::string& name) {
    const auto extensions = value.find("extensions");
    return extensions ? extensions->find(name) : std::nullopt;
}

double number_or(const JsonReader& value, const std::string& key, double otherwise, double most) {
    const auto number = value.find(key);
    return number ? number->number_within(0, most) : otherwise;
}

Rgba8Image read_image_of(const GltfDocument& document, const JsonReader& image) {
    const std::string name = document.name() + ":" + image.path();
    if (const auto view = image.find("bufferView"))
        return parse_image(document.view(document.index(*view, "bufferViews")).bytes, name);
    return parse_image(document.resolve(image["uri"]), name);
}

TextureWrap wrap_of(const JsonReader& sampler, const std::string& key) {
    const auto value = sampler.find(key);
    if (!value) return TextureWrap::repeat;
    switch (value->integer(0, 65535)) {
        case 33071:
            return TextureWrap::clamp;
        case 33648:
            return TextureWrap::mirror;
        case 10497:
            return TextureWrap::repeat;
        default:
            value->fail("a wrapping mode of glTF: 33071, 33648 or 10497");
    }
}

/// The texture that an object such as "baseColorTexture" names, with KHR_texture_transform.
std::optional<TextureUse> texture_use(const GltfDocument& document, const JsonReader& parent,
                                      const std::string& key, World& world) {
    const auto value = parent.find(key);
    if (!value) return std::nullopt;
    TextureUse use;
    use.texture = document.index((*value)["index"], "textures");
    std::optional<JsonReader> coordinates = value->find("texCoord");
    if (const auto transform = extension(*value, "KHR_texture_transform")) {
        const auto rotation = transform->find("rotation");
        const auto scale = transform->find("scale");
        const auto offset = transform->find("offset");
        const double angle = rotation ? rotation->number() : 0;
        Eigen::Matrix2d turn;
        turn << std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle);
        const std::vector<double> s = scale ? scale->numbers(2) : std::vector<double>{1, 1};
        const std::vector<double> o = offset ? offset->numbers(2) : std::vector<double>{0, 0};
        use.linear = turn * Vec2d(s[0], s[1]).asDiagonal();
        use.offset = {o[0], o[1]};
        if (const auto other = transform->find("texCoord")) coordinates = other;
    }
    if (coordinates && coordinates->integer(0, 65535) != 0) {
        world.warnings.add("textures with other coordinates than the first, left out",
                           document.name(), coordinates->path(),
                           "found another set of coordinates, expected 0");
        return std::nullopt;
    }
    return use;
}

void set_phong_terms(Material& material, const Color& base, double metallic, double roughness) {
    const Color reflected = (1 - metallic) * Color::Constant(0.04) + metallic * base;
    const double width = std::max(roughness * roughness, 0.02);
    const double shininess = std::clamp(2 / (width * width) - 2, 1.0, 2000.0);
    material.ambient = base;
    material.diffuse = (1 - 0.5 * metallic) * base;
    // The highlight's height makes up for its width, up to what 8-bit pictures can show.
    material.specular = std::min((shininess + 8) / 8, 12.0) * reflected;
    material.shininess = shininess;
    material.mirror = std::max(0.0, 1 - 4 * roughness) * reflected;
}

Material read_material(const GltfDocument& document, const JsonReader& value, World& world) {
    Material material;
    if (const auto name = value.find("name")) material.name = name->string();

    Color base = Color::Ones();
    double metallic = 1, roughness = 1;
    if (const auto pbr = value.find("pbrMetallicRoughness")) {
        if (const auto factor = pbr->find("baseColorFactor")) {
            const std::vector<double> c = factor->numbers(4);
            base = {c[0], c[1], c[2]};
            material.opacity = std::clamp(c[3], 0.0, 1.0);
        }
        metallic = number_or(*pbr, "metallicFactor", 1, 1);
        roughness = number_or(*pbr, "roughnessFactor", 1, 1);
        material.color_texture = texture_use(document, *pbr, "baseColorTexture", world);
        // A picture of them may make parts of the surface matte, which isn't looked at: half-way.
        if (pbr->find("metallicRoughnessTexture")) {
            world.warnings.add("textures of metal and roughness, replaced by their factors",
                               document.name(), pbr->path(),
                               "found a metallicRoughnessTexture, expected none");
            metallic /= 2;
        }
    }
    for (const char* key : {"normalTexture", "occlusionTexture"}) {
        if (value.find(key))
            world.warnings.add("textures of normals and occlusion, left out", document.name(),
                               value.path(), fmt::format("found {}, expected none", key));
    }
    set_phong_terms(material, base, metallic, roughness);

    if (const auto factor = value.find("emissiveFactor")) material.emission = factor->vec3();
    if (const auto strength = extension(value, "KHR_materials_emissive_strength"))
        material.emission *= number_or(*strength, "emissiveStrength", 1, 1e30);
    material.emission_texture = texture_use(document, value, "emissiveTexture", world);

    if (extension(value, "KHR_materials_unlit")) {
        material.ambient = material.diffuse = material.specular = material.mirror = Color::Zero();
        material.emission = base;
        material.emission_texture = material.color_texture;
    }

    const auto mode_value = value.find("alphaMode");
    const std::string mode = mode_value ? mode_value->string() : "OPAQUE";
    if (mode == "MASK") {
        material.opacity_cutoff = number_or(value, "alphaCutoff", 0.5, 1e30);
    } else if (mode == "BLEND") {
        material.blends = true;
    } else if (mode == "OPAQUE") {
        material.opacity = 1;
    } else {
        mode_value->fail("\"OPAQUE\", \"MASK\" or \"BLEND\"");
    }
    const auto two_sided = value.find("doubleSided");
    material.is_two_sided = two_sided && two_sided->boolean();
    material.culls_back_faces = !material.is_two_sided;
    return material;
}

}  // namespace

void add_gltf_textures(const GltfDocument& document, World& world) {
    // Several textures may show one image in different ways; it is decoded once.
    std::map<std::size_t, std::size_t> first_with;
    for (std::size_t i = 0; i < document.count("textures"); ++i) {
        const JsonReader value = document.item("textures", i);
        Texture texture;
        if (const auto index = value.find("sampler")) {
            const JsonReader sampler =
                document.item("samplers", document.index(*index, "samplers"));
            texture.wrap_x = wrap_of(sampler, "wrapS");
            texture.wrap_y = wrap_of(sampler, "wrapT");
            constexpr std::uint64_t kNearest = 9728;
            const auto filter = sampler.find("magFilter");
            texture.is_smooth = !(filter && filter->integer(0, 65535) == kNearest);
        }
        try {
            const std::size_t image = document.index(value["source"], "images");
            const auto [first, is_new] = first_with.emplace(image, i);
            texture.image = is_new ? read_image_of(document, document.item("images", image))
                                   : world.textures[first->second].image;
        } catch (const Error& error) {
            world.warnings.add("textures that can't be read, shown white", "", "", error.what());
        }
        world.textures.push_back(std::move(texture));
    }
}

void add_gltf_materials(const GltfDocument& document, World& world) {
    for (std::size_t i = 0; i < document.count("materials"); ++i)
        world.materials.push_back(read_material(document, document.item("materials", i), world));
    Material none;
    none.name = "none";
    none.culls_back_faces = true;
    set_phong_terms(none, Color::Ones(), 0, 1);
    world.materials.push_back(none);
}

}  // namespace boxwood
