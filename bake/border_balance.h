// Texels outside a chart, set so that interpolation meets given values along its border.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace rad::bake {

using glm::dvec2;
using glm::dvec3;

/// A condition on the four texels around a point: bilinear interpolation has the value `target` there.
struct BorderSample {
  std::uint32_t column = 0;  ///< of the upper left one
  std::uint32_t row = 0;
  dvec2 share{0, 0};  ///< of the way to the next column and row
  dvec3 target{0, 0, 0};
};

class BorderBalance {
 public:
  /// `inside` of each texel, by rows, says whether it is given; what is referred to outlives the object.
  BorderBalance(std::span<const std::uint8_t> inside, std::uint32_t columns, std::uint32_t rows)
      : inside_(inside), columns_(columns), rows_(rows) {}

  /// Conditions along an edge of the border, half a texel apart or less, between the values of its ends. Points are in
  /// texels; (i, j) is the centre of column i in row j.
  void add_edge(const dvec2& from, const dvec2& to, const dvec3& value_from, const dvec3& value_to);

  /// Changes the texels outside as little as the conditions let it (Kaczmarz's projections, in the order in which edges
  /// were added); none falls below 0. `texel` gives the three channels of one.
  template <typename Texel>
  void settle(Texel&& texel) const {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (const BorderSample& sample : samples_) project(sample, texel);
    }
  }

 private:
  static constexpr int kSweeps = 8;
  // Texels outside that have less weight than this, as a sum of squares, would move far for little.
  static constexpr double kLeastWeight = 0.01;

  template <typename Texel>
  void project(const BorderSample& sample, Texel&& texel) const {
    double squares = 0;
    dvec3 missing = sample.target;
    for (int corner = 0; corner < 4; ++corner) {
      const std::uint32_t column = sample.column + corner % 2, row = sample.row + corner / 2;
      const double weight = weight_of(sample, corner);
      const float* value = texel(column, row);
      missing -= weight * dvec3(value[0], value[1], value[2]);
      if (is_free(column, row)) squares += weight * weight;
    }
    if (squares < kLeastWeight) return;
    for (int corner = 0; corner < 4; ++corner) {
      const std::uint32_t column = sample.column + corner % 2, row = sample.row + corner / 2;
      if (!is_free(column, row)) continue;
      float* value = texel(column, row);
      const double step = weight_of(sample, corner) / squares;
      for (int channel = 0; channel < 3; ++channel) {
        value[channel] = static_cast<float>(std::max(0.0, value[channel] + step * missing[channel]));
      }
    }
  }

  static double weight_of(const BorderSample& sample, int corner) {
    return (corner % 2 == 1 ? sample.share.x : 1 - sample.share.x) *
           (corner / 2 == 1 ? sample.share.y : 1 - sample.share.y);
  }
  [[nodiscard]] bool is_free(std::uint32_t column, std::uint32_t row) const {
    return inside_[std::size_t{row} * columns_ + column] == 0;
  }

  std::span<const std::uint8_t> inside_;
  std::uint32_t columns_;
  std::uint32_t rows_;
  std::vector<BorderSample> samples_;
};

}  // namespace rad::bake
