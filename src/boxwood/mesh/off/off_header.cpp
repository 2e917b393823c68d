// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/off/off_header.h"

#include <fmt/format.h>

#include "boxwood/core/error.h"

namespace boxwood {

namespace {

class HeaderReader {
public:
    HeaderReader(TextScanner& scanner, const std::string& file, const Limits& limits)
        : scanner_(scanner), file_(file), limits_(limits) {}

    OffHeader read() {
        scanner_.accept("\xEF\xBB\xBF");  // the byte order mark that some editors write
        if (!scanner_.find_word()) fail("the file is empty, expected the keyword OFF");
        read_keyword();
        if (header_.is_binary) {
            scanner_.finish_line();
            return header_;
        }
        if (header_.has_dimension) read_dimension();
        find_next("counts of vertices and faces");
        header_.line = scanner_.line();
        header_.vertices = read_count("vertices", limits_.max_vertices);
        header_.faces = read_count("faces", limits_.max_faces);
        // The count of edges, which nobody keeps right.
        while (!scanner_.at_end_of_line()) {
            if (!scanner_.number())
                fail(fmt::format("found {}, expected a number", quoted(scanner_.word())));
        }
        scanner_.finish_line();
        return header_;
    }

private:
    [[noreturn]] void fail(const std::string& message) const {
        throw ParseError(file_, scanner_.line(), message);
    }

    void read_keyword() {
        const std::string found = quoted(TextScanner(scanner_).word());
        for (bool goes_on = true; goes_on;) {
            goes_on = take("ST", header_.has_texture_coordinates) ||
                      take("C", header_.has_colors) || take("N", header_.has_normals);
        }
        take("4", header_.is_homogeneous);
        take("n", header_.has_dimension);
        // No look at what follows: in many files the first count does, without a blank.
        if (!scanner_.accept("OFF")) fail(fmt::format("found {}, expected the keyword OFF", found));
        header_.is_binary = !scanner_.at_end_of_line() && scanner_.accept("BINARY");
    }

    bool take(const char* prefix, bool& is_there) {
        if (!scanner_.accept(prefix)) return false;
        is_there = true;
        return true;
    }

    void find_next(const char* what) {
        if (!scanner_.at_end_of_line()) return;
        scanner_.finish_line();
        if (!scanner_.find_word()) fail(fmt::format("the file ends, expected the {}", what));
    }

    void read_dimension() {
        find_next("dimension");
        const std::string_view word = TextScanner(scanner_).word();
        if (scanner_.integer() != 3)
            fail(
                fmt::format("found {} as the dimension, expected 3, for vertices of three "
                            "coordinates",
                            quoted(word)));
    }

    std::size_t read_count(const char* what, std::uint64_t most) {
        const std::string_view word = TextScanner(scanner_).word();
        const auto count = scanner_.integer();
        if (!count || *count < 0 || static_cast<std::uint64_t>(*count) > most)
            fail(fmt::format("found {} as the count of {}, expected 0 to {}",
                             word.empty() ? "nothing" : quoted(word), what, most));
        return static_cast<std::size_t>(*count);
    }

    TextScanner& scanner_;
    const std::string& file_;
    const Limits& limits_;
    OffHeader header_;
};

}  // namespace

OffHeader read_off_header(TextScanner& scanner, const std::string& file, const Limits& limits) {
    return HeaderReader(scanner, file, limits).read();
}

}  // namespace boxwood
