// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/gltf/accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "boxwood/mesh/byte_order.h"

namespace boxwood {

namespace {

enum class Component { int8 = 5120, uint8, int16, uint16, uint32 = 5125, float32 = 5126 };

std::size_t size_of(Component type) {
    switch (type) {
        case Component::int8:
        case Component::uint8:
            return 1;
        case Component::int16:
        case Component::uint16:
            return 2;
        default:
            return 4;
    }
}

Component component_type(const JsonReader& value) {
    const std::uint64_t number = value.integer(0, 65535);
    for (const Component type : {Component::int8, Component::uint8, Component::int16,
                                 Component::uint16, Component::uint32, Component::float32}) {
        if (number == static_cast<std::uint64_t>(type)) return type;
    }
    value.fail("a component type of glTF: 5120, 5121, 5122, 5123, 5125 or 5126");
}

std::size_t components_of(const JsonReader& value) {
    const std::string type = value.string();
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    if (type == "VEC3") return 3;
    if (type == "VEC4") return 4;
    value.fail("SCALAR, VEC2, VEC3 or VEC4");
}

std::uint32_t bits_at(const char* place, std::size_t size) {
    return size == 1 ? byte_at(place, 0) : size == 2 ? little_uint16(place) : little_uint32(place);
}

float float_at(const char* place, Component type, bool is_normalized) {
    const std::uint32_t bits = bits_at(place, size_of(type));
    const auto scaled = [&](double value, double most) {
        return static_cast<float>(is_normalized ? std::max(value / most, -1.0) : value);
    };
    switch (type) {
        case Component::int8:
            return scaled(static_cast<std::int8_t>(bits), 127);
        case Component::uint8:
            return scaled(bits, 255);
        case Component::int16:
            return scaled(static_cast<std::int16_t>(bits), 32767);
        case Component::uint16:
            return scaled(bits, 65535);
        case Component::uint32:
            return scaled(bits, 4294967295.0);
        case Component::float32:
            break;
    }
    return float_of_bits(bits);
}

/// Elements that lie in a buffer view at equal distances.
struct Elements {
    const char* first = nullptr;
    std::size_t stride = 0;
    std::size_t count = 0;

    const char* operator[](std::size_t i) const { return first + i * stride; }
};

/// Those of an object with a bufferView and a byteOffset. Fails unless all of them lie in it.
Elements elements_of(const GltfDocument& document, const JsonReader& object, std::size_t count,
                     std::size_t size, bool may_have_stride) {
    const auto view = document.view(document.index(object["bufferView"], "bufferViews"));
    const auto offset_value = object.find("byteOffset");
    const std::size_t offset =
        offset_value ? static_cast<std::size_t>(offset_value->integer(0, view.bytes.size())) : 0;
    const std::size_t stride = may_have_stride && view.stride > 0 ? view.stride : size;
    const std::size_t room = view.bytes.size() - offset;
    // Without multiplying, as the product may not fit.
    const std::size_t most = room < size ? 0 : (room - size) / stride + 1;
    if (count > most)
        object.fail(fmt::format("at most {} elements, which its buffer view has room for", most));
    return {view.bytes.data() + offset, stride, count};
}

std::size_t count_of(const JsonReader& accessor, std::uint64_t limit) {
    // Where there is no data all elements are zero, and nothing says how many can be meant.
    constexpr std::uint64_t kMostZeros = std::uint64_t{1} << 24;
    if (!accessor.find("bufferView")) limit = std::min(limit, kMostZeros);
    return accessor["count"].integer(0, limit);
}

/// Calls put(element, place of its bytes) for each element that a sparse accessor replaces.
template <class Put>
void for_each_replaced(const GltfDocument& document, const JsonReader& accessor, std::size_t count,
                       std::size_t size, const Put& put) {
    const auto sparse = accessor.find("sparse");
    if (!sparse) return;
    const std::size_t replaced = (*sparse)["count"].integer(0, count);
    const JsonReader indices = (*sparse)["indices"];
    const JsonReader type_value = indices["componentType"];
    const Component type = component_type(type_value);
    if (type != Component::uint8 && type != Component::uint16 && type != Component::uint32)
        type_value.fail("a type of indices: 5121, 5123 or 5125");
    const Elements places = elements_of(document, indices, replaced, size_of(type), false);
    const Elements values = elements_of(document, (*sparse)["values"], replaced, size, false);
    for (std::size_t i = 0; i < replaced; ++i) {
        const std::size_t place = bits_at(places[i], size_of(type));
        if (place >= count)
            indices.fail(
                fmt::format("indices below {}, the number of elements, and not {}", count, place));
        put(place, values[i]);
    }
}

}  // namespace

GltfNumbers read_numbers(const GltfDocument& document, const JsonReader& named, std::size_t least,
                         std::size_t most) {
    const JsonReader accessor = document.item("accessors", document.index(named, "accessors"));
    const Component type = component_type(accessor["componentType"]);
    const std::size_t components = components_of(accessor["type"]);
    if (components < least || components > most)
        accessor["type"].fail(least == most ? fmt::format("VEC{}", least)
                                            : fmt::format("VEC{} or VEC{}", least, most));
    const auto normalized = accessor.find("normalized");
    const bool is_normalized = normalized && normalized->boolean();
    const std::size_t count = count_of(accessor, document.limits().max_vertices);
    const std::size_t size = components * size_of(type);
    const bool has_data = accessor.find("bufferView").has_value();
    const Elements elements =
        has_data ? elements_of(document, accessor, count, size, true) : Elements{};

    GltfNumbers result{components, std::vector<float>(count * components)};
    const auto put = [&](std::size_t element, const char* bytes) {
        for (std::size_t k = 0; k < components; ++k)
            result.values[element * components + k] =
                float_at(bytes + k * size_of(type), type, is_normalized);
    };
    for (std::size_t i = 0; i < elements.count; ++i) put(i, elements[i]);
    for_each_replaced(document, accessor, count, size, put);
    return result;
}

std::vector<std::uint32_t> read_indices(const GltfDocument& document, const JsonReader& named,
                                        std::size_t vertices) {
    const JsonReader accessor = document.item("accessors", document.index(named, "accessors"));
    const Component type = component_type(accessor["componentType"]);
    if (type != Component::uint8 && type != Component::uint16 && type != Component::uint32)
        accessor["componentType"].fail("a type of indices: 5121, 5123 or 5125");
    if (components_of(accessor["type"]) != 1) accessor["type"].fail("SCALAR");
    const std::size_t count = count_of(accessor, 3 * document.limits().max_faces);
    const std::size_t size = size_of(type);
    const bool has_data = accessor.find("bufferView").has_value();
    const Elements elements =
        has_data ? elements_of(document, accessor, count, size, true) : Elements{};

    std::vector<std::uint32_t> indices(count);
    for (std::size_t i = 0; i < elements.count; ++i) indices[i] = bits_at(elements[i], size);
    for_each_replaced(document, accessor, count, size,
                      [&](std::size_t i, const char* bytes) { indices[i] = bits_at(bytes, size); });
    for (std::size_t i = 0; i < count; ++i) {
        if (indices[i] >= vertices)
            accessor.fail(
                fmt::format("indices below {}, the number of vertices, and not {} at "
                            "place {}",
                            vertices, indices[i], i));
    }
    return indices;
}

}  // namespace boxwood
