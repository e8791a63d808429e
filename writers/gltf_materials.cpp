#include "writers/gltf_materials.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rad::writers::gltf {
namespace {

using geom::dvec3;
using scene::Material;

dvec3 finite_part(dvec3 colour) {
  for (int channel = 0; channel < 3; ++channel) {
    if (!std::isfinite(colour[channel])) colour[channel] = 0;
  }
  return colour;
}

bool is_luminance(const Material& material) { return material.emission_unit == Material::EmissionUnit::Luminance; }

// A luminance L in all directions is the exitance π L.
dvec3 exitance_of(const Material& material) {
  return finite_part(is_luminance(material) ? material.emission * std::numbers::pi : material.emission);
}

dvec3 luminance_of(const Material& material) {
  const dvec3 luminance =
      finite_part(is_luminance(material) ? material.emission : material.emission / std::numbers::pi);
  return {std::max(luminance.x, 0.0), std::max(luminance.y, 0.0), std::max(luminance.z, 0.0)};
}

bool is_a_share(const dvec3& colour) {
  return std::min({colour.x, colour.y, colour.z}) >= 0 && std::max({colour.x, colour.y, colour.z}) <= 1;
}

void set_emission(Json& json, const Material& material) {
  const dvec3 luminance = luminance_of(material);
  const double strength = std::max({luminance.x, luminance.y, luminance.z});
  if (strength == 0) return;
  json["emissiveFactor"] = triple_json(strength > 1 ? luminance / strength : luminance);
  if (strength > 1) json["extensions"][kEmissiveStrength] = {{"emissiveStrength", strength}};
}

dvec3 factor_of(const scene::Texture& texture) { return {texture.factor[0], texture.factor[1], texture.factor[2]}; }

}  // namespace

Json material_record(const Material& material) {
  Json record{{"reflectance", triple_json(finite_part(material.reflectance))},
              {"exitance", triple_json(exitance_of(material))}};
  if (!material.reflectance_stated) record["stated"] = false;
  return record;
}

Json triple_json(const dvec3& value) { return Json::array({value.x, value.y, value.z}); }

Json material_json(const Material& material, bool unlit, Json texture_reference) {
  Json json = Json::object();
  if (!material.name.empty()) json["name"] = material.name;
  const bool textured = !texture_reference.is_null() && material.texture.has_value();
  const dvec3 shown = unlit ? dvec3(1.0) : finite_part(textured ? factor_of(*material.texture) : material.reflectance);
  Json base = Json::array();
  for (int channel = 0; channel < 3; ++channel) base.push_back(std::clamp(shown[channel], 0.0, 1.0));
  base.push_back(1.0);
  json["pbrMetallicRoughness"] = {
      {"baseColorFactor", std::move(base)}, {"metallicFactor", 0.0}, {"roughnessFactor", 1.0}};
  if (textured) json["pbrMetallicRoughness"]["baseColorTexture"] = std::move(texture_reference);
  if (unlit) {
    json["extensions"][kUnlit] = Json::object();
  } else {
    set_emission(json, material);
  }
  if (material.double_sided) json["doubleSided"] = true;
  if (unlit || textured || !material.reflectance_stated || !is_a_share(material.reflectance)) {
    json["extras"]["radfix"] = material_record(material);
  }
  return json;
}

}  // namespace rad::writers::gltf
