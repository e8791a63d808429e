// Fills what the corners of a scene have, face by face.
#pragma once

#include <span>

#include "scene/attribute_transfer.h"
#include "scene/corner_rows.h"

namespace rad::scene {

class AttributeWriter {
 public:
  /// `attributes` are those of a scene whose faces are added in their order, all of them.
  AttributeWriter(CornerAttributes& attributes, TextureOrigin origin)
      : attributes_(attributes),
        texture_rows_(attributes.texture_coordinates.table),
        normal_rows_(attributes.normals.table) {
    attributes.texture_origin = origin;
  }

  /// The values at all corners of the next face. What not every corner has, none gets.
  void add(std::span<const CornerValue> values);

  /// To be called after the last face: nothing stays where no face had anything.
  void finish();

 private:
  CornerAttributes& attributes_;
  CornerRows<dvec2> texture_rows_;
  CornerRows<dvec3> normal_rows_;
};

}  // namespace rad::scene
