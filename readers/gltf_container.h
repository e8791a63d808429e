// The outer shape of a glTF file: the chunks of a GLB, the JSON text, the version and the extensions it demands.
#pragma once

#include <optional>
#include <string_view>

#include "readers/json_view.h"
#include "readers/reader.h"

namespace rad::readers::gltf {

inline constexpr std::string_view kGlbMagic = "glTF";

/// A parsed file. Everything below borrows from it and from the Input.
struct Document {
  const Input& input;
  scene::ReadIssues& issues;
  Json json;
  std::optional<std::string_view> binary;  ///< the BIN chunk of a GLB, as much of it as the file holds

  [[nodiscard]] JsonView root() const { return JsonView(json, "", issues); }
};

/// Parses the container. Nothing, with one ParseError, where the file cannot be read as glTF 2 at all or demands an
/// extension that is not read. A cut BIN chunk is reported and kept as far as it goes.
std::optional<Document> open_document(const Input& input, scene::ReadIssues& issues);

}  // namespace rad::readers::gltf
