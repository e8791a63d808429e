// rad_corpus --out DIR writes the kept models; rad_corpus MODEL OUT.obj writes one, with its materials beside it.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "corpus/generate/kept_files.h"
#include "writers/whole_file.h"

namespace {

using namespace rad::corpus;

bool write(const std::filesystem::path& folder, const KeptFile& file) {
  const std::string problem = rad::writers::write_whole_file(folder / file.name, file.bytes);
  if (!problem.empty()) std::fprintf(stderr, "rad_corpus: %s\n", problem.c_str());
  return problem.empty();
}

const Model* find_model(std::string_view name) {
  for (const std::span<const Model> models : {kept_models(), made_models()}) {
    const auto found = std::ranges::find(models, name, &Model::name);
    if (found != models.end()) return &*found;
  }
  return nullptr;
}

int usage() {
  std::fputs("usage: rad_corpus --out DIR\n       rad_corpus MODEL OUT.obj\nmodels:", stderr);
  for (const std::span<const Model> models : {kept_models(), made_models()}) {
    for (const Model& model : models) std::fprintf(stderr, " %s", std::string(model.name).c_str());
  }
  std::fputs("\n", stderr);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return usage();
  const std::filesystem::path out = argv[2];
  if (std::string_view(argv[1]) == "--out") {
    const auto files = kept_files();
    return std::ranges::all_of(files, [&](const KeptFile& file) { return write(out, file); }) ? 0 : 2;
  }
  const Model* model = find_model(argv[1]);
  if (model == nullptr || out.extension() != ".obj") return usage();
  const auto files = files_of(*model, out.stem().string());
  return std::ranges::all_of(files, [&](const KeptFile& file) { return write(out.parent_path(), file); }) ? 0 : 2;
}
