// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "boxwood/core/error.h"
#include "boxwood/core/warnings.h"
#include "boxwood/mesh/ply/ply_header.h"

namespace boxwood {

/// The number in memory at that place, of either byte order.
template <class Number>
Number load_ply(const char* place, bool must_swap) {
    char bytes[sizeof(Number)];
    std::memcpy(bytes, place, sizeof(Number));
    if (must_swap) std::reverse(bytes, bytes + sizeof(Number));
    Number number;
    std::memcpy(&number, bytes, sizeof(Number));
    return number;
}

/// Calls body with a value of the C++ type.
template <class Body>
auto with_ply_type(PlyType type, const Body& body) {
    switch (type) {
        case PlyType::int8:
            return body(std::int8_t{});
        case PlyType::uint8:
            return body(std::uint8_t{});
        case PlyType::int16:
            return body(std::int16_t{});
        case PlyType::uint16:
            return body(std::uint16_t{});
        case PlyType::int32:
            return body(std::int32_t{});
        case PlyType::uint32:
            return body(std::uint32_t{});
        case PlyType::float32:
            return body(float{});
        case PlyType::float64:
            return body(double{});
    }
    return body(double{});
}

/// Walks through the numbers of a binary file, as ply_rows.h wants it.
class PlyBinaryCursor {
public:
    PlyBinaryCursor(std::string_view text, std::size_t first_byte, bool must_swap,
                    const std::string& file)
        : text_(text), at_(first_byte), must_swap_(must_swap), file_(file) {}

    std::size_t byte() const { return at_; }
    std::size_t left() const { return text_.size() - at_; }

    double number(PlyType type) {
        const char* place = take(size_of(type));
        return with_ply_type(type, [&](auto number) {
            return static_cast<double>(load_ply<decltype(number)>(place, must_swap_));
        });
    }
    std::int64_t integer(PlyType type) {
        const char* place = take(size_of(type));
        return with_ply_type(type, [&](auto number) -> std::int64_t {
            const auto found = load_ply<decltype(number)>(place, must_swap_);
            if constexpr (std::is_floating_point_v<decltype(number)>) {
                // Beyond that, not every whole number is one of them.
                if (!(std::abs(found) <= 9007199254740992.0) || found != std::floor(found))
                    fail(fmt::format("found {}, expected a whole number", found));
            }
            return static_cast<std::int64_t>(found);
        });
    }
    std::size_t count(PlyType type) {
        const std::int64_t count = integer(type);
        if (count < 0)
            fail(fmt::format("found {} as the count of a list, expected 0 or more", count));
        return static_cast<std::size_t>(count);
    }
    void skip(PlyType type) { take(size_of(type)); }
    void skip_list(const PlyProperty& property) {
        const std::size_t items = count(property.count_type);
        const std::size_t size = size_of(property.type);
        if (items > left() / size)
            fail(fmt::format(
                "found a list of {} items, {} bytes each, but the file has {} more bytes", items,
                size, left()));
        at_ += items * size;
    }

    /// At what was read last.
    [[noreturn]] void fail(const std::string& message) const {
        throw ParseError(file_, fmt::format("byte {}", last_), message);
    }
    void warn(Warnings& warnings, const char* kind, const std::string& message) const {
        warnings.add(kind, file_, fmt::format("byte {}", last_), message);
    }

private:
    const char* take(std::size_t size) {
        last_ = at_;
        if (size > left()) fail(fmt::format("the file ends, expected {} more bytes", size));
        at_ += size;
        return text_.data() + last_;
    }

    std::string_view text_;
    std::size_t at_;
    std::size_t last_ = 0;
    bool must_swap_;
    const std::string& file_;
};

}  // namespace boxwood
