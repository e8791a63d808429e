#include "scene/texture_map.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "scene/face_map.h"

namespace rad::scene {
namespace {

std::tuple<double, double, double> in_order(const dvec3& p) { return {p.x, p.y, p.z}; }

/// The corner with the largest measure, ties by place.
template <typename MeasureOf>
CornerId farthest(const Scene& scene, const Face& face, MeasureOf measure_of) {
  CornerId best = scene.loops[face.first_loop].first;
  double largest = -1;
  for (const Loop& loop : scene.loops_of(face)) {
    for (CornerId corner = loop.first; corner < loop.first + loop.count; ++corner) {
      const dvec3& place = scene.vertices[scene.corners[corner]];
      const double measure = measure_of(place);
      const dvec3& known = scene.vertices[scene.corners[best]];
      if (!(measure > largest || (measure == largest && in_order(place) < in_order(known)))) continue;
      best = corner;
      largest = measure;
    }
  }
  return best;
}

}  // namespace

std::optional<TextureMap> TextureMap::of(const Scene& scene, const Face& face) {
  if (!has_texture_coordinates(scene, face)) return std::nullopt;
  const auto place = [&](CornerId corner) -> const dvec3& { return scene.vertices[scene.corners[corner]]; };
  // The first in space, the farthest from it, and the farthest from the line through both.
  const CornerId a = farthest(scene, face, [](const dvec3&) { return 0.0; });
  const CornerId b = farthest(scene, face, [&](const dvec3& p) { return glm::distance(p, place(a)); });
  const dvec3 along = place(b) - place(a);
  const CornerId c =
      farthest(scene, face, [&](const dvec3& p) { return glm::length(glm::cross(along, p - place(a))); });
  TextureMap map;
  map.corner_ = {place(a), place(b), place(c)};
  map.doubled_area_ = glm::length(glm::cross(along, place(c) - place(a)));
  if (!(map.doubled_area_ > 0)) return std::nullopt;
  const CornerValues<dvec2>& values = scene.attributes.texture_coordinates;
  map.set_gradients({values.table[values.row(a)], values.table[values.row(b)], values.table[values.row(c)]});
  return map;
}

// The gradient g of a coordinate lies in the plane of both edges e, f and has g·e, g·f as the coordinate changes.
void TextureMap::set_gradients(const std::array<dvec2, 3>& values) {
  const dvec3 e = corner_[1] - corner_[0], f = corner_[2] - corner_[0];
  const dvec3 normal = glm::cross(e, f);
  const double squared = glm::dot(normal, normal);
  const dvec3 along_e = glm::cross(f, normal) / squared, along_f = glm::cross(normal, e) / squared;
  const dvec2 by_e = values[1] - values[0], by_f = values[2] - values[0];
  value_ = values[0];
  u_ = along_e * by_e.x + along_f * by_f.x;
  v_ = along_e * by_e.y + along_f * by_f.y;
}

double TextureMap::dot(const dvec3& gradient, const dvec3& point) const {
  return glm::dot(gradient, point - corner_[0]);
}

bool TextureMap::fits(const Scene& scene, const Face& face, double tolerance) const {
  if (!has_texture_coordinates(scene, face)) return false;
  const CornerValues<dvec2>& values = scene.attributes.texture_coordinates;
  const double steepest = std::max(glm::length(u_), glm::length(v_));
  const double allowed = std::max(kTextureTolerance, steepest * tolerance);
  for (const Loop& loop : scene.loops_of(face)) {
    for (CornerId corner = loop.first; corner < loop.first + loop.count; ++corner) {
      const dvec2 off = values.table[values.row(corner)] - at(scene.vertices[scene.corners[corner]]);
      if (!(std::abs(off.x) <= allowed && std::abs(off.y) <= allowed)) return false;
    }
  }
  return true;
}

bool TextureMap::leads(const TextureMap& other) const {
  if (doubled_area_ != other.doubled_area_) return doubled_area_ > other.doubled_area_;
  return std::ranges::lexicographical_compare(corner_, other.corner_, {}, in_order, in_order);
}

bool same_texture_map(const Scene& scene, const Face& a, const Face& b, double tolerance) {
  const bool has_a = has_texture_coordinates(scene, a), has_b = has_texture_coordinates(scene, b);
  if (!has_a && !has_b) return true;
  const auto map_a = TextureMap::of(scene, a), map_b = TextureMap::of(scene, b);
  if (!map_a || !map_b) return false;
  const TextureMap& leader = map_a->leads(*map_b) ? *map_a : *map_b;
  return leader.fits(scene, a, tolerance) && leader.fits(scene, b, tolerance);
}

}  // namespace rad::scene
