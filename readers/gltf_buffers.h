// The buffers of a glTF document: the BIN chunk, bytes written into the JSON, and companion files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "readers/file_bytes.h"
#include "readers/gltf_container.h"

namespace rad::readers::gltf {

/// Holds the bytes of every buffer. Loads all of them when made, so that a missing companion is reported even where
/// no surface needs it; together they stay below Limits::file_bytes.
class Buffers {
 public:
  explicit Buffers(const Document& document);

  /// The bytes of a buffer view. Nothing, with a ParseError, where the view does not exist or reaches beyond its
  /// buffer; nothing without a further issue where the buffer itself could not be loaded.
  [[nodiscard]] std::optional<std::string_view> view(std::uint64_t index) const;

  /// Bytes of the file and of all buffers: no count without bytes of its own can soundly exceed it.
  [[nodiscard]] std::uint64_t backing_bytes() const { return backing_bytes_; }

 private:
  struct Buffer {
    std::string decoded;  ///< of a data URI
    FileBytes companion;
    std::string_view bytes;
    bool loaded = false;
  };

  void load(const JsonView& json, Buffer& buffer, bool may_be_binary_chunk);
  [[nodiscard]] bool load_data(const JsonView& json, const std::string& uri, Buffer& buffer) const;
  [[nodiscard]] bool load_companion(const JsonView& json, const std::string& uri, Buffer& buffer) const;
  void report_without_bytes(std::uint64_t index) const;
  void add_missing(std::string what, const std::string& pointer) const;

  const Document& document_;
  std::vector<Buffer> buffers_;
  std::uint64_t backing_bytes_ = 0;
};

}  // namespace rad::readers::gltf
