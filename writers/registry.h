// Which formats are written, and what a caller has to know of each.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "writers/model.h"

namespace rad::writers {

struct Writer {
  std::string_view name;
  std::span<const std::string_view> extensions;  ///< lower case, without dot
  bool triangles_only;                           ///< faces must be triangles or convex quads, without holes
  bool carries_light;
  bool carries_legend;
  bool between_filters;  ///< a stage file: holds a model between two filters
  WriteResult (*write)(const Output& output, const std::filesystem::path& path);
};

/// The writer for the extension of a path, whatever its case. Null where there is none.
const Writer* writer_for(const std::filesystem::path& path);

/// "obj, ply, stl, off, glb, gltf", for messages.
std::string writable_extensions();

}  // namespace rad::writers
