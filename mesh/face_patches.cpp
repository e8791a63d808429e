#include "mesh/face_patches.h"

#include <algorithm>
#include <cmath>

#include "mesh/box_grid.h"
#include "mesh/graded_grid.h"
#include "mesh/lengths.h"
#include "mesh/remainder.h"

namespace rad::mesh {
namespace {

using geom::LatticePoint;
using geom::PlanePoint;

// A narrow face has boxes that are longer along it than across by this much at most.
constexpr double kMostElongated = 1.5;

struct Extent {
  PlanePoint low{INFINITY, INFINITY};
  PlanePoint high{-INFINITY, -INFINITY};
};

FacePoints points_of(const FaceFrame& frame, const FaceOutline& outline, std::span<const LatticePoint> points) {
  FacePoints face;
  for (const PointId id : outline.ids) add_point(face, frame, points[id]);
  return face;
}

Extent extent_of(const FacePoints& points) {
  Extent extent;
  for (const PlanePoint& p : points.plane) {
    extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y)};
    extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y)};
  }
  return extent;
}

std::uint32_t steps_in(double length, double longest) {
  return static_cast<std::uint32_t>(std::max(1.0, std::ceil((length - kLengthRounding) / longest)));
}

// Along the longest edge the lines go through the points that divide it; across it the height of the face is divided
// evenly. An edge too short to tell a step (half a patch) leaves the width to tell it.
GridLines grid_lines(const FaceFrame& frame, const FaceOutline& outline, std::span<const LatticePoint> points,
                     const Extent& extent, const FaceLengths& lengths) {
  const double longest = lengths.longest;
  const PlanePoint from = frame.in_plane(points[outline.longest_edge[0]]);
  const double edge = frame.in_plane(points[outline.longest_edge[1]]).x - from.x;
  const double width = extent.high.x - extent.low.x, height = extent.high.y - extent.low.y;
  GridLines lines{extent.low, {1, 1}, {1, 1}};
  if (edge > longest / 2) {
    lines.step[0] = edge / steps_in(edge, longest);
    lines.low.x = from.x - steps_in(from.x - extent.low.x, lines.step[0]) * lines.step[0];
    lines.boxes[0] = steps_in(extent.high.x - lines.low.x, lines.step[0]);
  } else {
    lines.boxes[0] = steps_in(width, longest);
    lines.step[0] = width / lines.boxes[0];
  }
  lines.boxes[1] = steps_in(height, longest);
  lines.step[1] = height / lines.boxes[1];
  if (lengths.method == PatchMethod::Graded && lines.step[0] > kMostElongated * lines.step[1]) {
    const double parts = std::ceil(lines.step[0] / (kMostElongated * lines.step[1]));
    lines.step[0] /= parts;
    lines.boxes[0] *= static_cast<std::uint32_t>(parts);
  }
  return lines;
}

bool strictly_convex(const FacePoints& points, const std::array<std::uint32_t, 4>& box) {
  for (std::size_t i = 0; i < 4; ++i) {
    const auto turn = geom::orient2d(points.flat[box[i]], points.flat[box[(i + 1) % 4]], points.flat[box[(i + 2) % 4]]);
    if (turn != geom::Sign::Positive) return false;
  }
  return true;
}

// Edges with a box on one side only, the box's way round.
std::vector<PointEdge> boundary_of(std::span<const std::array<std::uint32_t, 4>> boxes) {
  std::vector<PointEdge> edges;
  for (const auto& box : boxes) {
    for (std::size_t i = 0; i < 4; ++i) edges.push_back({box[i], box[(i + 1) % 4]});
  }
  std::sort(edges.begin(), edges.end());
  std::vector<PointEdge> boundary;
  for (const PointEdge& edge : edges) {
    if (!std::binary_search(edges.begin(), edges.end(), PointEdge{edge[1], edge[0]})) boundary.push_back(edge);
  }
  return boundary;
}

// Adds the corners of the grid to the points; returns its boxes that are patches as they are.
std::vector<std::array<std::uint32_t, 4>> add_grid(const BoxGrid& grid, const FaceFrame& frame, FacePoints& points) {
  const auto first = static_cast<std::uint32_t>(points.lattice.size());
  for (const PlanePoint& corner : grid.corners) add_point(points, frame, frame.nearest(corner));
  std::vector<std::array<std::uint32_t, 4>> boxes;
  for (auto box : grid.boxes) {
    for (std::uint32_t& corner : box) corner += first;
    if (strictly_convex(points, box)) boxes.push_back(box);
  }
  return boxes;
}

// The remainder's points are those of the outline and the grid corners that are not within boxes only.
Remainder remainder_of(const FaceOutline& outline, const FacePoints& points,
                       std::span<const std::array<std::uint32_t, 4>> boxes) {
  Remainder remainder;
  remainder.points = points;
  remainder.outline = outline.outline;
  remainder.inner = outline.inner;
  remainder.kept = static_cast<std::uint32_t>(outline.ids.size());
  const auto boundary = boundary_of(boxes);
  remainder.outline.insert(remainder.outline.end(), boundary.begin(), boundary.end());
  remainder.state.assign(points.lattice.size(), PointState::Free);
  std::fill_n(remainder.state.begin(), outline.ids.size(), PointState::Fixed);
  for (const auto& box : boxes) {
    for (const std::uint32_t corner : box) remainder.state[corner] = PointState::Unused;
  }
  for (const PointEdge& edge : boundary) {
    for (const std::uint32_t corner : edge) remainder.state[corner] = PointState::Fixed;
  }
  return remainder;
}

GridLines lines_over(FaceFrame& frame, const FaceOutline& outline, std::span<const LatticePoint> points,
                     const FaceLengths& lengths, FacePoints& face) {
  frame.align(points[outline.longest_edge[0]], points[outline.longest_edge[1]]);
  face = points_of(frame, outline, points);
  return grid_lines(frame, outline, points, extent_of(face), lengths);
}

std::vector<GridObstacles::Sharp> sharp_in_plane(const FaceFrame& frame, std::span<const LatticePoint> points,
                                                 const ClearZone& zone) {
  std::vector<GridObstacles::Sharp> sharp;
  for (const auto& [ends, clearance] : zone.edges()) {
    sharp.push_back({frame.in_plane(points[ends[0]]), frame.in_plane(points[ends[1]]), clearance});
  }
  return sharp;
}

}  // namespace

FacePatches face_patches(FaceFrame frame, const FaceOutline& outline, std::span<const LatticePoint> points,
                         const FaceLengths& lengths, const ClearZone& zone) {
  FacePoints face;
  const GridLines lines = lines_over(frame, outline, points, lengths, face);
  const std::vector<GridObstacles::Sharp> sharp = sharp_in_plane(frame, points, zone);
  const GridObstacles obstacles{face.plane, outline.outline, outline.inner, outline.single, sharp};
  // Corners keep 0.6 of a box from the outline, and that is to be no less than the spacing.
  const BoxGrid grid = lengths.method == PatchMethod::Grid
                           ? box_grid(lines, obstacles)
                           : graded_grid(lines, obstacles, lengths.spacing / kNearShare);
  const auto boxes = add_grid(grid, frame, face);
  Remainder remainder = remainder_of(outline, face, boxes);
  FacePatches result;
  if (!mesh_remainder(remainder, frame, lengths, zone, result.patches)) return {};
  for (const auto& box : boxes) result.patches.push_back({box, 4});
  result.added.assign(remainder.points.lattice.begin() + static_cast<std::ptrdiff_t>(outline.ids.size()),
                      remainder.points.lattice.end());
  return result;
}

double grid_size(FaceFrame frame, const FaceOutline& outline, std::span<const LatticePoint> points,
                 const FaceLengths& lengths) {
  FacePoints face;
  const GridLines lines = lines_over(frame, outline, points, lengths, face);
  return static_cast<double>(lines.boxes[0]) * lines.boxes[1];
}

}  // namespace rad::mesh
