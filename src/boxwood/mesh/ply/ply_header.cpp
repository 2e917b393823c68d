// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/ply/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>
#include <unordered_set>

#include "boxwood/core/error.h"
#include "boxwood/mesh/text_scanner.h"

namespace boxwood {

namespace {

std::optional<PlyType> type_of(std::string_view word) {
    struct Entry {
        std::string_view old_name, name;
        PlyType type;
    };
    static constexpr Entry kTypes[] = {
        {"char", "int8", PlyType::int8},        {"uchar", "uint8", PlyType::uint8},
        {"short", "int16", PlyType::int16},     {"ushort", "uint16", PlyType::uint16},
        {"int", "int32", PlyType::int32},       {"uint", "uint32", PlyType::uint32},
        {"float", "float32", PlyType::float32}, {"double", "float64", PlyType::float64},
    };
    for (const Entry& entry : kTypes) {
        if (word == entry.old_name || word == entry.name) return entry.type;
    }
    return std::nullopt;
}

class PlyHeaderReader {
public:
    PlyHeaderReader(const MeshSource& source, const Limits& limits)
        : name_(source.name()), text_(source.bytes), limits_(limits) {}

    PlyHeader read() {
        if (!next_line()) fail("the file is empty, expected the keyword ply");
        if (words_.size() != 1 || words_[0] != "ply")
            fail(fmt::format("found {}, expected the keyword ply", shown_line()));
        if (!next_line()) fail("the file ends, expected the format");
        while (is_comment()) {
            if (!next_line()) fail("the file ends, expected the format");
        }
        read_format();
        for (;;) {
            if (!next_line()) fail("the file ends, expected end_header");
            if (is_comment() || words_.empty()) continue;
            if (words_[0] == "end_header" && words_.size() == 1) break;
            read_declaration();
        }
        header_.bytes = at_;
        return std::move(header_);
    }

private:
    [[noreturn]] void fail(const std::string& message) const {
        throw ParseError(name_, header_.lines, message);
    }

    /// Cuts off the next line and parts its words; false when there is none. Its size is bounded,
    /// so that of binary junk little is read.
    bool next_line() {
        ++header_.lines;
        if (at_ == text_.size()) return false;
        constexpr std::size_t kLongest = 1 << 16;
        const std::size_t end = text_.substr(at_, kLongest).find('\n');
        if (end == text_.npos && text_.size() - at_ > kLongest)
            fail(fmt::format("found a line of more than {} bytes, expected a header", kLongest));
        line_ = text_.substr(at_, end);
        at_ = end == text_.npos ? text_.size() : at_ + end + 1;
        if (line_.ends_with('\r')) line_.remove_suffix(1);
        words_.clear();
        constexpr std::string_view kBlanks = " \t\r\v\f";
        for (std::string_view rest = line_;;) {
            const std::size_t begin = rest.find_first_not_of(kBlanks);
            if (begin == rest.npos) break;
            rest.remove_prefix(begin);
            const std::size_t size = std::min(rest.find_first_of(kBlanks), rest.size());
            words_.push_back(rest.substr(0, size));
            rest.remove_prefix(size);
        }
        return true;
    }

    bool is_comment() const {
        return !words_.empty() && (words_[0] == "comment" || words_[0] == "obj_info");
    }

    std::string shown_line() const { return line_.empty() ? "nothing" : quoted(line_); }

    void read_format() {
        if (words_.size() != 3 || words_[0] != "format")
            fail(fmt::format("found {}, expected the format", shown_line()));
        if (words_[1] == "ascii") {
            header_.format = PlyFormat::ascii;
        } else if (words_[1] == "binary_little_endian") {
            header_.format = PlyFormat::binary_little_endian;
        } else if (words_[1] == "binary_big_endian") {
            header_.format = PlyFormat::binary_big_endian;
        } else {
            fail(
                fmt::format("found the format {}, expected ascii, binary_little_endian or "
                            "binary_big_endian",
                            quoted(words_[1])));
        }
        if (words_[2] != "1.0")
            fail(fmt::format("found version {}, expected 1.0", quoted(words_[2])));
    }

    void read_declaration() {
        if (words_[0] == "element") {
            read_element();
        } else if (words_[0] == "property") {
            read_property();
        } else {
            fail(fmt::format("found {}, expected element, property, comment or end_header",
                             quoted(words_[0])));
        }
    }

    void read_element() {
        if (words_.size() != 3)
            fail(fmt::format("found {}, expected an element's name and count", shown_line()));
        const std::string name(words_[1]);
        if (!element_names_.insert(name).second)
            fail(
                fmt::format("found the element {} again, expected it once", boxwood::quoted(name)));
        constexpr std::uint64_t kMostIndices = std::numeric_limits<int>::max();
        const std::uint64_t most = name == "vertex" ? std::min(limits_.max_vertices, kMostIndices)
                                   : name == "face" ? std::min(limits_.max_faces, kMostIndices)
                                                    : std::uint64_t{1} << 48;
        const auto count = TextScanner(words_[2]).integer();
        if (!count || *count < 0 || static_cast<std::uint64_t>(*count) > most)
            fail(fmt::format("found {} as the count of element {}, expected 0 to {}",
                             quoted(words_[2]), boxwood::quoted(name), most));
        header_.elements.push_back({name, static_cast<std::size_t>(*count), header_.lines, {}});
        property_names_.clear();
    }

    void read_property() {
        if (header_.elements.empty()) fail("found a property, expected an element before it");
        PlyProperty property;
        property.line = header_.lines;
        property.is_list = words_.size() > 1 && words_[1] == "list";
        if (words_.size() != (property.is_list ? 5 : 3))
            fail(fmt::format("found {}, expected a property's {} and name", shown_line(),
                             property.is_list ? "two types" : "type"));
        property.type = read_type(words_[property.is_list ? 3 : 1]);
        if (property.is_list) {
            property.count_type = read_type(words_[2]);
            if (is_floating(property.count_type))
                fail(
                    fmt::format("found {} as the type of a list's count, expected a type of "
                                "whole numbers",
                                quoted(words_[2])));
        }
        property.name = words_.back();
        if (!property_names_.insert(property.name).second)
            fail(fmt::format("found the property {} again, expected it once",
                             boxwood::quoted(property.name)));
        header_.elements.back().properties.push_back(property);
    }

    PlyType read_type(std::string_view word) const {
        const auto type = type_of(word);
        if (!type) fail(fmt::format("found the type {}, expected one such as float", quoted(word)));
        return *type;
    }

    std::string name_;
    std::string_view text_;
    Limits limits_;
    std::size_t at_ = 0;
    std::string_view line_;
    std::vector<std::string_view> words_;
    std::unordered_set<std::string> element_names_, property_names_;
    PlyHeader header_;
};

}  // namespace

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        case PlyType::float64:
            return 8;
    }
    return 1;
}

bool PlyElement::has_lists() const {
    return std::any_of(properties.begin(), properties.end(),
                       [](const PlyProperty& property) { return property.is_list; });
}

std::size_t PlyElement::least_size() const {
    std::size_t sum = 0;
    for (const PlyProperty& property : properties)
        sum += size_of(property.is_list ? property.count_type : property.type);
    return sum;
}

PlyHeader read_ply_header(const MeshSource& source, const Limits& limits) {
    return PlyHeaderReader(source, limits).read();
}

}  // namespace boxwood
