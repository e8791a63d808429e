#include "solve/strata.h"

namespace rad::solve {
namespace {

struct Corner {
  dvec3 point;
  std::array<double, 2> place;
};

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

Shares shape_at_centre(const Stratum& piece) {
  double u = 0, v = 0;
  for (std::uint32_t i = 0; i < piece.count; ++i) {
    u += piece.place[i][0] / piece.count;
    v += piece.place[i][1] / piece.count;
  }
  return piece.count == 3 ? triangle_shape(u, v) : quadrilateral_shape(u, v);
}

}  // namespace rad::solve
