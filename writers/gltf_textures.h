// The textures of a written glTF document: images by URI or as bytes in the buffer, and samplers.
#pragma once

#include <memory>
#include <vector>

#include "scene/texture.h"
#include "writers/gltf_buffer.h"

namespace rad::writers::gltf {

/// Collects what materials refer to; equal images, samplers and textures are written once, in the order of first use.
class TextureTable {
 public:
  /// The reference to a texture ("baseColorTexture"), on coordinate set 0.
  Json reference(const scene::Texture& texture);

  /// Adds "images", "samplers" and "textures" to a document where there are any, and embedded bytes to its buffer.
  void write(Json& document, BufferBuilder& buffer) const;

 private:
  struct Entry {
    std::size_t image = 0;
    scene::Sampling sampling;
    friend bool operator==(const Entry&, const Entry&) = default;
  };

  std::vector<std::shared_ptr<const scene::Image>> images_;
  std::vector<Entry> textures_;
};

}  // namespace rad::writers::gltf
