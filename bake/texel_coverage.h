// How much of each texel an element covers.
#pragma once

#include <cstdint>
#include <span>

#include "bake/element_function.h"

namespace rad::bake {

/// Texels that a span of columns of one row covers; the square of texel (i, j) reaches from i - 1/2 to i + 1/2.
struct CoverageRow {
  std::int64_t row = 0;
  std::span<double> share;                ///< of each column from 0 on, 0 to 1; added to
  std::span<const std::uint8_t> counted;  ///< of each column, 0 where nobody asks; empty: all are
};

/// Adds the area of the element inside each texel of the row, exactly but for rounding. The element lies within the
/// columns.
void add_coverage(const FlatElement& element, const CoverageRow& row);

}  // namespace rad::bake
