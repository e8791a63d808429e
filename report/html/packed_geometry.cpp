#include "report/html/packed_geometry.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <new>
#include <vector>

namespace rad::report::html {
namespace {

using scene::VertexId;

class NumberWriter {
 public:
  void add(std::uint64_t number) {
    for (; number >= 0x80U; number >>= 7U) bytes_ += static_cast<char>(0x80U | (number & 0x7FU));
    bytes_ += static_cast<char>(number);
  }
  void add_difference(std::int64_t number) {
    const std::int64_t difference = number - last_;
    last_ = number;
    add(difference < 0 ? 2 * static_cast<std::uint64_t>(-difference) - 1 : 2 * static_cast<std::uint64_t>(difference));
  }
  void restart() { last_ = 0; }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::int64_t last_ = 0;
};

constexpr std::uint32_t kUnused = 0xffffffffU;

struct UsedVertices {
  std::vector<VertexId> order;
  std::vector<std::uint32_t> number;  ///< by vertex of the scene
};

UsedVertices used_vertices(std::size_t vertices, std::span<const bake::DrawnTriangle> triangles) {
  UsedVertices used{{}, std::vector<std::uint32_t>(vertices, kUnused)};
  for (const bake::DrawnTriangle& triangle : triangles) {
    for (const VertexId id : triangle.corners) {
      if (used.number[id] != kUnused) continue;
      used.number[id] = static_cast<std::uint32_t>(used.order.size());
      used.order.push_back(id);
    }
  }
  return used;
}

// Of a value from 0 to 1; what is below the least normal half is shown as 0.
std::uint32_t half_bits(double value) {
  constexpr std::uint32_t kRebias = (127 - 15) << 10U;
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  const std::uint32_t rounded = (bits + (1U << 12U)) >> 13U;
  return rounded >= kRebias + (1U << 10U) ? rounded - kRebias : 0;
}

}  // namespace

std::string compressed(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  const int code = compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                             bytes.size(), Z_BEST_COMPRESSION);
  if (code != Z_OK) throw std::bad_alloc();
  out.resize(size);
  return out;
}

PackedGeometry packed(const scene::Scene& scene, std::span<const bake::DrawnTriangle> triangles) {
  const UsedVertices used = used_vertices(scene.vertices.size(), triangles);
  geom::Box box;
  for (const VertexId id : used.order) box.add(scene.vertices[id]);
  PackedGeometry result;
  if (!box.empty()) {
    const geom::dvec3 size = box.high - box.low;
    result.low = box.low;
    const double step = std::max({size.x, size.y, size.z}) / kSteps;
    // A box beyond the range of a double is shown as a point.
    if (std::isfinite(step)) result.step = step;
  }
  NumberWriter numbers;
  numbers.add(used.order.size());
  numbers.add(triangles.size());
  for (int axis = 0; axis < 3; ++axis) {
    numbers.restart();
    for (const VertexId id : used.order) {
      const double offset = scene.vertices[id][axis] - result.low[axis];
      numbers.add_difference(result.step > 0 ? std::llround(offset / result.step) : 0);
    }
  }
  numbers.restart();
  for (const bake::DrawnTriangle& triangle : triangles) {
    for (const VertexId id : triangle.corners) numbers.add_difference(used.number[id]);
  }
  for (const bake::DrawnTriangle& triangle : triangles) {
    const auto& outline = triangle.outline;
    numbers.add((outline[0] ? 1U : 0U) | (outline[1] ? 2U : 0U) | (outline[2] ? 4U : 0U));
  }
  result.bytes = compressed(numbers.bytes());
  return result;
}

PackedLight packed_light(const scene::VertexLight& light, std::span<const bake::DrawnTriangle> triangles) {
  const UsedVertices used = used_vertices(light.radiosity.size(), triangles);
  PackedLight result;
  double largest = 0;
  for (const VertexId id : used.order) {
    const geom::dvec3& b = light.radiosity[id];
    largest = std::max({largest, b.x, b.y, b.z});
  }
  if (largest > 0) result.largest = largest;
  NumberWriter numbers;
  for (int channel = 0; channel < 3; ++channel) {
    numbers.restart();
    for (const VertexId id : used.order) {
      numbers.add_difference(half_bits(std::max(0.0, light.radiosity[id][channel]) / result.largest));
    }
  }
  result.bytes = compressed(numbers.bytes());
  return result;
}

}  // namespace rad::report::html
