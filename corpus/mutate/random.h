// Seeded random numbers that are the same with every standard library.
#pragma once

#include <cstdint>
#include <random>

namespace rad::corpus {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Below `count`, which is at least 1.
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  /// In [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace rad::corpus
