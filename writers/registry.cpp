#include "writers/registry.h"

#include <algorithm>
#include <array>

#include "writers/gltf.h"
#include "writers/obj.h"
#include "writers/off.h"
#include "writers/ply.h"
#include "writers/stl.h"

namespace rad::writers {
namespace {

constexpr std::array<std::string_view, 1> kObj = {"obj"}, kPly = {"ply"}, kStl = {"stl"}, kOff = {"off"},
                                          kGlb = {"glb"}, kGltf = {"gltf"};

constexpr std::array<Writer, 6> kWriters = {{
    {"OBJ", kObj, false, false, write_obj},
    {"PLY", kPly, false, true, write_ply},
    {"STL", kStl, true, false, write_stl},
    {"OFF", kOff, false, false, write_off},
    {"GLB", kGlb, true, true, write_glb},
    {"glTF", kGltf, true, true, write_gltf},
}};

std::string lower_case_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

}  // namespace

const Writer* writer_for(const std::filesystem::path& path) {
  const std::string extension = lower_case_extension(path);
  const auto* const found = std::ranges::find_if(kWriters, [&](const Writer& writer) {
    return std::ranges::find(writer.extensions, extension) != writer.extensions.end();
  });
  return found == kWriters.end() ? nullptr : found;
}

std::string writable_extensions() {
  std::string text;
  for (const Writer& writer : kWriters) {
    for (const std::string_view extension : writer.extensions) {
      if (!text.empty()) text += ", ";
      text += extension;
    }
  }
  return text;
}

}  // namespace rad::writers
