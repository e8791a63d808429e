// Seeded random numbers that are the same with every standard library.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>

namespace rad::corpus {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Below `count`, which is at least 1.
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  /// From `low` to `high`, both included.
  int between(int low, int high) { return low + static_cast<int>(index(static_cast<std::size_t>(high - low) + 1)); }
  bool one_in(std::size_t n) { return index(n) == 0; }

  /// In [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// In [low, high).
  double real(double low, double high) { return low + (high - low) * unit(); }
  double one_of(std::initializer_list<double> values) { return *(values.begin() + index(values.size())); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace rad::corpus
