#include "repair/surface_order.h"

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>
#include <utility>

#include "scene/disjoint_sets.h"

namespace rad::repair {
namespace {

// Equal sheets must not change places for the noise of their measures.
constexpr double kAreaBand = 1e-3;

constexpr std::array<std::pair<std::string_view, CoplanarPolicy>, 5> kPolicies{{
    {"paper", CoplanarPolicy::Paper},
    {"area", CoplanarPolicy::Area},
    {"priority", CoplanarPolicy::Priority},
    {"keep-first", CoplanarPolicy::KeepFirst},
    {"keep-last", CoplanarPolicy::KeepLast},
}};

bool is_letter(const std::string& text, std::size_t at) {
  return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
}

// "decal" as a word of its own, in any case: "Decal.001", "floor_decal", not "decalcified".
bool is_decal(const std::string& name) {
  constexpr std::string_view kWord = "decal";
  std::string lower = name;
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (std::size_t at = lower.find(kWord); at != std::string::npos; at = lower.find(kWord, at + 1)) {
    if ((at == 0 || !is_letter(lower, at - 1)) && !is_letter(lower, at + kWord.size())) return true;
  }
  return false;
}

std::size_t level_of(const std::string& material, const std::string& object, const CoplanarOptions& options) {
  const auto fits = [&](const std::string& pattern) {
    return fnmatch(pattern.c_str(), material.c_str(), 0) == 0 || fnmatch(pattern.c_str(), object.c_str(), 0) == 0;
  };
  const auto found = std::ranges::find_if(options.priority, fits);
  const auto level = static_cast<std::size_t>(found - options.priority.begin());
  return found == options.priority.end() && !is_decal(material) && !is_decal(object) ? level + 1 : level;
}

std::vector<scene::PointId> points_of(const validate::Context& context, scene::FaceId face) {
  std::vector<scene::PointId> points;
  for (const scene::Loop& loop : context.scene.loops_of(context.scene.faces[face])) {
    const auto corners = context.model.corners_of(loop);
    points.insert(points.end(), corners.begin(), corners.end());
  }
  return points;
}

// FNV-1a over the coordinates of the points, which are in the order of space.
std::uint64_t hash_of(const validate::Context& context, std::vector<scene::PointId> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const scene::PointId id : points) {
    const geom::LatticePoint& p = context.model.points[id];
    for (const std::int32_t value : {p.x, p.y, p.z}) {
      hash = (hash ^ static_cast<std::uint32_t>(value)) * 0x100000001b3u;
    }
  }
  return hash;
}

bool equal_areas(double a, double b) { return std::abs(a - b) <= kAreaBand * std::max(a, b); }

}  // namespace

std::optional<CoplanarPolicy> parse_coplanar_policy(std::string_view name) {
  const auto found = std::ranges::find(kPolicies, name, &decltype(kPolicies)::value_type::first);
  return found == kPolicies.end() ? std::nullopt : std::optional(found->second);
}

SurfaceOrder::SurfaceOrder(const validate::Context& context, const CoplanarOptions& options)
    : policy_(options.policy),
      emitters_first_(options.policy == CoplanarPolicy::Paper && options.emitter_priority),
      surface_of_face_(context.topology.surface_of_face) {
  gather(context, options);
  find_equals(context);
  sort();
}

// Areas are summed as whole numbers: the order of faces must not show in the last digit.
void SurfaceOrder::gather(const validate::Context& context, const CoplanarOptions& options) {
  surfaces_.resize(context.scene.faces.size());
  std::vector<geom::Int128> doubled_area(surfaces_.size(), 0);
  for (scene::FaceId face = 0; face < surfaces_.size(); ++face) {
    Surface& surface = surfaces_[surface_of_face_[face]];
    const std::string& object = context.scene.objects[context.object_of(face)];
    const scene::Material& material = context.scene.materials[context.material_of(face)];
    const std::size_t level = level_of(material.name, object, options);
    const bool fresh = surface_of_face_[face] == face;  // the representative is the first face of its surface
    if (fresh) {
      surface.first = face;
      surface.material = context.material_of(face);
      surface.material_name = material.name;
      surface.emits = material.emits();
    }
    surface.level = fresh ? level : std::min(surface.level, level);
    surface.object_name = fresh ? object : std::min(surface.object_name, object);
    surface.last = face;
    doubled_area[surface_of_face_[face]] += std::llround(glm::length(context.triangles.normal[face]));
    for (const scene::PointId point : points_of(context, face)) {
      surface.smallest_point = std::min(surface.smallest_point, point);
    }
  }
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    surfaces_[i].area = surfaces_[i].class_area = static_cast<double>(doubled_area[i]) / 2;
  }
}

// Surfaces that overlap each other and are equal in all but content are of one class, and so is what overlaps and
// equals one of them.
void SurfaceOrder::find_equals(const validate::Context& context) {
  scene::DisjointSets classes(surfaces_.size());
  std::vector<scene::FaceId> equals;
  for (const validate::FaceContact& contact : context.contacts.faces) {
    if (contact.kind != geom::ContactKind::Overlap || !contact.same_facing) continue;
    const scene::FaceId a = surface_of_face_[contact.a], b = surface_of_face_[contact.b];
    if (a == b || surfaces_[a].level != surfaces_[b].level || surfaces_[a].emits != surfaces_[b].emits) continue;
    if (!equal_areas(surfaces_[a].area, surfaces_[b].area)) continue;
    classes.unite(a, b);
    equals.insert(equals.end(), {a, b});
  }
  std::sort(equals.begin(), equals.end());
  equals.erase(std::unique(equals.begin(), equals.end()), equals.end());
  std::vector<double> least(surfaces_.size(), INFINITY);
  for (const scene::FaceId id : equals) {
    const std::uint32_t root = classes.find(id);
    least[root] = std::min(least[root], surfaces_[id].area);
  }
  for (const scene::FaceId id : equals) surfaces_[id].class_area = least[classes.find(id)];
  if (!equals.empty()) hash_contents(context, equals);
}

void SurfaceOrder::hash_contents(const validate::Context& context, std::span<const scene::FaceId> equals) {
  std::vector<std::vector<scene::PointId>> points(surfaces_.size());
  for (scene::FaceId face = 0; face < surfaces_.size(); ++face) {
    const scene::FaceId id = surface_of_face_[face];
    if (!std::ranges::binary_search(equals, id)) continue;
    const auto own = points_of(context, face);
    points[id].insert(points[id].end(), own.begin(), own.end());
  }
  for (const scene::FaceId id : equals) surfaces_[id].content = hash_of(context, std::move(points[id]));
}

bool SurfaceOrder::before(const Surface& a, const Surface& b) const {
  if (a.level != b.level) return a.level < b.level;
  if (emitters_first_ && a.emits != b.emits) return a.emits;
  if (policy_ == CoplanarPolicy::KeepFirst) return a.first < b.first;
  if (policy_ == CoplanarPolicy::KeepLast) return a.last > b.last;
  if (policy_ != CoplanarPolicy::Priority && a.class_area != b.class_area) return a.class_area < b.class_area;
  const auto content = [](const Surface& s) {
    return std::tie(s.material_name, s.object_name, s.content, s.smallest_point, s.first);
  };
  return content(a) < content(b);
}

void SurfaceOrder::sort() {
  std::vector<scene::FaceId> order;
  for (scene::FaceId face = 0; face < surfaces_.size(); ++face) {
    if (surface_of_face_[face] == face) order.push_back(face);
  }
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return before(surfaces_[a], surfaces_[b]); });
  std::vector<std::uint32_t> rank_of_surface(surfaces_.size(), 0);
  for (std::uint32_t rank = 0; rank < order.size(); ++rank) rank_of_surface[order[rank]] = rank;
  ranks_.resize(surfaces_.size());
  for (scene::FaceId face = 0; face < ranks_.size(); ++face) ranks_[face] = rank_of_surface[surface_of_face_[face]];
}

OrderRule SurfaceOrder::decided_by(scene::FaceId winner, scene::FaceId loser) const {
  const Surface& a = surfaces_[surface_of_face_[winner]];
  const Surface& b = surfaces_[surface_of_face_[loser]];
  if (a.level != b.level) return OrderRule::Priority;
  if (emitters_first_ && a.emits != b.emits) return OrderRule::Emitter;
  if (a.material == b.material) return OrderRule::SameMaterial;
  if (by_file()) return OrderRule::FileOrder;
  if (policy_ != CoplanarPolicy::Priority && a.class_area != b.class_area) return OrderRule::Area;
  return OrderRule::Content;
}

}  // namespace rad::repair
