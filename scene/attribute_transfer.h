// Texture coordinates and normals of the input, carried over to the corners of a repaired model.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "scene/conforming_model.h"
#include "scene/scene.h"

namespace rad::scene {

/// What one corner of a triangle has.
struct CornerValue {
  std::optional<dvec2> texture_coordinates;
  std::optional<dvec3> normal;
  bool kept = false;  ///< it is a corner of the source face: the values are that corner's, to the bit
};

/// Values at the corners of the triangles of a model, each from the face that the triangle came from.
///
/// A corner of the source face goes to the point of its triangles that is nearest to it, if that is within the
/// distance that a vertex may move, and its values go with it as they are. At all other points the values are those of
/// the source face at its nearest place. Normals are of unit length there; where the triangle looks the other way than
/// its source they are turned. Nothing where the model does not say what its triangles came
/// from.
class AttributeTransfer {
 public:
  /// `model` was made from `origin`. Both must outlive this.
  AttributeTransfer(const ConformingModel& model, const Scene& origin);

  /// Of corner 0, 1 or 2 of a triangle of the model.
  [[nodiscard]] CornerValue value(std::size_t triangle, std::size_t corner) const;

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  void transfer_face(const Face& face, std::span<const std::uint32_t> triangles);

  const ConformingModel& model_;
  const Scene& origin_;
  std::vector<dvec2> texture_coordinates_;  ///< three for each triangle; NaN for none; empty where no face has any
  std::vector<dvec3> normals_;              ///< likewise
  std::vector<bool> kept_;                  ///< likewise, never empty
};

}  // namespace rad::scene
