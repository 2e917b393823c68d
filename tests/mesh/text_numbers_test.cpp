// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/text_numbers.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "cases.h"

namespace boxwood {
namespace {

using namespace std::string_view_literals;

/// Makes what looks like a number, often one at the edge of what is exact, and what may stand
/// behind it.
class Texts {
public:
    std::string next() {
        std::string text = one_in(3) ? "-" : "";
        text += one_in(4) ? kNearTheEdge[below(std::size(kNearTheEdge))] : digits(20);
        if (!one_in(4)) text.insert(below(text.size() + 1), one_in(8) ? ".." : ".");
        if (!one_in(3)) text += digits(one_in(3) ? 20 : 9);
        if (one_in(6)) text += any_of("eE") + any_of("+-0123456789") + digits(3);
        if (one_in(12)) text.insert(below(text.size() + 1), any_of("+-x/:#,ein"));
        return text + any_of(" \n\r#/;.\0"sv) + digits(9);
    }

private:
    std::size_t below(std::size_t count) { return engine_() % count; }
    bool one_in(std::size_t count) { return below(count) == 0; }
    std::string any_of(std::string_view choices) {
        return std::string(1, choices[below(choices.size())]);
    }
    std::string digits(std::size_t most) {
        std::string result;
        for (std::size_t i = below(most + 1); i > 0; --i) result += any_of("00123456789");
        return result;
    }

    static constexpr std::string_view kNearTheEdge[] = {"9007199254740991",
                                                        "9007199254740992",
                                                        "9007199254740993",
                                                        "16777215",
                                                        "16777216",
                                                        "16777217",
                                                        "9223372036854775807",
                                                        "9223372036854775808",
                                                        "18446744073709551616",
                                                        "999999999999999999",
                                                        "9999999999999999999",
                                                        "99999999999999999999"};
    std::mt19937_64 engine_{1};
};

/// As the library that the fast way stands before, which tells of less in newer versions.
std::from_chars_result expected_of(std::string_view text, auto& value) {
    const auto [end, error] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
    return {end, error == std::errc::result_out_of_range ? std::errc() : error};
}
std::from_chars_result expected_of(std::string_view text, std::int64_t& value) {
    return std::from_chars(text.data(), text.data() + text.size(), value);
}

template <class Value>
void expect_same(std::string_view text) {
    Value value = 0, expected_value = 0;
    const auto expected = expected_of(text, expected_value);
    const auto found = parse_text(text.data(), text.data() + text.size(), value);
    ASSERT_EQ(found.ec, expected.ec) << text;
    if (expected.ec != std::errc()) return;
    ASSERT_EQ(found.ptr, expected.ptr) << text;
    ASSERT_EQ(std::memcmp(&value, &expected_value, sizeof(Value)), 0)
        << text << ": " << value << ", expected " << expected_value;
}

TEST(TextNumbers, are_what_the_slow_way_reads_to_the_last_bit) {
    Texts texts;
    for (int i = 0; i < cases(2'000'000); ++i) {
        const std::string text = texts.next();
        expect_same<double>(text);
        expect_same<float>(text);
        expect_same<std::int64_t>(text);
        if (HasFatalFailure()) return;
    }
}

TEST(TextNumbers, end_with_the_text) {
    for (const std::string_view text : {"", "-", ".", "1", "1.", "-.5", "12345678", "0.12345678",
                                        "123456789012345678", "1234567890123456789"}) {
        for (std::size_t size = 0; size <= text.size(); ++size) {
            // In memory of its own, so that a sanitizer sees who reads on.
            const std::vector<char> bytes(text.begin(), text.begin() + size);
            expect_same<double>({bytes.data(), size});
            expect_same<std::int64_t>({bytes.data(), size});
        }
    }
}

TEST(TextNumbers, plain_lines_are_parted_by_single_spaces_and_end) {
    const auto read = [](std::string_view text) {
        double values[2] = {};
        const char* end = parse_plain_line(text.data(), text.data() + text.size(), values, 2);
        return end ? std::to_string(end - text.data()) + ": " + std::to_string(values[0]) + ", " +
                         std::to_string(values[1])
                   : "no";
    };
    EXPECT_EQ(read("1 -2.5\n3"), "6: 1.000000, -2.500000");
    EXPECT_EQ(read("1e1 2\r\n"), "6: 10.000000, 2.000000");
    EXPECT_EQ(read("1 2 \n"), "4: 1.000000, 2.000000");
    EXPECT_EQ(read("1 2 \r\n"), "5: 1.000000, 2.000000");
    for (const std::string_view text :
         {"1 2", "1 2\r", "1 2\r \n", "1  2\n", " 1 2\n", "1 2  \n", "1 2 3\n", "1\n2\n", "1 +2\n",
          "1 2#\n", "1 x\n", "", "1", "1 "})
        EXPECT_EQ(read(text), "no") << text;
}

}  // namespace
}  // namespace boxwood
