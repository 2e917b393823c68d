// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/image/read_image.h"
#include "boxwood/mesh/file_content.h"
#include "boxwood/mesh/side_file.h"
#include "boxwood/mesh/text_scanner.h"
#include "boxwood/world/mtl.h"

namespace boxwood {

namespace {

/// Of what a mirror would show, Phong's terms have no part for a matte surface.
constexpr std::array<std::string_view, 6> kIgnored = {"Ka", "illum",     "Tf",
                                                      "Km", "sharpness", "map_Ka"};

class MtlReader {
public:
    MtlReader(const MeshSource& source, const ReadOptions& options)
        : source_(source), options_(options) {}

    MtlLibrary read() {
        TextScanner scanner(source_.bytes);
        for (; scanner.find_word(); scanner.finish_line()) read_line(scanner);
        return std::move(library_);
    }

private:
    void read_line(TextScanner& scanner) {
        const std::string_view keyword = scanner.word();
        if (keyword == "newmtl") {
            Material& material = library_.materials.emplace_back();
            material.name = rest_of_line(scanner);
            material.ambient = material.diffuse = Color::Constant(0.8);
            material.is_two_sided = true;
            return;
        }
        if (library_.materials.empty())
            throw ParseError(source_.name(), scanner.line(),
                             fmt::format("found {}, expected newmtl first", quoted(keyword)));
        Material& material = library_.materials.back();
        if (keyword == "Kd") {
            material.diffuse = read_color(scanner);
            material.ambient = material.diffuse;
        } else if (keyword == "Ks") {
            material.specular = read_color(scanner);
        } else if (keyword == "Ke") {
            material.emission = read_color(scanner);
        } else if (keyword == "Ns") {
            material.shininess = std::clamp(read_number(scanner), 0.0, 1e4);
        } else if (keyword == "Ni") {
            material.refraction_index = std::clamp(read_number(scanner), 0.1, 10.0);
        } else if (keyword == "d") {
            material.opacity = std::clamp(read_number(scanner), 0.0, 1.0);
        } else if (keyword == "Tr") {
            material.opacity = 1 - std::clamp(read_number(scanner), 0.0, 1.0);
        } else if (keyword == "map_Kd") {
            read_texture(scanner, material);
        } else if (std::find(kIgnored.begin(), kIgnored.end(), keyword) == kIgnored.end()) {
            library_.warnings.add("material properties that aren't read", source_.name(),
                                  scanner.line(), fmt::format("found {}", quoted(keyword)));
        }
    }

    double read_number(TextScanner& scanner) const {
        const std::string_view word = TextScanner(scanner).word();
        const auto number = scanner.number();
        if (!number || !std::isfinite(*number))
            throw ParseError(source_.name(), scanner.line(),
                             fmt::format("found {}, expected a number",
                                         word.empty() ? "nothing" : quoted(word)));
        return *number;
    }

    /// One number stands for three.
    Color read_color(TextScanner& scanner) const {
        const double r = read_number(scanner);
        if (scanner.at_end_of_line()) return Color::Constant(r);
        const double g = read_number(scanner);
        return {r, g, read_number(scanner)};
    }

    static std::string rest_of_line(TextScanner& scanner) {
        (void)scanner.at_end_of_line();  // skips blanks
        std::string_view text = scanner.rest();
        text = text.substr(0, text.find_first_of("\r\n"));
        while (text.ends_with(' ') || text.ends_with('\t')) text.remove_suffix(1);
        return std::string(text);
    }

    /// "map_Kd [-option numbers ...] name": -s and -o move the picture, the others are passed over.
    void read_texture(TextScanner& scanner, Material& material) {
        TextureUse use;
        Vec2d scale(1, 1), offset(0, 0);
        while (!scanner.at_end_of_line() && scanner.rest().starts_with('-')) {
            const std::string_view option = scanner.word();
            std::array<double, 3> numbers = {1, 1, 1};
            std::size_t count = 0;
            while (count < numbers.size()) {
                const auto number = scanner.number();
                if (!number) break;
                numbers[count++] = *number;
            }
            if (count == 0) scanner.word();  // on, off or a channel
            if (count == 1) numbers[1] = option == "-o" ? 0 : numbers[1];
            if (option == "-s") scale = {numbers[0], numbers[1]};
            if (option == "-o") offset = {numbers[0], numbers[1]};
        }
        std::string name = rest_of_line(scanner);
        std::replace(name.begin(), name.end(), '\\', '/');
        // Texture coordinates grow upwards, places in the picture downwards: with v' = 1 - v the
        // scaled and moved 1 - (s v + o) is s v' + 1 - s - o.
        use.linear = scale.asDiagonal();
        use.offset = {offset.x(), 1 - scale.y() - offset.y()};
        if (const auto texture = texture_of(name, scanner.line())) {
            use.texture = *texture;
            material.color_texture = use;
            // With a picture, files have black or grey by accident.
            if (material.diffuse.isZero(0)) material.diffuse = Color::Ones();
            material.ambient = material.diffuse;
        }
    }

    std::optional<std::size_t> texture_of(const std::string& name, std::size_t line) {
        const auto found = places_.find(name);
        if (found != places_.end()) return found->second;
        std::optional<std::size_t> place;
        try {
            const auto folder = source_.path.parent_path();
            if (const auto refusal = refusal_of(folder, name, options_.allow_outside_files))
                throw ParseError(
                    source_.name(), line,
                    fmt::format("found {}, expected {}", quoted(std::string_view(name)), *refusal));
            const FileContent content(folder / name, options_.limits);
            Texture texture;
            texture.image = parse_image(content.bytes(), (folder / name).string());
            place = library_.textures.size();
            library_.textures.push_back(std::move(texture));
        } catch (const Error& error) {
            library_.warnings.add("textures that can't be read, left out", "", "", error.what());
        }
        return places_[name] = place;
    }

    const MeshSource& source_;
    const ReadOptions& options_;
    MtlLibrary library_;
    std::map<std::string, std::optional<std::size_t>> places_;  ///< of textures, by name
};

}  // namespace

MtlLibrary parse_mtl(const MeshSource& source, const ReadOptions& options) {
    return MtlReader(source, options).read();
}

}  // namespace boxwood
