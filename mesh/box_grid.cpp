#include "mesh/box_grid.h"

#include <algorithm>
#include <cmath>

#include "geom/vec.h"

namespace rad::mesh {
namespace {

using geom::PlanePoint;

constexpr std::uint32_t kNoCorner = 0xffffffffU;

class GridMarks {
 public:
  GridMarks(const GridLines& lines, const GridObstacles& obstacles)
      : lines_(lines), obstacles_(obstacles), width_(lines.boxes[0] + 1), height_(lines.boxes[1] + 1) {
    corner_inside_.assign(std::size_t{width_} * height_, 0);
    box_cut_.assign(corner_inside_.size(), 0);
  }

  BoxGrid grid() {
    mark_inside();
    const double near = kNearShare * std::min(lines_.step[0], lines_.step[1]);
    // What stays this far from the middle of a box does not enter it.
    const double reach = std::hypot(lines_.step[0], lines_.step[1]) / 2;
    for_each_obstacle([&](const PlanePoint& a, const PlanePoint& b) {
      mark(a, b, near, 0, [&](std::size_t corner) { corner_inside_[corner] = 0; });
      mark(a, b, reach, 0.5, [&](std::size_t box) { box_cut_[box] = 1; });
    });
    for (const auto& [from, to, clearance] : obstacles_.sharp) {
      mark(from, to, clearance, 0, [&](std::size_t corner) { corner_inside_[corner] = 0; });
    }
    return collected();
  }

 private:
  template <typename Visit>
  void for_each_obstacle(Visit&& visit) const {
    for (const auto& edges : {obstacles_.outline, obstacles_.inner}) {
      for (const geom::PointEdge& edge : edges) visit(obstacles_.points[edge[0]], obstacles_.points[edge[1]]);
    }
    for (const std::uint32_t point : obstacles_.single) visit(obstacles_.points[point], obstacles_.points[point]);
  }

  // Corners between an odd and the next crossing of their row with the outline are inside. Those for which rounding
  // decides are near the outline and fall away.
  void mark_inside() {
    std::vector<std::vector<double>> crossings(height_);
    for (const geom::PointEdge& edge : obstacles_.outline) {
      add_crossings(obstacles_.points[edge[0]], obstacles_.points[edge[1]], crossings);
    }
    for (std::uint32_t row = 0; row < height_; ++row) {
      std::vector<double>& places = crossings[row];
      std::sort(places.begin(), places.end());
      std::size_t passed = 0;
      for (std::uint32_t column = 0; column < width_; ++column) {
        const double x = lines_.corner(column, row).x;
        while (passed < places.size() && places[passed] <= x) ++passed;
        corner_inside_[index(column, row)] = static_cast<char>(passed % 2);
      }
    }
  }

  void add_crossings(const PlanePoint& a, const PlanePoint& b, std::vector<std::vector<double>>& crossings) const {
    const auto [first, last] = range(std::min(a.y, b.y), std::max(a.y, b.y), 1, 0, height_);
    for (std::uint32_t row = first; row < last; ++row) {
      const double y = lines_.corner(0, row).y;
      if ((a.y <= y) == (b.y <= y)) continue;
      crossings[row].push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
    }
  }

  // Calls visit(index) for what lies at corners plus `shift` steps and within `reach` of the segment.
  template <typename Visit>
  void mark(const PlanePoint& a, const PlanePoint& b, double reach, double shift, Visit&& visit) const {
    const auto columns = range(std::min(a.x, b.x) - reach, std::max(a.x, b.x) + reach, 0, shift, width_);
    const auto rows = range(std::min(a.y, b.y) - reach, std::max(a.y, b.y) + reach, 1, shift, height_);
    for (std::uint32_t row = rows[0]; row < rows[1]; ++row) {
      for (std::uint32_t column = columns[0]; column < columns[1]; ++column) {
        const PlanePoint corner = lines_.corner(column, row);
        const geom::dvec3 place(corner.x + shift * lines_.step[0], corner.y + shift * lines_.step[1], 0);
        if (geom::distance_to_segment(place, {a.x, a.y, 0}, {b.x, b.y, 0}) < reach) visit(index(column, row));
      }
    }
  }

  // First and one past the last line along an axis whose place, moved by `shift` steps, is from low to high.
  [[nodiscard]] std::array<std::uint32_t, 2> range(double low, double high, int axis, double shift,
                                                   std::uint32_t count) const {
    const double origin = axis == 0 ? lines_.low.x : lines_.low.y, step = lines_.step[static_cast<std::size_t>(axis)];
    const double first = std::clamp(std::floor((low - origin) / step - shift), 0.0, static_cast<double>(count));
    const double last = std::clamp(std::ceil((high - origin) / step - shift) + 1, 0.0, static_cast<double>(count));
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last)};
  }

  [[nodiscard]] BoxGrid collected() const {
    BoxGrid grid;
    std::vector<std::uint32_t> id(corner_inside_.size(), kNoCorner);
    for (std::uint32_t row = 0; row < height_; ++row) {
      for (std::uint32_t column = 0; column < width_; ++column) {
        if (corner_inside_[index(column, row)] == 0) continue;
        id[index(column, row)] = static_cast<std::uint32_t>(grid.corners.size());
        grid.corners.push_back(lines_.corner(column, row));
      }
    }
    for (std::uint32_t row = 0; row + 1 < height_; ++row) {
      for (std::uint32_t column = 0; column + 1 < width_; ++column) {
        const std::array<std::uint32_t, 4> box{id[index(column, row)], id[index(column + 1, row)],
                                               id[index(column + 1, row + 1)], id[index(column, row + 1)]};
        const bool whole = std::find(box.begin(), box.end(), kNoCorner) == box.end();
        if (whole && box_cut_[index(column, row)] == 0) grid.boxes.push_back(box);
      }
    }
    return grid;
  }

  [[nodiscard]] std::size_t index(std::uint32_t column, std::uint32_t row) const {
    return std::size_t{row} * width_ + column;
  }

  const GridLines& lines_;
  const GridObstacles& obstacles_;
  std::uint32_t width_, height_;
  std::vector<char> corner_inside_;
  std::vector<char> box_cut_;
};

}  // namespace

BoxGrid box_grid(const GridLines& lines, const GridObstacles& obstacles) { return GridMarks(lines, obstacles).grid(); }

}  // namespace rad::mesh
