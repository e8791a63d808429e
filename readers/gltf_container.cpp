#include "readers/gltf_container.h"

#include <algorithm>
#include <array>

namespace rad::readers::gltf {

namespace {

constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

// Demanded extensions that either are read or leave the surfaces as they are.
constexpr std::array<std::string_view, 13> kHarmlessExtensions = {
    "KHR_draco_mesh_compression",
    "KHR_mesh_quantization",
    "EXT_mesh_gpu_instancing",
    "EXT_mesh_manifold",
    "KHR_texture_transform",
    "KHR_lights_punctual",
    "KHR_texture_basisu",
    "EXT_texture_webp",
    "EXT_texture_avif",
    "MSFT_texture_dds",
    "KHR_xmp_json_ld",
    "EXT_lights_image_based",
    "EXT_lights_ies",
};
constexpr std::string_view kMaterialPrefix = "KHR_materials_";

struct Chunks {
  std::string_view json;
  std::size_t json_offset = 0;
  std::optional<std::string_view> binary;
};

void add_fault(scene::ReadIssues& issues, std::string what, std::uint64_t byte_offset) {
  scene::ReadIssue issue;
  issue.kind = scene::ReadIssueKind::ParseError;
  issue.what = std::move(what);
  issue.place.byte_offset = byte_offset;
  issues.add(std::move(issue));
}

std::uint32_t little_endian(std::string_view bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[offset + i]);
  return value;
}

struct Chunk {
  std::uint32_t type = 0;
  std::string_view bytes;
  bool complete = false;
};

std::optional<Chunk> chunk_at(std::string_view bytes, std::size_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < kChunkHeaderBytes) return std::nullopt;
  const std::uint32_t length = little_endian(bytes, offset);
  const std::string_view rest = bytes.substr(offset + kChunkHeaderBytes);
  return Chunk{little_endian(bytes, offset + 4), rest.substr(0, length), length <= rest.size()};
}

// Walks over the chunks after the JSON one; the first BIN chunk is the one that buffer 0 may mean.
void find_binary_chunk(std::string_view bytes, std::size_t offset, Chunks& chunks, scene::ReadIssues& issues) {
  while (const auto chunk = chunk_at(bytes, offset)) {
    if (!chunk->complete) add_fault(issues, "the file ends within a chunk of the GLB", bytes.size());
    if (chunk->type == kBinaryChunk) {
      chunks.binary = chunk->bytes;
      return;
    }
    offset += kChunkHeaderBytes + chunk->bytes.size();
  }
  if (offset < bytes.size()) add_fault(issues, "the file ends within a chunk header of the GLB", offset);
}

std::optional<Chunks> split_binary(std::string_view bytes, scene::ReadIssues& issues) {
  if (bytes.size() < kHeaderBytes) {
    add_fault(issues, "the file ends within the GLB header", bytes.size());
    return std::nullopt;
  }
  const std::uint32_t version = little_endian(bytes, 4);
  if (version != 2) {
    add_fault(issues, "GLB version " + std::to_string(version) + " is not read, only version 2", 4);
    return std::nullopt;
  }
  const std::uint32_t length = little_endian(bytes, 8);
  const auto chunk = chunk_at(bytes, kHeaderBytes);
  if (!chunk || chunk->type != kJsonChunk || !chunk->complete) {
    add_fault(issues, "the GLB has no complete JSON chunk", kHeaderBytes);
    return std::nullopt;
  }
  Chunks chunks{chunk->bytes, kHeaderBytes + kChunkHeaderBytes, std::nullopt};
  if (length < chunks.json_offset + chunks.json.size() || length > bytes.size()) {
    add_fault(
        issues,
        "the GLB header states " + std::to_string(length) + " bytes, the file holds " + std::to_string(bytes.size()),
        8);
  } else {
    bytes = bytes.substr(0, length);
  }
  find_binary_chunk(bytes, chunks.json_offset + chunks.json.size(), chunks, issues);
  return chunks;
}

// What has the wrong type is taken out, so that it is reported once, however often it is asked for.
void drop_lists_of_wrong_type(Json& json, scene::ReadIssues& issues) {
  for (const char* key : {"accessors", "animations", "bufferViews", "buffers", "cameras", "extensionsRequired",
                          "materials", "meshes", "nodes", "scenes", "skins"}) {
    const auto found = json.find(key);
    if (found == json.end() || found->is_array()) continue;
    add_parse_error(issues, "\"" + std::string(key) + "\" is not an array", "/" + std::string(key));
    json.erase(found);
  }
}

bool is_version_two(const JsonView& asset, std::string_view key) { return asset.text(key).substr(0, 2) == "2."; }

bool check_version(const JsonView& root, scene::ReadIssues& issues) {
  const JsonView asset = root.object("asset");
  if (!asset || !asset.has("version")) {
    add_parse_error(issues, "asset.version is missing; read as glTF 2.0", "/asset");
    return true;
  }
  const bool has_minimum = asset.has("minVersion");
  if (has_minimum ? asset.text("minVersion") == "2.0" : is_version_two(asset, "version")) return true;
  const std::string_view key = has_minimum ? "minVersion" : "version";
  add_parse_error(issues, "glTF version \"" + asset.text(key) + "\" is not read, only 2.0",
                  "/asset/" + std::string(key));
  return false;
}

bool check_required_extensions(const JsonView& root, scene::ReadIssues& issues) {
  const std::vector<std::string> names = root.texts("extensionsRequired");
  for (const std::string& name : names) {
    const bool known =
        std::find(kHarmlessExtensions.begin(), kHarmlessExtensions.end(), name) != kHarmlessExtensions.end() ||
        name.starts_with(kMaterialPrefix);
    if (known) continue;
    add_parse_error(issues, "the file requires the extension " + name + ", which is not read; nothing was read",
                    "/extensionsRequired");
    return false;
  }
  return true;
}

}  // namespace

std::optional<Document> open_document(const Input& input, scene::ReadIssues& issues) {
  std::optional<Chunks> chunks;
  if (input.bytes.starts_with(kGlbMagic)) {
    chunks = split_binary(input.bytes, issues);
  } else {
    chunks = Chunks{input.bytes, 0, std::nullopt};
  }
  if (!chunks) return std::nullopt;
  auto json = parse_json_object(chunks->json, chunks->json_offset, "glTF", issues);
  if (!json) return std::nullopt;
  Document document{input, issues, std::move(*json), chunks->binary};
  drop_lists_of_wrong_type(document.json, issues);
  if (!check_version(document.root(), issues)) return std::nullopt;
  if (!check_required_extensions(document.root(), issues)) return std::nullopt;
  return document;
}

}  // namespace rad::readers::gltf
