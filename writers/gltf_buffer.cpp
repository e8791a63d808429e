#include "writers/gltf_buffer.h"

#include <algorithm>

namespace rad::writers::gltf {
namespace {

constexpr int kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;

struct Layout {
  std::size_t element_bytes;
  int component;
  const char* type;
  bool is_vertex_data;
};

constexpr std::array<Layout, kKinds> kLayouts = {{
    {12, kFloat, "VEC3", true},
    {12, kFloat, "VEC3", true},
    {8, kFloat, "VEC2", true},
    {8, kUnsignedShort, "VEC4", true},
    {12, kFloat, "VEC3", true},
    {2, kUnsignedShort, "SCALAR", false},
    {4, kUnsignedInt, "SCALAR", false},
}};

std::size_t aligned(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

}  // namespace

std::size_t BufferBuilder::add_accessor(Kind kind, std::size_t count, Json members) {
  const std::size_t bytes = count * kLayouts[static_cast<std::size_t>(kind)].element_bytes;
  accessors_.push_back({kind, bytes_of(kind).size() - bytes, count, std::move(members)});
  return accessors_.size() - 1;
}

std::size_t BufferBuilder::used_kinds() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(bytes_, [](const std::string& bytes) { return !bytes.empty(); }));
}

std::size_t BufferBuilder::add_block(std::string_view bytes) {
  blocks_.push_back(bytes);
  return used_kinds() + blocks_.size() - 1;
}

std::string BufferBuilder::buffer() const {
  std::string all;
  const auto append = [&](std::string_view bytes) {
    all += bytes;
    all.resize(aligned(all.size()), '\0');
  };
  for (const std::string& bytes : bytes_) append(bytes);
  for (const std::string_view block : blocks_) append(block);
  return all;
}

// Several accessors into one view of vertex data need its stride stated.
Json BufferBuilder::views() const {
  Json views = Json::array();
  std::size_t offset = 0;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    if (bytes_[kind].empty()) continue;
    Json view{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes_[kind].size()}};
    if (kLayouts[kind].is_vertex_data) view["byteStride"] = kLayouts[kind].element_bytes;
    view["target"] = kLayouts[kind].is_vertex_data ? kArrayBuffer : kElementArrayBuffer;
    views.push_back(std::move(view));
    offset += aligned(bytes_[kind].size());
  }
  for (const std::string_view block : blocks_) {
    views.push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", block.size()}});
    offset += aligned(block.size());
  }
  return views;
}

Json BufferBuilder::accessors() const {
  std::array<std::size_t, kKinds> view_of{};
  std::size_t views = 0;
  for (std::size_t kind = 0; kind < kKinds; ++kind) view_of[kind] = bytes_[kind].empty() ? views : views++;
  Json accessors = Json::array();
  for (const Accessor& accessor : accessors_) {
    const auto kind = static_cast<std::size_t>(accessor.kind);
    Json json{{"bufferView", view_of[kind]},
              {"byteOffset", accessor.offset},
              {"componentType", kLayouts[kind].component},
              {"count", accessor.count},
              {"type", kLayouts[kind].type}};
    json.update(accessor.members);
    accessors.push_back(std::move(json));
  }
  return accessors;
}

}  // namespace rad::writers::gltf
