#include "cli/annotation.h"

#include <array>

#include "cli/annotated_scene.h"
#include "scene/repaired_scene.h"

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
    {"moved",
     "moved by more than rounding",
     {0.90, 0.45, 0.02},
     [](const FaceHistory& face) { return face.moved > 0; }},
    {"merged", "made of several faces", {0.05, 0.25, 0.80}, [](const FaceHistory& face) { return face.merged(); }},
    {"cut", "a part of a face that was cut", {0.02, 0.55, 0.60}, [](const FaceHistory& face) { return face.cut; }},
    {"divided",
     "has new vertices along its edges",
     {0.35, 0.65, 0.10},
     [](const FaceHistory& face) { return face.divided; }},
    {"untouched", "as it was", {0.60, 0.60, 0.60}, [](const FaceHistory&) { return true; }},
}};

std::vector<FaceSort> face_sorts() {
  std::vector<FaceSort> sorts;
  for (const Sort& sort : kSorts) sorts.push_back({sort.name, sort.meaning, sort.colour});
  return sorts;
}

std::size_t sort_of(const FaceHistory& face) {
  std::size_t sort = 0;
  while (!kSorts[sort].holds(face)) ++sort;
  return sort;
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
  std::vector<std::size_t> sorts(scene.faces.size());
  for (std::size_t face = 0; face < sorts.size(); ++face) {
    const std::size_t of_history = turned_only ? face : pieces.face[face];
    sorts[face] = history ? sort_of(history->faces[of_history]) : kSorts.size() - 1;
  }
  put_into_sorts(scene, face_sorts(), sorts);
  return std::move(pieces.scene);
}

}  // namespace

std::string write_annotation(const std::string& path, const Model& before, const Product& product,
                             const std::optional<repair::History>& history) {
  return write_annotated(path, annotated(before, product, history), face_sorts(), product.lattice);
}

}  // namespace rad::cli
