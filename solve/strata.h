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

/// Weights of the values at the corners of a polygon (the first four, the last of them 0 for a triangle) and at its
/// centre.
using Shares = std::array<double, 5>;
constexpr std::size_t kCentreShare = 4;

/// The quadratic through the values at the corners and the centre of a triangle (`corners` 3) or quadrilateral (4), at
/// a place in its parameters. The sum is 1.
Shares shape_at(std::uint32_t corners, const std::array<double, 2>& place);

/// Parameters of a point in the plane of a triangle or a strictly convex quadrilateral: the inverse of its (bi)linear
/// map. Points of it have parameters in [0, 1], up to rounding.
std::array<double, 2> place_in(const Stratum& whole, const dvec3& point);

/// The quadratic through the values at the corners and the centre of the whole, at the centre of the piece: the
/// bilinear (linear) interpolant of the corners, and a bubble that makes up for what it lacks at the centre. The sum
/// is 1.
Shares shape_at_centre(const Stratum& piece);

}  // namespace rad::solve
