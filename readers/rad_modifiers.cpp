#include "readers/rad_modifiers.h"

#include <algorithm>
#include <array>

#include "readers/radiance_material.h"
#include "readers/text_cursor.h"

namespace rad::readers::radiance {
namespace {

constexpr std::array<std::string_view, 16> kPatterns = {
    "colorfunc", "brightfunc", "colordata", "brightdata", "colorpict", "colortext", "brighttext", "texfunc",
    "texdata",   "mixfunc",    "mixdata",   "mixpict",    "mixtext",   "specfile",  "specfunc",   "specpict"};

}  // namespace

bool is_pattern(std::string_view type) { return std::ranges::find(kPatterns, type) != kPatterns.end(); }

Modifiers::Modifiers(scene::SceneBuilder& builder, scene::ReadIssues& issues) : builder_(builder), issues_(issues) {
  definitions_.emplace("void", Definition());
}

void Modifiers::define(const Primitive& primitive, const scene::IssuePlace& place) {
  const std::string name(primitive.identifier);
  if (primitive.type == "alias") {
    const Definition definition = find(primitive.strings.front(), place);
    definitions_.insert_or_assign(name, definition);
    return;
  }
  const Optics optics = optics_of(primitive.type, primitive.reals);
  if (is_material(primitive.type) && is_defined_so(name, optics)) return;
  // A pattern that is used as a material leaves a surface without one that could be told.
  const scene::MaterialId id = builder_.material(names_.claim(name));
  if (!is_material(primitive.type)) {
    issues_.add_unsupported(std::string(primitive.type) + " patterns and textures", place);
    definitions_.insert_or_assign(name, Definition{id, false});
    return;
  }
  apply(optics, builder_.material_at(id));
  if (!optics.lost.empty()) {
    issues_.add_unsupported(optics.lost + " of " + std::string(primitive.type) + " materials", place);
  }
  definitions_.insert_or_assign(name, Definition{id, optics.is_antimatter});
}

// A file that is placed twice defines its materials twice.
bool Modifiers::is_defined_so(const std::string& name, const Optics& optics) const {
  const auto found = definitions_.find(name);
  if (found == definitions_.end() || found->second.is_antimatter != optics.is_antimatter) return false;
  const scene::Material& known = builder_.material_at(found->second.material);
  return found->second.material != 0 && known.reflectance == optics.reflectance &&
         known.reflectance_stated == optics.reflectance_stated && known.emission == optics.emission;
}

Definition Modifiers::find(std::string_view name, const scene::IssuePlace& place) {
  const std::string key(name.substr(0, kLongestName));
  const auto found = definitions_.find(key);
  if (found != definitions_.end()) return found->second;
  issues_.add({scene::ReadIssueKind::MissingResource, "the modifier " + in_quotes(name) + " is not defined", place, 1});
  const Definition unknown{builder_.material(names_.claim(key)), false};
  definitions_.emplace(key, unknown);
  return unknown;
}

}  // namespace rad::readers::radiance
