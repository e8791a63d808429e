#include "writers/gltf_draco.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

#include "writers/draco_stream.h"
#include "writers/gltf_manifold.h"

namespace rad::writers::gltf {
namespace {

constexpr const char* kDraco = "KHR_draco_mesh_compression";
constexpr int kUnsignedShort = 5123, kUnsignedInt = 5125;
constexpr std::uint32_t kShortIndices = 65535;

DracoUse use_of(const std::string& name) {
  if (name == "POSITION") return DracoUse::Position;
  if (name == "NORMAL") return DracoUse::Normal;
  if (name.starts_with("TEXCOORD_")) return DracoUse::Texture;
  return name.starts_with("COLOR_") ? DracoUse::Colour : DracoUse::Other;
}

std::uint8_t components_of(const std::string& type) { return static_cast<std::uint8_t>(type.back() - '0'); }

class Compressor {
 public:
  Compressor(const Json& plain, std::string_view buffer, double pitch) : plain_(plain), buffer_(buffer) {
    result_.json = plain;
    result_.json["accessors"] = Json::array();
    result_.json["bufferViews"] = Json::array();
    if (pitch > 0) grid_ = grid_over_positions(pitch);
  }

  DracoDocument run() {
    Json& meshes = result_.json["meshes"];
    for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
      meshes[mesh].erase("extensions");  // Draco numbers vertices anew: the solid's indices would mean nothing
      for (Json& primitive : meshes[mesh]["primitives"]) {
        if (!compress(primitive)) return {"Draco does not keep the triangles of mesh " + std::to_string(mesh), {}, {}};
      }
    }
    copy_images();
    name_extension();
    result_.json["buffers"] = Json::array({{{"byteLength", result_.buffer.size()}}});
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::optional<DracoGrid> grid_over_positions(double pitch) const {
    geom::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const Json& accessor : plain_["accessors"]) {
      if (!accessor.contains("min")) continue;
      for (int axis = 0; axis < 3; ++axis) {
        const auto place = static_cast<std::size_t>(axis);
        low[axis] = std::min(low[axis], accessor["min"][place].get<double>());
        high[axis] = std::max(high[axis], accessor["max"][place].get<double>());
      }
    }
    return draco_grid(low, high, pitch);
  }

  [[nodiscard]] std::string_view bytes_of(const Json& accessor, std::size_t element) const {
    const Json& view = plain_["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    return buffer_.substr(view["byteOffset"].get<std::size_t>() + accessor["byteOffset"].get<std::size_t>(),
                          accessor["count"].get<std::size_t>() * element);
  }

  [[nodiscard]] DracoAttribute attribute_of(const std::string& name, const Json& accessor) const {
    DracoAttribute attribute;
    attribute.use = use_of(name);
    const bool is_short = accessor["componentType"] == kUnsignedShort;
    attribute.number = is_short ? DracoNumber::UnsignedShort : DracoNumber::Float;
    attribute.components = components_of(accessor["type"]);
    attribute.normalized = accessor.value("normalized", false);
    attribute.bytes = bytes_of(accessor, attribute.components * (is_short ? sizeof(std::uint16_t) : sizeof(float)));
    return attribute;
  }

  [[nodiscard]] std::vector<std::uint32_t> corners_of(const Json& accessor) const {
    std::vector<std::uint32_t> corners(accessor["count"].get<std::size_t>());
    if (accessor["componentType"] == kUnsignedInt) {
      std::memcpy(corners.data(), bytes_of(accessor, sizeof(std::uint32_t)).data(),
                  corners.size() * sizeof(std::uint32_t));
      return corners;
    }
    std::vector<std::uint16_t> shorts(corners.size());
    std::memcpy(shorts.data(), bytes_of(accessor, sizeof(std::uint16_t)).data(), shorts.size() * sizeof(std::uint16_t));
    std::ranges::copy(shorts, corners.begin());
    return corners;
  }

  bool compress(Json& primitive) {
    std::vector<DracoAttribute> attributes;
    for (const auto& [name, accessor] : primitive["attributes"].items()) {
      attributes.push_back(attribute_of(name, plain_["accessors"][accessor.get<std::size_t>()]));
    }
    const std::vector<std::uint32_t> corners = corners_of(plain_["accessors"][primitive["indices"].get<std::size_t>()]);
    const DracoStream stream = draco_stream(attributes, corners, grid_);
    if (stream.bytes.empty()) return false;
    Json ids = Json::object();
    std::size_t place = 0;
    for (auto& [name, accessor] : primitive["attributes"].items()) {
      accessor =
          describe(plain_["accessors"][accessor.get<std::size_t>()], stream.vertices, attributes[place], corners);
      ids[name] = stream.id[place++];
    }
    primitive["indices"] = describe_indices(stream);
    primitive["extensions"][kDraco] = {{"bufferView", add_view(stream.bytes)}, {"attributes", std::move(ids)}};
    return true;
  }

  // An accessor without bytes: what it says holds of the decoded values.
  std::size_t describe(const Json& plain, std::uint32_t count, const DracoAttribute& attribute,
                       const std::vector<std::uint32_t>& corners) {
    Json accessor{{"componentType", plain["componentType"]}, {"count", count}, {"type", plain["type"]}};
    if (attribute.normalized) accessor["normalized"] = true;
    if (attribute.use == DracoUse::Position) add_bounds(accessor, attribute, corners);
    return add(std::move(accessor));
  }

  std::size_t describe_indices(const DracoStream& stream) {
    const bool is_short = stream.vertices < kShortIndices;
    return add({{"componentType", is_short ? kUnsignedShort : kUnsignedInt},
                {"count", std::size_t{stream.triangles} * 3},
                {"type", "SCALAR"}});
  }

  // Of the vertices that these triangles use: primitives of one mesh share theirs in the plain document.
  static void add_bounds(Json& accessor, const DracoAttribute& attribute, const std::vector<std::uint32_t>& corners) {
    geom::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const std::uint32_t corner : corners) {
      float place[3];
      std::memcpy(place, attribute.bytes.data() + std::size_t{corner} * sizeof(place), sizeof(place));
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], static_cast<double>(place[axis]));
        high[axis] = std::max(high[axis], static_cast<double>(place[axis]));
      }
    }
    accessor["min"] = triple_json(low);
    accessor["max"] = triple_json(high);
  }

  std::size_t add(Json accessor) {
    result_.json["accessors"].push_back(std::move(accessor));
    return result_.json["accessors"].size() - 1;
  }

  std::size_t add_view(std::string_view bytes) {
    result_.json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", result_.buffer.size()}, {"byteLength", bytes.size()}});
    result_.buffer += bytes;
    result_.buffer.resize((result_.buffer.size() + 3) / 4 * 4, '\0');
    return result_.json["bufferViews"].size() - 1;
  }

  void copy_images() {
    if (!result_.json.contains("images")) return;
    for (Json& image : result_.json["images"]) {
      if (!image.contains("bufferView")) continue;
      const Json& view = plain_["bufferViews"][image["bufferView"].get<std::size_t>()];
      image["bufferView"] =
          add_view(buffer_.substr(view["byteOffset"].get<std::size_t>(), view["byteLength"].get<std::size_t>()));
    }
  }

  void name_extension() {
    if (result_.json.contains("extensionsUsed"))
      std::erase(*result_.json["extensionsUsed"].get_ptr<Json::array_t*>(), Json(kManifold));
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) result_.json[list].push_back(kDraco);
  }

  const Json& plain_;
  std::string_view buffer_;
  std::optional<DracoGrid> grid_;
  DracoDocument result_;
};

}  // namespace

DracoDocument draco_document(const Json& plain, std::string_view buffer, double pitch) {
  return Compressor(plain, buffer, pitch).run();
}

}  // namespace rad::writers::gltf
