// The material libraries that an OBJ file names by mtllib.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "readers/reader.h"
#include "scene/scene_builder.h"

namespace rad::readers {

/// The file names of a mtllib statement. A name may hold blanks: it reaches to the next ".mtl" that a blank or the
/// end follows. Without any ".mtl", blanks part the names.
std::vector<std::string> library_names(std::string_view statement);

/// Reads libraries into a scene. Each is read once, however often it is named; of several definitions of a material
/// the first one holds.
class ObjLibraries {
 public:
  ObjLibraries(const Input& input, scene::SceneBuilder& builder, scene::ReadIssues& issues)
      : input_(input), builder_(builder), issues_(issues) {}

  /// Takes over what the libraries of a statement define; `line` is that of the statement.
  void use(std::string_view statement, std::uint64_t line);

  [[nodiscard]] bool defines(scene::MaterialId material) const { return defined_.contains(material); }

 private:
  void read(const std::string& name, std::uint64_t line);
  void define(scene::Material material);
  void add_missing(std::string what, std::uint64_t line);

  const Input& input_;
  scene::SceneBuilder& builder_;
  scene::ReadIssues& issues_;
  std::set<std::string> seen_;
  std::set<scene::MaterialId> defined_;
};

}  // namespace rad::readers
