#include "writers/registry.h"

#include <algorithm>
#include <array>

#include "writers/gltf.h"
#include "writers/obj.h"
#include "writers/off.h"
#include "writers/ply.h"
#include "writers/stage.h"
#include "writers/stl.h"

namespace rad::writers {
namespace {

constexpr std::array<std::string_view, 1> kObj = {"obj"}, kPly = {"ply"}, kStl = {"stl"}, kOff = {"off"},
                                          kGlb = {"glb"}, kGltf = {"gltf"}, kStage = {"stage.json"};

constexpr std::array<Writer, 7> kWriters = {{
    {"OBJ", kObj, false, false, false, false, write_obj},
    {"PLY", kPly, false, true, false, false, write_ply},
    {"STL", kStl, true, false, false, false, write_stl},
    {"OFF", kOff, false, false, false, false, write_off},
    {"GLB", kGlb, true, true, true, false, write_glb},
    {"glTF", kGltf, true, true, true, false, write_gltf},
    {"stage file", kStage, false, false, false, true, write_stage},
}};

std::string lower_case_name(const std::filesystem::path& path) {
  std::string name = path.filename().string();
  std::ranges::transform(name, name.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return name;
}

// Extensions may have more than one part. A name that is nothing else has none.
bool ends_in(std::string_view name, std::string_view extension) {
  return name.size() > extension.size() + 1 && name.ends_with(extension) &&
         name[name.size() - extension.size() - 1] == '.';
}

}  // namespace

const Writer* writer_for(const std::filesystem::path& path) {
  const std::string name = lower_case_name(path);
  const auto* const found = std::ranges::find_if(kWriters, [&](const Writer& writer) {
    return std::ranges::any_of(writer.extensions, [&](std::string_view extension) { return ends_in(name, extension); });
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
