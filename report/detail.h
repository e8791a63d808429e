// How much of findings a format shows: what it does not show need not be brought back from records.
#pragma once

#include <cstdint>

namespace rad::report {

/// Each with all before it.
enum class Detail : std::uint8_t {
  Findings,  ///< without their faces
  Faces,     ///< Where::faces
  Drawings,  ///< Where::face_ids, Where::places
};

}  // namespace rad::report
