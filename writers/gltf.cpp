#include "writers/gltf.h"

#include <limits>
#include <set>

#include "writers/gltf_draco.h"
#include "writers/gltf_light_map.h"
#include "writers/gltf_meshes.h"
#include "writers/gltf_textures.h"
#include "writers/gltf_uri.h"
#include "writers/head_comments.h"
#include "writers/little_endian.h"
#include "writers/whole_file.h"

namespace rad::writers {
namespace gltf {
namespace {

constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr std::size_t kGlbHeaderBytes = 12, kChunkHeaderBytes = 8;

struct Document {
  std::string problem;
  Json json;  ///< but for the URI of its buffer
  std::string buffer;
};

// The radiosity (W/m², by luminance) that each colour of the scale stands for.
Json scale_json(double exposure) {
  Json scale = Json::array();
  const std::size_t last = scene::false_colours().size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(last);
    scale.push_back({{"radiosity", share / exposure}, {"colour", triple_json(scene::false_colour(share))}});
  }
  return scale;
}

Json asset_json(const Output& output) {
  Json record = Json::object();
  if (output.lattice) {
    record["tolerance"] = output.lattice->tolerance;
    record["pitch"] = output.lattice->lattice.pitch;
    record["origin"] = triple_json(output.lattice->lattice.origin);
  }
  const scene::LightMap* const map = output.light_map;
  if (output.light != nullptr) {
    record["exposure"] = output.light->exposure;
    record["clampedShare"] = map != nullptr ? map->clamped_share : output.light->clamped_share;
    record["curve"] = scene::name(output.light->curve);
    if (output.light->curve == scene::DisplayCurve::FalseColour) record["scale"] = scale_json(output.light->exposure);
    if (map != nullptr) record["bake"] = map->look == scene::LightMapLook::Unlit ? "lightmap" : "emissive";
  }
  if (output.marked_incomplete) record["incomplete"] = true;
  for (const std::string& comment : output.comments) record["comments"].push_back(comment);
  for (const LegendEntry& entry : output.legend) {
    record["legend"].push_back(
        {{"name", entry.name}, {"meaning", entry.meaning}, {"colour", triple_json(entry.colour)}});
  }
  Json asset{{"version", "2.0"}, {"generator", program_name()}};
  if (!record.empty()) asset["extras"]["radfix"] = std::move(record);
  return asset;
}

// The nodes of the meshes, below a root that holds the translation where there is one.
void set_nodes(Json& json, const Meshes& meshes, const scene::Scene& scene, const geom::dvec3& origin) {
  const bool has_root = origin != geom::dvec3(0.0);
  Json nodes = Json::array(), of_meshes = Json::array();
  if (has_root) nodes.push_back({{"translation", triple_json(origin)}});
  for (std::size_t mesh = 0; mesh < meshes.objects.size(); ++mesh) {
    Json node{{"mesh", mesh}};
    const std::string& name = scene.objects[meshes.objects[mesh]];
    if (!name.empty()) node["name"] = name;
    of_meshes.push_back(nodes.size());
    nodes.push_back(std::move(node));
  }
  if (has_root) nodes[0]["children"] = of_meshes;
  json["scene"] = 0;
  json["scenes"] = Json::array({{{"nodes", has_root ? Json::array({0}) : of_meshes}}});
  json["nodes"] = std::move(nodes);
}

// Names of extensions anywhere in a part of the document.
void gather_extensions(const Json& json, std::set<std::string>& names) {
  if (!json.is_structured()) return;
  for (const auto& [key, value] : json.items()) {
    if (key == "extensions") {
      for (const auto& extension : value.items()) names.insert(extension.key());
    } else if (key != "extras") {
      gather_extensions(value, names);
    }
  }
}

void set_materials(Json& json, Meshes& meshes, const Output& output) {
  TextureTable textures;
  json["materials"] = Json::array();
  for (std::size_t i = 0; i < meshes.materials.size(); ++i) {
    const auto& [use, shows_texture] = meshes.materials[i];
    const scene::Material& material = output.scene.materials[use.material];
    if (output.light_map != nullptr) {
      Json reference = textures.reference(light_map_texture(*output.light_map, use.page));
      json["materials"].push_back(light_map_material_json(material, output.light_map->look, use.page,
                                                          use.white_luminance, std::move(reference)));
      continue;
    }
    Json reference = shows_texture ? textures.reference(*material.texture) : Json(nullptr);
    json["materials"].push_back(material_json(material, output.light != nullptr, std::move(reference)));
  }
  textures.write(json, meshes.buffer);
  std::set<std::string> extensions;
  gather_extensions(json["materials"], extensions);
  gather_extensions(json["meshes"], extensions);
  if (json.contains("textures")) gather_extensions(json["textures"], extensions);
  if (!extensions.empty()) json["extensionsUsed"] = extensions;
}

Document document_of(const Output& output) {
  if (std::string problem = problem_of(output); !problem.empty()) return {std::move(problem), {}, {}};
  const Frame frame = frame_of(output);
  Meshes meshes = build_meshes(output, frame);
  if (!meshes.problem.empty()) return {std::move(meshes.problem), {}, {}};
  Document document;
  Json& json = document.json;
  json["asset"] = asset_json(output);
  set_nodes(json, meshes, output.scene, frame.origin);
  json["meshes"] = std::move(meshes.meshes);
  set_materials(json, meshes, output);
  json["accessors"] = meshes.buffer.accessors();
  json["bufferViews"] = meshes.buffer.views();
  document.buffer = meshes.buffer.buffer();
  json["buffers"] = Json::array({{{"byteLength", document.buffer.size()}}});
  return document;
}

// Bytes that are not UTF-8 become U+FFFD.
std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

void append_chunk(std::string& bytes, std::uint32_t type, std::string_view content, char filler) {
  const std::size_t padding = (4 - content.size() % 4) % 4;
  append_bytes(bytes, static_cast<std::uint32_t>(content.size() + padding));
  append_bytes(bytes, type);
  bytes.append(content);
  bytes.append(padding, filler);
}

WriteResult write_as_glb(const Json& json, std::string_view buffer, const std::filesystem::path& path) {
  std::string chunks;
  append_chunk(chunks, kJsonChunk, text_of(json), ' ');
  if (buffer.size() + chunks.size() + kGlbHeaderBytes + kChunkHeaderBytes > std::numeric_limits<std::uint32_t>::max()) {
    return {"a GLB holds less than 4 GiB; write .gltf"};
  }
  append_chunk(chunks, kBinaryChunk, buffer, '\0');
  std::string bytes = "glTF";
  append_bytes(bytes, std::uint32_t{2});
  append_bytes(bytes, static_cast<std::uint32_t>(kGlbHeaderBytes + chunks.size()));
  return {write_whole_file(path, bytes + chunks)};
}

}  // namespace
}  // namespace gltf

WriteResult write_glb(const Output& output, const std::filesystem::path& path) {
  const gltf::Document document = gltf::document_of(output);
  return document.problem.empty() ? gltf::write_as_glb(document.json, document.buffer, path)
                                  : WriteResult{document.problem};
}

WriteResult write_draco_glb(const Output& output, const std::filesystem::path& path) {
  const gltf::Document plain = gltf::document_of(output);
  if (!plain.problem.empty()) return {plain.problem};
  const double pitch = output.lattice ? output.lattice->lattice.pitch : 0;
  const gltf::DracoDocument document = gltf::draco_document(plain.json, plain.buffer, pitch);
  return document.problem.empty() ? gltf::write_as_glb(document.json, document.buffer, path)
                                  : WriteResult{document.problem};
}

WriteResult write_gltf(const Output& output, const std::filesystem::path& path) {
  gltf::Document document = gltf::document_of(output);
  if (!document.problem.empty()) return {document.problem};
  std::filesystem::path buffer_path = path;
  buffer_path.replace_extension(".bin");
  document.json["buffers"][0]["uri"] = gltf::uri_of_name(buffer_path.filename().string());
  const std::string text = gltf::text_of(document.json);
  return {write_whole_files(std::array<WholeFile, 2>{{{buffer_path, document.buffer}, {path, text}}})};
}

}  // namespace rad::writers
