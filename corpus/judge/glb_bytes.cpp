#include "corpus/judge/glb_bytes.h"

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "readers/reader.h"
#include "writers/gltf.h"

namespace rad::corpus {
namespace {

// Of this process and no other call.
std::filesystem::path temporary_path() {
  static std::atomic<unsigned> count = 0;
  const std::string name = "rad_judge_" + std::to_string(getpid()) + "_" + std::to_string(count++) + ".glb";
  return std::filesystem::temp_directory_path() / name;
}

}  // namespace

std::string glb_bytes(const scene::Scene& scene) {
  const std::filesystem::path path = temporary_path();
  const writers::Output output{.scene = scene, .lattice = scene.recorded};
  if (const auto result = writers::write_glb(output, path); !result.ok()) throw std::runtime_error(result.problem);
  std::string bytes;
  {
    std::ifstream file(path, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
  }
  std::filesystem::remove(path);
  return bytes;
}

scene::Scene scene_of_glb(const std::string& bytes) { return readers::read_bytes({"scene.glb", {}, bytes, {}}).scene; }

}  // namespace rad::corpus
