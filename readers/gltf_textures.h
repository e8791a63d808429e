// The textures of glTF materials: images by name or as bytes, samplers, and how coordinates are changed before.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "readers/gltf_buffers.h"
#include "scene/texture.h"

namespace rad::readers::gltf {

/// A texture and the set of coordinates (TEXCOORD_n) that it is looked up by.
struct MaterialTexture {
  scene::Texture texture;
  std::uint64_t set = 0;
};

/// Reads textures that materials refer to. No image file is opened; the bytes of embedded images are copied, once each
/// and together no more than the file has.
class Textures {
 public:
  Textures(const Document& document, const Buffers& buffers) : document_(document), buffers_(buffers) {}

  /// What a reference ("baseColorTexture") means; nothing where it leads to no image.
  std::optional<MaterialTexture> read(const JsonView& reference);

 private:
  std::shared_ptr<const scene::Image> image(std::uint64_t index);
  std::shared_ptr<const scene::Image> read_image(const JsonView& json);
  bool embed(std::string bytes, const JsonView& json, scene::Image& image);

  const Document& document_;
  const Buffers& buffers_;
  std::map<std::uint64_t, std::shared_ptr<const scene::Image>> images_;
  std::uint64_t embedded_bytes_ = 0;
};

}  // namespace rad::readers::gltf
