#include "readers/mtl_optics.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rad::readers {
namespace {

using Token = TextCursor::Token;

// Between 0 and 1.
std::optional<double> share(TextCursor& cursor) {
  double value = 0;
  if (cursor.next_number(value) != Token::Good || !std::isfinite(value)) return std::nullopt;
  return std::clamp(value, 0.0, 1.0);
}

// One number stands for all three.
geom::dvec3 colour(TextCursor& cursor) {
  std::array<double, 3> parts{};
  std::size_t count = 0;
  while (count < 3 && cursor.next_number(parts[count]) == Token::Good && std::isfinite(parts[count])) ++count;
  if (count == 1) return geom::dvec3(parts[0]);
  return count == 3 ? geom::dvec3(parts[0], parts[1], parts[2]) : geom::dvec3(0);
}

}  // namespace

void MtlOptics::read(std::string_view keyword, TextCursor& cursor) {
  if (keyword == "Ks") specular_ = colour(cursor);
  if (keyword == "d") dissolve_ = share(cursor);
  if (keyword == "Tr") transparency_ = share(cursor);
  if (keyword == "map_d") cut_out_ = true;
  if (keyword == "map_Ke") picture_of_light_ = true;
  std::int64_t model = 0;
  if (keyword == "illum" && cursor.next_integer(model) == Token::Good) highlights_ = model >= 2;
}

void MtlOptics::settle(scene::Material& material) const {
  if (highlights_) material.specular = specular_;
  // "Tr 1" alone is written by programs that mean opaque by it: nobody exports what cannot be seen at all.
  const bool says_nothing = !transparency_ || *transparency_ == 1;
  material.opacity = dissolve_.value_or(says_nothing ? 1 : 1 - *transparency_);
  material.cut_out = cut_out_;
  material.emission_cancelled = picture_of_light_ && !material.emits();
}

}  // namespace rad::readers
