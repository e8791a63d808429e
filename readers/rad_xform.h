// Arguments of xform, the program that places Radiance scene files: names, a modifier, transformations and arrays.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rad::readers::radiance {

/// One copy of what an xform places.
struct PlacedCopy {
  glm::dmat4 matrix{1.0};
  std::string prefix;  ///< of identifiers, with a dot at its end; empty for none
};

struct Xform {
  std::vector<PlacedCopy> copies;
  std::string modifier;            ///< of all surfaces; empty where they keep theirs
  bool inverted = false;           ///< surfaces look the other way
  std::vector<std::string> files;  ///< what is placed; none where it comes through a pipe
  std::string problem;             ///< why the arguments cannot be followed, as a clause; then the rest means nothing
};

/// Follows the words after "xform" as its manual describes them. At most `limit` copies.
Xform parse_xform(std::span<const std::string> words, std::uint64_t limit);

}  // namespace rad::readers::radiance
