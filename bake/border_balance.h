// Texels along the border of a chart, set so that interpolation between them meets given values there.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace rad::bake {

using glm::dvec2;
using glm::dvec3;

/// Texels of a page by rows; three floats each.
struct TexelBlock {
  float* first = nullptr;  ///< of the upper left texel of the rectangle
  std::size_t stride = 0;  ///< floats from one row to the next

  [[nodiscard]] float* at(std::uint32_t column, std::uint32_t row) const { return first + row * stride + 3 * column; }
};

/// An edge of the border with the values at its ends.
struct BorderLine {
  dvec2 from{0, 0};
  dvec2 to{0, 0};
  dvec3 value_from{0, 0, 0};
  dvec3 value_to{0, 0, 0};
};

/// A least change of the texels around a border: a weighted least-squares fit of bilinear interpolation to the values
/// along it, in which every texel is held to its value by a weak spring and none falls below 0.
class BorderBalance {
 public:
  /// `inside` of each texel, by rows, says whether its value is that of an element there (then its spring is stronger);
  /// what is referred to outlives the object.
  BorderBalance(std::span<const std::uint8_t> inside, std::uint32_t columns, std::uint32_t rows)
      : inside_(inside), columns_(columns), rows_(rows) {}

  /// Asks for the values along an edge of the border, linear between those of its ends, with a weight a length. Points
  /// are in texels; (i, j) is the centre of column i in row j.
  void add_edge(const BorderLine& line, double weight);

  /// Changes the texels. The same bits for the same order of edges.
  void settle(const TexelBlock& texels) const;

 private:
  /// Bilinear interpolation between four texels has the value `target`.
  struct Sample {
    std::uint32_t column = 0;  ///< of the upper left one
    std::uint32_t row = 0;
    dvec2 share{0, 0};  ///< of the way to the next column and row
    dvec3 target{0, 0, 0};
    double weight = 0;
  };
  friend class BorderFit;

  std::span<const std::uint8_t> inside_;
  std::uint32_t columns_;
  std::uint32_t rows_;
  std::vector<Sample> samples_;
};

}  // namespace rad::bake
