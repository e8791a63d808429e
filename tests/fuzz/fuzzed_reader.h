// What every fuzz target of a reader does with its bytes.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>

#include "readers/reader.h"
#include "tests/support/scene_invariants.h"

namespace rad::tests {

/// Limits that a small input can reach.
inline readers::Limits fuzzed_limits() {
  readers::Limits limits;
  limits.vertices = 1'000'000;
  limits.faces = 1'000'000;
  limits.corners = 1'000'000;
  limits.face_corners = 1'000;
  limits.line_bytes = 1'000;
  // Of blocks and files that are placed again and again.
  limits.file_bytes = 1'000'000;
  limits.instances = 1'000;
  return limits;
}

/// Reads the bytes; stops the program where the scene is not sound or an issue says nothing.
inline void read_fuzzed(const readers::Reader& reader, const std::uint8_t* data, std::size_t size) {
  readers::Input input;
  input.path = "fuzzed." + std::string(reader.format);
  // No companion can be found in a folder that does not exist.
  input.directory = "no-such-folder";
  input.bytes = {reinterpret_cast<const char*>(data), size};
  input.limits = fuzzed_limits();
  const readers::ReadResult result = reader.read(input);
  if (!broken_invariant(result.scene).empty()) std::abort();
  for (const scene::ReadIssue& issue : result.issues.all()) {
    if (issue.what.empty() || issue.count == 0) std::abort();
  }
}

}  // namespace rad::tests
