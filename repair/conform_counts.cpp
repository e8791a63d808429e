#include "repair/conform_counts.h"

#include <algorithm>

namespace rad::repair {

ConformCounts& ConformCounts::operator+=(const ConformCounts& more) {
  welded += more.welded;
  largest_weld = std::max(largest_weld, more.largest_weld);
  collapsed += more.collapsed;
  snapped.moved += more.snapped.moved;
  snapped.largest = std::max(snapped.largest, more.snapped.largest);
  t_vertices += more.t_vertices;
  complex.new_points += more.complex.new_points;
  complex.splits += more.complex.splits;
  complex.imprints += more.complex.imprints;
  complex.merges += more.complex.merges;
  complex.largest_merge = std::max(complex.largest_merge, more.complex.largest_merge);
  residual.rehomed += more.residual.rehomed;
  residual.steiner_points += more.residual.steiner_points;
  residual.local_merges += more.residual.local_merges;
  residual_rounds += more.residual_rounds;
  return *this;
}

}  // namespace rad::repair
