#include "bake/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "scene/display_curve.h"

namespace rad::bake {
namespace {

using geom::dvec3;

constexpr std::uint32_t kMargin = 20, kBarWidth = 18, kLetterWidth = 6, kLetterHeight = 7, kZoom = 2, kPad = 10;
constexpr std::uint32_t kSteps = 4;  // between numbers
constexpr std::uint32_t kLongest = 7;
constexpr dvec3 kPaper{0.02, 0.02, 0.02}, kInk{0.85, 0.85, 0.85};

/// Letters of five by seven; bit 4 of a row is its left pixel.
struct Letter {
  char letter;
  std::array<std::uint8_t, 7> rows;
};
constexpr std::array<Letter, 17> kLetters{{{'0', {14, 17, 19, 21, 25, 17, 14}},
                                           {'1', {4, 12, 4, 4, 4, 4, 14}},
                                           {'2', {14, 17, 1, 2, 4, 8, 31}},
                                           {'3', {31, 2, 4, 2, 1, 17, 14}},
                                           {'4', {2, 6, 10, 18, 31, 2, 2}},
                                           {'5', {31, 16, 30, 1, 1, 17, 14}},
                                           {'6', {6, 8, 16, 30, 17, 17, 14}},
                                           {'7', {31, 1, 2, 4, 8, 8, 8}},
                                           {'8', {14, 17, 17, 14, 17, 17, 14}},
                                           {'9', {14, 17, 17, 15, 1, 2, 12}},
                                           {'.', {0, 0, 0, 0, 0, 12, 12}},
                                           {'-', {0, 0, 0, 31, 0, 0, 0}},
                                           {'+', {0, 4, 4, 31, 4, 4, 0}},
                                           {'e', {0, 0, 14, 17, 31, 16, 14}},
                                           {'W', {17, 17, 17, 21, 21, 21, 10}},
                                           {'/', {0, 1, 2, 4, 8, 16, 0}},
                                           {'m', {0, 0, 26, 21, 21, 17, 17}}}};

class Drawing {
 public:
  explicit Drawing(Image& image) : image_(image) {}

  void fill(std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height, const dvec3& colour) {
    for (std::uint32_t row = y; row < y + height; ++row) {
      for (std::uint32_t column = x; column < x + width; ++column) {
        image_.pixels[std::size_t{row} * image_.width + column] = colour;
      }
    }
  }

  void write(std::uint32_t x, std::uint32_t y, std::string_view text) {
    for (const char c : text) {
      for (const Letter& letter : kLetters) {
        if (letter.letter == c) draw(letter, x, y);
      }
      x += kLetterWidth * kZoom;
    }
  }

 private:
  void draw(const Letter& letter, std::uint32_t x, std::uint32_t y) {
    for (std::uint32_t row = 0; row < kLetterHeight; ++row) {
      for (std::uint32_t column = 0; column < 5; ++column) {
        if ((letter.rows[row] >> (4 - column) & 1U) == 0) continue;
        fill(x + column * kZoom, y + row * kZoom, kZoom, kZoom, kInk);
      }
    }
  }

  Image& image_;
};

}  // namespace

double round_above(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0}) {
    // Rounding of the power must not take 2 to 5.
    if (value <= step * power * (1 + 1e-12)) return step * power;
  }
  return 10 * power;
}

Image with_legend(const Image& image, double most) {
  const std::uint32_t line = kLetterHeight * kZoom, above = kMargin + 2 * line;
  if (image.height < above + 2 * kSteps * line + kMargin) return image;
  const std::uint32_t strip = kMargin + kBarWidth + kPad + kLongest * kLetterWidth * kZoom,
                      bar = image.height - above - kMargin;
  Image result{image.width + strip, image.height, {}};
  result.pixels.assign(std::size_t{result.width} * result.height, kPaper);
  for (std::uint32_t row = 0; row < image.height; ++row) {
    std::copy_n(&image.pixels[std::size_t{row} * image.width], image.width,
                &result.pixels[std::size_t{row} * result.width + strip]);
  }
  Drawing drawing(result);
  drawing.write(kMargin, kMargin, "W/m2");
  for (std::uint32_t row = 0; row < bar; ++row) {
    drawing.fill(kMargin, above + row, kBarWidth, 1, scene::false_colour(1 - (row + 0.5) / bar));
  }
  for (std::uint32_t step = 0; step <= kSteps; ++step) {
    const std::uint32_t y = above + step * (bar - 1) / kSteps;
    const double value = most * (1 - static_cast<double>(step) / kSteps);
    drawing.fill(kMargin + kBarWidth, y, kPad / 2, 1, kInk);
    drawing.write(kMargin + kBarWidth + kPad, y - line / 2, fmt::format("{:.4g}", value));
  }
  return result;
}

}  // namespace rad::bake
