#include "validate/fingerprint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <tuple>

namespace rad::validate {
namespace {

/// FNV-1a over bytes, 64 bits.
class Hash {
 public:
  void add(std::string_view text) {
    for (const char c : text) mix(static_cast<unsigned char>(c));
    mix(0);
  }
  void add(std::int64_t value) {
    for (int shift = 0; shift < 64; shift += 8)
      mix(static_cast<unsigned char>(static_cast<std::uint64_t>(value) >> shift));
  }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  void mix(unsigned char byte) {
    state_ ^= byte;
    state_ *= 1099511628211ull;
  }
  std::uint64_t state_ = 14695981039346656037ull;
};

/// Coordinates that modellers like are halves, quarters and tenths of something; borders of steps at the golden section
/// keep clear of all of them.
constexpr double kBorder = 0.3819660112501051;

double step_length(double frame_size, double tolerance) {
  constexpr double kStepInTolerances = 64;
  constexpr double kStepsInFrame = 1024;
  return std::exp2(std::ceil(std::log2(std::max(kStepInTolerances * tolerance, frame_size / kStepsInFrame))));
}

// Beyond the int64 range places are told apart no more; such coordinates have no 64 T to speak of.
std::int64_t step_of(double coordinate, double step) {
  return static_cast<std::int64_t>(std::clamp(std::floor(coordinate / step + kBorder), -0x1p62, 0x1p62));
}

std::optional<dvec3> centre_of(const scene::Where& where) {
  return where.bounds ? std::optional(((*where.bounds)[0] + (*where.bounds)[1]) * 0.5) : where.point;
}

}  // namespace

geom::Box frame_of(const Context& context, std::span<const scene::FaceId> faces) {
  std::optional<scene::ObjectId> best;
  const auto key = [&](scene::ObjectId id) {
    const geom::Box& box = context.object_boxes[id];
    return std::tuple(box.empty() ? 0.0 : box.diagonal(), std::string_view(context.scene.objects[id]), box.low.x,
                      box.low.y, box.low.z);
  };
  for (const scene::FaceId face : faces) {
    const scene::ObjectId object = context.object_of(face);
    if (!best || (object != *best && key(object) < key(*best))) best = object;
  }
  return best ? context.object_boxes[*best] : geom::Box{};
}

std::string fingerprint_of(const scene::Finding& finding, double frame_size, double tolerance) {
  Hash hash;
  hash.add(finding.rule);
  for (const std::string& object : finding.where.objects) hash.add(object);
  for (const std::string& material : finding.where.materials) hash.add(material);
  if (const auto centre = centre_of(finding.where); centre && tolerance > 0) {
    const dvec3 local = *centre - finding.where.frame.value_or(dvec3{0, 0, 0});
    const double step = step_length(frame_size, tolerance);
    for (int axis = 0; axis < 3; ++axis) hash.add(step_of(local[axis], step));
  } else {
    hash.add(finding.message);
  }
  return fmt::format("{:016x}", hash.value());
}

}  // namespace rad::validate
