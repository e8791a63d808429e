#include "corpus/generate/kept_files.h"

#include <array>

#include "writers/obj.h"

namespace rad::corpus {

std::vector<KeptFile> kept_files() {
  std::vector<KeptFile> files;
  for (const Model& model : kept_models()) {
    const std::string name(model.name);
    const std::array<std::string, 2> comments{name + ", made by rad_corpus: do not edit", "units: m, Z up"};
    writers::ObjText text = writers::obj_text(model.make(), name + ".mtl", comments);
    files.push_back({name + ".obj", std::move(text.obj)});
    files.push_back({name + ".mtl", std::move(text.mtl)});
  }
  return files;
}

}  // namespace rad::corpus
