#include "solve/strata.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace rad::solve {
namespace {

struct Corner {
  dvec3 point;
  std::array<double, 2> place;
};

/// The inverse of a bilinear map: Newton's steps converge quadratically inside a convex quadrilateral; of a linear one
/// the first is exact.
constexpr int kNewtonSteps = 12;
constexpr double kPlaceRounding = 1e-13;

Corner corner_of(const Stratum& stratum, std::uint32_t i) { return {stratum.corner[i], stratum.place[i]}; }

Corner midway(const Corner& a, const Corner& b) {
  return {(a.point + b.point) * 0.5, {(a.place[0] + b.place[0]) * 0.5, (a.place[1] + b.place[1]) * 0.5}};
}

template <typename... Corners>
Stratum piece(const Corners&... corners) {
  Stratum result;
  ((result.corner[result.count] = corners.point, result.place[result.count++] = corners.place), ...);
  return result;
}

std::array<Stratum, 4> split_triangle(const Stratum& stratum) {
  const Corner a = corner_of(stratum, 0), b = corner_of(stratum, 1), c = corner_of(stratum, 2);
  const Corner ab = midway(a, b), bc = midway(b, c), ca = midway(c, a);
  return {piece(a, ab, ca), piece(ab, b, bc), piece(ca, bc, c), piece(bc, ca, ab)};
}

std::array<Stratum, 4> split_quadrilateral(const Stratum& stratum) {
  const Corner a = corner_of(stratum, 0), b = corner_of(stratum, 1), c = corner_of(stratum, 2),
               d = corner_of(stratum, 3);
  const Corner ab = midway(a, b), bc = midway(b, c), cd = midway(c, d), da = midway(d, a);
  const Corner centre = midway(ab, cd);
  return {piece(a, ab, centre, da), piece(ab, b, bc, centre), piece(centre, bc, c, cd), piece(da, centre, cd, d)};
}

/// `bubble` is 1 at the centre and 0 at the corners.
Shares with_bubble(Shares corners, std::uint32_t count, double bubble) {
  for (std::uint32_t i = 0; i < count; ++i) corners[i] -= bubble / count;
  corners[kCentreShare] = bubble;
  return corners;
}

Shares triangle_shape(double u, double v) {
  const double w = 1 - u - v;
  return with_bubble({w, u, v, 0, 0}, 3, 3 * (u * v + v * w + w * u));
}

Shares quadrilateral_shape(double u, double v) {
  const double x = 2 * u - 1, y = 2 * v - 1;
  return with_bubble({(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v, 0}, 4, 1 - (x * x + y * y) / 2);
}

}  // namespace

dvec3 Stratum::centre() const {
  dvec3 sum{0, 0, 0};
  for (std::uint32_t i = 0; i < count; ++i) sum += corner[i];
  return sum / static_cast<double>(count);
}

Stratum whole(std::span<const dvec3> corners) {
  Stratum result;
  result.count = static_cast<std::uint32_t>(corners.size());
  for (std::uint32_t i = 0; i < result.count; ++i) result.corner[i] = corners[i];
  result.place[0] = {0, 0};
  result.place[1] = {1, 0};
  result.place[2] = {result.count == 4 ? 1.0 : 0.0, 1};
  result.place[3] = {0, 1};
  return result;
}

std::array<Stratum, 4> split(const Stratum& stratum) {
  return stratum.count == 3 ? split_triangle(stratum) : split_quadrilateral(stratum);
}

std::vector<Stratum> strata(const Stratum& stratum, std::uint32_t level) {
  std::vector<Stratum> pieces{stratum};
  for (std::uint32_t i = 0; i < level; ++i) {
    std::vector<Stratum> finer;
    finer.reserve(4 * pieces.size());
    for (const Stratum& coarse : pieces) {
      for (const Stratum& fine : split(coarse)) finer.push_back(fine);
    }
    pieces = std::move(finer);
  }
  return pieces;
}

Shares shape_at(std::uint32_t corners, const std::array<double, 2>& place) {
  return corners == 3 ? triangle_shape(place[0], place[1]) : quadrilateral_shape(place[0], place[1]);
}

std::array<double, 2> place_in(const Stratum& whole, const dvec3& point) {
  const dvec3 u_side = whole.corner[1] - whole.corner[0];
  const dvec3 v_side = whole.corner[whole.count - 1] - whole.corner[0];
  const dvec3 twist = whole.count == 4 ? whole.corner[2] - whole.corner[1] - v_side : dvec3(0);
  const dvec3 normal = glm::cross(u_side, v_side);
  std::array<double, 2> place{0.5, 0.5};
  for (int step = 0; step < kNewtonSteps; ++step) {
    const auto [u, v] = place;
    const dvec3 miss = point - (whole.corner[0] + u_side * u + v_side * v + twist * (u * v));
    const dvec3 along_u = u_side + twist * v, along_v = v_side + twist * u;
    const double area = glm::dot(glm::cross(along_u, along_v), normal);
    if (!(std::abs(area) > 0)) break;
    const double du = glm::dot(glm::cross(miss, along_v), normal) / area;
    const double dv = glm::dot(glm::cross(along_u, miss), normal) / area;
    place = {u + du, v + dv};
    if (std::abs(du) + std::abs(dv) < kPlaceRounding) break;
  }
  return place;
}

Shares shape_at_centre(const Stratum& piece) {
  double u = 0, v = 0;
  for (std::uint32_t i = 0; i < piece.count; ++i) {
    u += piece.place[i][0] / piece.count;
    v += piece.place[i][1] / piece.count;
  }
  return shape_at(piece.count, {u, v});
}

}  // namespace rad::solve
