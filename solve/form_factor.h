// The form factor from a point to a polygon, in closed form.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geom/vec.h"

namespace rad::solve {

using geom::dvec3;

/// A triangle or convex quadrilateral after a cut by a plane. The cut adds one corner; where the polygon lies in the
/// plane but for rounding, up to four.
struct ConvexPolygon {
  std::array<dvec3, 8> corner;
  std::uint32_t count = 0;

  [[nodiscard]] std::span<const dvec3> all() const { return std::span(corner).first(count); }
};

/// A point that receives light from the side to which the unit vector `normal` points.
struct Receiver {
  dvec3 position;
  dvec3 normal;
};

/// The part of a convex polygon of 3 or 4 corners that lies above the horizon of the receiver, as seen from it: the
/// origin of the result is the receiver. Empty where nothing of it does.
ConvexPolygon above_horizon(std::span<const dvec3> polygon, const Receiver& receiver);

/// The share of what a receiver at the origin gets that comes from the polygon if all that it sees is equally bright:
/// (1/2π) Σ γᵢ n·(rᵢ × rᵢ₊₁)/|rᵢ × rᵢ₊₁| over its edges, γᵢ the angle between the ends of an edge [BAUM89]. The polygon
/// lies above the horizon and turns counter-clockwise seen from the receiver's side of its plane. From 0 to 1.
double form_factor(const ConvexPolygon& polygon, const dvec3& normal);

}  // namespace rad::solve
