#include "corpus/mutate/survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace rad::corpus {
namespace {

constexpr double kGrainShare = 1e-3;
constexpr int kSpotTries = 60;

double segment_distance(const dvec3& point, const dvec3& a, const dvec3& b) {
  const dvec3 along = b - a;
  const double squared = glm::dot(along, along);
  const double t = squared > 0 ? std::clamp(glm::dot(point - a, along) / squared, 0.0, 1.0) : 0;
  return glm::distance(point, a + t * along);
}

std::vector<VertexId> first_vertices_by_place(const scene::Scene& scene) {
  std::map<std::array<double, 3>, VertexId> places;
  std::vector<VertexId> first;
  for (VertexId id = 0; id < scene.vertices.size(); ++id) {
    const dvec3& p = scene.vertices[id];
    first.push_back(places.emplace(std::array{p.x, p.y, p.z}, id).first->second);
  }
  return first;
}

template <typename Visit>
void for_each_side(const scene::Scene& scene, const scene::Face& face, Visit visit) {
  for (std::uint32_t l = 0; l < face.loop_count; ++l) {
    const auto corners = scene.corners_of(scene.loops[face.first_loop + l]);
    for (std::uint32_t c = 0; c < corners.size(); ++c) visit(l, c, corners[c], corners[(c + 1) % corners.size()]);
  }
}

dvec3 area_normal(const scene::Scene& scene, const scene::Face& face) {
  dvec3 sum{0, 0, 0};
  for_each_side(scene, face,
                [&](auto, auto, VertexId a, VertexId b) { sum += glm::cross(scene.vertices[a], scene.vertices[b]); });
  return sum / 2.0;
}

bool holds(const geom::Box& box, const dvec3& p) {
  return p.x > box.low.x && p.x < box.high.x && p.y > box.low.y && p.y < box.high.y && p.z > box.low.z &&
         p.z < box.high.z;
}

void drop_bridges(std::vector<EdgeUse>& uses) {
  for (std::size_t i = 0; i < uses.size(); ++i) {
    for (std::size_t j = i + 1; j < uses.size(); ++j) {
      if (uses[i].face != uses[j].face || uses[i].forward == uses[j].forward) continue;
      uses.erase(uses.begin() + static_cast<std::ptrdiff_t>(j));
      uses.erase(uses.begin() + static_cast<std::ptrdiff_t>(i--));
      break;
    }
  }
}

}  // namespace

Survey::Survey(const scene::Scene& scene) : scene_(scene), first_at_(first_vertices_by_place(scene)) {
  geom::Box box;
  for (const dvec3& p : scene.vertices) box.add(p);
  grain_ = kGrainShare * box.diagonal();
  for (const scene::Face& face : scene.faces) normals_.push_back(glm::normalize(area_normal(scene, face)));
  find_edges();
  find_objects();
  find_private();
}

void Survey::find_edges() {
  std::map<std::pair<VertexId, VertexId>, std::vector<EdgeUse>> uses;
  for (FaceId id = 0; id < scene_.faces.size(); ++id) {
    for_each_side(scene_, scene_.faces[id], [&](std::uint32_t loop, std::uint32_t corner, VertexId a, VertexId b) {
      a = first_at_[a];
      b = first_at_[b];
      uses[std::minmax(a, b)].push_back({id, loop, corner, a < b});
    });
  }
  for (auto& [ends, list] : uses) {
    drop_bridges(list);
    if (!list.empty()) edges_.push_back({ends.first, ends.second, std::move(list)});
  }
}

void Survey::find_objects() {
  objects_.resize(scene_.objects.size());
  std::vector<scene::ObjectId> owner(scene_.vertices.size(), std::numeric_limits<scene::ObjectId>::max());
  for (FaceId id = 0; id < scene_.faces.size(); ++id) {
    ObjectFacts& object = objects_[scene_.faces[id].object];
    object.faces.push_back(id);
    const dvec3 anchor = scene_.vertices[outer(id)[0]];
    object.volume += glm::dot(area_normal(scene_, scene_.faces[id]), anchor) / 3;
    for_each_side(scene_, scene_.faces[id], [&](auto, auto, VertexId a, VertexId) {
      object.box.add(scene_.vertices[a]);
      scene::ObjectId& known = owner[first_at_[a]];
      if (known < objects_.size() && known != scene_.faces[id].object) object.alone = objects_[known].alone = false;
      known = scene_.faces[id].object;
    });
  }
  for (const Edge& edge : edges_) {
    std::map<scene::ObjectId, std::pair<int, int>> tally;
    for (const EdgeUse& use : edge.uses) {
      auto& [count, balance] = tally[scene_.faces[use.face].object];
      ++count;
      balance += use.forward ? 1 : -1;
    }
    for (const auto& [id, counts] : tally) {
      if (counts != std::pair{2, 0}) objects_[id].closed = false;
    }
  }
  for (scene::ObjectId id = 0; id < objects_.size(); ++id) {
    for (VertexId v = 0; v < scene_.vertices.size(); ++v) {
      if (owner[first_at_[v]] != id && holds(objects_[id].box, scene_.vertices[v])) objects_[id].holds_others = true;
    }
  }
}

void Survey::find_private() {
  private_.assign(scene_.faces.size(), true);
  contact_vertex_.assign(scene_.vertices.size(), false);
  std::vector<std::size_t> corners(scene_.faces.size(), 0);
  for (const Edge& edge : edges_) {
    const bool shared = edge.uses.size() == 2 && edge.uses[0].face != edge.uses[1].face &&
                        scene_.faces[edge.uses[0].face].object == scene_.faces[edge.uses[1].face].object;
    if (!shared) contact_vertex_[edge.a] = contact_vertex_[edge.b] = true;
    for (const EdgeUse& use : edge.uses) {
      ++corners[use.face];
      if (!shared) private_[use.face] = false;
    }
  }
  for (FaceId id = 0; id < scene_.faces.size(); ++id) {
    // A ring with a bridge has more corners than edges that count.
    if (scene_.faces[id].loop_count > 1 || corners[id] != outer(id).size()) private_[id] = false;
  }
}

geom::Box Survey::box(FaceId face) const {
  geom::Box box;
  for (const VertexId id : outer(face)) box.add(scene_.vertices[id]);
  return box;
}

std::span<const VertexId> Survey::outer(FaceId face) const {
  return scene_.corners_of(scene_.loops[scene_.faces[face].first_loop]);
}

std::vector<FaceId> Survey::faces_at(VertexId vertex) const {
  std::vector<FaceId> faces;
  for (FaceId id = 0; id < scene_.faces.size(); ++id) {
    bool meets = false;
    for_each_side(scene_, scene_.faces[id], [&](auto, auto, VertexId a, VertexId) { meets |= first_at_[a] == vertex; });
    if (meets) faces.push_back(id);
  }
  return faces;
}

// Odd crossings of the rings with a ray in the face's plane, along the two axes that its normal leaves.
bool Survey::inside(FaceId face, const dvec3& point) const {
  const dvec3 n = glm::abs(normals_[face]);
  const int dropped = n.x >= n.y && n.x >= n.z ? 0 : n.y >= n.z ? 1 : 2;
  const int i = (dropped + 1) % 3, j = (dropped + 2) % 3;
  bool odd = false;
  for_each_side(scene_, scene_.faces[face], [&](auto, auto, VertexId from, VertexId to) {
    const dvec3 &a = scene_.vertices[from], &b = scene_.vertices[to];
    if ((a[j] > point[j]) == (b[j] > point[j])) return;
    if (point[i] < a[i] + (point[j] - a[j]) / (b[j] - a[j]) * (b[i] - a[i])) odd = !odd;
  });
  return odd;
}

double Survey::boundary_distance(FaceId face, const dvec3& point) const {
  double least = std::numeric_limits<double>::infinity();
  for_each_side(scene_, scene_.faces[face], [&](auto, auto, VertexId a, VertexId b) {
    least = std::min(least, segment_distance(point, scene_.vertices[a], scene_.vertices[b]));
  });
  return least;
}

double Survey::face_distance(FaceId face, const dvec3& point) const {
  const double height = glm::dot(normals_[face], point - scene_.vertices[outer(face)[0]]);
  if (inside(face, point - height * normals_[face])) return std::abs(height);
  return boundary_distance(face, point);
}

double Survey::distance(const dvec3& point, std::span<const FaceId> skipped) const {
  double least = std::numeric_limits<double>::infinity();
  for (FaceId id = 0; id < scene_.faces.size(); ++id) {
    if (std::find(skipped.begin(), skipped.end(), id) == skipped.end())
      least = std::min(least, face_distance(id, point));
  }
  return least;
}

std::optional<Spot> Survey::random_spot(Random& random, FaceId face) const {
  const auto ring = outer(face);
  // A random mean of three corners: anywhere in the hull of the face, often in the face.
  const std::array<VertexId, 3> corners{ring[random.index(ring.size())], ring[random.index(ring.size())],
                                        ring[random.index(ring.size())]};
  const double s = std::sqrt(random.unit()), t = random.unit();
  const dvec3 point =
      (1 - s) * position(corners[0]) + s * (1 - t) * position(corners[1]) + s * t * position(corners[2]);
  if (!inside(face, point)) return std::nullopt;
  Spot spot{.face = face, .point = point, .normal = normals_[face]};
  spot.clearance = std::min(boundary_distance(face, point), distance(point, std::span(&face, 1)));
  const dvec3 helper = std::abs(spot.normal.z) < 0.9 ? dvec3{0, 0, 1} : dvec3{1, 0, 0};
  const dvec3 p = glm::normalize(glm::cross(helper, spot.normal)), q = glm::cross(spot.normal, p);
  const double angle = 2 * std::numbers::pi * random.unit();
  spot.u = std::cos(angle) * p + std::sin(angle) * q;
  spot.v = glm::cross(spot.normal, spot.u);
  return spot;
}

std::optional<Spot> Survey::spot(Random& random, double clearance) const {
  for (int attempt = 0; attempt < kSpotTries; ++attempt) {
    const auto face = static_cast<FaceId>(random.index(scene_.faces.size()));
    auto found = random_spot(random, face);
    if (found && found->clearance >= clearance) return found;
  }
  return std::nullopt;
}

std::optional<Spot> Survey::free_spot(Random& random, double clearance) const {
  for (int attempt = 0; attempt < kSpotTries; ++attempt) {
    auto found = spot(random, 2 * clearance);
    if (!found) return std::nullopt;
    found->point += found->normal * (found->clearance / 2);
    found->clearance = distance(found->point);
    if (found->clearance >= clearance) return found;
  }
  return std::nullopt;
}

}  // namespace rad::corpus
