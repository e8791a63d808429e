// Writing a scene as Wavefront OBJ with its MTL.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "scene/scene.h"

namespace rad::writers {

struct ObjOptions {
  std::span<const std::string> comments;  ///< lines for the head of the OBJ, without the leading "# "
};

/// The two files as text. `mtl` is empty where no face names a material that MTL has to describe.
struct ObjText {
  std::string obj;
  std::string mtl;
};

/// The scene as text. Vertices, faces and names keep their order; numbers are the shortest that read back the same.
/// A face with holes becomes one ring with a bridge to each hole. A material in cd/m² is written as the exitance π
/// times that. Lost, for OBJ has no place for it: double-sidedness, faces without corners, line breaks in names.
ObjText obj_text(const scene::Scene& scene, const std::string& mtl_name, const ObjOptions& options = {});

/// Why nothing was written; empty where all was.
struct WriteResult {
  std::string problem;
  [[nodiscard]] bool ok() const { return problem.empty(); }
};

/// Writes `path` and, beside it, the MTL of the same stem. Both are written under another name first and renamed when
/// complete, the MTL before the OBJ that names it.
WriteResult write_obj(const scene::Scene& scene, const std::filesystem::path& path, const ObjOptions& options = {});

}  // namespace rad::writers
