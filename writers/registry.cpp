#include "writers/registry.h"

#include <algorithm>
#include <array>

#include "writers/cityjson.h"
#include "writers/drc.h"
#include "writers/dxf.h"
#include "writers/gltf.h"
#include "writers/obj.h"
#include "writers/off.h"
#include "writers/ply.h"
#include "writers/rad.h"
#include "writers/stage.h"
#include "writers/stl.h"
#include "writers/threemf.h"

namespace rad::writers {
namespace {

constexpr std::array<std::string_view, 1> kObj = {"obj"}, kPly = {"ply"}, kStl = {"stl"}, kOff = {"off"},
                                          kGlb = {"glb"}, kDracoGlb = {"draco.glb"}, kDrc = {"drc"}, kGltf = {"gltf"},
                                          kStage = {"stage.json"}, kRad = {"rad"}, kDxf = {"dxf"}, k3mf = {"3mf"};
constexpr std::array<std::string_view, 2> kCityJson = {"city.json", "cityjson"};

constexpr Holds kAll{Corners::Any, true, true, true, true, true, true, true, true, true, true};
constexpr Holds kObjHolds{.objects = true,
                          .groups = true,
                          .materials = true,
                          .reflectance = true,
                          .emission = true,
                          .reflecting_lights = true,
                          .images = true,
                          .doubles = true};
constexpr Holds kPointsOnly{.doubles = true};
constexpr Holds kStlHolds{.corners = Corners::Three};
constexpr Holds kGltfHolds{.corners = Corners::Three,
                           .objects = true,
                           .materials = true,
                           .reflectance = true,
                           .emission = true,
                           .reflecting_lights = true,
                           .images = true,
                           .unit = true};
constexpr Holds kRadHolds{.objects = true, .materials = true, .reflectance = true, .emission = true, .doubles = true};
constexpr Holds kDxfHolds{.corners = Corners::Four, .objects = true, .unit = true, .doubles = true};
constexpr Holds kCityHolds{.holes = true,
                           .objects = true,
                           .materials = true,
                           .reflectance = true,
                           .reflecting_lights = true,
                           .unit = true,
                           .doubles = true};
constexpr Holds k3mfHolds{.corners = Corners::Three,
                          .objects = true,
                          .materials = true,
                          .reflectance = true,
                          .reflecting_lights = true,
                          .unit = true,
                          .doubles = true};

constexpr std::array<Writer, 13> kWriters = {{
    {"OBJ", kObj, false, false, false, false, kObjHolds, write_obj},
    {"PLY", kPly, false, true, false, false, kPointsOnly, write_ply},
    {"STL", kStl, true, false, false, false, kStlHolds, write_stl},
    {"OFF", kOff, false, false, false, false, kPointsOnly, write_off},
    {"GLB, Draco", kDracoGlb, true, true, true, false, kGltfHolds, write_draco_glb},
    {"GLB", kGlb, true, true, true, false, kGltfHolds, write_glb},
    {"glTF", kGltf, true, true, true, false, kGltfHolds, write_gltf},
    {"Draco", kDrc, true, true, false, false, kStlHolds, write_drc},
    {"Radiance", kRad, false, false, false, false, kRadHolds, write_rad},
    {"DXF", kDxf, true, false, false, false, kDxfHolds, write_dxf},
    {"CityJSON", kCityJson, false, false, false, false, kCityHolds, write_cityjson},
    {"3MF", k3mf, true, false, false, false, k3mfHolds, write_3mf},
    {"stage file", kStage, false, false, false, true, kAll, write_stage},
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

std::span<const Writer> all_writers() { return kWriters; }

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
