#include "cli/annotated_scene.h"

#include "writers/registry.h"

namespace rad::cli {

namespace {

void name_sorts(scene::Scene& scene, std::span<const FaceSort> sorts) {
  scene.materials.resize(1);
  scene.objects.resize(1);
  scene.groups.resize(1);
  for (const FaceSort& sort : sorts) {
    scene::Material material;
    material.name = sort.name;
    material.reflectance = sort.colour;
    material.reflectance_stated = true;
    scene.materials.push_back(std::move(material));
    scene.objects.push_back(sort.name);
  }
}

}  // namespace

void put_into_sorts(scene::Scene& scene, std::span<const FaceSort> sorts, std::span<const std::size_t> sort_of_face) {
  name_sorts(scene, sorts);
  for (std::size_t face = 0; face < scene.faces.size(); ++face) {
    scene.faces[face].material = static_cast<scene::MaterialId>(sort_of_face[face] + 1);
    scene.faces[face].object = static_cast<scene::ObjectId>(sort_of_face[face] + 1);
    scene.faces[face].group = 0;
  }
}

std::string write_annotated(const std::string& path, const scene::Scene& scene, std::span<const FaceSort> sorts,
                            const std::optional<scene::RecordedLattice>& lattice) {
  std::vector<writers::LegendEntry> legend;
  for (const FaceSort& sort : sorts) legend.push_back({sort.name, sort.meaning, sort.colour});
  writers::Output output{scene};
  output.lattice = lattice;
  output.legend = legend;
  return writers::writer_for(path)->write(output, path).problem;
}

std::string annotation_problem(const std::string& path) {
  if (path.empty()) return {};
  const writers::Writer* const writer = writers::writer_for(path);
  return writer != nullptr && writer->carries_legend ? std::string() : path + ": annotated models are .glb or .gltf";
}

}  // namespace rad::cli
