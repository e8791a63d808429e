// What a reader says of records that it cannot take, and of limits that it keeps.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "readers/limits.h"
#include "scene/read_issue.h"
#include "scene/scene.h"

namespace rad::readers {

inline scene::ReadIssue issue_at_line(scene::ReadIssueKind kind, std::string what, std::uint64_t line) {
  scene::IssuePlace place;
  place.line = line;
  return {kind, std::move(what), std::move(place), 1};
}

inline scene::ReadIssue issue_at_byte(scene::ReadIssueKind kind, std::string what, std::uint64_t offset) {
  scene::IssuePlace place;
  place.byte_offset = offset;
  return {kind, std::move(what), std::move(place), 1};
}

/// Which limit a scene would pass by so many more vertices; empty while there is room.
inline std::string limit_before_vertices(const scene::Scene& scene, std::uint64_t count, const Limits& limits) {
  if (scene.vertices.size() + count <= limits.vertices) return {};
  return "the limit of " + std::to_string(limits.vertices) + " vertices is reached; the rest is left out";
}

/// The same for one more face of so many corners.
inline std::string limit_before_face(const scene::Scene& scene, std::uint64_t corners, const Limits& limits) {
  if (scene.faces.size() >= limits.faces) {
    return "the limit of " + std::to_string(limits.faces) + " faces is reached; the rest is left out";
  }
  if (scene.corners.size() + corners > limits.corners) {
    return "the limit of " + std::to_string(limits.corners) + " face corners is reached; the rest is left out";
  }
  return {};
}

/// "vertex index 9 exceeds the 8 vertices of the file".
inline std::string index_beyond(std::int64_t index, std::size_t vertices) {
  return "vertex index " + std::to_string(index) + " exceeds the " + std::to_string(vertices) + " vertices of the file";
}

/// The same for formats that count vertices from 0.
inline std::string index_outside(std::int64_t index, std::size_t vertices) {
  if (index < 0) return "vertex index " + std::to_string(index) + " is negative";
  return "vertex index " + std::to_string(index) + " is outside the " + std::to_string(vertices) +
         " vertices, which count from 0";
}

}  // namespace rad::readers
