#include "cli/annotation.h"

#include <array>

#include "scene/repaired_scene.h"
#include "writers/registry.h"

namespace rad::cli {
namespace {

using repair::FaceHistory;

struct Sort {
  const char* name;
  const char* meaning;
  geom::dvec3 colour;  ///< linear
  bool (*holds)(const FaceHistory& face);
};

// A face is shown as the first of these that holds: what an author has to look at comes first.
constexpr std::array<Sort, 7> kSorts{{
    {"turned", "turned to look the other way", {0.80, 0.05, 0.60}, [](const FaceHistory& face) { return face.turned; }},
    {"won", "others lay in it and were removed", {0.85, 0.10, 0.02}, [](const FaceHistory& face) { return face.won; }},
    {"moved", "moved by more than rounding", {0.90, 0.45, 0.02}, [](const FaceHistory& face) { return face.moved > 0; }},
    {"merged", "made of several faces", {0.05, 0.25, 0.80}, [](const FaceHistory& face) { return face.merged(); }},
    {"cut", "a part of a face that was cut", {0.02, 0.55, 0.60}, [](const FaceHistory& face) { return face.cut; }},
    {"divided", "has new vertices along its edges", {0.35, 0.65, 0.10}, [](const FaceHistory& face) { return face.divided; }},
    {"untouched", "as it was", {0.60, 0.60, 0.60}, [](const FaceHistory&) { return true; }},
}};

std::size_t sort_of(const FaceHistory& face) {
  std::size_t sort = 0;
  while (!kSorts[sort].holds(face)) ++sort;
  return sort;
}

// A material and an object for each sort, by its name; those that no face has are left out by the writer.
void name_sorts(scene::Scene& scene) {
  scene.materials.resize(1);
  scene.objects.resize(1);
  scene.groups.resize(1);
  for (const Sort& sort : kSorts) {
    scene::Material material;
    material.name = sort.name;
    material.reflectance = sort.colour;
    material.reflectance_stated = true;
    scene.materials.push_back(std::move(material));
    scene.objects.emplace_back(sort.name);
  }
}

// Triangles of the model or, where it is the input as it was, its faces, which writers triangulate.
scene::Scene annotated(const Model& before, const Product& product, const std::optional<repair::History>& history) {
  const repair::Repaired& repaired = product.work.repaired;
  const scene::Scene& input = before.content.scene;
  const bool turned_only = repaired.turned.has_value();
  scene::PiecesOfModel pieces;
  if (turned_only) {
    pieces.scene = *repaired.turned;
  } else {
    pieces = scene::pieces_of(repaired.model, input, std::vector<bool>(repaired.model.faces.size(), true));
  }
  scene::Scene& scene = pieces.scene;
  name_sorts(scene);
  for (std::size_t face = 0; face < scene.faces.size(); ++face) {
    const std::size_t of_history = turned_only ? face : pieces.face[face];
    const std::size_t sort = history ? sort_of(history->faces[of_history]) : kSorts.size() - 1;
    scene.faces[face].material = static_cast<scene::MaterialId>(sort + 1);
    scene.faces[face].object = static_cast<scene::ObjectId>(sort + 1);
    scene.faces[face].group = 0;
  }
  return std::move(pieces.scene);
}

}  // namespace

std::string write_annotation(const std::string& path, const Model& before, const Product& product,
                             const std::optional<repair::History>& history) {
  const scene::Scene scene = annotated(before, product, history);
  std::array<writers::LegendEntry, kSorts.size()> legend;
  for (std::size_t i = 0; i < kSorts.size(); ++i) legend[i] = {kSorts[i].name, kSorts[i].meaning, kSorts[i].colour};
  writers::Output output{scene};
  output.lattice = product.lattice;
  output.legend = legend;
  return writers::writer_for(path)->write(output, path).problem;
}

}  // namespace rad::cli
