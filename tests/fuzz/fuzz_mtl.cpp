// Arbitrary bytes as a material library: every colour that is taken over must be finite.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "readers/mtl.h"

namespace {

bool is_finite(const rad::scene::dvec3& colour) {
  return std::isfinite(colour.x) && std::isfinite(colour.y) && std::isfinite(colour.z);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rad::scene::ReadIssues issues;
  const auto materials = rad::readers::read_mtl({reinterpret_cast<const char*>(data), size}, "fuzzed.mtl", issues);
  for (const rad::scene::Material& material : materials) {
    if (!is_finite(material.reflectance) || !is_finite(material.emission)) std::abort();
  }
  return 0;
}
