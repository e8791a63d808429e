#include "corpus/generate/kept_files.h"

#include "writers/obj.h"

namespace rad::corpus {

std::array<KeptFile, 2> files_of(const Model& model, const std::string& stem) {
  const std::array<std::string, 2> comments{std::string(model.name) + ", made by rad_corpus: do not edit",
                                            "units: m, Z up"};
  writers::ObjText text = writers::obj_text(model.make(), stem + ".mtl", comments);
  return {{{stem + ".obj", std::move(text.obj)}, {stem + ".mtl", std::move(text.mtl)}}};
}

std::vector<KeptFile> kept_files() {
  std::vector<KeptFile> files;
  for (const Model& model : kept_models()) {
    for (KeptFile& file : files_of(model, std::string(model.name))) files.push_back(std::move(file));
  }
  return files;
}

}  // namespace rad::corpus
