// What conforming did, for the ledger.
#pragma once

#include <cstddef>

#include "repair/complex.h"
#include "repair/plane_snap.h"
#include "repair/residual.h"

namespace rad::repair {

struct ConformCounts {
  std::size_t welded = 0;     ///< points that another point took the place of
  double largest_weld = 0;    ///< pitches
  std::size_t collapsed = 0;  ///< pieces that lost their area
  SnapCounts snapped;
  std::size_t t_vertices = 0;  ///< splits of edges before the first plane pass
  ComplexCounts complex;
  ResidualCounts residual;
  std::size_t residual_rounds = 0;

  /// Adds what was done after it.
  ConformCounts& operator+=(const ConformCounts& more);
};

}  // namespace rad::repair
