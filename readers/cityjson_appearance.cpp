#include "readers/cityjson_appearance.h"

#include <algorithm>

#include "readers/unique_names.h"
#include "scene/drawing_colour.h"

namespace rad::readers::cityjson {
namespace {

void count(scene::ReadIssues& issues, std::string what, std::string pointer) {
  scene::IssuePlace place;
  place.pointer = std::move(pointer);
  issues.add_unsupported(std::move(what), std::move(place));
}

void read_material(const JsonView& json, scene::Material& material, scene::ReadIssues& issues) {
  if (const auto colour = json.numbers("diffuseColor", 3)) {
    material.reflectance = scene::reflectance_of_srgb({(*colour)[0], (*colour)[1], (*colour)[2]});
    material.reflectance_stated = true;
  }
  const auto emissive = json.numbers("emissiveColor", 3);
  if (emissive && std::ranges::any_of(*emissive, [](double channel) { return channel > 0; })) {
    count(issues, "emissive colours, which have no unit", json.pointer());
  }
  if (json.number("transparency").value_or(0) > 0) count(issues, "transparency of materials", json.pointer());
}

void read_texture_coordinates(const JsonView& root, Appearance& appearance, scene::SceneBuilder& builder) {
  const JsonView json = root.object("appearance");
  const std::size_t rows = json.length("vertices-texture");
  for (std::size_t i = 0; i < rows; ++i) {
    const Json& row = json.json()["vertices-texture"][i];
    const bool sound = row.is_array() && row.size() == 2 && row[0].is_number() && row[1].is_number();
    builder.add_texture_coordinates(sound ? scene::dvec2(row[0].get<double>(), row[1].get<double>())
                                          : scene::dvec2(0.0));
  }
  appearance.texture_rows = rows;
}

}  // namespace

Appearance read_appearance(const JsonView& root, scene::SceneBuilder& builder, scene::ReadIssues& issues) {
  Appearance appearance;
  const JsonView json = root.object("appearance");
  if (!json) return appearance;
  UniqueNames names;
  for (std::size_t i = 0; i < json.length("materials"); ++i) {
    const JsonView item = json.item("materials", i);
    const std::string name = item ? item.text("name") : std::string();
    const auto id = builder.material(names.claim(name.empty() ? "material " + std::to_string(i) : name));
    if (item) read_material(item, builder.material_at(id), issues);
    appearance.materials.push_back(id);
  }
  for (std::size_t i = 0; i < json.length("textures"); ++i) {
    const JsonView item = json.item("textures", i);
    const std::string path = item ? item.text("image") : std::string();
    const auto id = builder.material(names.claim(path.empty() ? "texture " + std::to_string(i) : path));
    if (!path.empty()) {
      scene::Texture texture;
      texture.image = std::make_shared<const scene::Image>(scene::Image{path, {}, {}, {}});
      builder.material_at(id).texture = std::move(texture);
    }
    appearance.textures.push_back(id);
  }
  appearance.material_theme = json.text("default-theme-material");
  appearance.texture_theme = json.text("default-theme-texture");
  if (!appearance.textures.empty()) read_texture_coordinates(root, appearance, builder);
  return appearance;
}

}  // namespace rad::readers::cityjson
