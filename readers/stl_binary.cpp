#include "readers/stl_binary.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <utility>

#include "readers/binary_number.h"
#include "readers/refusals.h"
#include "scene/scene_builder.h"

namespace rad::readers {
namespace {

constexpr std::uint64_t kNormalBytes = 12;

float float_at(const char* bytes) { return binary_number<float, std::endian::little>(bytes); }

void add_facet(scene::SceneBuilder& builder, const char* facet, std::uint64_t offset) {
  std::array<scene::VertexId, 3> corners{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint64_t place = kNormalBytes * (i + 1);
    const char* const vertex = facet + place;
    corners[i] = builder.add_vertex({float_at(vertex), float_at(vertex + 4), float_at(vertex + 8)}, offset + place);
  }
  builder.add_face(corners, offset);
}

void add_facets(const Input& input, std::uint64_t count, scene::SceneBuilder& builder, scene::ReadIssues& issues) {
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t offset = kStlHeaderBytes + i * kStlFacetBytes;
    std::string full = limit_before_face(builder.scene(), 3, input.limits);
    if (full.empty()) full = limit_before_vertices(builder.scene(), 3, input.limits);
    if (!full.empty()) {
      issues.add(issue_at_byte(scene::ReadIssueKind::ParseError, std::move(full), offset));
      return;
    }
    add_facet(builder, input.bytes.data() + offset, offset);
  }
}

// What is wrong with the length of the file, given how many facets it states and how many follow.
void judge_length(const Input& input, std::uint64_t stated, std::uint64_t present, scene::ReadIssues& issues) {
  if (stated > present) {
    issues.add(issue_at_byte(
        scene::ReadIssueKind::ParseError,
        "the file ends after " + std::to_string(present) + " whole facets, its header states " + std::to_string(stated),
        input.bytes.size()));
  } else if (stated < present) {
    issues.add(issue_at_byte(scene::ReadIssueKind::ParseError,
                             "the header states " + std::to_string(stated) + " facets, " +
                                 std::to_string((present - stated) * kStlFacetBytes) +
                                 " bytes or more follow them and are left out",
                             kStlHeaderBytes + stated * kStlFacetBytes));
  }
}

}  // namespace

std::uint64_t stated_stl_facets(std::string_view bytes) {
  return binary_number<std::uint32_t, std::endian::little>(bytes.data() + kStlHeaderBytes - sizeof(std::uint32_t));
}

ReadResult read_binary_stl(const Input& input) {
  scene::SceneBuilder builder(input.path, "stl");
  builder.add_section({input.path, {}, scene::RecordKind::ByteOffset});
  ReadResult result;
  if (input.bytes.size() < kStlHeaderBytes) {
    result.issues.add(issue_at_byte(scene::ReadIssueKind::ParseError, "the file ends within the header of a binary STL",
                                    input.bytes.size()));
  } else {
    const std::uint64_t stated = stated_stl_facets(input.bytes);
    const std::uint64_t present = (input.bytes.size() - kStlHeaderBytes) / kStlFacetBytes;
    judge_length(input, stated, present, result.issues);
    add_facets(input, std::min(stated, present), builder, result.issues);
  }
  result.scene = builder.take();
  return result;
}

}  // namespace rad::readers
