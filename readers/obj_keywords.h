// The statements of OBJ and what this reader does with each.
#pragma once

#include <cstdint>
#include <string_view>

namespace rad::readers {

enum class ObjStatement : std::uint8_t {
  Vertex,
  TextureCoordinates,
  Normal,
  Face,
  SmoothingGroup,
  Object,
  Group,
  UseMaterial,
  MaterialLibrary,
  Harmless,     ///< shapes no surface: display attributes, parts of curves
  Unsupported,  ///< shapes something that is left out
  Unknown,
};

struct ObjKeyword {
  std::string_view keyword;
  ObjStatement statement = ObjStatement::Unknown;
  std::string_view what;  ///< of unsupported ones, in words
};

/// The entry of a keyword; one of statement Unknown where it is none of OBJ.
const ObjKeyword& obj_keyword(std::string_view keyword);

}  // namespace rad::readers
