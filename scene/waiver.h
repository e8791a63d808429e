// What an author asks not to be told of: in the model itself, in a file beside it, or in the configuration.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/name_patterns.h"
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
  Names,      ///< whose objects and materials fit `names`
};

/// Who says it.
enum class WaiverOrigin : std::uint8_t { Model, Sidecar, Configuration };

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
  NamePatterns names;
  WaiverOrigin origin = WaiverOrigin::Model;
};

/// Whether the waiver speaks of a face of the scene that it was read with. Not of scope Names: NamedFaces knows these.
bool covers(const Waiver& waiver, const Scene& scene, FaceId face);

/// Whether it speaks of a record that is no face, such as a vertex or a line that could not be read.
bool covers_record(const Waiver& waiver, const SourceRef& record);

std::string_view name(WaiverOrigin origin);  ///< "comment", "sidecar", "configuration"

}  // namespace rad::scene
