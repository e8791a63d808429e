// Which formats are written, and what a caller has to know of each.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "writers/holds.h"
#include "writers/model.h"

namespace rad::writers {

struct Writer {
  std::string_view name;
  std::span<const std::string_view> extensions;  ///< lower case, without dot
  bool triangles_only;                           ///< faces must be triangles or convex quads, without holes
  bool carries_light;
  bool carries_legend;
  bool between_filters;  ///< a stage file: holds a model between two filters
  Holds holds;
  WriteResult (*write)(const Output& output, const std::filesystem::path& path);
};

/// All writers, in the order in which they are listed.
std::span<const Writer> all_writers();

/// The writer for the extension of a path, whatever its case. Null where there is none.
const Writer* writer_for(const std::filesystem::path& path);

/// "obj, ply, stl…", for messages.
std::string writable_extensions();

}  // namespace rad::writers
