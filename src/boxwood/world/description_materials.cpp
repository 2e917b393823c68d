// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/description_materials.h"

#include <array>
#include <utility>

#include "boxwood/core/named.h"
#include "boxwood/image/read_image.h"
#include "boxwood/mesh/file_content.h"

namespace boxwood {

namespace {

constexpr std::array<Named<TextureWrap>, 3> kWraps = {{{"repeat", TextureWrap::repeat},
                                                       {"mirror", TextureWrap::mirror},
                                                       {"clamp", TextureWrap::clamp}}};

/// A file's name, or an object with more to say.
TextureUse read_texture(const JsonReader& json, const DescriptionFiles& files,
                        const std::filesystem::path& folder, World& world) {
    TextureUse use;
    Texture texture;
    JsonReader name = json;
    if (!json.is_string()) {
        json.expect_keys({"file"}, {"wrap", "smooth", "scale", "offset"});
        name = json["file"];
        if (const auto wrap = json.find("wrap"))
            texture.wrap_x = texture.wrap_y = wrap->choice(kWraps);
        if (const auto smooth = json.find("smooth")) texture.is_smooth = smooth->boolean();
        if (const auto scale = json.find("scale")) {
            const std::vector<double> s = scale->numbers(2);
            use.linear = Vec2d(s[0], s[1]).asDiagonal();
        }
        if (const auto offset = json.find("offset")) {
            const std::vector<double> o = offset->numbers(2);
            use.offset = {o[0], o[1]};
        }
    }
    const std::filesystem::path path = files.find(name, folder);
    const FileContent content(path, files.options().limits);
    texture.image = parse_image(content.bytes(), path.string());
    use.texture = world.textures.size();
    world.textures.push_back(std::move(texture));
    return use;
}

}  // namespace

Material read_description_material(const JsonReader& json, const DescriptionFiles& files,
                                   const std::filesystem::path& folder, World& world) {
    json.expect_keys(
        {}, {"type", "ambient", "diffuse", "specular", "mirror", "refraction", "refraction_index",
             "shininess", "emission", "opacity", "two_sided", "color_texture"});
    if (const auto type = json.find("type"); type && type->string() != "phong")
        type->fail("\"phong\", the one type that is rendered");
    Material material;
    material.is_two_sided = true;
    const auto read_color = [&](const char* key, Color& color) {
        if (const auto value = json.find(key)) color = value->vec3();
    };
    if (json.find("color_texture")) material.diffuse = Color::Ones();
    read_color("diffuse", material.diffuse);
    material.ambient = material.diffuse;
    read_color("ambient", material.ambient);
    read_color("specular", material.specular);
    read_color("mirror", material.mirror);
    read_color("refraction", material.refraction);
    read_color("emission", material.emission);
    if (const auto index = json.find("refraction_index"))
        material.refraction_index = index->number_above(0);
    if (const auto shininess = json.find("shininess"))
        material.shininess = shininess->number_at_least(0);
    if (const auto opacity = json.find("opacity")) material.opacity = opacity->number_within(0, 1);
    if (const auto two_sided = json.find("two_sided")) material.is_two_sided = two_sided->boolean();
    if (const auto texture = json.find("color_texture"))
        material.color_texture = read_texture(*texture, files, folder, world);
    return material;
}

}  // namespace boxwood
