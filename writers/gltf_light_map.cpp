#include "writers/gltf_light_map.h"

namespace rad::writers::gltf {
namespace {

constexpr const char* kSpecular = "KHR_materials_specular";
constexpr std::uint32_t kLinear = 9729, kClampToEdge = 33071;

}  // namespace

scene::Texture light_map_texture(const scene::LightMap& map, std::uint32_t page) {
  scene::Texture texture;
  texture.image = map.pages[page];
  texture.sampling = {kClampToEdge, kClampToEdge, kLinear, kLinear};
  return texture;
}

Json light_map_material_json(const scene::Material& material, scene::LightMapLook look, std::uint32_t page,
                             double white_luminance, Json reference) {
  Json json = Json::object();
  if (!material.name.empty()) json["name"] = material.name;
  reference["texCoord"] = 1;
  const double base = look == scene::LightMapLook::Unlit ? 1.0 : 0.0;
  Json& shading = json["pbrMetallicRoughness"];
  shading = {{"baseColorFactor", {base, base, base, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 1.0}};
  if (look == scene::LightMapLook::Unlit) {
    shading["baseColorTexture"] = std::move(reference);
    json["extensions"][kUnlit] = Json::object();
  } else {
    json["emissiveTexture"] = std::move(reference);
    json["emissiveFactor"] = triple_json(geom::dvec3(1.0));
    json["extensions"][kEmissiveStrength] = {{"emissiveStrength", white_luminance}};
    json["extensions"][kSpecular] = {{"specularFactor", 0.0}};
  }
  if (material.double_sided) json["doubleSided"] = true;
  json["extras"]["radfix"] = material_record(material);
  json["extras"]["radfix"]["lightMap"] = page;
  return json;
}

}  // namespace rad::writers::gltf
