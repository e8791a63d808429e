// A conforming model as sheets: every triangle once, with the faces that show their front on each of its sides.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "validate/context.h"
#include "validate/violation.h"

namespace rad::validate {

/// Triangles that meet in common corners and edges only. Where two faces lie on each other back to back or front to
/// front, they are one sheet: on either side one sees one front, the way a solver sees them.
struct Sheets {
  std::vector<std::array<PointId, 3>> triangles;  ///< points of Context::model
  std::vector<std::array<FaceId, 2>> front;       ///< per triangle: the face whose front is on side 0 (where the normal
                                                  ///< points) and on side 1; kNoFace where one sees a back
  [[nodiscard]] std::size_t size() const { return triangles.size(); }
};

/// The sheets of a model in which nothing meets at the tolerance but in common vertices and edges, or as a whole. Then
/// all pairs of triangles are tested again without tolerance. Nothing where this does not hold.
std::optional<Sheets> conforming_sheets(const Context& context);

}  // namespace rad::validate
