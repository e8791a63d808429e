#include "readers/gltf_materials.h"

#include <algorithm>

#include "readers/gltf_record.h"
#include "readers/unique_names.h"

namespace rad::readers::gltf {

namespace {

using scene::Material;

constexpr double kUnknownTexture = 0.5;

geom::dvec3 colour(const JsonView& parent, std::string_view key, std::size_t components, double otherwise) {
  const auto numbers = parent.numbers(key, components);
  if (!numbers) return geom::dvec3(otherwise);
  return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

void set_textured_reflectance(Material& material, const geom::dvec3& factor, bool textured) {
  material.reflectance = textured ? factor * kUnknownTexture : factor;
  material.reflectance_stated = !textured;
}

// The reference to the texture of the base colour, and the factor beside it.
void read_texture(const JsonView& parent, std::string_view reference, std::string_view factor, Textures& textures,
                  ReadMaterial& result) {
  auto texture = textures.read(parent.object(reference));
  if (!texture) return;
  const geom::dvec3 colour_factor = colour(parent, factor, 4, 1.0);
  texture->texture.factor = {colour_factor.x, colour_factor.y, colour_factor.z};
  result.material.texture = std::move(texture->texture);
  result.texture_set = texture->set;
}

void read_textures(const JsonView& json, Textures& textures, ReadMaterial& result) {
  if (const JsonView specular = json.extension("KHR_materials_pbrSpecularGlossiness")) {
    read_texture(specular, "diffuseTexture", "diffuseFactor", textures, result);
  } else if (const JsonView metallic = json.object("pbrMetallicRoughness")) {
    read_texture(metallic, "baseColorTexture", "baseColorFactor", textures, result);
  }
}

void read_reflectance(const JsonView& json, Material& material) {
  const JsonView specular = json.extension("KHR_materials_pbrSpecularGlossiness");
  if (specular) {
    set_textured_reflectance(material, colour(specular, "diffuseFactor", 4, 1.0), specular.has("diffuseTexture"));
    return;
  }
  const JsonView metallic = json.object("pbrMetallicRoughness");
  if (!metallic) return;
  const geom::dvec3 base = colour(metallic, "baseColorFactor", 4, 1.0);
  const bool unlit = static_cast<bool>(json.extension("KHR_materials_unlit"));
  const bool metal_textured = !unlit && metallic.has("metallicRoughnessTexture");
  const double metal = unlit || metal_textured ? 0.0 : metallic.number("metallicFactor").value_or(1.0);
  set_textured_reflectance(material, base * (1.0 - metal), metallic.has("baseColorTexture"));
  if (metal_textured) material.reflectance_stated = false;
}

// Glass: what is blended below full alpha, and what transmits.
double opacity_of(const JsonView& json) {
  const JsonView metallic = json.object("pbrMetallicRoughness");
  const auto base = metallic ? metallic.numbers("baseColorFactor", 4) : std::nullopt;
  const double alpha = json.text("alphaMode") == "BLEND" && base ? (*base)[3] : 1.0;
  const JsonView transmission = json.extension("KHR_materials_transmission");
  const double through = transmission ? transmission.number("transmissionFactor").value_or(0.0) : 0.0;
  return std::clamp(alpha * (1.0 - through), 0.0, 1.0);
}

geom::dvec3 specular_of(const JsonView& json) {
  if (json.extension("KHR_materials_unlit")) return geom::dvec3(0);
  if (const JsonView specular = json.extension("KHR_materials_pbrSpecularGlossiness")) {
    return colour(specular, "specularFactor", 3, 1.0);
  }
  const JsonView metallic = json.object("pbrMetallicRoughness");
  if (!metallic || metallic.has("metallicRoughnessTexture")) return geom::dvec3(0);
  return colour(metallic, "baseColorFactor", 4, 1.0) * metallic.number("metallicFactor").value_or(1.0);
}

// A picture, a strength beside a factor of 0, or a factor beside a strength of 0.
bool states_light(const JsonView& json) {
  const JsonView strength = json.extension("KHR_materials_emissive_strength");
  const double factor = strength ? strength.number("emissiveStrength").value_or(1.0) : 1.0;
  const geom::dvec3 emission = colour(json, "emissiveFactor", 3, 0.0);
  const bool lit = emission.x > 0 || emission.y > 0 || emission.z > 0;
  return json.has("emissiveTexture") || factor > 1 || (lit && factor == 0);
}

// What a diffuse solution leaves out.
void read_optics(const JsonView& json, Material& material) {
  material.specular = specular_of(json);
  material.opacity = opacity_of(json);
  material.cut_out = json.text("alphaMode") == "MASK" && json.object("pbrMetallicRoughness").has("baseColorTexture");
  material.emission_cancelled = !material.emits() && states_light(json);
}

Material read_material(const JsonView& json) {
  Material material;
  material.name = json.text("name");
  read_reflectance(json, material);
  const JsonView strength = json.extension("KHR_materials_emissive_strength");
  const double factor = strength ? strength.number("emissiveStrength").value_or(1.0) : 1.0;
  material.emission = colour(json, "emissiveFactor", 3, 0.0) * factor;
  material.emission_unit = Material::EmissionUnit::Luminance;
  material.double_sided = json.flag("doubleSided").value_or(false);
  read_optics(json, material);
  return material;
}

}  // namespace

std::vector<ReadMaterial> read_materials(const Document& document, const Buffers& buffers) {
  const JsonView root = document.root();
  std::vector<ReadMaterial> materials;
  UniqueNames names;
  Textures textures(document, buffers);
  const std::size_t count = root.length("materials");
  for (std::size_t i = 0; i < count; ++i) {
    const JsonView json = root.item("materials", i);
    ReadMaterial read;
    Material& material = read.material;
    if (json) {
      material = read_material(json);
      read_textures(json, textures, read);
      take_recorded_material(document.json["materials"][i], material);
      if (shows_light_map(document.json["materials"][i])) {
        material.texture.reset();
        read.texture_set = kNoTextureSet;
      }
    }
    material.name = names.claim(material.name.empty() ? "material " + std::to_string(i) : material.name);
    materials.push_back(std::move(read));
  }
  return materials;
}

}  // namespace rad::readers::gltf
