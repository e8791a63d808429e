#include "mesh/face_outline.h"

#include <unordered_map>

#include "geom/predicates.h"

namespace rad::mesh {
namespace {

class OutlineBuilder {
 public:
  OutlineBuilder(const scene::ConformingModel& model, const EdgeDivision& division)
      : model_(model), division_(division) {}

  void add_loop(std::span<const PointId> ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PointId from = ring[i], to = ring[(i + 1) % ring.size()];
      const std::uint32_t parts = add_edge(from, to, face_.outline);
      const std::int64_t length = geom::squared_distance(model_.points[from], model_.points[to]);
      if (length > longest_) {
        longest_ = length;
        face_.longest_edge = {from, to};
        face_.longest_edge_parts = parts;
      }
    }
  }
  void add_inner_edge(const std::array<PointId, 2>& edge) { add_edge(edge[0], edge[1], face_.inner); }
  void add_single(PointId point) {
    const auto before = face_.ids.size();
    const std::uint32_t index = index_of(point);
    if (index == before) face_.single.push_back(index);
  }
  FaceOutline take() { return std::move(face_); }

 private:
  std::uint32_t index_of(PointId point) {
    const auto [entry, added] = indices_.try_emplace(point, static_cast<std::uint32_t>(face_.ids.size()));
    if (added) face_.ids.push_back(point);
    return entry->second;
  }
  std::uint32_t add_edge(PointId from, PointId to, std::vector<PointEdge>& edges) {
    std::vector<PointId> chain;
    division_.append_chain(from, to, chain);
    chain.push_back(to);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const std::uint32_t start = index_of(chain[i - 1]);
      edges.push_back({start, index_of(chain[i])});
    }
    return static_cast<std::uint32_t>(chain.size() - 1);
  }

  const scene::ConformingModel& model_;
  const EdgeDivision& division_;
  FaceOutline face_;
  std::unordered_map<PointId, std::uint32_t> indices_;
  std::int64_t longest_ = -1;
};

}  // namespace

FaceOutline face_outline(const scene::ConformingModel& model, const scene::ConformingFace& face,
                         const EdgeDivision& division) {
  OutlineBuilder builder(model, division);
  for (const scene::Loop& loop : model.loops_of(face)) builder.add_loop(model.corners_of(loop));
  for (const auto& edge : model.inner_edges_of(face)) builder.add_inner_edge(edge);
  for (const auto& triangle : model.triangles_of(face)) {
    for (const PointId point : triangle) builder.add_single(point);
  }
  return builder.take();
}

}  // namespace rad::mesh
