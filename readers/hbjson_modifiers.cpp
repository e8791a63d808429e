#include "readers/hbjson_modifiers.h"

#include <array>
#include <vector>

#include "readers/radiance_material.h"

namespace rad::readers::hbjson {
namespace {

struct ModifierType {
  std::string_view name;
  std::string_view radiance;
  std::array<std::string_view, 7> arguments;  ///< in the order of Radiance; empty ones end the list
};

constexpr std::array<ModifierType, 7> kTypes = {{
    {"Plastic", "plastic", {"r_reflectance", "g_reflectance", "b_reflectance", "specularity", "roughness"}},
    {"Metal", "metal", {"r_reflectance", "g_reflectance", "b_reflectance", "specularity", "roughness"}},
    {"Trans",
     "trans",
     {"r_reflectance", "g_reflectance", "b_reflectance", "specularity", "roughness", "transmitted_diff",
      "transmitted_spec"}},
    {"Glass", "glass", {"r_transmissivity", "g_transmissivity", "b_transmissivity"}},
    {"Mirror", "mirror", {"r_reflectance", "g_reflectance", "b_reflectance"}},
    {"Light", "light", {"r_emittance", "g_emittance", "b_emittance"}},
    {"Glow", "glow", {"r_emittance", "g_emittance", "b_emittance", "max_radius"}},
}};

radiance::Optics optics_of(const JsonView& modifier) {
  const std::string type = modifier.text("type");
  for (const ModifierType& known : kTypes) {
    if (known.name != type) continue;
    std::vector<double> reals;
    for (const std::string_view argument : known.arguments) {
      if (!argument.empty()) reals.push_back(modifier.number(argument).value_or(0.0));
    }
    return radiance::optics_of(known.radiance, reals);
  }
  radiance::Optics unknown;
  if (type != "Void") unknown.lost = "scattering";
  return unknown;
}

bool states(const JsonView& object, std::string_view key) {
  return object.has(key) && object.json().at(std::string(key)).is_string();
}

// The identifier in `key` of properties.radiance; empty where there is none or it is null.
std::string of_properties(const JsonView& object, std::string_view key) {
  if (!object || !object.has("properties")) return {};
  const JsonView properties = object.object("properties");
  if (!properties || !properties.has("radiance")) return {};
  const JsonView radiance = properties.object("radiance");
  return radiance && states(radiance, key) ? radiance.text(key) : std::string();
}

}  // namespace

Modifiers::Modifiers(const JsonView& model, scene::SceneBuilder& builder, scene::ReadIssues& issues)
    : builder_(builder), issues_(issues) {
  const JsonView properties = model.object("properties");
  const JsonView radiance = properties ? properties.object("radiance") : JsonView();
  if (!radiance) return;
  for (std::size_t i = 0; i < radiance.length("modifiers"); ++i) add(radiance.item("modifiers", i));
  for (std::size_t i = 0; i < radiance.length("modifier_sets"); ++i) add_set(radiance.item("modifier_sets", i));
  if (!radiance.has("global_modifier_set") || radiance.json().at("global_modifier_set").is_null()) return;
  // The set itself in newer files, its identifier in older ones.
  if (states(radiance, "global_modifier_set")) {
    global_set_ = radiance.text("global_modifier_set");
    return;
  }
  const JsonView global = radiance.object("global_modifier_set");
  if (!global) return;
  for (std::size_t i = 0; i < global.length("modifiers"); ++i) add(global.item("modifiers", i));
  global_set_ = global.text("identifier");
  add_set(global);
}

void Modifiers::add(const JsonView& modifier) {
  if (!modifier) return;
  const std::string name = modifier.text("identifier");
  if (name.empty() || materials_.contains(name)) return;
  const radiance::Optics optics = optics_of(modifier);
  const scene::MaterialId id = builder_.material(name);
  radiance::apply(optics, builder_.material_at(id));
  materials_.emplace(name, id);
  if (optics.lost.empty()) return;
  scene::IssuePlace place;
  place.pointer = modifier.pointer();
  issues_.add_unsupported(optics.lost + " of " + modifier.text("type").substr(0, 40) + " modifiers", std::move(place));
}

void Modifiers::add_set(const JsonView& set) {
  if (set) sets_.emplace(set.text("identifier"), set);
}

std::string Modifiers::of_set(const std::string& set, const FaceSort& sort) const {
  const auto found = sets_.find(set);
  if (found == sets_.end()) return {};
  if (!found->second.has(sort.set) || found->second.json().at(std::string(sort.set)).is_null()) return {};
  const JsonView members = found->second.object(sort.set);
  return members && states(members, sort.member) ? members.text(sort.member) : std::string();
}

scene::MaterialId Modifiers::material_of(const JsonView& face, const JsonView& room, const FaceSort& sort,
                                         std::string_view fallback) {
  std::string name = of_properties(face, "modifier");
  if (name.empty()) name = of_set(of_properties(room, "modifier_set"), sort);
  if (name.empty()) name = of_set(global_set_, sort);
  const auto found = materials_.find(name);
  return found != materials_.end() ? found->second
                                   : builder_.material(name.empty() ? fallback : std::string_view(name));
}

}  // namespace rad::readers::hbjson
