#include "writers/rad.h"

#include <numbers>
#include <vector>

#include "writers/bridged_ring.h"
#include "writers/head_comments.h"
#include "writers/text_line.h"
#include "writers/whole_file.h"

namespace rad::writers {
namespace {

using scene::Material;

constexpr std::string_view kUnnamed = "unnamed";
// Lumens in a watt of the white light that Radiance counts with.
constexpr double kLumensPerWatt = 179;

// A word as Radiance reads it back: in quotes where it holds blanks or would begin with something else.
std::string word(std::string_view text) {
  std::string clean = one_line(text);
  if (clean.empty()) return std::string(kUnnamed);
  const bool blank = clean.find_first_of(" \t") != std::string::npos;
  if (!blank && clean.find_first_of("\"'#!") != 0) return clean;
  const char quote = clean.find('"') == std::string::npos ? '"' : '\'';
  for (char& c : clean) {
    if (c == quote) c = '_';
  }
  return quote + clean + quote;
}

void append_reals(std::string& text, std::initializer_list<double> reals) {
  text += "0\n0\n";
  append_number(text, reals.size());
  for (const double real : reals) {
    text += ' ';
    append_number(text, real);
  }
  text += '\n';
}

geom::dvec3 radiance_of(const Material& material) {
  const bool luminance = material.emission_unit == Material::EmissionUnit::Luminance;
  return luminance ? material.emission / kLumensPerWatt : material.emission / std::numbers::pi;
}

void append_material(std::string& text, const Material& material) {
  const bool emits = material.emits();
  if (!emits && !material.reflectance_stated) text += "# no reflectance was stated; this one is assumed\n";
  text += emits ? "void light " : "void plastic ";
  text += word(material.name) + "\n";
  if (emits) {
    const geom::dvec3 radiance = radiance_of(material);
    append_reals(text, {radiance.x, radiance.y, radiance.z});
  } else {
    append_reals(text, {material.reflectance.x, material.reflectance.y, material.reflectance.z, 0, 0});
  }
  text += '\n';
}

void append_polygon(std::string& text, const scene::Scene& scene, const std::vector<std::uint32_t>& ring) {
  text += "0\n0\n";
  append_number(text, 3 * ring.size());
  text += '\n';
  for (const std::uint32_t corner : ring) {
    const geom::dvec3& at = scene.vertices[scene.corners[corner]];
    for (const double component : {at.x, at.y, at.z}) {
      text += ' ';
      append_number(text, component);
    }
    text += '\n';
  }
}

std::string identifier(const std::string& object, std::uint64_t number) {
  std::string name = object.empty() ? std::string(kUnnamed) : object;
  name += '.';
  append_number(name, number);
  return word(name);
}

}  // namespace

WriteResult write_rad(const Output& output, const std::filesystem::path& path) {
  if (std::string problem = problem_of(output); !problem.empty()) return {std::move(problem)};
  const scene::Scene& scene = output.scene;
  std::string text;
  for (const std::string& comment : head_comments(output)) text += "# " + comment + "\n";
  text += '\n';
  std::vector<bool> used(scene.materials.size(), false);
  for (const scene::Face& face : scene.faces) used[face.material] = true;
  for (std::size_t id = 0; id < used.size(); ++id) {
    if (used[id]) append_material(text, scene.materials[id]);
  }
  std::vector<std::uint64_t> written(scene.objects.size(), 0);
  for (const scene::Face& face : scene.faces) {
    const std::vector<std::uint32_t> ring = bridged_ring(scene, face);
    if (ring.empty()) continue;
    text += word(scene.materials[face.material].name) + " polygon ";
    text += identifier(scene.objects[face.object], ++written[face.object]) + "\n";
    append_polygon(text, scene, ring);
  }
  return {write_whole_file(path, text)};
}

}  // namespace rad::writers
