// Caps for hostile files: a count is checked against these and against the bytes that back it before memory is taken.
#pragma once

#include <cstdint>

namespace rad::readers {

struct Limits {
  std::uint64_t file_bytes = 4ull << 30;
  std::uint64_t vertices = 200'000'000;
  std::uint64_t faces = 200'000'000;
  std::uint64_t corners = 800'000'000;
  std::uint64_t face_corners = 1'000'000;  ///< of one face
  std::uint64_t line_bytes = 64ull << 20;  ///< of one logical line of a text format
  std::uint64_t node_depth = 256;          ///< of a scene graph
  std::uint64_t instances = 1'000'000;     ///< of meshes by scene graph nodes
};

}  // namespace rad::readers
