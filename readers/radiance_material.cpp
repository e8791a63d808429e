#include "readers/radiance_material.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace rad::readers::radiance {
namespace {

using geom::dvec3;

enum class Sort : std::uint8_t { Opaque, Translucent, Clear, Mirror, Emitter, Directed, Antimatter, Unknown };

struct MaterialType {
  std::string_view name;
  Sort sort;
  std::size_t reals;  ///< that its colour and what reduces it need
};

// Variants with data, functions or a direction of brushing begin with the same arguments as the plain ones.
constexpr std::array<MaterialType, 32> kTypes = {{
    {"plastic", Sort::Opaque, 4},     {"metal", Sort::Opaque, 4},          {"plastic2", Sort::Opaque, 4},
    {"metal2", Sort::Opaque, 4},      {"plasfunc", Sort::Opaque, 4},       {"metfunc", Sort::Opaque, 4},
    {"plasdata", Sort::Opaque, 4},    {"metdata", Sort::Opaque, 4},        {"trans", Sort::Translucent, 6},
    {"trans2", Sort::Translucent, 6}, {"transfunc", Sort::Translucent, 6}, {"transdata", Sort::Translucent, 6},
    {"glass", Sort::Clear, 3},        {"dielectric", Sort::Clear, 5},      {"interface", Sort::Clear, 8},
    {"mist", Sort::Clear, 0},         {"mirror", Sort::Mirror, 3},         {"light", Sort::Emitter, 3},
    {"glow", Sort::Emitter, 3},       {"illum", Sort::Emitter, 3},         {"spotlight", Sort::Directed, 3},
    {"prism1", Sort::Clear, 0},       {"prism2", Sort::Clear, 0},          {"antimatter", Sort::Antimatter, 0},
    {"BRTDfunc", Sort::Unknown, 0},   {"BSDF", Sort::Unknown, 0},          {"aBSDF", Sort::Unknown, 0},
    {"ashik2", Sort::Opaque, 3},      {"WGMDfunc", Sort::Unknown, 0},      {"ptrans", Sort::Unknown, 0},
    {"spec", Sort::Unknown, 0},       {"specdata", Sort::Unknown, 0},
}};

const MaterialType* find(std::string_view type) {
  const auto* const found = std::ranges::find(kTypes, type, &MaterialType::name);
  return found == kTypes.end() ? nullptr : found;
}

void set_reflectance(Optics& optics, const dvec3& value) {
  optics.reflectance = value;
  optics.reflectance_stated = true;
}

}  // namespace

bool is_material(std::string_view type) { return find(type) != nullptr; }

Optics optics_of(std::string_view type, std::span<const double> reals) {
  Optics optics;
  const MaterialType* const known = find(type);
  if (known == nullptr || reals.size() < known->reals) return optics;
  const auto real = [&](std::size_t i) { return i < reals.size() ? reals[i] : 0.0; };
  const dvec3 colour(real(0), real(1), real(2));
  switch (known->sort) {
    case Sort::Opaque:
      set_reflectance(optics, colour * (1 - real(3)));
      if (real(3) > 0) optics.lost = "specular reflection";
      break;
    case Sort::Translucent:
      set_reflectance(optics, colour * (1 - real(3)) * (1 - real(5)));
      if (real(5) > 0) optics.lost = "transmission";
      break;
    case Sort::Clear:
      set_reflectance(optics, dvec3(0.0));
      optics.lost = "transmission";
      break;
    case Sort::Mirror:
      set_reflectance(optics, dvec3(0.0));
      optics.lost = "specular reflection";
      break;
    case Sort::Directed:
      optics.lost = "direction of light";
      [[fallthrough]];
    case Sort::Emitter:
      set_reflectance(optics, dvec3(0.0));
      optics.emission = colour * std::numbers::pi;
      break;
    case Sort::Antimatter:
      optics.is_antimatter = true;
      break;
    case Sort::Unknown:
      optics.lost = "scattering by data or functions";
      break;
  }
  return optics;
}

void apply(const Optics& optics, scene::Material& material) {
  material.reflectance = optics.reflectance;
  material.reflectance_stated = optics.reflectance_stated;
  material.emission = optics.emission;
  material.emission_unit = scene::Material::EmissionUnit::Exitance;
}

}  // namespace rad::readers::radiance
