// The image over the diffuse colour of a material, passed on from file to file. It is never looked at.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "scene/corner_values.h"

namespace rad::scene {

/// An image that a model refers to by `path`, or one that it carries in itself.
struct Image {
  std::string path;        ///< as the model names it, '/' or '\' between its parts, no escapes; empty where embedded
  std::string name;        ///< of an embedded image; may be empty
  std::string media_type;  ///< of an embedded image: "image/png", "image/jpeg"…
  std::string bytes;       ///< of an embedded image, as the file holds them

  [[nodiscard]] bool embedded() const { return path.empty(); }
  friend bool operator==(const Image&, const Image&) = default;
};

/// How texture coordinates are changed before the image is looked up, in the order scale, rotation, offset, with the
/// origin at the upper left (KHR_texture_transform).
struct TextureTransform {
  dvec2 offset{0, 0};
  double rotation = 0;  ///< radians
  dvec2 scale{1, 1};
  friend bool operator==(const TextureTransform&, const TextureTransform&) = default;
};

/// Codes of glTF for wrapping (10497 repeat, 33071 clamp, 33648 mirror) and filtering; 0 where the file states none.
struct Sampling {
  std::uint32_t wrap_s = 0;
  std::uint32_t wrap_t = 0;
  std::uint32_t magnify = 0;
  std::uint32_t minify = 0;
  friend bool operator==(const Sampling&, const Sampling&) = default;
};

struct Texture {
  std::shared_ptr<const Image> image;     ///< never null; materials may share it
  std::array<double, 3> factor{1, 1, 1};  ///< the image's colour is multiplied by it
  Sampling sampling;
  std::optional<TextureTransform> transform;
};

}  // namespace rad::scene
