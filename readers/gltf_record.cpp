#include "readers/gltf_record.h"

#include <cmath>

namespace rad::readers::gltf {
namespace {

const Json* member(const Json* parent, const char* key) {
  if (parent == nullptr || !parent->is_object()) return nullptr;
  const auto found = parent->find(key);
  return found == parent->end() ? nullptr : &*found;
}

const Json* record_in(const Json* json) { return member(member(json, "extras"), "radfix"); }

std::optional<double> finite_number(const Json* json) {
  if (json == nullptr || !json->is_number()) return std::nullopt;
  const double value = json->get<double>();
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<geom::dvec3> finite_triple(const Json* json) {
  if (json == nullptr || !json->is_array() || json->size() != 3) return std::nullopt;
  geom::dvec3 triple;
  for (int axis = 0; axis < 3; ++axis) {
    const auto number = finite_number(&(*json)[static_cast<std::size_t>(axis)]);
    if (!number) return std::nullopt;
    triple[axis] = *number;
  }
  return triple;
}

}  // namespace

std::optional<scene::RecordedLattice> read_recorded_lattice(const Document& document) {
  const Json* record = record_in(member(&document.json, "asset"));
  const auto tolerance = finite_number(member(record, "tolerance"));
  const auto pitch = finite_number(member(record, "pitch"));
  const auto origin = finite_triple(member(record, "origin"));
  if (!tolerance || !pitch || !origin) return std::nullopt;
  return scene::RecordedLattice{{*pitch, *origin}, *tolerance};
}

void take_recorded_material(const Json& material_json, scene::Material& material) {
  const Json* record = record_in(&material_json);
  const auto reflectance = finite_triple(member(record, "reflectance"));
  const auto exitance = finite_triple(member(record, "exitance"));
  if (!reflectance || !exitance) return;
  material.reflectance = *reflectance;
  const Json* stated = member(record, "stated");
  material.reflectance_stated = stated == nullptr || !stated->is_boolean() || stated->get<bool>();
  material.emission = *exitance;
  material.emission_unit = scene::Material::EmissionUnit::Exitance;
}

bool shows_light_map(const Json& material_json) {
  const Json* page = member(record_in(&material_json), "lightMap");
  return page != nullptr && page->is_number();
}

}  // namespace rad::readers::gltf
