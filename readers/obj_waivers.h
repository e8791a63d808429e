// Which lines of an OBJ file its comments to radlint speak of.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "scene/waiver.h"

namespace rad::readers {

/// A comment on a line of its own speaks of the next `f`, `g` or `o`: that face, or all faces up to the next `g` or `o`
/// (of an `o`: the next `o`). One behind a face speaks of that face.
class ObjWaivers {
 public:
  enum class Block : std::uint8_t { Group, Object };

  void read_comment(std::string_view comment, std::uint64_t line);
  void read_comment_behind_face(std::string_view comment, std::uint64_t line);
  void face(std::uint64_t line) {
    if (!waiting_.empty()) cover_face(line);
  }
  void block(Block block, std::uint64_t line);

  /// All of the file, which has ended.
  std::vector<scene::Waiver> take();

 private:
  struct Open {
    std::size_t waiver = 0;
    Block block = Block::Group;
  };

  void cover_face(std::uint64_t line);

  std::vector<scene::Waiver> waivers_;
  std::vector<std::size_t> waiting_;  ///< that do not know yet what they speak of
  std::vector<Open> open_;            ///< whose end is not reached
};

}  // namespace rad::readers
