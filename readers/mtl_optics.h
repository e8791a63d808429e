// What a material library says of mirrors, glass and pictures of light: all that a diffuse solution leaves out.
#pragma once

#include <optional>
#include <string_view>

#include "readers/text_cursor.h"
#include "scene/scene.h"

namespace rad::readers {

/// Collects the statements of one material. Nothing that is solved hangs on them, so that a value that is no number is
/// passed over without a word.
class MtlOptics {
 public:
  /// Reads Ks, d, Tr, map_d, map_Ke and illum, the keyword being read already; others are passed over.
  void read(std::string_view keyword, TextCursor& cursor);

  /// Puts what was read into the material; its emission must be known.
  void settle(scene::Material& material) const;

 private:
  geom::dvec3 specular_{0, 0, 0};
  std::optional<double> dissolve_;      ///< d: 1 is opaque
  std::optional<double> transparency_;  ///< Tr: 0 is opaque
  bool highlights_ = true;              ///< illum 0 and 1 have none, whatever Ks says
  bool picture_of_light_ = false;
  bool cut_out_ = false;
};

}  // namespace rad::readers
