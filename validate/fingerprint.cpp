#include "validate/fingerprint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rad::validate {
namespace {

constexpr double kStepInTolerances = 64;

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

}  // namespace

std::string fingerprint_of(const scene::Finding& finding, const dvec3& frame_origin, double tolerance) {
  Hash hash;
  hash.add(finding.rule);
  for (const std::string& object : finding.where.objects) hash.add(object);
  for (const std::string& material : finding.where.materials) hash.add(material);
  if (finding.where.point && tolerance > 0) {
    const dvec3 local = (*finding.where.point - frame_origin) / (kStepInTolerances * tolerance);
    for (int axis = 0; axis < 3; ++axis) {
      // Beyond the int64 range places are told apart no more; such coordinates have no 64 T to speak of.
      const double step = std::clamp(std::nearbyint(local[axis]), -0x1p62, 0x1p62);
      hash.add(static_cast<std::int64_t>(step));
    }
  } else {
    hash.add(finding.message);
  }
  return fmt::format("{:016x}", hash.value());
}

}  // namespace rad::validate
