#include "readers/dxf_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "readers/refusals.h"
#include "scene/drawing_colour.h"
#include "scene/index_colour.h"

namespace rad::readers::dxf {
namespace {

std::string hexadecimal(std::uint32_t colour) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%06X", colour & 0xFFFFFF);
  return text.data();
}

std::string entity_name(const Entity& entity, const Placement& placement) {
  std::string name;
  if (const std::string_view handle = entity.text(5); !handle.empty()) name = "handle " + std::string(handle);
  if (placement.block.empty()) return name;
  name += (name.empty() ? "in block " : " in block ") + placement.block;
  if (!placement.insert.empty()) name += ", insert " + placement.insert;
  return name;
}

}  // namespace

glm::dmat4 object_frame(const dvec3& extrusion) {
  const double length = glm::length(extrusion);
  if (!(length > 0) || !std::isfinite(length)) return glm::dmat4(1.0);
  const dvec3 z = extrusion / length;
  constexpr double kNearZ = 1.0 / 64;
  const dvec3 side = std::abs(z.x) < kNearZ && std::abs(z.y) < kNearZ ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
  const dvec3 x = glm::normalize(glm::cross(side, z));
  const dvec3 y = glm::normalize(glm::cross(z, x));
  return {glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(0, 0, 0, 1)};
}

const Layer& Surfaces::layer_of(const Entity& entity, const Placement& placement) const {
  const std::string_view name = entity.text(8);
  const bool inherits = !placement.layer.empty() && (name == "0" || name.empty());
  return layers_.find(inherits ? placement.layer : name.empty() ? std::string_view("0") : name);
}

Colour Surfaces::colour_of(const Entity& entity, const Placement& placement) const {
  Colour colour;
  const std::int64_t index = entity.integer(62, scene::kColourByLayer);
  const Layer& layer = layer_of(entity, placement);
  if (entity.find(420) != nullptr) {
    colour.true_colour = static_cast<std::uint32_t>(entity.integer(420)) & 0xFFFFFF;
    colour.by_layer = false;
  } else if (index == scene::kColourByBlock) {
    return {placement.colour, placement.true_colour, false};
  } else if (index > scene::kColourByBlock && index < scene::kColourByLayer) {
    colour.index = static_cast<int>(index);
    colour.by_layer = false;
  } else {
    return {layer.colour, layer.true_colour, true};
  }
  return colour;
}

bool Surfaces::begin(const Entity& entity, const Placement& placement) {
  const Layer& layer = layer_of(entity, placement);
  if (!layer.visible || entity.integer(60) == 1) {
    count_unsupported("entities that are hidden or on layers that are off or frozen", entity.line());
    return false;
  }
  if (entity.integer(67) == 1) {
    count_unsupported("entities in paper space", entity.line());
    return false;
  }
  placed_ = placement.world;
  use_frame(glm::dmat4(1.0));
  builder_.use_object(builder_.object(layer.name));
  builder_.use_group(builder_.group(placement.block));
  builder_.use_material(material_of(layer, colour_of(entity, placement)));
  builder_.use_entity(builder_.add_entity(entity_name(entity, placement)));
  return true;
}

scene::MaterialId Surfaces::material_of(const Layer& layer, const Colour& colour) {
  const std::uint32_t rgb = colour.true_colour.value_or(scene::colour_of_index(colour.index));
  const scene::MaterialId id = builder_.material(colour.by_layer      ? layer.name
                                                 : colour.true_colour ? hexadecimal(rgb)
                                                                      : "colour " + std::to_string(colour.index));
  scene::Material& material = builder_.material_at(id);
  material.reflectance = scene::reflectance_of_colour(rgb);
  material.reflectance_stated = true;
  return id;
}

void Surfaces::use_frame(const glm::dmat4& frame) {
  world_ = placed_ * frame;
  mirrored_ = glm::determinant(glm::dmat3(world_)) < 0;
}

scene::VertexId Surfaces::add_vertex(const dvec3& point, std::uint64_t line) {
  if (std::string why = limit_before_vertices(builder_.scene(), 1, input_.limits); !why.empty()) {
    stop(std::move(why), line);
    return 0;
  }
  return builder_.add_vertex(dvec3(world_ * glm::dvec4(point, 1.0)), line);
}

void Surfaces::add_face(std::span<const scene::VertexId> corners, std::uint64_t line) {
  if (full_ || corners.empty()) return;
  if (corners.size() > input_.limits.face_corners) {
    return refuse(scene::ReadIssueKind::ParseError, "a face has more corners than the limit; it is left out", line);
  }
  if (std::string why = limit_before_face(builder_.scene(), corners.size(), input_.limits); !why.empty()) {
    stop(std::move(why), line);
    return;
  }
  if (!mirrored_) {
    builder_.add_face(corners, line);
    return;
  }
  turned_.assign(corners.rbegin(), corners.rend());
  builder_.add_face(turned_, line);
}

bool Surfaces::stop(std::string why, std::uint64_t line) {
  if (!full_) refuse(scene::ReadIssueKind::ParseError, std::move(why), line);
  full_ = true;
  return false;
}

void Surfaces::refuse(scene::ReadIssueKind kind, std::string what, std::uint64_t line) {
  issues_.add(issue_at_line(kind, std::move(what), line));
}

void Surfaces::count_unsupported(std::string what, std::uint64_t line) {
  scene::IssuePlace place;
  place.line = line;
  issues_.add_unsupported(std::move(what), std::move(place));
}

}  // namespace rad::readers::dxf
