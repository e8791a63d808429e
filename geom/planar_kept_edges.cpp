// PlanarDelaunay: edges that must be kept.
#include <algorithm>

#include "geom/planar_delaunay.h"

namespace rad::geom {
namespace {

std::uint64_t ends_of(std::uint32_t a, std::uint32_t b) {
  return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
}

bool is_ahead(const PlanarPoint& point, const PlanarPoint& from, const PlanarPoint& to) {
  return (point.u - from.u) * (to.u - from.u) + (point.v - from.v) * (to.v - from.v) > 0;
}

}  // namespace

// Once around the point.
PlanarDelaunay::Start PlanarDelaunay::start_towards(std::uint32_t from, std::uint32_t to) const {
  std::uint32_t here = triangle_of_[from];
  while (true) {
    const PlanarTriangle& t = triangles_[here];
    const std::uint32_t side = side_of(here, from);
    const std::uint32_t right = t.corner[(side + 1) % 3], left = t.corner[(side + 2) % 3];
    if (right == to) return {here, side, true};
    if (right != infinite_) {
      const Sign at_right = turn(from, to, right);
      if (at_right == Sign::Zero && is_ahead(points_[right], points_[from], points_[to])) return {here, side, true};
      if (at_right == Sign::Negative && left != infinite_ && turn(from, to, left) == Sign::Positive) {
        return {here, (side + 1) % 3, false};
      }
    }
    here = t.neighbour[(side + 2) % 3];
  }
}

void PlanarDelaunay::mark_kept(std::uint32_t triangle, std::uint32_t side) {
  PlanarTriangle& t = triangles_[triangle];
  t.constrained[side] = true;
  const std::uint32_t other = t.neighbour[side];
  triangles_[other].constrained[side_of(other, t.corner[(side + 1) % 3])] = true;
}

KeptEdge PlanarDelaunay::keep(std::uint32_t from, std::uint32_t to) {
  KeptEdge result = KeptEdge::Whole;
  while (from != to) {
    const Start start = start_towards(from, to);
    std::uint32_t reached = 0;
    if (start.along) {
      mark_kept(start.triangle, start.side);
      reached = triangles_[start.triangle].corner[(start.side + 1) % 3];
    } else {
      if (!run_through(from, to, start)) return KeptEdge::Crossed;
      reached = left_.back();
      cut_open(from, reached);
    }
    if (reached != to) result = KeptEdge::Split;
    from = reached;
  }
  return result;
}

// Gathers the triangles from `from` to the first point on the way, and the points to both sides. False where the way
// crosses an edge that is kept.
bool PlanarDelaunay::run_through(std::uint32_t from, std::uint32_t to, const Start& start) {
  std::uint32_t here = start.triangle, side = start.side;
  cavity_.assign(1, here);
  right_ = {from, triangles_[here].corner[side]};
  left_ = {from, triangles_[here].corner[(side + 1) % 3]};
  while (true) {
    const PlanarTriangle& t = triangles_[here];
    if (t.constrained[side]) return false;
    here = t.neighbour[side];
    cavity_.push_back(here);
    side = side_of(here, left_.back());
    const std::uint32_t apex = triangles_[here].corner[(side + 2) % 3];
    const Sign at_apex = apex == to ? Sign::Zero : turn(from, to, apex);
    if (at_apex != Sign::Negative) left_.push_back(apex);
    if (at_apex != Sign::Positive) right_.push_back(apex);
    if (at_apex == Sign::Zero) return true;
    side = (side + (at_apex == Sign::Positive ? 1 : 2)) % 3;
  }
}

void PlanarDelaunay::cut_open(std::uint32_t from, std::uint32_t to) {
  ++round_;
  for (const std::uint32_t triangle : cavity_) dug_[triangle] = round_;
  note_rims();
  filled_ = 0;
  fill(left_);
  std::reverse(right_.begin(), right_.end());
  fill(right_);
  link_all(ends_of(from, to));
}

// What the new triangles will be neighbours of. An edge between two triangles of the cavity that is not crossed is a
// side of two new ones.
void PlanarDelaunay::note_rims() {
  links_.clear();
  kept_.clear();
  for (const std::uint32_t triangle : cavity_) {
    const PlanarTriangle& t = triangles_[triangle];
    for (std::size_t side = 0; side < 3; ++side) {
      const std::uint64_t ends = ends_of(t.corner[side], t.corner[(side + 1) % 3]);
      if (t.constrained[side]) kept_.push_back(ends);
      const std::uint32_t other = t.neighbour[side];
      if (!dug(other)) links_.push_back({ends, other, side_of(other, t.corner[(side + 1) % 3])});
    }
  }
}

// The part of the cavity to the left of the way from the first point of the chain to the last.
void PlanarDelaunay::fill(std::span<const std::uint32_t> chain) {
  std::vector<std::array<std::size_t, 2>> open{{0, chain.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    if (last - first < 2) continue;
    std::size_t apex = first + 1;
    for (std::size_t i = first + 2; i < last; ++i) {
      if (in_circle(chain[first], chain[last], chain[apex], chain[i])) apex = i;
    }
    const std::uint32_t place = cavity_[filled_++];
    triangles_[place] = {{chain[first], chain[last], chain[apex]}, {kNoTriangle, kNoTriangle, kNoTriangle}, {}};
    for (std::uint32_t side = 0; side < 3; ++side) {
      const auto& corner = triangles_[place].corner;
      links_.push_back({ends_of(corner[side], corner[(side + 1) % 3]), place, side});
      triangle_of_[corner[side]] = place;
    }
    open.push_back({first, apex});
    open.push_back({apex, last});
  }
}

void PlanarDelaunay::link_all(std::uint64_t kept) {
  kept_.push_back(kept);
  std::sort(kept_.begin(), kept_.end());
  std::sort(links_.begin(), links_.end(), [](const Link& a, const Link& b) { return a.ends < b.ends; });
  for (std::size_t i = 0; i + 1 < links_.size(); i += 2) {
    const Link &a = links_[i], &b = links_[i + 1];
    const bool constrained = std::binary_search(kept_.begin(), kept_.end(), a.ends);
    triangles_[a.triangle].neighbour[a.side] = b.triangle;
    triangles_[b.triangle].neighbour[b.side] = a.triangle;
    triangles_[a.triangle].constrained[a.side] = triangles_[b.triangle].constrained[b.side] = constrained;
  }
}

}  // namespace rad::geom
