// The files under corpus/models, as text.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "corpus/generate/models.h"

namespace rad::corpus {

struct KeptFile {
  std::string name;  ///< "lamp_post.obj"
  std::string bytes;
};

/// OBJ and MTL of one model; the first names the second as `stem`.mtl.
std::array<KeptFile, 2> files_of(const Model& model, const std::string& stem);

/// OBJ and MTL of every kept model. The same on every run.
std::vector<KeptFile> kept_files();

}  // namespace rad::corpus
