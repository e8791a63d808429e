#include "scene/attribute_writer.h"

#include <algorithm>

namespace rad::scene {

void AttributeWriter::add(std::span<const CornerValue> values) {
  const auto has_texture = [](const CornerValue& value) { return value.texture_coordinates.has_value(); };
  const auto has_normal = [](const CornerValue& value) { return value.normal.has_value(); };
  const bool textured = std::ranges::all_of(values, has_texture), shaded = std::ranges::all_of(values, has_normal);
  for (const CornerValue& value : values) {
    attributes_.texture_coordinates.row_of_corner.push_back(textured ? texture_rows_.row(*value.texture_coordinates)
                                                                     : kNoRow);
    attributes_.normals.row_of_corner.push_back(shaded ? normal_rows_.row(*value.normal) : kNoRow);
  }
}

void AttributeWriter::finish() {
  if (attributes_.texture_coordinates.table.empty()) attributes_.texture_coordinates.row_of_corner.clear();
  if (attributes_.normals.table.empty()) attributes_.normals.row_of_corner.clear();
}

}  // namespace rad::scene
