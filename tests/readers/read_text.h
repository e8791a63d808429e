// A model given as text in a test, read as a file of some name would be.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "readers/reader.h"

namespace rad::tests {

inline readers::ReadResult read_text(std::string_view text, const std::string& name,
                                     const std::filesystem::path& directory = "no-such-folder",
                                     const readers::Limits& limits = {}) {
  return readers::read_bytes({name, directory, text, limits});
}

inline std::size_t issue_count(const readers::ReadResult& result, scene::ReadIssueKind kind) {
  return static_cast<std::size_t>(
      std::ranges::count_if(result.issues.all(), [&](const auto& issue) { return issue.kind == kind; }));
}

/// "line 3: what" or "byte 84: what" of every issue, one a line.
inline std::string issue_text(const readers::ReadResult& result) {
  std::string text;
  for (const scene::ReadIssue& issue : result.issues.all()) {
    const std::string place = issue.place.byte_offset ? "byte " + std::to_string(*issue.place.byte_offset)
                                                      : "line " + std::to_string(issue.place.line);
    text += place + ": " + issue.what + "\n";
  }
  return text;
}

/// The vertices of a face's outer loop.
inline std::vector<scene::VertexId> outer_loop(const scene::Scene& scene, scene::FaceId face) {
  const auto corners = scene.corners_of(scene.loops[scene.faces[face].first_loop]);
  return {corners.begin(), corners.end()};
}

}  // namespace rad::tests
