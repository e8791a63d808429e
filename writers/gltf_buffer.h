// The one buffer of a written glTF document: a buffer view for each kind of data, then one for each embedded image.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "writers/gltf_materials.h"

namespace rad::writers::gltf {

enum class Kind : std::uint8_t { Position, Normal, Texture, Colour, Radiosity, ShortIndex, LongIndex };
inline constexpr std::size_t kKinds = 7;

/// Collects elements and the accessors to them; gives the views without gaps of unused kinds.
class BufferBuilder {
 public:
  /// Where elements of a kind are appended.
  std::string& bytes_of(Kind kind) { return bytes_[static_cast<std::size_t>(kind)]; }

  /// An accessor to the last `count` elements of a kind, with further members. Returns its index.
  std::size_t add_accessor(Kind kind, std::size_t count, Json members = Json::object());

  /// Adds a block of bytes with a view of its own; elements must all be there. `bytes` must outlive the builder.
  /// Returns the index of the view.
  std::size_t add_block(std::string_view bytes);

  /// The bytes of all kinds and blocks, each aligned to 4 bytes.
  [[nodiscard]] std::string buffer() const;
  [[nodiscard]] Json views() const;
  [[nodiscard]] Json accessors() const;

 private:
  struct Accessor {
    Kind kind;
    std::size_t offset;
    std::size_t count;
    Json members;
  };

  [[nodiscard]] std::size_t used_kinds() const;

  std::array<std::string, kKinds> bytes_;
  std::vector<std::string_view> blocks_;
  std::vector<Accessor> accessors_;
};

}  // namespace rad::writers::gltf
