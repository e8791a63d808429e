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

std::array<double, 4> corner_shares(const Stratum& stratum) {
  double u = 0, v = 0;
  for (std::uint32_t i = 0; i < stratum.count; ++i) {
    u += stratum.place[i][0] / stratum.count;
    v += stratum.place[i][1] / stratum.count;
  }
  if (stratum.count == 3) return {1 - u - v, u, v, 0};
  return {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
}

}  // namespace rad::solve
