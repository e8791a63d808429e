#include "readers/gltf_textures.h"

#include <cmath>
#include <utility>

#include "readers/gltf_uri.h"

namespace rad::readers::gltf {
namespace {

constexpr std::string_view kTransform = "KHR_texture_transform";

scene::dvec2 finite_pair(const JsonView& json, std::string_view key, double otherwise) {
  const auto numbers = json.numbers(key, 2);
  if (!numbers || !std::isfinite((*numbers)[0]) || !std::isfinite((*numbers)[1])) return scene::dvec2(otherwise);
  return {(*numbers)[0], (*numbers)[1]};
}

std::optional<scene::TextureTransform> transform_of(const JsonView& json) {
  if (!json) return std::nullopt;
  const scene::TextureTransform transform{finite_pair(json, "offset", 0), json.number("rotation").value_or(0),
                                          finite_pair(json, "scale", 1)};
  if (transform == scene::TextureTransform{} || !std::isfinite(transform.rotation)) return std::nullopt;
  return transform;
}

scene::Sampling sampling_of(const JsonView& json) {
  const auto code = [&](std::string_view key) {
    return static_cast<std::uint32_t>(json.whole(key).value_or(0) & 0xffffu);
  };
  return {code("wrapS"), code("wrapT"), code("magFilter"), code("minFilter")};
}

// No light hangs on an image: an index that leads nowhere is passed over.
JsonView existing_item(const JsonView& root, std::string_view key, const std::optional<std::uint64_t>& index) {
  return index && *index < root.length(key) ? root.item(key, *index) : JsonView();
}

// The image of a texture; extensions name one of another format where the core names none.
std::optional<std::uint64_t> source_of(const JsonView& texture) {
  if (const auto source = texture.whole("source")) return source;
  for (const std::string_view extension : {"EXT_texture_webp", "KHR_texture_basisu", "EXT_texture_avif"}) {
    if (const auto source = texture.extension(extension).whole("source")) return source;
  }
  return std::nullopt;
}

// "data:image/png;base64,…" → "image/png".
std::string media_type_of(std::string_view data_uri) {
  constexpr std::size_t kScheme = 5;
  return std::string(data_uri.substr(kScheme, data_uri.find_first_of(";,") - kScheme));
}

}  // namespace

std::optional<MaterialTexture> Textures::read(const JsonView& reference) {
  const auto index = reference.whole("index");
  const JsonView json = existing_item(document_.root(), "textures", index);
  if (!json) return std::nullopt;
  const auto source = source_of(json);
  MaterialTexture result;
  result.texture.image = source ? image(*source) : nullptr;
  if (!result.texture.image) return std::nullopt;
  if (const JsonView sampler = existing_item(document_.root(), "samplers", json.whole("sampler"))) {
    result.texture.sampling = sampling_of(sampler);
  }
  const JsonView transform = reference.extension(kTransform);
  result.texture.transform = transform_of(transform);
  result.set = transform.whole("texCoord").value_or(reference.whole("texCoord").value_or(0));
  return result;
}

std::shared_ptr<const scene::Image> Textures::image(std::uint64_t index) {
  const auto [entry, fresh] = images_.try_emplace(index);
  if (!fresh) return entry->second;
  if (const JsonView json = existing_item(document_.root(), "images", index)) entry->second = read_image(json);
  return entry->second;
}

std::shared_ptr<const scene::Image> Textures::read_image(const JsonView& json) {
  auto image = std::make_shared<scene::Image>();
  image->name = json.text("name");
  image->media_type = json.text("mimeType");
  const std::string uri = json.text("uri");
  if (is_data_uri(uri)) {
    auto bytes = data_uri_bytes(uri);
    image->media_type = media_type_of(uri);
    if (!bytes) {
      add_parse_error(document_.issues, "the data URI is not sound Base64", json.pointer() + "/uri");
      return nullptr;
    }
    if (!embed(std::move(*bytes), json, *image)) return nullptr;
  } else if (!uri.empty()) {
    *image = {percent_decoded(uri).value_or(uri), {}, {}, {}};
  } else {
    const auto view = json.whole("bufferView");
    const auto bytes = view ? buffers_.view(*view) : std::nullopt;
    if (!bytes || !embed(std::string(*bytes), json, *image)) return nullptr;
  }
  return image;
}

// Views that overlap let a short file name endless bytes.
bool Textures::embed(std::string bytes, const JsonView& json, scene::Image& image) {
  embedded_bytes_ += bytes.size();
  if (embedded_bytes_ > buffers_.backing_bytes()) {
    add_parse_error(document_.issues, "the images have more bytes than the file", json.pointer());
    return false;
  }
  image.bytes = std::move(bytes);
  return true;
}

}  // namespace rad::readers::gltf
