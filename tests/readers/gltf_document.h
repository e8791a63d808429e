// Builds small glTF documents for the tests of the reader.
#pragma once

#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "readers/reader.h"

namespace rad::readers {
extern const Reader gltf_reader;
}

namespace rad::tests {

using Json = nlohmann::json;

inline std::string base64(std::string_view bytes) {
  static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::string_view group = bytes.substr(i, 3);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < group.size() ? static_cast<unsigned char>(group[k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) text += k <= group.size() ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// A document with one buffer that grows as accessors are added.
struct GltfDocument {
  Json json = {{"asset", {{"version", "2.0"}}}};
  std::string bytes;

  /// Appends packed values as a buffer view of their own.
  template <typename Value>
  std::size_t add_view(const std::vector<Value>& values) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", values.size() * sizeof(Value)}});
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
    return json["bufferViews"].size() - 1;
  }

  template <typename Value>
  std::size_t add_accessor(const std::vector<Value>& values, int component_type, const char* type, std::size_t count) {
    const std::size_t view = add_view(values);
    json["accessors"].push_back(
        {{"bufferView", view}, {"componentType", component_type}, {"type", type}, {"count", count}});
    return json["accessors"].size() - 1;
  }

  std::size_t add_positions(const std::vector<float>& coordinates) {
    return add_accessor(coordinates, 5126, "VEC3", coordinates.size() / 3);
  }

  std::size_t add_indices(const std::vector<std::uint16_t>& indices) {
    return add_accessor(indices, 5123, "SCALAR", indices.size());
  }

  /// A mesh of one primitive; the primitive is returned for more to be set on it.
  Json& add_mesh(Json primitive) {
    json["meshes"].push_back({{"primitives", Json::array({std::move(primitive)})}});
    return json["meshes"].back()["primitives"][0];
  }

  /// The document as text, its bytes in a data URI.
  [[nodiscard]] std::string text() const {
    Json complete = json;
    if (!bytes.empty()) {
      complete["buffers"] = Json::array(
          {{{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}});
    }
    return complete.dump();
  }

  [[nodiscard]] std::string glb() const {
    Json complete = json;
    if (!bytes.empty()) complete["buffers"] = Json::array({{{"byteLength", bytes.size()}}});
    std::string text = complete.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string binary = bytes;
    binary.resize((binary.size() + 3) / 4 * 4);
    return "glTF" + word(2) + word(28 + text.size() + binary.size()) + word(text.size()) + "JSON" + text +
           word(binary.size()) + std::string("BIN\0", 4) + binary;
  }

  static std::string word(std::size_t value) {
    const auto little = static_cast<std::uint32_t>(value);
    return std::string(reinterpret_cast<const char*>(&little), sizeof little);
  }
};

/// A right-angled triangle in the plane z = 0, without indices.
inline GltfDocument one_triangle() {
  GltfDocument document;
  document.add_mesh({{"attributes", {{"POSITION", document.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}});
  return document;
}

inline readers::ReadResult read_gltf(std::string_view bytes, const readers::Limits& limits = {}) {
  return readers::gltf_reader.read({"model.gltf", "no-such-folder", bytes, limits});
}

inline readers::ReadResult read_gltf(const GltfDocument& document) { return read_gltf(document.text()); }

/// The issues of one kind, as "what @pointer".
inline std::vector<std::string> issues_of(const readers::ReadResult& result, scene::ReadIssueKind kind) {
  std::vector<std::string> texts;
  for (const scene::ReadIssue& issue : result.issues.all()) {
    if (issue.kind == kind) texts.push_back(issue.what + " @" + issue.place.pointer);
  }
  return texts;
}

inline std::vector<scene::dvec3> corners_of(const scene::Scene& scene, std::size_t face) {
  std::vector<scene::dvec3> corners;
  for (const scene::VertexId id : scene.corners_of(scene.loops_of(scene.faces[face])[0])) {
    corners.push_back(scene.vertices[id]);
  }
  return corners;
}

}  // namespace rad::tests
