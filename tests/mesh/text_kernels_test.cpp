// SPDX-License-Identifier: Apache-2.0
// Lines are read as plain ones only if they are, and then as the C library reads their numbers, by
// each instruction set, wherever in memory they lie.
#include "boxwood/mesh/text_kernels/text_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "boxwood/mesh/plain_lines.h"

namespace boxwood {

static void PrintTo(const Named<InstructionSet>& set, std::ostream* out) { *out << set.name; }

namespace {

/// Makes lines as most programs write them, and, one in a few, such as nobody writes.
class Lines {
public:
    explicit Lines(unsigned seed) : engine_(seed) {}

    std::size_t below(std::size_t count) { return engine_() % count; }
    bool one_in(std::size_t count) { return below(count) == 0; }

    std::string digits(std::size_t most) {
        std::string result;
        for (std::size_t i = 1 + below(most); i > 0; --i)
            result += static_cast<char>('0' + below(10));
        return result;
    }
    /// At most 15 digits, so that all of them are exact.
    std::string number() {
        std::string result = one_in(2) ? "-" : "";
        result += digits(one_in(4) ? 15 : 7);
        if (!one_in(4))
            result.insert(
                result.size() - below(result[0] == '-' ? result.size() : result.size() + 1), ".");
        return result;
    }
    std::string unusual_number() {
        if (one_in(4)) return number() + (one_in(2) ? "e" : "E-") + digits(3);
        static constexpr const char* kNumbers[] = {"9007199254740991",
                                                   "9007199254740992",
                                                   "9007199254740993",
                                                   "-12345678901234567890",
                                                   "0.12345678901234567",
                                                   "9999999999999999",
                                                   "1.5e308",
                                                   "-1e39",
                                                   "inf",
                                                   "nan",
                                                   "1e400",
                                                   "0.0000000000000000000000001",
                                                   "100000000000000000000000000000000000.0"};
        return kNumbers[below(std::size(kNumbers))];
    }
    std::string end() { return std::string(one_in(8) ? " " : "") + (one_in(8) ? "\r\n" : "\n"); }
    /// Something in it replaced, left out or put in.
    std::string damaged(std::string line) {
        const char other = one_in(2) ? "0. -+\n\r\t#e"[below(10)] : static_cast<char>(below(256));
        const std::size_t place = below(line.size());
        const std::size_t way = below(3);
        if (way == 0) line[place] = other;
        if (way == 1) line.erase(place, 1);
        if (way == 2) line.insert(place, 1, other);
        return line;
    }

private:
    std::mt19937 engine_;
};

/// The line's numbers, if it is plain: by what plain_lines.h says, word by word.
std::optional<std::vector<std::string>> plain_words(std::string_view line,
                                                    std::string_view prefix) {
    if (!line.starts_with(prefix) || !line.ends_with('\n')) return std::nullopt;
    line.remove_prefix(prefix.size());
    line.remove_suffix(1);
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.ends_with(' ')) line.remove_suffix(1);
    std::vector<std::string> words(1);
    for (const char c : line) {
        if (c == ' ')
            words.emplace_back();
        else
            words.back() += c;
    }
    return words;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n') + 1); }

/// The number as the C library reads it, from a word that is a number and nothing else.
std::optional<double> number_of(const std::string& word) {
    if (word.empty() || word[0] == '+' || std::isspace(static_cast<unsigned char>(word[0])) ||
        word.find_first_of("xX()") != word.npos)
        return std::nullopt;
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (end != word.c_str() + word.size() || !(std::abs(value) <= FLT_MAX)) return std::nullopt;
    return value;
}

std::optional<std::uint32_t> index_of(const std::string& word, std::uint32_t first,
                                      std::uint32_t count) {
    if (word.empty() || word.find_first_not_of("0123456789") != word.npos) return std::nullopt;
    const unsigned long long value = std::strtoull(word.c_str(), nullptr, 10);
    if (value < first || value - first >= count) return std::nullopt;
    return static_cast<std::uint32_t>(value - first);
}

/// A line with what the kernels want to see around it, or a few characters less, and not one more,
/// so that a sanitizer sees who looks farther.
class Framed {
public:
    explicit Framed(const std::string& line, std::ptrdiff_t missing_in_front = 0,
                    std::ptrdiff_t missing_behind = 0) {
        const auto size = static_cast<std::ptrdiff_t>(line.size());
        const std::ptrdiff_t before = kTextBehind - missing_in_front;
        bytes_.assign(
            static_cast<std::size_t>(before + std::max(size, kTextAhead) - missing_behind), '7');
        std::copy_n(line.begin(), std::min(size, std::ssize(bytes_) - before),
                    bytes_.begin() + before);
        start_ = bytes_.data() + before;
        text_ = {bytes_.data(), start_, bytes_.data() + bytes_.size()};
    }
    PlainText& text() { return text_; }
    std::size_t read() const { return static_cast<std::size_t>(text_.at - start_); }

private:
    std::vector<char> bytes_;
    const char* start_ = nullptr;
    PlainText text_ = {};
};

/// The words of the one line that was read, empty if it isn't plain. Damage may have put another
/// line's end into the text.
std::vector<std::string> words_read(const std::string& text, const Framed& framed,
                                    std::string_view prefix) {
    const std::string line = text.substr(0, framed.read());
    EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
    const auto words = plain_words(line, prefix);
    EXPECT_TRUE(words);
    return words.value_or(std::vector<std::string>());
}

class TextKernelsTest : public testing::TestWithParam<Named<InstructionSet>> {
protected:
    void SetUp() override {
        if (!is_supported(GetParam().value)) GTEST_SKIP() << "not on this machine";
    }
    const TextKernels& kernels() const { return text_kernels(GetParam().value); }
};

bool are_same(double a, double b) { return std::memcmp(&a, &b, sizeof(a)) == 0; }

TEST_P(TextKernelsTest, rows_are_read_as_the_library_reads_their_words) {
    Lines lines(1);
    std::size_t plain = 0, not_plain = 0;
    for (int i = 0; i < 60000; ++i) {
        const std::string prefix = i % 3 == 0 ? "" : i % 3 == 1 ? "v " : "vertex ";
        const std::size_t columns = i % 2 == 0 ? 3 : 1 + lines.below(7);
        std::string line = prefix;
        if (lines.one_in(4)) line += std::string(1 + lines.below(8 - prefix.size()), ' ');
        bool is_usual = true;
        for (std::size_t k = 0; k < columns; ++k) {
            const bool is_usual_number = !lines.one_in(24);
            is_usual = is_usual && is_usual_number;
            line +=
                (k > 0 ? " " : "") + (is_usual_number ? lines.number() : lines.unusual_number());
        }
        line += lines.end();
        const bool is_damaged = lines.one_in(3);
        if (is_damaged) line = lines.damaged(line);
        SCOPED_TRACE(line);

        Framed framed(line);
        const LinePrefix line_prefix = i % 3 == 0   ? LinePrefix()
                                       : i % 3 == 1 ? LinePrefix("v ")
                                                    : LinePrefix("vertex ");
        std::vector<double> numbers(columns, -1);
        const std::size_t count =
            kernels().read_rows(framed.text(), line_prefix, columns, numbers.data(), 1);
        if (count == 0) {
            EXPECT_EQ(framed.read(), 0U);
            EXPECT_TRUE(is_damaged || !is_usual);
            ++not_plain;
            continue;
        }
        ++plain;
        const std::vector<std::string> words = words_read(line, framed, prefix);
        ASSERT_EQ(words.size(), columns);
        for (std::size_t k = 0; k < columns; ++k) {
            const auto number = number_of(words[k]);
            ASSERT_TRUE(number);
            EXPECT_TRUE(are_same(numbers[k], *number)) << numbers[k] << " for " << words[k];
        }
    }
    EXPECT_GT(plain, 40000U);
    EXPECT_GT(not_plain, 4000U);
}

TEST_P(TextKernelsTest, triangles_are_read_as_the_library_reads_their_words) {
    Lines lines(2);
    std::size_t plain = 0, not_plain = 0;
    for (int i = 0; i < 60000; ++i) {
        const bool is_obj = i % 2 == 0;
        const std::uint32_t first = is_obj ? 1 : 0;
        const std::uint32_t count = i % 3 == 0 ? 100 : i % 3 == 1 ? 90000000 : 4000000000U;
        std::string line = is_obj ? "f " : "3 ";
        if (lines.one_in(4)) line += std::string(1 + lines.below(6), ' ');
        bool is_index = true;
        for (int k = 0; k < 3; ++k) {
            const std::string word = lines.digits(lines.one_in(8) ? 10 : i % 3 == 0 ? 2 : 8);
            is_index = is_index && word.size() <= 8 && index_of(word, first, count);
            line += (k > 0 ? " " : "") + word;
        }
        line += lines.end();
        const bool is_damaged = lines.one_in(3);
        if (is_damaged) line = lines.damaged(line);
        SCOPED_TRACE(line);

        Framed framed(line);
        int indices[3] = {-1, -1, -1};
        if (kernels().read_triangles(framed.text(), is_obj ? LinePrefix("f ") : LinePrefix("3 "),
                                     first, count, indices, 1) == 0) {
            EXPECT_EQ(framed.read(), 0U);
            EXPECT_TRUE(is_damaged || !is_index);
            ++not_plain;
            continue;
        }
        ++plain;
        const std::vector<std::string> words = words_read(line, framed, is_obj ? "f " : "3 ");
        ASSERT_EQ(words.size(), 3U);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto index = index_of(words[k], first, count);
            ASSERT_TRUE(index);
            EXPECT_EQ(indices[k], static_cast<int>(*index));
        }
    }
    EXPECT_GT(plain, 30000U);
    EXPECT_GT(not_plain, 8000U);
}

TEST_P(TextKernelsTest, any_character_in_any_place_is_seen_for_what_it_is) {
    const std::string row = "-1.5 20.25 0.125\n", triangle = "3 12 34567 8\n";
    for (std::size_t place = 0; place < row.size(); ++place) {
        for (int c = 0; c < 256; ++c) {
            std::string line = row;
            line[place] = static_cast<char>(c);
            Framed framed(line);
            double numbers[3];
            const bool is_read = kernels().read_rows(framed.text(), LinePrefix(), 3, numbers, 1);
            const auto words = plain_words(first_line(line), "");
            const bool is_plain = words && words->size() == 3 &&
                                  std::all_of(words->begin(), words->end(), [](const auto& word) {
                                      return number_of(word).has_value();
                                  });
            EXPECT_EQ(is_read, is_plain) << place << ", " << c;
        }
    }
    for (std::size_t place = 0; place < triangle.size(); ++place) {
        for (int c = 0; c < 256; ++c) {
            std::string line = triangle;
            line[place] = static_cast<char>(c);
            Framed framed(line);
            int indices[3];
            const bool is_read =
                kernels().read_triangles(framed.text(), LinePrefix("3 "), 0, 1000000, indices, 1);
            const auto words = plain_words(first_line(line), "3 ");
            const bool is_plain = words && words->size() == 3 &&
                                  std::all_of(words->begin(), words->end(), [](const auto& word) {
                                      return index_of(word, 0, 1000000).has_value();
                                  });
            EXPECT_EQ(is_read, is_plain) << place << ", " << c;
        }
    }
}

TEST_P(TextKernelsTest, lines_with_too_little_around_them_are_left_alone) {
    double numbers[3];
    int indices[3];
    for (const int in_front : {0, 1, 5, 16}) {
        for (const int behind : {0, 1, 5, 40}) {
            Framed row("1 2 3\n", in_front, behind);
            const std::size_t expected = in_front + behind == 0 ? 1 : 0;
            EXPECT_EQ(kernels().read_rows(row.text(), LinePrefix(), 3, numbers, 1), expected);
            Framed face("3 1 2 3\n", in_front, behind);
            EXPECT_EQ(kernels().read_triangles(face.text(), LinePrefix("3 "), 0, 9, indices, 1),
                      expected);
        }
    }
}

TEST_P(TextKernelsTest, lines_are_counted) {
    std::mt19937 engine(3);
    for (int i = 0; i < 3000; ++i) {
        std::string text;
        for (std::size_t size = engine() % 400; text.size() < size;)
            text += engine() % 4 != 0 ? "\n #!\r3a\t"[engine() % 8] : static_cast<char>(engine());
        std::size_t line_ends = 0, doubtful = 0;
        for (std::size_t k = 0; k < text.size(); ++k) {
            line_ends += text[k] == '\n';
            doubtful += k > 0 && text[k - 1] == '\n' &&
                        (static_cast<unsigned char>(text[k]) <= ' ' || text[k] == '#');
        }
        const std::vector<char> exact(text.begin(), text.end());
        const LineCounts counts = kernels().count_lines(exact.data(), exact.data() + exact.size());
        EXPECT_EQ(counts.line_ends, line_ends);
        EXPECT_EQ(counts.doubtful, doubtful);
    }
}

INSTANTIATE_TEST_SUITE_P(All, TextKernelsTest, testing::ValuesIn(instruction_sets()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(PlainRows, are_read_up_to_both_ends_of_a_text) {
    Lines lines(4);
    for (int i = 0; i < 3000; ++i) {
        std::string text, triangles;
        std::vector<double> expected;
        std::vector<int> corners;
        const std::size_t count = lines.below(8);
        for (std::size_t k = 0; k < count; ++k) {
            for (int c = 0; c < 3; ++c) {
                const std::string number = lines.number(), index = lines.digits(i % 2 == 0 ? 1 : 5);
                text += (c > 0 ? " " : "") + number;
                triangles += (c > 0 ? " " : "3 ") + index;
                expected.push_back(std::strtod(number.c_str(), nullptr));
                corners.push_back(std::atoi(index.c_str()));
            }
            text += "\n";
            triangles += "\n";
        }
        const std::vector<char> exact(text.begin(), text.end());
        PlainText rows = {exact.data(), exact.data(), exact.data() + exact.size()};
        std::vector<double> numbers(3 * count + 1, -1);
        ASSERT_EQ(read_plain_rows(rows, LinePrefix(), 3, numbers.data(), count + 1), count) << text;
        EXPECT_EQ(rows.at, rows.end);
        numbers.pop_back();
        EXPECT_EQ(numbers, expected);

        const std::vector<char> exact_triangles(triangles.begin(), triangles.end());
        PlainText faces = {exact_triangles.data(), exact_triangles.data(),
                           exact_triangles.data() + exact_triangles.size()};
        std::vector<int> indices(3 * count);
        // No more are read than are asked for.
        const std::size_t most = count - (count > 0 && lines.one_in(2));
        ASSERT_EQ(read_plain_triangles(faces, LinePrefix("3 "), 0, 100000, indices.data(), most),
                  most)
            << triangles;
        indices.resize(3 * most);
        corners.resize(3 * most);
        EXPECT_EQ(indices, corners);
    }
}

}  // namespace
}  // namespace boxwood
