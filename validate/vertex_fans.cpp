#include "validate/vertex_fans.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <span>

#include "scene/disjoint_sets.h"

namespace rad::validate {
namespace {

// Subedges by the vertex that they end at with their larger id; those by the smaller are in order already.
struct EndingAt {
  std::vector<std::uint32_t> start;  ///< per point, one more than there are points
  std::vector<std::uint32_t> subedge;
};

EndingAt subedges_by_larger_end(const Context& context) {
  const auto& subedges = context.topology.subedges;
  EndingAt ending{std::vector<std::uint32_t>(context.model.points.size() + 1, 0),
                  std::vector<std::uint32_t>(subedges.size())};
  for (const Subedge& subedge : subedges) ++ending.start[subedge.b + 1];
  std::partial_sum(ending.start.begin(), ending.start.end(), ending.start.begin());
  std::vector<std::uint32_t> next = ending.start;
  for (std::uint32_t i = 0; i < subedges.size(); ++i) ending.subedge[next[subedges[i].b]++] = i;
  return ending;
}

// The faces around one vertex, and which of them share a subedge there.
class Fans {
 public:
  explicit Fans(const Context& context) : context_(context) {}

  void clear() {
    faces_.clear();
    links_.clear();
  }

  void add(const Subedge& subedge) {
    const auto coedges = context_.topology.coedges_of(subedge);
    const std::size_t first = faces_.size();
    for (const Coedge& coedge : coedges) faces_.push_back(coedge.face);
    const auto users = std::span(faces_).subspan(first);
    if (users.size() > 2) std::ranges::sort(users, {}, [&](FaceId face) { return context_.object_of(face); });
    for (std::size_t i = 1; i < users.size(); ++i) {
      if (context_.object_of(users[i]) == context_.object_of(users[i - 1])) links_.push_back({users[i - 1], users[i]});
    }
  }

  // Appends a record for each object with more than one fan.
  void collect(PointId vertex, std::vector<PinchedVertex>& out) {
    std::ranges::sort(faces_);
    faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
    scene::DisjointSets sets(static_cast<std::uint32_t>(faces_.size()));
    for (const auto& [a, b] : links_) sets.unite(slot(a), slot(b));
    std::vector<FaceId> heads = first_of_each(sets);
    if (heads.size() < 2) return;
    std::ranges::sort(heads, [&](FaceId a, FaceId b) { return context_.precedes(a, b); });
    std::ranges::stable_sort(heads, {}, [&](FaceId face) { return context_.object_of(face); });
    for (std::size_t begin = 0; begin < heads.size();) {
      std::size_t end = begin + 1;
      while (end < heads.size() && context_.object_of(heads[end]) == context_.object_of(heads[begin])) ++end;
      if (end - begin > 1) {
        out.push_back({vertex, {heads[begin], heads[begin + 1]}, static_cast<std::uint32_t>(end - begin)});
      }
      begin = end;
    }
  }

 private:
  [[nodiscard]] std::uint32_t slot(FaceId face) const {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(faces_, face) - faces_.begin());
  }

  std::vector<FaceId> first_of_each(scene::DisjointSets& sets) const {
    std::size_t fans = 0;
    for (std::uint32_t i = 0; i < faces_.size(); ++i) fans += sets.find(i) == i ? 1 : 0;
    if (fans < 2) return {};
    std::vector<FaceId> first(faces_.size(), kNoFace);
    for (std::uint32_t i = 0; i < faces_.size(); ++i) {
      FaceId& head = first[sets.find(i)];
      if (head == kNoFace || context_.precedes(faces_[i], head)) head = faces_[i];
    }
    std::erase(first, kNoFace);
    return first;
  }

  const Context& context_;
  std::vector<FaceId> faces_;
  std::vector<std::array<FaceId, 2>> links_;
};

}  // namespace

std::vector<PinchedVertex> find_pinched_vertices(const Context& context) {
  const auto& subedges = context.topology.subedges;
  const EndingAt ending = subedges_by_larger_end(context);
  tbb::enumerable_thread_specific<std::vector<PinchedVertex>> found;
  constexpr std::size_t kVerticesPerBlock = 4096;
  const auto points = static_cast<PointId>(context.model.points.size());
  tbb::parallel_for(tbb::blocked_range<PointId>(0, points, kVerticesPerBlock), [&](const auto& range) {
    auto& own = found.local();
    Fans fans(context);
    auto next = std::ranges::lower_bound(subedges, range.begin(), {}, &Subedge::a);
    for (PointId vertex = range.begin(); vertex != range.end(); ++vertex) {
      fans.clear();
      for (; next != subedges.end() && next->a == vertex; ++next) fans.add(*next);
      for (std::uint32_t i = ending.start[vertex]; i < ending.start[vertex + 1]; ++i) {
        fans.add(subedges[ending.subedge[i]]);
      }
      fans.collect(vertex, own);
    }
  });
  std::vector<PinchedVertex> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  std::ranges::sort(all, [&](const PinchedVertex& x, const PinchedVertex& y) {
    if (x.vertex != y.vertex) return x.vertex < y.vertex;
    return x.faces[0] != y.faces[0] && context.precedes(x.faces[0], y.faces[0]);
  });
  return all;
}

}  // namespace rad::validate
