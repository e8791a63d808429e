// What the float positions of a written glTF document are relative to.
#pragma once

#include "writers/model.h"

namespace rad::writers::gltf {

/// origin + offset is the position, offset a float.
struct Frame {
  geom::dvec3 origin{0, 0, 0};
  double pitch = 0;  ///< of the lattice; 0 without one

  /// The offset along one axis. A position of the lattice gives its whole number of pitches, exactly.
  [[nodiscard]] float offset(double position, int axis) const;
};

/// The frame of the lattice that the output records. Without one: zero where every position of a corner is a float,
/// else the origin that lattice_for gives the box of the corners.
Frame frame_of(const Output& output);

}  // namespace rad::writers::gltf
