// The one buffer of a written glTF document: five buffer views, one for each kind of data.
#pragma once

#include <array>
#include <string>

#include "writers/gltf_materials.h"

namespace rad::writers::gltf {

enum class Kind : std::uint8_t { Position, Colour, Radiosity, ShortIndex, LongIndex };
inline constexpr std::size_t kKinds = 5;

/// Collects elements and the accessors to them; gives the views without gaps of unused kinds.
class BufferBuilder {
 public:
  /// Where elements of a kind are appended.
  std::string& bytes_of(Kind kind) { return bytes_[static_cast<std::size_t>(kind)]; }

  /// An accessor to the last `count` elements of a kind, with further members. Returns its index.
  std::size_t add_accessor(Kind kind, std::size_t count, Json members = Json::object());

  /// The bytes of all kinds, each aligned to 4 bytes.
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

  std::array<std::string, kKinds> bytes_;
  std::vector<Accessor> accessors_;
};

}  // namespace rad::writers::gltf
