#include "readers/gltf_buffers.h"

#include <algorithm>

#include "readers/companion_path.h"
#include "readers/gltf_uri.h"

namespace rad::readers::gltf {

namespace {

constexpr std::size_t kShownUriLength = 80;

// Cut between characters: a continuation byte of UTF-8 never ends up alone.
std::string shown(std::string_view uri) {
  if (uri.size() <= kShownUriLength) return "\"" + std::string(uri) + "\"";
  std::size_t length = kShownUriLength;
  while (length > 0 && (static_cast<unsigned char>(uri[length]) & 0xc0u) == 0x80u) --length;
  return "\"" + std::string(uri.substr(0, length)) + "…\"";
}

}  // namespace

Buffers::Buffers(const Document& document) : document_(document), backing_bytes_(document.input.bytes.size()) {
  const JsonView root = document.root();
  // Made once at full length: `bytes` points into its own Buffer, which must not move.
  buffers_ = std::vector<Buffer>(root.length("buffers"));
  for (std::size_t i = 0; i < buffers_.size(); ++i) {
    if (const JsonView json = root.item("buffers", i)) load(json, buffers_[i], i == 0);
  }
}

void Buffers::load(const JsonView& json, Buffer& buffer, bool may_be_binary_chunk) {
  if (!json.has("uri")) {
    // Without the chunk the buffer may be one that an extension fills: only its use is a fault.
    if (!may_be_binary_chunk || !document_.binary) return;
    buffer.bytes = *document_.binary;
  } else {
    const std::string uri = json.text("uri");
    if (!(is_data_uri(uri) ? load_data(json, uri, buffer) : load_companion(json, uri, buffer))) return;
    backing_bytes_ += buffer.bytes.size();
  }
  buffer.loaded = true;
  const std::uint64_t stated = json.whole("byteLength").value_or(buffer.bytes.size());
  if (stated > buffer.bytes.size()) {
    add_parse_error(
        document_.issues,
        "the buffer states " + std::to_string(stated) + " bytes, " + std::to_string(buffer.bytes.size()) + " are there",
        json.pointer());
  }
  buffer.bytes = buffer.bytes.substr(0, stated);
}

void Buffers::add_missing(std::string what, const std::string& pointer) const {
  scene::ReadIssue issue;
  issue.kind = scene::ReadIssueKind::MissingResource;
  issue.what = std::move(what);
  issue.place.pointer = pointer;
  document_.issues.add(std::move(issue));
}

bool Buffers::load_data(const JsonView& json, const std::string& uri, Buffer& buffer) const {
  auto decoded = data_uri_bytes(uri);
  if (!decoded) {
    add_parse_error(document_.issues, "the data URI is not sound Base64", json.pointer() + "/uri");
    return false;
  }
  buffer.decoded = std::move(*decoded);
  buffer.bytes = buffer.decoded;
  return true;
}

bool Buffers::load_companion(const JsonView& json, const std::string& uri, Buffer& buffer) const {
  const std::string pointer = json.pointer() + "/uri";
  const auto name = percent_decoded(uri);
  const auto path = name ? companion_path(document_.input.directory, *name) : std::nullopt;
  if (!path) {
    add_missing("buffer " + shown(uri) + " is not a file in the model's folder", pointer);
    return false;
  }
  if (document_.input.companions != nullptr) document_.input.companions->push_back(*path);
  const std::uint64_t limit = document_.input.limits.file_bytes;
  const std::uint64_t left = limit - std::min(limit, backing_bytes_);
  const std::string fault = buffer.companion.open(*path, left, FileKind::Regular);
  if (!fault.empty()) {
    add_missing("buffer file " + shown(uri) + " cannot be opened: " + fault, pointer);
    return false;
  }
  buffer.bytes = buffer.companion.bytes();
  return true;
}

void Buffers::report_without_bytes(std::uint64_t index) const {
  const JsonView buffer = document_.root().item("buffers", index);
  if (!buffer || buffer.has("uri")) return;
  add_parse_error(document_.issues, "the buffer has no bytes: neither a uri nor a BIN chunk", buffer.pointer());
}

std::optional<std::string_view> Buffers::view(std::uint64_t index) const {
  const JsonView json = document_.root().item("bufferViews", index);
  if (!json) return std::nullopt;
  const auto buffer = json.whole("buffer");
  const auto length = json.whole("byteLength");
  if (!buffer || *buffer >= buffers_.size() || !length) {
    add_parse_error(document_.issues, "the buffer view names no buffer that exists, or no length", json.pointer());
    return std::nullopt;
  }
  if (!buffers_[*buffer].loaded) {
    report_without_bytes(*buffer);
    return std::nullopt;
  }
  const std::string_view bytes = buffers_[*buffer].bytes;
  const std::uint64_t offset = json.whole("byteOffset").value_or(0);
  if (offset <= bytes.size() && *length <= bytes.size() - offset) return bytes.substr(offset, *length);
  add_parse_error(document_.issues,
                  "the buffer view reaches beyond its buffer of " + std::to_string(bytes.size()) + " bytes",
                  json.pointer());
  return std::nullopt;
}

}  // namespace rad::readers::gltf
