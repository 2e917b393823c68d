// SPDX-License-Identifier: Apache-2.0
#include "boxwood/image/color_bar.h"

#include <array>
#include <string>
#include <string_view>

#include "boxwood/image/color_map.h"

namespace boxwood {

namespace {

constexpr int kDigitWidth = 3, kDigitHeight = 5, kDot = 2;
constexpr int kAdvance = (kDigitWidth + 1) * kDot;

/// Rows of three dots from the top.
constexpr std::array<std::string_view, 10> kDigits = {
    "####.##.##.####", ".#.##..#..#.###", "###..#####..###", "###..####..####", "#.##.####..#..#",
    "####..###..####", "####..####.####", "###..#..#..#..#", "####.#####.####", "####.####..####"};

void fill(ColorImage& image, int left, int top, int width, int height, const Vec3d& color) {
    for (int y = top; y < top + height; ++y) {
        for (int x = left; x < left + width; ++x) image.at(x, y) = color;
    }
}

void write_number(ColorImage& image, int right, int top, const std::string& digits) {
    int left = right - static_cast<int>(digits.size()) * kAdvance;
    fill(image, left - kDot, top - kDot, right - left + kDot, kDigitHeight * kDot + 2 * kDot,
         Vec3d::Zero());
    for (const char digit : digits) {
        const std::string_view dots = kDigits[digit - '0'];
        for (int i = 0; i < kDigitWidth * kDigitHeight; ++i) {
            if (dots[i] == '#')
                fill(image, left + i % kDigitWidth * kDot, top + i / kDigitWidth * kDot, kDot, kDot,
                     Vec3d::Ones());
        }
        left += kAdvance;
    }
}

}  // namespace

void draw_color_bar(ColorImage& image, int largest_value) {
    constexpr int kWidth = 12, kMargin = 12;
    const int height = image.height - 2 * kMargin;
    if (image.width < 160 || height < 80) return;

    const int left = image.width - kMargin - kWidth;
    fill(image, left - 2, kMargin - 2, kWidth + 4, height + 4, Vec3d::Zero());
    for (int y = 0; y < height; ++y)
        fill(image, left, kMargin + y, kWidth, 1, heat_color(1 - (y + 0.5) / height));

    const int right = left - 6;
    const int half_digit = kDigitHeight * kDot / 2;
    write_number(image, right, kMargin, std::to_string(largest_value));
    write_number(image, right, kMargin + height / 2 - half_digit,
                 std::to_string(largest_value / 2));
    write_number(image, right, kMargin + height - 2 * half_digit, "0");
}

}  // namespace boxwood
