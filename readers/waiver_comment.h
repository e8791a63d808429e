// Comments that speak to radlint: "# radlint: ignore[RL221, t-vertex] reason".
#pragma once

#include <optional>
#include <string_view>

#include "scene/waiver.h"

namespace rad::readers {

struct WaiverComment {
  scene::Waiver waiver;     ///< place and scope are for the reader to fill in
  bool whole_file = false;  ///< ignore-file
};

/// What a comment (with or without its '#') asks; nothing where it does not begin with "radlint:". One that does and
/// cannot be understood has a fault.
std::optional<WaiverComment> waiver_of_comment(std::string_view comment);

}  // namespace rad::readers
