#include "mesh/graded_grid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_set>

#include "geom/vec.h"

namespace rad::mesh {
namespace {

using geom::PlanePoint;

/// Columns and rows count boxes of the level, each half as wide as one of the level above it; level 0 is the grid.
struct Cell {
  std::uint32_t level, column, row;
};

// 2^-14 of a patch is below any spacing that the lattice leaves to a face with more than a handful of patches.
constexpr std::uint32_t kDeepest = 14;

// A triangle of a box's corner and two points of the outline is at least 0.2 of the box high: below this many least
// sizes that is less than T.
constexpr double kSmallBoxes = 4;

class Quadtree {
 public:
  explicit Quadtree(const GridLines& lines) : lines_(lines) {}

  /// Divides boxes until the place lies in one of the level.
  void refine_at(const PlanePoint& place, std::uint32_t level) {
    if (level == 0) return;
    ensure({level, line_at(place.x, 0, level), line_at(place.y, 1, level)});
  }

  [[nodiscard]] bool is_split(const Cell& cell) const { return split_.contains(key(cell)); }
  [[nodiscard]] std::uint32_t deepest() const { return deepest_; }
  [[nodiscard]] bool inside(std::uint32_t level, std::int64_t column, std::int64_t row) const {
    return column >= 0 && row >= 0 && column < std::int64_t{lines_.boxes[0]} << level &&
           row < std::int64_t{lines_.boxes[1]} << level;
  }

  /// Visits the leaves that a rectangle, widened by `reach` sizes of the leaf, comes near.
  template <typename Visit>
  void visit(const PlanePoint& low, const PlanePoint& high, double reach, Visit&& visit) const {
    const auto widened = [&](double value, int axis, double sign) {
      return line_at(value + sign * reach * lines_.step[static_cast<std::size_t>(axis)], axis, 0);
    };
    for (std::uint32_t row = widened(low.y, 1, -1); row <= widened(high.y, 1, 1); ++row) {
      for (std::uint32_t column = widened(low.x, 0, -1); column <= widened(high.x, 0, 1); ++column) {
        descend({0, column, row}, low, high, reach, visit);
      }
    }
  }

 private:
  static std::uint64_t key(const Cell& cell) {
    return std::uint64_t{cell.level} << 60 | std::uint64_t{cell.column} << 30 | cell.row;
  }

  [[nodiscard]] double step(int axis, std::uint32_t level) const {
    return std::ldexp(lines_.step[static_cast<std::size_t>(axis)], -static_cast<int>(level));
  }

  [[nodiscard]] std::uint32_t line_at(double value, int axis, std::uint32_t level) const {
    const double low = axis == 0 ? lines_.low.x : lines_.low.y;
    const double last = std::ldexp(lines_.boxes[static_cast<std::size_t>(axis)], static_cast<int>(level)) - 1;
    return static_cast<std::uint32_t>(std::clamp(std::floor((value - low) / step(axis, level)), 0.0, last));
  }

  // The cell comes to exist: all cells that hold it are split, and their neighbours are cells of their level at least.
  void ensure(const Cell& cell) {
    if (cell.level == 0) return;
    const Cell parent{cell.level - 1, cell.column / 2, cell.row / 2};
    if (!split_.insert(key(parent)).second) return;
    deepest_ = std::max(deepest_, cell.level);
    ensure(parent);
    for (const int dx : {-1, 0, 1}) {
      for (const int dy : {-1, 0, 1}) {
        const std::int64_t column = std::int64_t{parent.column} + dx, row = std::int64_t{parent.row} + dy;
        if (inside(parent.level, column, row)) {
          ensure({parent.level, static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row)});
        }
      }
    }
  }

  template <typename Visit>
  void descend(const Cell& cell, const PlanePoint& low, const PlanePoint& high, double reach, Visit& visit) const {
    const double width = step(0, cell.level), height = step(1, cell.level);
    const double x = lines_.low.x + width * cell.column, y = lines_.low.y + height * cell.row;
    if (x - reach * width > high.x || x + (1 + reach) * width < low.x || y - reach * height > high.y ||
        y + (1 + reach) * height < low.y) {
      return;
    }
    if (!is_split(cell)) return visit(cell);
    for (const std::uint32_t dy : {0U, 1U}) {
      for (const std::uint32_t dx : {0U, 1U}) {
        descend({cell.level + 1, 2 * cell.column + dx, 2 * cell.row + dy}, low, high, reach, visit);
      }
    }
  }

  const GridLines& lines_;
  std::unordered_set<std::uint64_t> split_;
  std::uint32_t deepest_ = 0;
};

class GradedGrid {
 public:
  GradedGrid(const GridLines& lines, const GridObstacles& obstacles, double least_size)
      : lines_(lines),
        obstacles_(obstacles),
        tree_(lines),
        least_size_(least_size),
        finest_(level_of(std::max(1.0, least_size))) {}

  BoxGrid run() {
    for_each_edge([this](const PlanePoint& a, const PlanePoint& b) {
      const double length = std::hypot(b.x - a.x, b.y - a.y), size = std::sqrt(lines_.step[0] * lines_.step[1]);
      const double level = std::clamp(std::round(std::log2(size / length)), 0.0, finest_);
      tree_.refine_at({(a.x + b.x) / 2, (a.y + b.y) / 2}, static_cast<std::uint32_t>(level));
    });
    collect_cells();
    mark_inside();
    for_each_edge([this](const PlanePoint& a, const PlanePoint& b) { mark_near(a, b); });
    for (const std::uint32_t point : obstacles_.single) mark_near(obstacles_.points[point], obstacles_.points[point]);
    for (const GridObstacles::Sharp& sharp : obstacles_.sharp) keep_clear_of(sharp);
    return collected();
  }

 private:
  // The deepest level with boxes of the size at least.
  [[nodiscard]] double level_of(double size) const {
    const double level = std::floor(std::log2(std::min(lines_.step[0], lines_.step[1]) / size));
    return std::clamp(level, 0.0, double{kDeepest});
  }

  using Row = std::uint64_t;
  /// Column and row on the lines of the deepest level.
  struct Place {
    Row row;
    std::uint64_t column;
    friend auto operator<=>(const Place&, const Place&) = default;
  };
  struct Corner {
    double size;  ///< the smaller step of the smallest box there
    bool kept;
  };
  struct Box {
    Cell cell;
    bool cut;
  };

  template <typename Visit>
  void for_each_edge(Visit&& visit) const {
    for (const auto& edges : {obstacles_.outline, obstacles_.inner}) {
      for (const geom::PointEdge& edge : edges) visit(obstacles_.points[edge[0]], obstacles_.points[edge[1]]);
    }
  }

  [[nodiscard]] double scale() const { return std::ldexp(1.0, -static_cast<int>(tree_.deepest())); }
  [[nodiscard]] PlanePoint at(const Place& place) const {
    return {lines_.low.x + lines_.step[0] * scale() * static_cast<double>(place.column),
            lines_.low.y + lines_.step[1] * scale() * static_cast<double>(place.row)};
  }
  [[nodiscard]] std::array<Place, 4> corners_of(const Cell& cell) const {
    const std::uint32_t shift = tree_.deepest() - cell.level;
    const auto place = [&](std::uint64_t dx, std::uint64_t dy) {
      return Place{(cell.row + dy) << shift, (cell.column + dx) << shift};
    };
    return {place(0, 0), place(1, 0), place(1, 1), place(0, 1)};
  }
  [[nodiscard]] std::uint64_t id(const Cell& cell) const {
    const Place first = corners_of(cell)[0];
    return first.row << 32 | first.column;
  }

  void collect_cells() {
    const PlanePoint high{lines_.low.x + lines_.step[0] * lines_.boxes[0],
                          lines_.low.y + lines_.step[1] * lines_.boxes[1]};
    tree_.visit(lines_.low, high, 0, [&](const Cell& cell) {
      boxes_.try_emplace(id(cell), Box{cell, false});
      const double size = std::ldexp(std::min(lines_.step[0], lines_.step[1]), -static_cast<int>(cell.level));
      for (const Place& place : corners_of(cell)) {
        Corner& corner = corners_.try_emplace(place, Corner{size, false}).first->second;
        corner.size = std::min(corner.size, size);
      }
    });
  }

  // As in the even grid: between an odd and the next crossing of their row with the outline.
  void mark_inside() {
    std::map<Row, std::vector<double>> crossings;
    for (const auto& [place, corner] : corners_) crossings.try_emplace(place.row);
    for (const geom::PointEdge& edge : obstacles_.outline) {
      const PlanePoint &a = obstacles_.points[edge[0]], &b = obstacles_.points[edge[1]];
      const double step = lines_.step[1] * scale();
      const double first = std::max(0.0, std::floor((std::min(a.y, b.y) - lines_.low.y) / step) - 1);
      for (auto row = crossings.lower_bound(static_cast<Row>(first)); row != crossings.end(); ++row) {
        const double y = at({row->first, 0}).y;
        if (y > std::max(a.y, b.y)) break;
        if ((a.y <= y) != (b.y <= y)) row->second.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
      }
    }
    for (auto& [row, places] : crossings) std::sort(places.begin(), places.end());
    for (auto& [place, corner] : corners_) {
      const auto& places = crossings.at(place.row);
      corner.kept = (std::upper_bound(places.begin(), places.end(), at(place).x) - places.begin()) % 2 == 1;
    }
  }

  void mark_near(const PlanePoint& a, const PlanePoint& b) {
    const PlanePoint low{std::min(a.x, b.x), std::min(a.y, b.y)}, high{std::max(a.x, b.x), std::max(a.y, b.y)};
    const auto distance = [&](const PlanePoint& p) {
      return geom::distance_to_segment({p.x, p.y, 0}, {a.x, a.y, 0}, {b.x, b.y, 0});
    };
    tree_.visit(low, high, 1, [&](const Cell& cell) {
      const auto places = corners_of(cell);
      for (const Place& place : places) {
        Corner& corner = corners_.at(place);
        if (corner.kept && distance(at(place)) < kNearShare * corner.size) corner.kept = false;
      }
      const PlanePoint from = at(places[0]), to = at(places[2]);
      // Nor may it pass between two corners nearer to the side than the spacing. Corners of boxes stay whatever
      // triangles they make with the outline: small boxes leave a row of free corners before it, which can be dropped.
      const double side = std::max(to.x - from.x, to.y - from.y);
      const double beside = side / 2 + (side < kSmallBoxes * least_size_ ? side : kNearShare * least_size_);
      const double reach = std::max(std::hypot(to.x - from.x, to.y - from.y) / 2, beside);
      if (distance({(from.x + to.x) / 2, (from.y + to.y) / 2}) < reach) boxes_.at(id(cell)).cut = true;
    });
  }

  void keep_clear_of(const GridObstacles::Sharp& sharp) {
    const auto& [from, to, clearance] = sharp;
    const PlanePoint low{std::min(from.x, to.x) - clearance, std::min(from.y, to.y) - clearance};
    const PlanePoint high{std::max(from.x, to.x) + clearance, std::max(from.y, to.y) + clearance};
    tree_.visit(low, high, 0, [&](const Cell& cell) {
      for (const Place& place : corners_of(cell)) {
        const PlanePoint p = at(place);
        if (geom::distance_to_segment({p.x, p.y, 0}, {from.x, from.y, 0}, {to.x, to.y, 0}) < clearance) {
          corners_.at(place).kept = false;
        }
      }
    });
  }

  [[nodiscard]] bool is_whole(const Box& box) const {
    if (box.cut) return false;
    constexpr std::array<std::array<int, 2>, 4> kSides{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    return std::none_of(kSides.begin(), kSides.end(), [&](const auto& side) {
      const std::int64_t column = std::int64_t{box.cell.column} + side[0], row = std::int64_t{box.cell.row} + side[1];
      return tree_.inside(box.cell.level, column, row) &&
             tree_.is_split({box.cell.level, static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row)});
    });
  }

  [[nodiscard]] BoxGrid collected() const {
    BoxGrid grid;
    std::map<Place, std::uint32_t> ids;
    for (const auto& [place, corner] : corners_) {
      if (!corner.kept) continue;
      ids.emplace(place, static_cast<std::uint32_t>(grid.corners.size()));
      grid.corners.push_back(at(place));
    }
    for (const auto& [key, box] : boxes_) {
      if (!is_whole(box)) continue;
      std::array<std::uint32_t, 4> corners{};
      bool whole = true;
      const auto places = corners_of(box.cell);
      for (std::size_t i = 0; i < 4 && whole; ++i) {
        const auto known = ids.find(places[i]);
        whole = known != ids.end();
        if (whole) corners[i] = known->second;
      }
      if (whole) grid.boxes.push_back(corners);
    }
    return grid;
  }

  const GridLines& lines_;
  const GridObstacles& obstacles_;
  Quadtree tree_;
  double least_size_;  ///< pitches
  double finest_;      ///< level
  std::map<Place, Corner> corners_;
  std::map<std::uint64_t, Box> boxes_;  ///< by row and column of the first corner
};

}  // namespace

BoxGrid graded_grid(const GridLines& lines, const GridObstacles& obstacles, double least_size) {
  return GradedGrid(lines, obstacles, least_size).run();
}

}  // namespace rad::mesh
