// SPDX-License-Identifier: Apache-2.0
// PLY files as text, and a way from there to binary ones that shares nothing with the reader.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace boxwood {

inline const std::string kPlyTriangle =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1.5 0 -2e1\n0 1 0\n3 0 1 2\n";

/// The text with the first place of some words replaced.
inline std::string with_word(std::string text, std::string_view words,
                             std::string_view replacement) {
    return text.replace(text.find(words), words.size(), replacement);
}

/// The bytes of a number in a type by its name.
inline std::string ply_bytes(const std::string& type, double value, bool is_big) {
    const auto bytes_of = [&](auto number) {
        std::string bytes(sizeof(number), '\0');
        std::memcpy(bytes.data(), &number, sizeof(number));
        if (is_big) std::reverse(bytes.begin(), bytes.end());
        return bytes;
    };
    if (type == "char" || type == "int8") return bytes_of(static_cast<std::int8_t>(value));
    if (type == "uchar" || type == "uint8") return bytes_of(static_cast<std::uint8_t>(value));
    if (type == "short" || type == "int16") return bytes_of(static_cast<std::int16_t>(value));
    if (type == "ushort" || type == "uint16") return bytes_of(static_cast<std::uint16_t>(value));
    if (type == "int" || type == "int32") return bytes_of(static_cast<std::int32_t>(value));
    if (type == "uint" || type == "uint32") return bytes_of(static_cast<std::uint32_t>(value));
    if (type == "float" || type == "float32") return bytes_of(static_cast<float>(value));
    return bytes_of(value);
}

/// A valid file in text as a binary one of the same numbers.
inline std::string binary_of(const std::string& text, bool is_big) {
    const std::size_t body = text.find('\n', text.find("\nend_header") + 1) + 1;
    std::string result = with_word(text.substr(0, body), "ascii",
                                   is_big ? "binary_big_endian" : "binary_little_endian");
    std::istringstream header(text.substr(0, body)), numbers(text.substr(body));
    struct Element {
        std::size_t count;
        std::vector<std::vector<std::string>> types;
    };
    std::vector<Element> elements;
    for (std::string line; std::getline(header, line);) {
        std::istringstream words(line);
        std::string keyword, first, second, third;
        words >> keyword >> first >> second >> third;
        if (keyword == "element") elements.push_back({std::stoul(second), {}});
        if (keyword == "property" && first == "list")
            elements.back().types.push_back({second, third});
        else if (keyword == "property")
            elements.back().types.push_back({first});
    }
    const auto next = [&] {
        std::string word;
        numbers >> word;
        return std::stod(word);
    };
    for (const Element& element : elements) {
        for (std::size_t i = 0; i < element.count; ++i) {
            for (const std::vector<std::string>& types : element.types) {
                const double number = next();
                result += ply_bytes(types[0], number, is_big);
                for (double k = 0; types.size() == 2 && k < number; ++k)
                    result += ply_bytes(types[1], next(), is_big);
            }
        }
    }
    return result;
}

}  // namespace boxwood
