// What the author of a file asks not to be told of, as the file itself says it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/read_issue.h"
#include "scene/scene.h"

namespace rad::scene {

/// Which faces a waiver speaks of.
enum class WaiverScope : std::uint8_t {
  File,
  Records,    ///< of `section`, from `first` to `last`
  Object,     ///< `id`
  Material,   ///< `id`
  Primitive,  ///< whose section has `pointer`, or one that begins with it and a slash
};

struct Waiver {
  std::vector<std::string> rules;  ///< ids, aliases or prefixes, as written
  std::string reason;
  std::string fault;  ///< why it cannot be understood; then it is of no effect
  IssuePlace place;   ///< where it stands
  WaiverScope scope = WaiverScope::File;
  std::uint32_t section = 0;
  std::uint64_t first = 0, last = 0;
  std::uint32_t id = 0;
  std::string pointer;
};

/// Whether the waiver speaks of a face of the scene that it was read with.
bool covers(const Waiver& waiver, const Scene& scene, FaceId face);

}  // namespace rad::scene
