#include "repair/triangulation.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "repair/cluster_map.h"

namespace rad::repair {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

std::array<PointId, 3> smallest_first(std::array<PointId, 3> points) {
  std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
  return points;
}

// The piece of one facing that wins: the least rank, then the least id.
const PieceId* winner(const Complex& complex, const std::vector<PieceId>& cover, bool along) {
  const PieceId* best = nullptr;
  for (const PieceId& id : cover) {
    if (complex.pieces()[id].along != along) continue;
    if (!best || complex.pieces()[id].rank < complex.pieces()[*best].rank) best = &id;
  }
  return best;
}

void append(Stacking& to, const Stacking& from) {
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  to.points_on_edges.insert(to.points_on_edges.end(), from.points_on_edges.begin(), from.points_on_edges.end());
  to.crossing |= from.crossing;
}

}  // namespace

std::uint32_t Triangulation::add(const Triangle& triangle) {
  triangles_.push_back(triangle);
  alive_.push_back(0);
  exists_.push_back(1);
  next_same_.push_back(kNone);
  return static_cast<std::uint32_t>(triangles_.size() - 1);
}

void Triangulation::set_alive(std::uint32_t triangle, bool alive) {
  if (alive && !alive_[triangle]) fresh_.push_back(triangle);
  alive_[triangle] = alive ? 1 : 0;
}

std::uint32_t Triangulation::add_as_it_is(std::array<PointId, 3> points, PieceId piece) {
  const std::uint32_t number = add({smallest_first(points), kNoCluster, true, piece, 0});
  as_they_are_.push_back(number);
  set_alive(number, true);
  return number;
}

void Triangulation::remove_as_it_is(std::uint32_t triangle) {
  exists_[triangle] = 0;
  set_alive(triangle, false);
}

Triangulation::Map Triangulation::triangulate(const Complex& complex, ClusterId cluster) {
  Map result;
  ClusterPart& part = result.part;
  part.version = complex.clusters()[cluster].version;
  ClusterMap map(complex, cluster);
  part.stacking = map.stacking();
  map.flip_slivers(complex.tolerance());
  part.covers = map.covers();
  for (std::size_t i = 0; i < map.triangles().size(); ++i) {
    const std::uint32_t cover = map.cover(i);
    for (const bool along : {true, false}) {
      const PieceId* best = winner(complex, part.covers[cover], along);
      if (!best) continue;
      std::array<PointId, 3> points = map.points(i);
      if (!along) std::swap(points[1], points[2]);
      result.triangles.push_back({smallest_first(points), cluster, along, *best, cover});
    }
  }
  return result;
}

// Of triangles with the same points, facing the same way, the one of the largest cluster is there; of equal ones that
// of the first.
void Triangulation::choose(const Complex& complex, std::uint32_t any_of_them) {
  const auto found = first_of_.find(triangles_[any_of_them].points);
  if (found == first_of_.end()) return;
  const auto area = [&](std::uint32_t i) { return complex.clusters()[triangles_[i].cluster].area; };
  std::uint32_t best = found->second;
  for (std::uint32_t i = next_same_[best]; i != kNone; i = next_same_[i]) {
    const double own = area(i), bests = area(best);
    if (own > bests || (own == bests && triangles_[i].cluster < triangles_[best].cluster)) best = i;
  }
  for (std::uint32_t i = found->second; i != kNone; i = next_same_[i]) set_alive(i, i == best);
}

void Triangulation::enter(const Complex& complex, std::uint32_t triangle) {
  const auto [entry, is_new] = first_of_.try_emplace(triangles_[triangle].points, triangle);
  if (is_new) {
    set_alive(triangle, true);
    return;
  }
  next_same_[triangle] = entry->second;
  entry.value() = triangle;
  choose(complex, triangle);
}

void Triangulation::leave(const Complex& complex, std::uint32_t triangle) {
  exists_[triangle] = 0;
  set_alive(triangle, false);
  const auto entry = first_of_.find(triangles_[triangle].points);
  if (entry->second == triangle) {
    if (next_same_[triangle] == kNone) {
      first_of_.erase(entry);
      return;
    }
    entry.value() = next_same_[triangle];
  } else {
    std::uint32_t before = entry->second;
    while (next_same_[before] != triangle) before = next_same_[before];
    next_same_[before] = next_same_[triangle];
  }
  next_same_[triangle] = kNone;
  choose(complex, triangle);
}

// Triangles that stay keep their numbers.
void Triangulation::take_over(const Complex& complex, ClusterId cluster, Map map) {
  std::vector<std::uint32_t> old = clusters_[cluster].triangles;
  std::sort(old.begin(), old.end(),
            [&](std::uint32_t a, std::uint32_t b) { return triangles_[a].points < triangles_[b].points; });
  std::vector<std::uint32_t> order(map.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(map.triangles[a].points, a) < std::tie(map.triangles[b].points, b);
  });
  std::vector<std::uint32_t> number(map.triangles.size(), kNone), gone;
  std::size_t at = 0;
  for (const std::uint32_t i : order) {
    while (at < old.size() && triangles_[old[at]].points < map.triangles[i].points) gone.push_back(old[at++]);
    if (at < old.size() && triangles_[old[at]].points == map.triangles[i].points) number[i] = old[at++];
  }
  gone.insert(gone.end(), old.begin() + static_cast<std::ptrdiff_t>(at), old.end());
  for (const std::uint32_t i : gone) leave(complex, i);
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] != kNone) {
      triangles_[number[i]] = map.triangles[i];
      continue;
    }
    number[i] = add(map.triangles[i]);
    enter(complex, number[i]);
  }
  folded_[cluster] = map.part.sound() ? 0 : 1;
  if (folded_[cluster]) fresh_.insert(fresh_.end(), number.begin(), number.end());
  map.part.triangles = std::move(number);
  clusters_[cluster] = std::move(map.part);
}

void Triangulation::update(const Complex& complex) {
  const auto clusters = complex.clusters();
  clusters_.resize(clusters.size());
  folded_.resize(clusters.size(), 0);
  std::vector<ClusterId> changed;
  for (ClusterId id = 0; id < clusters.size(); ++id) {
    if (clusters_[id].version != clusters[id].version) changed.push_back(id);
  }
  std::vector<Map> maps(changed.size());
  tbb::parallel_for(std::size_t{0}, changed.size(), [&](std::size_t i) { maps[i] = triangulate(complex, changed[i]); });
  for (std::size_t i = 0; i < changed.size(); ++i) take_over(complex, changed[i], std::move(maps[i]));
  stacking_ = {};
  for (const ClusterPart& part : clusters_) append(stacking_, part.stacking);
}

bool Triangulation::hides_others(const Complex& complex, const Triangle& triangle) const {
  if (triangle.cluster == kNoCluster) return false;
  return std::ranges::any_of(cover_of(triangle), [&](PieceId id) {
    return id != triangle.winner && complex.pieces()[id].along == triangle.along;
  });
}

std::vector<std::uint32_t> Triangulation::living() const {
  std::vector<std::uint32_t> all;
  const auto add_living = [&](std::uint32_t i) {
    if (alive_[i]) all.push_back(i);
  };
  for (const ClusterPart& part : clusters_) std::ranges::for_each(part.triangles, add_living);
  std::ranges::for_each(as_they_are_, add_living);
  return all;
}

std::vector<std::uint32_t> Triangulation::take_fresh() {
  std::sort(fresh_.begin(), fresh_.end());
  fresh_.erase(std::unique(fresh_.begin(), fresh_.end()), fresh_.end());
  std::erase_if(fresh_, [&](std::uint32_t i) { return !alive_[i]; });
  return std::exchange(fresh_, {});
}

}  // namespace rad::repair
