#include "writers/gltf_frame.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rad::writers::gltf {
namespace {

// Whether single precision holds the value as a normal number or zero. Asked of the bits: GCC 12 drops a conversion to
// float and back when it vectorises a loop.
bool is_float(double value) {
  constexpr std::uint64_t kBitsBeyondFloat = (std::uint64_t{1} << (52 - 23)) - 1;
  const double magnitude = std::abs(value);
  const bool in_range =
      magnitude >= std::numeric_limits<float>::min() && magnitude <= std::numeric_limits<float>::max();
  return value == 0 || (in_range && (std::bit_cast<std::uint64_t>(value) & kBitsBeyondFloat) == 0);
}

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
