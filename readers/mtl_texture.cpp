#include "readers/mtl_texture.h"

#include <array>
#include <cmath>
#include <utility>

namespace rad::readers {
namespace {

constexpr std::uint32_t kClampToEdge = 33071;

/// Options with a fixed number of words after them.
constexpr std::array<std::pair<std::string_view, int>, 9> kPassedOver = {{{"-blendu", 1},
                                                                          {"-blendv", 1},
                                                                          {"-boost", 1},
                                                                          {"-mm", 2},
                                                                          {"-texres", 1},
                                                                          {"-bm", 1},
                                                                          {"-imfchan", 1},
                                                                          {"-type", 1},
                                                                          {"-cc", 1}}};

/// Steps over one to three numbers; of a pair the first two count.
scene::dvec2 take_numbers(TextCursor& cursor, double otherwise) {
  scene::dvec2 value(otherwise);
  for (int i = 0; i < 3; ++i) {
    TextCursor ahead = cursor;
    double number = 0;
    if (ahead.next_number(number) != TextCursor::Token::Good) break;
    cursor = ahead;
    if (i < 2 && std::isfinite(number)) value[i] = number;
  }
  return value;
}

/// The origin of MTL is at the lower left, that of a TextureTransform at the upper left: v there is 1 - v here.
std::optional<scene::TextureTransform> transform_of(const scene::dvec2& offset, const scene::dvec2& scale) {
  if (offset == scene::dvec2(0) && scale == scene::dvec2(1)) return std::nullopt;
  return scene::TextureTransform{{offset.x, 1 - scale.y - offset.y}, 0, scale};
}

}  // namespace

std::optional<scene::Texture> mtl_texture(TextCursor cursor) {
  scene::Texture texture;
  scene::dvec2 offset(0), scale(1);
  while (true) {
    TextCursor ahead = cursor;
    const std::string_view word = ahead.next_token();
    if (word == "-o") {
      offset = take_numbers(ahead, 0);
    } else if (word == "-s") {
      scale = take_numbers(ahead, 1);
    } else if (word == "-t") {
      take_numbers(ahead, 0);
    } else if (word == "-clamp") {
      if (ahead.next_token() == "on") texture.sampling.wrap_s = texture.sampling.wrap_t = kClampToEdge;
    } else {
      int words = 0;
      for (const auto& [option, count] : kPassedOver) words = option == word ? count : words;
      if (words == 0) break;
      for (int i = 0; i < words; ++i) ahead.next_token();
    }
    cursor = ahead;
  }
  auto image = std::make_shared<scene::Image>();
  image->path = cursor.rest();
  if (image->path.empty()) return std::nullopt;
  texture.image = std::move(image);
  texture.transform = transform_of(offset, scale);
  return texture;
}

}  // namespace rad::readers
