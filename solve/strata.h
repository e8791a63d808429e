// Radiators split by the 4-to-1 rule, with the share of each corner's radiosity carried along.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solve/form_factor.h"

namespace rad::solve {

/// A piece of a triangle or quadrilateral: its corners in space and in the parameters of the whole.
struct Stratum {
  std::array<dvec3, 4> corner;
  std::array<std::array<double, 2>, 4> place{};  ///< of the corners
  std::uint32_t count = 0;

  [[nodiscard]] std::span<const dvec3> all() const { return std::span(corner).first(count); }
  [[nodiscard]] dvec3 centre() const;
};

/// The whole of a triangle or quadrilateral.
Stratum whole(std::span<const dvec3> corners);

/// Four pieces: a triangle by its edge midpoints, a quadrilateral by them and its centre.
std::array<Stratum, 4> split(const Stratum& stratum);

/// The 4^level pieces after `level` splits.
std::vector<Stratum> strata(const Stratum& stratum, std::uint32_t level);

/// What the radiosity at each corner of the whole adds to that at the centre of the piece; the sum is 1.
std::array<double, 4> corner_shares(const Stratum& stratum);

}  // namespace rad::solve
