#include "repair/complex.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "geom/tolerance.h"
#include "repair/distance.h"

namespace rad::repair {
namespace {

// Most searches reach one weld distance: so wide, they meet four cells or so.
constexpr double kGridCellInWelds = 3;
// What is made within this of where a point was that another took the place of, in T, would be that point again.
// Measured: between none and T, a quarter lets the residual loop end most often.
constexpr double kSamePlace = 0.25;

template <typename List>
void erase_one(List& list, PointId id) {
  const auto found = std::find(list.begin(), list.end(), id);
  *found = list.back();
  list.pop_back();
}

}  // namespace

std::vector<EdgeKey> Cluster::sorted_edges() const {
  std::vector<EdgeKey> sorted(edges.begin(), edges.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

Complex::Complex(double tolerance) : tolerance_(tolerance), grid_(kGridCellInWelds * geom::kWeldRatio * tolerance) {}

void Complex::keep_near(std::vector<std::array<LatticePoint, 3>> origins, double farthest,
                        std::vector<std::uint8_t> held) {
  origins_ = std::move(origins);
  farthest_ = farthest;
  held_ = std::move(held);
}

bool Complex::is_held(std::uint32_t origin) const {
  return held_.empty() || (origin != kNoOrigin && held_[origin] != 0);
}

bool Complex::is_off_plane(ClusterId cluster, PointId id) const {
  return std::abs(clusters_[cluster].plane.height(points_[id])) > farthest_;
}

bool Complex::may_imprint(ClusterId cluster, PointId id) const {
  return !(held_.empty() || clusters_[cluster].held) || !is_off_plane(cluster, id);
}

// Whether the point is too far from a surface that the items are of.
bool Complex::draws_off(std::span<const Item> items, PointId to) const {
  if (std::isinf(farthest_)) return false;
  return std::ranges::any_of(items, [&](Item item) {
    const std::uint32_t origin = item.is_piece() ? pieces_[item.piece_id()].origin : kNoOrigin;
    if (origin == kNoOrigin) return !may_imprint(cluster_of(item), to);
    return is_held(origin) && distance_to_triangle(place(to), origins_[origin]) > farthest_;
  });
}

double Complex::drawn(Item item, PointId to) const {
  const std::uint32_t origin = item.is_piece() ? pieces_[item.piece_id()].origin : kNoOrigin;
  if (origin == kNoOrigin) return std::abs(clusters_[cluster_of(item)].plane.height(points_[to]));
  return distance_to_triangle(place(to), origins_[origin]);
}

double Complex::drawn_by_merge(PointId from, PointId to) const {
  double farthest = 0;
  for (const PointId other : neighbours_[from]) {
    if (other == to) continue;
    for (const Item item : items(edge_key(from, other))) farthest = std::max(farthest, drawn(item, to));
  }
  return farthest;
}

double Complex::weld_distance() const { return geom::kWeldRatio * tolerance_; }

PointId Complex::add_point(const LatticePoint& point) {
  const auto id = static_cast<PointId>(points_.size());
  points_.push_back(point);
  neighbours_.emplace_back();
  imprinted_in_.emplace_back();
  holds_.push_back(0);
  grid_.add(id, point);
  return id;
}

ClusterId Complex::add_cluster(const Plane& plane, double area) {
  clusters_.push_back({plane, false, area, {}, {}, 1, {}});
  return static_cast<ClusterId>(clusters_.size() - 1);
}

PieceId Complex::add_piece(const Piece& piece) {
  pieces_.push_back(piece);
  if (piece.cluster != kNoCluster && is_held(piece.origin)) clusters_[piece.cluster].held = true;
  return static_cast<PieceId>(pieces_.size() - 1);
}

void Complex::place_piece(PieceId id, ClusterId cluster, bool along) {
  pieces_[id].cluster = cluster;
  pieces_[id].along = along;
  if (is_held(pieces_[id].origin)) clusters_[cluster].held = true;
}

std::span<const Item> Complex::items(EdgeKey edge) const {
  const auto found = edges_.find(edge);
  return found == edges_.end() ? std::span<const Item>()
                               : std::span<const Item>(found->second.data(), found->second.size());
}

bool Complex::edge_in_cluster(EdgeKey edge, ClusterId cluster) const {
  return std::ranges::any_of(items(edge), [&](Item item) { return cluster_of(item) == cluster; });
}

std::vector<EdgeKey> Complex::edges() const {
  std::vector<EdgeKey> all;
  all.reserve(edges_.size());
  for (const auto& [edge, list] : edges_) all.push_back(edge);
  std::sort(all.begin(), all.end());
  return all;
}

bool Complex::in_cluster(PointId id, ClusterId cluster) const {
  if (std::ranges::find(imprinted_in_[id], cluster) != imprinted_in_[id].end()) return true;
  return std::ranges::any_of(neighbours_[id],
                             [&](PointId other) { return edge_in_cluster(edge_key(id, other), cluster); });
}

double Complex::length(EdgeKey edge) const {
  const auto [a, b] = ends_of(edge);
  return distance(a, b);
}

double Complex::distance(PointId a, PointId b) const { return glm::distance(place(a), place(b)); }

void Complex::note_revival(PointId id) {
  if (!live(id)) points_revived_.push_back(id);
}

void Complex::link(EdgeKey edge) {
  const auto [a, b] = ends_of(edge);
  note_revival(a);
  note_revival(b);
  edges_added_.push_back(edge);
  neighbours_[a].push_back(b);
  neighbours_[b].push_back(a);
}

void Complex::unlink(EdgeKey edge) {
  const auto [a, b] = ends_of(edge);
  erase_one(neighbours_[a], b);
  erase_one(neighbours_[b], a);
}

void Complex::toggle(EdgeKey edge, Item item) {
  const auto [a, b] = ends_of(edge);
  if (a == b) return;
  const auto [entry, is_new] = edges_.try_emplace(edge);
  if (is_new) link(edge);
  Items& list = entry.value();
  const auto found = std::find(list.begin(), list.end(), item);
  if (found != list.end() && !item.is_piece()) return;
  touch(item);
  const ClusterId cluster = cluster_of(item);
  if (found == list.end()) {
    list.push_back(item);
    if (clusters_[cluster].edges.insert(edge).second) clusters_[cluster].added.push_back(edge);
    return;
  }
  list.erase(found);
  if (std::ranges::none_of(list, [&](Item other) { return cluster_of(other) == cluster; })) {
    clusters_[cluster].edges.erase(edge);
  }
  if (list.empty()) {
    edges_.erase(entry);
    unlink(edge);
  }
}

bool Complex::split(EdgeKey edge, PointId at, Need need) {
  const auto [a, b] = ends_of(edge);
  if (at == a || at == b) return false;
  const auto found = edges_.find(edge);
  if (found == edges_.end()) return false;
  if (need == Need::Optional && draws_off({found->second.data(), found->second.size()}, at)) {
    ++counts_.refused;
    return false;
  }
  const Items list = std::move(found.value());
  edges_.erase(found);
  unlink(edge);
  for (const Item item : list) {
    clusters_[cluster_of(item)].edges.erase(edge);
    touch(item);
    toggle(edge_key(a, at), item);
    toggle(edge_key(at, b), item);
    if (item.is_piece()) continue;
    for (const PointId id : {a, at, b}) imprint_point(item.imprinted_cluster(), id, need);
  }
  ++counts_.splits;
  splits_made_.push_back({edge, at});
  return true;
}

bool Complex::split_shortens(EdgeKey edge, PointId at) const {
  const auto [a, b] = ends_of(edge);
  const auto whole = geom::squared_distance(points_[a], points_[b]);
  return geom::squared_distance(points_[a], points_[at]) < whole &&
         geom::squared_distance(points_[at], points_[b]) < whole;
}

bool Complex::merge(PointId from, PointId to, Need need) {
  if (from == to) return false;
  const bool refused =
      (held_.empty() && distance(from, to) > farthest_) || std::ranges::any_of(neighbours_[from], [&](PointId other) {
        return other != to && draws_off(items(edge_key(from, other)), to);
      });
  if (need == Need::Optional && refused) {
    ++counts_.refused;
    return false;
  }
  counts_.largest_merge = std::max(counts_.largest_merge, distance(from, to));
  ++counts_.merges;
  merges_made_.push_back({from, to});
  merged_into_.erase(to);
  merged_into_[from] = to;
  std::vector<PointId> others(neighbours_[from].begin(), neighbours_[from].end());
  std::sort(others.begin(), others.end());
  for (const PointId other : others) {
    const EdgeKey edge = edge_key(from, other);
    const auto found = edges_.find(edge);
    const Items list = std::move(found.value());
    edges_.erase(found);
    unlink(edge);
    for (const Item item : list) {
      clusters_[cluster_of(item)].edges.erase(edge);
      touch(item);
      if (other != to) toggle(edge_key(to, other), item);
    }
  }
  const std::vector<ClusterId> imprints(imprinted_in_[from].begin(), imprinted_in_[from].end());
  for (const ClusterId cluster : imprints) {
    drop_point(cluster, from);
    imprint_point(cluster, to, need);
  }
  return true;
}

bool Complex::merge_either(PointId a, PointId b, Need need) {
  const double into_a = drawn_by_merge(b, a), into_b = drawn_by_merge(a, b);
  if (into_a != into_b ? into_b < into_a : precedes(b, a)) std::swap(a, b);
  return merge(b, a) || merge(a, b) || (need == Need::Sound && merge(b, a, need));
}

bool Complex::imprint_point(ClusterId cluster, PointId id, Need need) {
  if (need == Need::Optional && !may_imprint(cluster, id)) return false;
  if (!clusters_[cluster].points.insert(id).second) return false;
  note_revival(id);
  imprinted_in_[id].push_back(cluster);
  ++clusters_[cluster].version;
  ++counts_.imprints;
  return true;
}

void Complex::drop_point(ClusterId cluster, PointId id) {
  if (clusters_[cluster].points.erase(id) == 0) return;
  erase_one(imprinted_in_[id], cluster);
  ++clusters_[cluster].version;
}

void Complex::refresh_search() {
  first_unsettled_ = static_cast<PointId>(points_.size());
  std::vector<geom::LatticeBox> boxes;
  std::vector<std::uint32_t> items;
  for (; edges_searched_ < edges_added_.size(); ++edges_searched_) {
    const auto [a, b] = ends_of(edges_added_[edges_searched_]);
    if (!edges_.contains(edges_added_[edges_searched_])) continue;
    boxes.push_back(geom::box_of(std::array{points_[a], points_[b]}));
    items.push_back(static_cast<std::uint32_t>(edges_searched_));
  }
  edge_tree_.add(std::move(boxes), std::move(items),
                 [&](std::uint32_t at) { return edges_.contains(edges_added_[at]); });
  boxes = {};
  items = {};
  for (; points_searched_ < points_revived_.size(); ++points_searched_) {
    boxes.push_back(geom::box_of(std::span(&points_[points_revived_[points_searched_]], 1)));
    items.push_back(static_cast<std::uint32_t>(points_searched_));
  }
  point_tree_.add(std::move(boxes), std::move(items), [&](std::uint32_t at) { return live(points_revived_[at]); });
}

PointId Complex::nearest(const dvec3& place, double reach) const {
  PointId best = scene::kNoPoint;
  double best_distance = 0;
  for_each_point_near(place, reach, [&](PointId id) {
    const double away = glm::distance(this->place(id), place);
    if (away > reach) return;
    if (best == scene::kNoPoint || away < best_distance || (away == best_distance && precedes(id, best))) {
      best = id;
      best_distance = away;
    }
  });
  return best;
}

PointId Complex::became(PointId id) const {
  for (auto next = merged_into_.find(id); next != merged_into_.end(); next = merged_into_.find(id)) id = next->second;
  return id;
}

// What took the place of a point that was here: to make that anew would go round in a circle.
PointId Complex::became_of_merged(const dvec3& place) const {
  const double near = kSamePlace * tolerance_;
  PointId best = scene::kNoPoint;
  double best_distance = 0;
  grid_.for_each_near(place, near, [&](PointId id) {
    const double away = glm::distance(this->place(id), place);
    if (away > near || present(id)) return;
    if (best != scene::kNoPoint && (away > best_distance || (away == best_distance && !precedes(id, best)))) return;
    const PointId now = became(id);
    if (now == id || !present(now) || glm::distance(this->place(now), place) > kFarthestMerge * weld_distance()) return;
    best = now;
    best_distance = away;
  });
  return best;
}

PointId Complex::point_at(const dvec3& place, double reach) {
  if (const PointId found = nearest(place, reach); found != scene::kNoPoint) return found;
  const LatticePoint rounded{static_cast<std::int32_t>(std::lround(place.x)),
                             static_cast<std::int32_t>(std::lround(place.y)),
                             static_cast<std::int32_t>(std::lround(place.z))};
  if (const PointId found = nearest(geom::as_vector(rounded), reach); found != scene::kNoPoint) return found;
  if (const PointId found = became_of_merged(geom::as_vector(rounded)); reach > 0 && found != scene::kNoPoint)
    return found;
  const PointId id = add_point(rounded);
  ++counts_.new_points;
  return id;
}

}  // namespace rad::repair
