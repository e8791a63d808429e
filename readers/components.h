// Readers that stand on libraries and programs which a build or a machine may be without.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "readers/reader.h"

namespace rad::readers {

inline constexpr std::array<std::string_view, 6> kAssimpSuffixes = {".dae", ".fbx", ".3ds", ".3mf", ".x3d", ".lwo"};
inline constexpr std::array<std::string_view, 4> kOcctSuffixes = {".step", ".stp", ".iges", ".igs"};
inline constexpr std::array<std::string_view, 1> kIfcSuffixes = {".ifc"};

struct Component {
  std::string_view name;                       ///< "assimp"
  std::string_view formats;                    ///< for messages: "COLLADA, FBX, 3DS, 3MF, X3D, LWO"
  std::span<const std::string_view> suffixes;  ///< of the formats, lower case, with dot
  const Reader* reader = nullptr;              ///< null where the build is without it
  std::string version;                         ///< empty where the build is without it
};

std::span<const Component> components();

/// The component that would read a file of this name, where the build is without it; null elsewhere.
const Component* missing_component(const std::filesystem::path& path);

}  // namespace rad::readers
