#include "writers/gltf_frame.h"

#include <cmath>

namespace rad::writers::gltf {
namespace {

bool is_float(double value) { return static_cast<double>(static_cast<float>(value)) == value; }

}  // namespace

float Frame::offset(double position, int axis) const {
  const double difference = position - origin[axis];
  if (pitch == 0) return static_cast<float>(difference);
  // Far from zero the difference carries the rounding of the position.
  const double on_lattice = std::nearbyint(difference / pitch) * pitch;
  return static_cast<float>(origin[axis] + on_lattice == position ? on_lattice : difference);
}

Frame frame_of(const Output& output) {
  if (output.lattice) return {output.lattice->lattice.origin, output.lattice->lattice.pitch};
  geom::Box box;
  bool all_floats = true;
  for (const scene::VertexId id : output.scene.corners) {
    const geom::dvec3& position = output.scene.vertices[id];
    all_floats = all_floats && is_float(position.x) && is_float(position.y) && is_float(position.z);
    box.add(position);
  }
  if (all_floats) return {};
  return {geom::lattice_for(box).origin, 0};
}

}  // namespace rad::writers::gltf
