#include "corpus/generate/modeller.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace rad::corpus {
namespace {

using Wide = std::array<std::int64_t, 3>;

// Twice the area vector of a ring, exact.
Wide area_vector(const Ring& ring) {
  Wide sum{};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Millimetres &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum[0] += std::int64_t{a.y} * b.z - std::int64_t{a.z} * b.y;
    sum[1] += std::int64_t{a.z} * b.x - std::int64_t{a.x} * b.z;
    sum[2] += std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
  }
  return sum;
}

bool same_turn(const Ring& a, const Ring& b) {
  const Wide m = area_vector(a), n = area_vector(b);
  double dot = 0;
  for (int i = 0; i < 3; ++i) dot += static_cast<double>(m[i]) * static_cast<double>(n[i]);
  return dot > 0;
}

Ring turned_like(const Ring& model, Ring ring, bool like) {
  if (same_turn(model, ring) != like) std::reverse(ring.begin(), ring.end());
  return ring;
}

}  // namespace

Outline rectangle(Planar low, Planar high) { return {low, {high.u, low.v}, high, {low.u, high.v}}; }

Outline round_outline(Planar centre, int radius) {
  constexpr int kSides = 16;
  Outline outline;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    outline.push_back({centre.u + static_cast<int>(std::lround(radius * std::cos(angle))),
                       centre.v + static_cast<int>(std::lround(radius * std::sin(angle)))});
  }
  return outline;
}

Outline reversed(Outline outline) {
  std::reverse(outline.begin(), outline.end());
  return outline;
}

Millimetres Frame::at(Planar point, int n) const {
  const auto whole = [this](int offset) {
    assert(offset % divisor == 0);
    return offset / divisor;
  };
  return {origin.x + whole(point.u * axes[0].x + point.v * axes[1].x + n * axes[2].x),
          origin.y + whole(point.u * axes[0].y + point.v * axes[1].y + n * axes[2].y),
          origin.z + whole(point.u * axes[0].z + point.v * axes[1].z + n * axes[2].z)};
}

Ring Frame::ring(const Outline& outline, int n) const {
  Ring ring;
  for (const Planar& point : outline) ring.push_back(at(point, n));
  return ring;
}

Frame plan_at(Millimetres origin) { return {.origin = origin}; }

Frame turned_plan_at(Millimetres origin) { return {origin, {{{3, 4, 0}, {-4, 3, 0}, {0, 0, 5}}}, 5}; }

Frame half_turned(Frame frame) {
  for (Millimetres* axis : {&frame.axes[0], &frame.axes[1]}) *axis = {-axis->x, -axis->y, -axis->z};
  return frame;
}

Frame facing_east(Millimetres origin) { return {origin, {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}}, 1}; }

Frame facing_south(Millimetres origin) { return {origin, {{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}}, 1}; }

Modeller::Modeller(std::string_view name) : builder_(std::string(name), "obj") {
  builder_.add_section({std::string(name), "", scene::RecordKind::Element});
  builder_.scene().metres_per_unit = 1;
  builder_.scene().up = scene::UpAxis::Z;
}

void Modeller::define_material(std::string_view name, const scene::dvec3& reflectance, const scene::dvec3& emission) {
  scene::Material& material = builder_.material_at(builder_.material(name));
  material.reflectance = reflectance;
  material.reflectance_stated = true;
  material.emission = emission;
}

void Modeller::begin_object(std::string_view name) { builder_.use_object(builder_.object(name)); }

void Modeller::paint(std::string_view material) { builder_.use_material(builder_.material(material)); }

void Modeller::face(const Ring& front, const std::vector<Ring>& holes) {
  builder_.add_face(vertices_of(front), records_++);
  for (const Ring& hole : holes) builder_.add_hole(vertices_of(turned_like(front, hole, false)));
}

void Modeller::face_with_contacts(const Ring& front, const std::vector<Ring>& contacts, std::vector<Ring> holes) {
  holes.insert(holes.end(), contacts.begin(), contacts.end());
  face(front, holes);
  for (const Ring& contact : contacts) face(turned_like(front, contact, true));
}

scene::Scene Modeller::take() { return builder_.take(); }

std::vector<scene::VertexId> Modeller::vertices_of(const Ring& ring) {
  std::vector<scene::VertexId> ids;
  for (const Millimetres& place : ring) {
    const auto [entry, fresh] = vertices_.try_emplace(place, 0);
    if (fresh) entry->second = builder_.add_vertex({place.x / 1000.0, place.y / 1000.0, place.z / 1000.0});
    ids.push_back(entry->second);
  }
  return ids;
}

}  // namespace rad::corpus
