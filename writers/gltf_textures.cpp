#include "writers/gltf_textures.h"

#include <algorithm>

#include "writers/gltf_uri.h"

namespace rad::writers::gltf {
namespace {

constexpr const char* kTransform = "KHR_texture_transform";
constexpr std::uint32_t kRepeat = 10497;

bool is(const scene::Image& image, std::string_view media_type, std::string_view suffix) {
  return image.embedded() ? image.media_type == media_type : image.path.ends_with(suffix);
}

// The extension that a texture needs for an image that is neither PNG nor JPEG; null for none.
const char* extension_for(const scene::Image& image) {
  if (is(image, "image/webp", ".webp")) return "EXT_texture_webp";
  if (is(image, "image/ktx2", ".ktx2")) return "KHR_texture_basisu";
  if (is(image, "image/avif", ".avif")) return "EXT_texture_avif";
  return nullptr;
}

Json pair_json(const scene::dvec2& value) { return Json::array({value.x, value.y}); }

Json sampler_json(const scene::Sampling& sampling) {
  Json json = Json::object();
  if (sampling.magnify != 0) json["magFilter"] = sampling.magnify;
  if (sampling.minify != 0) json["minFilter"] = sampling.minify;
  json["wrapS"] = sampling.wrap_s != 0 ? sampling.wrap_s : kRepeat;
  json["wrapT"] = sampling.wrap_t != 0 ? sampling.wrap_t : kRepeat;
  return json;
}

Json image_json(const scene::Image& image, BufferBuilder& buffer) {
  Json json = Json::object();
  if (!image.name.empty()) json["name"] = image.name;
  if (!image.embedded()) {
    json["uri"] = uri_of_path(image.path);
    return json;
  }
  json["mimeType"] = image.media_type;
  json["bufferView"] = buffer.add_block(image.bytes);
  return json;
}

template <typename Item, typename Same>
std::size_t place_in(std::vector<Item>& items, const Item& item, Same same) {
  const auto found = std::ranges::find_if(items, [&](const Item& other) { return same(item, other); });
  if (found != items.end()) return static_cast<std::size_t>(found - items.begin());
  items.push_back(item);
  return items.size() - 1;
}

}  // namespace

Json TextureTable::reference(const scene::Texture& texture) {
  const std::size_t image =
      place_in(images_, texture.image, [](const auto& a, const auto& b) { return a == b || *a == *b; });
  const std::size_t index = place_in(textures_, Entry{image, texture.sampling}, std::equal_to<>());
  Json json{{"index", index}};
  if (texture.transform) {
    const scene::TextureTransform& transform = *texture.transform;
    json["extensions"][kTransform] = {{"offset", pair_json(transform.offset)},
                                      {"rotation", transform.rotation},
                                      {"scale", pair_json(transform.scale)}};
  }
  return json;
}

void TextureTable::write(Json& document, BufferBuilder& buffer) const {
  if (textures_.empty()) return;
  std::vector<scene::Sampling> samplings;
  Json images = Json::array(), samplers = Json::array(), textures = Json::array();
  for (const auto& image : images_) images.push_back(image_json(*image, buffer));
  for (const Entry& texture : textures_) {
    Json json{{"sampler", place_in(samplings, texture.sampling, std::equal_to<>())}};
    if (const char* extension = extension_for(*images_[texture.image])) {
      json["extensions"][extension] = {{"source", texture.image}};
    } else {
      json["source"] = texture.image;
    }
    textures.push_back(std::move(json));
  }
  for (const scene::Sampling& sampling : samplings) samplers.push_back(sampler_json(sampling));
  document["textures"] = std::move(textures);
  document["images"] = std::move(images);
  document["samplers"] = std::move(samplers);
}

}  // namespace rad::writers::gltf
