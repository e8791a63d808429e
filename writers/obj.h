// Writing a scene as Wavefront OBJ with its MTL.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "writers/model.h"

namespace rad::writers {

/// The two files as text. `mtl` is empty where no face names a material that MTL has to describe.
struct ObjText {
  std::string obj;
  std::string mtl;
};

/// The scene as text. Vertices, faces and names keep their order; numbers are the shortest that read back the same.
/// A face with holes becomes one ring with a bridge to each hole. A material in cd/m² is written as the exitance π
/// times that. Texture coordinates and normals are written row by row, smoothing groups as "s", the image of a material
/// as map_Kd with its factor as Kd. Lost, for OBJ has no place for it: light, double-sidedness, faces without corners,
/// line breaks in names, images that the input carries in itself, rotations and filters of textures.
/// `comments` are lines for the head of the OBJ, without the leading "# ".
ObjText obj_text(const scene::Scene& scene, const std::string& mtl_name, std::span<const std::string> comments = {});

/// Writes `path` and, beside it, the MTL of the same stem. Both are written under another name first and renamed when
/// complete, the MTL before the OBJ that names it.
WriteResult write_obj(const Output& output, const std::filesystem::path& path);

}  // namespace rad::writers
