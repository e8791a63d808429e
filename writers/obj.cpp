#include "writers/obj.h"

#include <array>
#include <numbers>
#include <optional>

#include "writers/bridged_ring.h"
#include "writers/head_comments.h"
#include "writers/mtl_texture.h"
#include "writers/text_line.h"
#include "writers/whole_file.h"

namespace rad::writers {
namespace {

using scene::Face;
using scene::Material;
using scene::MaterialId;
using scene::Scene;

constexpr std::string_view kUnnamedMaterial = "unnamed";

void append_triple(std::string& text, std::string_view keyword, const geom::dvec3& value) {
  text += keyword;
  for (const double component : {value.x, value.y, value.z}) {
    text += ' ';
    append_number(text, component);
  }
  text += '\n';
}

void append_named(std::string& text, std::string_view keyword, const std::string& name) {
  text += keyword;
  if (!name.empty()) text += ' ' + one_line(name);
  text += '\n';
}

std::string material_name(const Material& material) {
  return material.name.empty() ? std::string(kUnnamedMaterial) : one_line(material.name);
}

// Whether faces of material 0 need a name: it says something, or they follow faces of another material.
bool names_material_zero(const Scene& scene) {
  const Material& unnamed = scene.materials[0];
  bool used = false, follows_another = false, other = false;
  for (const Face& face : scene.faces) {
    used |= face.material == 0;
    follows_another |= face.material == 0 && other;
    other |= face.material != 0;
  }
  return used &&
         (follows_another || unnamed.reflectance_stated || unnamed.emits() || unnamed.texture || !unnamed.name.empty());
}

// Under an image Kd is what the image is multiplied by. A reflectance that no file states stays unstated.
void append_diffuse(std::string& text, const Material& material) {
  const bool textured = material.texture && !material.texture->image->embedded();
  if (!textured) {
    if (material.reflectance_stated) append_triple(text, "Kd", material.reflectance);
    return;
  }
  const auto& [red, green, blue] = material.texture->factor;
  if (material.reflectance_stated || material.texture->factor != std::array{1.0, 1.0, 1.0}) {
    append_triple(text, "Kd", {red, green, blue});
  }
  append_texture(text, *material.texture);
}

void append_material(std::string& text, const Material& material) {
  append_named(text, "newmtl", material_name(material));
  append_diffuse(text, material);
  if (material.emission == geom::dvec3{0, 0, 0}) return;
  if (material.emission_unit == Material::EmissionUnit::Luminance) {
    text += "# exitance: pi times the luminance in cd/m2 that was given\n";
    append_triple(text, "Ke", material.emission * std::numbers::pi);
  } else {
    append_triple(text, "Ke", material.emission);
  }
}

/// Writes faces one by one and, before them, what has changed since the face before.
class FaceWriter {
 public:
  FaceWriter(const Scene& scene, bool names_zero, std::string& text) : scene_(scene), text_(text) {
    if (!names_zero) material_ = 0;
  }

  void write(const Face& face) {
    const auto outer = scene_.corners_of(scene_.loops[face.first_loop]);
    if (outer.empty()) return;
    switch_to(face);
    switch_smoothing(face);
    text_ += 'f';
    for (const std::uint32_t corner : bridged_ring(scene_, face)) append_corner(corner);
    text_ += '\n';
  }

 private:
  void switch_to(const Face& face) {
    if (face.object != object_) append_named(text_, "o", scene_.objects[object_ = face.object]);
    if (face.group != group_) append_named(text_, "g", scene_.groups[group_ = face.group]);
    if (material_ == face.material) return;
    material_ = face.material;
    append_named(text_, "usemtl", material_name(scene_.materials[face.material]));
  }

  void switch_smoothing(const Face& face) {
    if (scene_.smoothing_groups.empty()) return;
    const std::uint32_t group = scene_.smoothing_groups[static_cast<std::size_t>(&face - scene_.faces.data())];
    if (group == smoothing_group_) return;
    smoothing_group_ = group;
    append_named(text_, "s", group == 0 ? "off" : std::to_string(group));
  }

  // "7", "7/1", "7//3" or "7/1/3".
  void append_corner(std::uint32_t corner) {
    const scene::RowId texture = scene_.attributes.texture_coordinates.row(corner);
    const scene::RowId normal = scene_.attributes.normals.row(corner);
    text_ += ' ';
    append_number(text_, std::uint64_t{scene_.corners[corner]} + 1);
    if (texture != scene::kNoRow || normal != scene::kNoRow) text_ += '/';
    if (texture != scene::kNoRow) append_number(text_, std::uint64_t{texture} + 1);
    if (normal == scene::kNoRow) return;
    text_ += '/';
    append_number(text_, std::uint64_t{normal} + 1);
  }

  const Scene& scene_;
  std::string& text_;
  scene::ObjectId object_ = 0;
  scene::GroupId group_ = 0;
  std::optional<MaterialId> material_;
  std::uint32_t smoothing_group_ = 0;
};

void append_attributes(std::string& text, const scene::CornerAttributes& attributes) {
  const bool upper_left = attributes.texture_origin == scene::TextureOrigin::UpperLeft;
  for (const scene::dvec2& value : attributes.texture_coordinates.table) {
    text += "vt ";
    append_number(text, value.x);
    text += ' ';
    append_number(text, upper_left ? 1 - value.y : value.y);
    text += '\n';
  }
  for (const geom::dvec3& normal : attributes.normals.table) append_triple(text, "vn", normal);
}

}  // namespace

ObjText obj_text(const Scene& scene, const std::string& mtl_name, std::span<const std::string> comments) {
  ObjText result;
  const bool names_zero = names_material_zero(scene);
  for (MaterialId id = names_zero ? 0 : 1; id < scene.materials.size(); ++id) {
    append_material(result.mtl, scene.materials[id]);
  }
  for (const std::string& comment : comments) append_named(result.obj, "#", comment);
  if (!result.mtl.empty()) append_named(result.obj, "mtllib", mtl_name);
  for (const geom::dvec3& vertex : scene.vertices) append_triple(result.obj, "v", vertex);
  append_attributes(result.obj, scene.attributes);
  FaceWriter faces(scene, names_zero, result.obj);
  for (const Face& face : scene.faces) faces.write(face);
  return result;
}

WriteResult write_obj(const Output& output, const std::filesystem::path& path) {
  if (std::string problem = problem_of(output); !problem.empty()) return {std::move(problem)};
  std::filesystem::path mtl_path = path;
  mtl_path.replace_extension(".mtl");
  const ObjText text = obj_text(output.scene, mtl_path.filename().string(), head_comments(output));
  if (text.mtl.empty()) return {write_whole_file(path, text.obj)};
  return {write_whole_files(std::array<WholeFile, 2>{{{mtl_path, text.mtl}, {path, text.obj}}})};
}

}  // namespace rad::writers
