// Parts: what holds together by edges that are the same on the lattice, whatever the tolerance. A pane thinner than T
// is still one closed part here, where Topology no longer sees its rim.
#pragma once

#include <cstdint>
#include <vector>

#include "validate/context.h"

namespace rad::validate {

struct Parts {
  std::vector<FaceId> part_of_face;  ///< smallest face of the part
  std::vector<bool> open;            ///< per face that names a part: some edge is not used as often each way

  /// Whether a and b belong to one part, or to open parts that hang together at T (Topology::components).
  [[nodiscard]] bool together(const Topology& topology, FaceId a, FaceId b) const;
};

/// Parts of all faces without lost corners, those without area too. Faces hang together over an edge that two of them
/// use; over one that more use, where they are of one named object. O(n log n), parallel.
Parts find_parts(const Context& context);

}  // namespace rad::validate
