#include "validate/air_cells.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>

#include "geom/box_tree.h"
#include "geom/radial_order.h"
#include "scene/disjoint_sets.h"
#include "validate/interior_ray.h"

namespace rad::validate {
namespace {

using geom::Int128;
using geom::LatticePoint;
using scene::PointId;
using Corners = std::array<PointId, 3>;

constexpr std::uint32_t kNone = 0xffffffffu;

/// One use of an edge by a triangle that has it between `corner` and the next.
struct Use {
  std::uint64_t edge = 0;  ///< the smaller point in the high half
  std::uint32_t triangle = 0;
  std::uint32_t corner = 0;

  friend bool operator<(const Use& x, const Use& y) {
    return std::tie(x.edge, x.triangle) < std::tie(y.edge, y.triangle);
  }
};

class CellFinder {
 public:
  CellFinder(std::span<const LatticePoint> points, std::span<const Corners> triangles)
      : points_(points), triangles_(triangles), sides_(2 * triangles.size()) {}

  std::optional<AirCells> run() {
    if (!join_around_edges()) return std::nullopt;
    number_shells();
    nest_shells();
    return numbered();
  }

 private:
  struct Shell {
    Int128 volume6 = 0;          ///< with normals that point into the cell: negative where the shell encloses the cell
    std::uint32_t side = 0;      ///< one of its sides
    std::uint32_t host = kNone;  ///< of one that does not: the shell that encloses its cell, kNone in open space
    CellId cell = kOpenSpace;

    [[nodiscard]] bool encloses_its_cell() const { return volume6 < 0; }
  };

  [[nodiscard]] std::vector<Use> uses_of_edges() const {
    std::vector<Use> uses(3 * triangles_.size());
    tbb::parallel_for(std::size_t{0}, triangles_.size(), [&](std::size_t t) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint64_t a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
        uses[3 * t + k] = {std::min(a, b) << 32 | std::max(a, b), static_cast<std::uint32_t>(t), k};
      }
    });
    tbb::parallel_sort(uses.begin(), uses.end());
    return uses;
  }

  bool join_around_edges() {
    std::vector<Use> uses = uses_of_edges();
    for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
      while (last < uses.size() && uses[last].edge == uses[first].edge) ++last;
      if (!join_around(std::span(uses).subspan(first, last - first))) return false;
    }
    return true;
  }

  // A triangle that runs along the edge has its normal on the side towards which one turns.
  [[nodiscard]] std::uint32_t side_ahead(const Use& use) const {
    const bool along = triangles_[use.triangle][use.corner] == (use.edge >> 32);
    return 2 * use.triangle + (along ? 0 : 1);
  }
  [[nodiscard]] std::uint32_t side_behind(const Use& use) const { return side_ahead(use) ^ 1U; }
  [[nodiscard]] const LatticePoint& apex(const Use& use) const {
    return points_[triangles_[use.triangle][(use.corner + 2) % 3]];
  }

  // Between neighbouring triangles around the edge there is one wedge of air.
  bool join_around(std::span<Use> uses) {
    const geom::RadialOrder order(points_[uses[0].edge >> 32], points_[uses[0].edge & 0xffffffffu], apex(uses[0]));
    const auto before = [&](const Use& x, const Use& y) { return order.precedes(apex(x), apex(y)); };
    if (uses.size() > 2) std::sort(uses.begin(), uses.end(), before);
    for (std::size_t i = 0; i < uses.size(); ++i) {
      const Use& next = uses[(i + 1) % uses.size()];
      if (i + 1 < uses.size() && order.coincide(apex(uses[i]), apex(next))) return false;
      sides_.unite(side_ahead(uses[i]), side_behind(next));
    }
    return true;
  }

  [[nodiscard]] Int128 volume6(std::uint32_t side) const {
    const Corners& t = triangles_[side / 2];
    const LatticePoint zero{};
    const Int128 volume =
        geom::dot(geom::difference(points_[t[0]], zero),
                  geom::cross(geom::difference(points_[t[1]], zero), geom::difference(points_[t[2]], zero)));
    return side % 2 == 0 ? volume : -volume;
  }

  void number_shells() {
    shell_of_side_.resize(sides_.size());
    for (std::uint32_t side = 0; side < sides_.size(); ++side) {
      const std::uint32_t root = sides_.find(side);  // the smallest of the set: it comes first
      if (root == side) {
        shell_of_side_[side] = static_cast<std::uint32_t>(shells_.size());
        shells_.push_back({0, side});
      }
      shell_of_side_[side] = shell_of_side_[root];
      shells_[shell_of_side_[side]].volume6 += volume6(side);
    }
  }

  void nest_shells() {
    if (std::ranges::none_of(shells_, &Shell::encloses_its_cell)) return;
    std::vector<std::uint32_t> islands;
    for (std::uint32_t i = 0; i < shells_.size(); ++i) {
      if (!shells_[i].encloses_its_cell()) islands.push_back(i);
    }
    std::vector<geom::LatticeBox> boxes;
    boxes.reserve(triangles_.size());
    for (const Corners& t : triangles_)
      boxes.push_back(geom::box_of(std::array{points_[t[0]], points_[t[1]], points_[t[2]]}));
    const geom::BoxTree tree(std::move(boxes));
    tbb::parallel_for(std::size_t{0}, islands.size(), [&](std::size_t i) {
      Shell& island = shells_[islands[i]];
      island.host = host_of(island, tree);
    });
  }

  // Of the shells that a ray from a side of the island passes through an odd number of times, which are those around
  // it, the smallest.
  [[nodiscard]] std::uint32_t host_of(const Shell& island, const geom::BoxTree& tree) const {
    std::vector<std::uint32_t> passed;
    const InteriorRay ray(corners_of(island.side / 2), island.side % 2 == 0);
    tree.for_each_meeting(ray.box(), [&](std::uint32_t other) {
      if (other == island.side / 2 || !ray.passes(corners_of(other))) return;
      for (const std::uint32_t side : {2 * other, 2 * other + 1}) {
        if (shells_[shell_of_side_[side]].encloses_its_cell()) passed.push_back(shell_of_side_[side]);
      }
    });
    std::sort(passed.begin(), passed.end());
    std::uint32_t host = kNone;
    for (std::size_t first = 0, last = 0; first < passed.size(); first = last) {
      while (last < passed.size() && passed[last] == passed[first]) ++last;
      const bool around = (last - first) % 2 == 1;
      if (around && (host == kNone || shells_[passed[first]].volume6 > shells_[host].volume6)) host = passed[first];
    }
    return host;
  }

  [[nodiscard]] std::array<LatticePoint, 3> corners_of(std::uint32_t triangle) const {
    const Corners& t = triangles_[triangle];
    return {points_[t[0]], points_[t[1]], points_[t[2]]};
  }

  /// A side by its place: the triangle's corners in ascending order, and whether it is where their normal points.
  using Place = std::pair<std::array<LatticePoint, 3>, bool>;

  [[nodiscard]] Place place_of(std::uint32_t side) const {
    std::array<LatticePoint, 3> corners = corners_of(side / 2);
    bool even = side % 2 == 0;
    for (const auto& [i, j] : {std::pair{0U, 1U}, std::pair{1U, 2U}, std::pair{0U, 1U}}) {
      if (corners[i] <= corners[j]) continue;
      std::swap(corners[i], corners[j]);
      even = !even;
    }
    return {corners, even};
  }

  // Shells around cells by their first place.
  [[nodiscard]] std::vector<std::uint32_t> enclosing_shells_by_place() const {
    std::vector<std::optional<Place>> first(shells_.size());
    for (std::uint32_t side = 0; side < shell_of_side_.size(); ++side) {
      const std::uint32_t shell = shell_of_side_[side];
      if (!shells_[shell].encloses_its_cell()) continue;
      const Place place = place_of(side);
      if (!first[shell] || place < *first[shell]) first[shell] = place;
    }
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < shells_.size(); ++i) {
      if (first[i]) order.push_back(i);
    }
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return *first[a] < *first[b]; });
    return order;
  }

  AirCells numbered() {
    AirCells cells;
    cells.volume6.push_back(0);
    for (const std::uint32_t shell : enclosing_shells_by_place()) {
      shells_[shell].cell = static_cast<CellId>(cells.volume6.size());
      cells.volume6.push_back(-shells_[shell].volume6);
    }
    for (Shell& shell : shells_) {
      if (shell.encloses_its_cell() || shell.host == kNone) continue;
      shell.cell = shells_[shell.host].cell;
      cells.volume6[shell.cell] -= shell.volume6;
    }
    cells.cell_of_side.resize(triangles_.size());
    for (std::uint32_t side = 0; side < shell_of_side_.size(); ++side) {
      cells.cell_of_side[side / 2][side % 2] = shells_[shell_of_side_[side]].cell;
    }
    return cells;
  }

  std::span<const LatticePoint> points_;
  std::span<const Corners> triangles_;
  scene::DisjointSets sides_;  ///< 2·triangle + side
  std::vector<std::uint32_t> shell_of_side_;
  std::vector<Shell> shells_;
};

}  // namespace

std::optional<AirCells> find_air_cells(std::span<const LatticePoint> points, std::span<const Corners> triangles) {
  return CellFinder(points, triangles).run();
}

}  // namespace rad::validate
