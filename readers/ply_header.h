// The header of a PLY file: which elements follow, with which properties, in which encoding.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "readers/head_comments.h"
#include "readers/limits.h"
#include "readers/text_cursor.h"
#include "scene/read_issue.h"
#include "scene/scene.h"
#include "scene/waiver.h"

namespace rad::readers {

enum class PlyType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };
enum class PlyEncoding : std::uint8_t { Text, LittleEndian, BigEndian };

/// Bytes of one value in a binary body.
std::uint64_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;
  std::optional<PlyType> count_type;  ///< of a list; an integer type
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  std::uint64_t line = 0;  ///< of its declaration

  [[nodiscard]] const PlyProperty* property(std::string_view name) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Text;
  std::vector<PlyElement> elements;
  TextCursor end;                 ///< at the end of the header's last line
  std::uint64_t body_offset = 0;  ///< first byte of a binary body
  HeadComments comments;
  std::vector<scene::Waiver> waivers;
};

/// Reads the header. Nothing, with a ParseError, where it is not sound.
std::optional<PlyHeader> read_ply_header(std::string_view bytes, const Limits& limits, scene::ReadIssues& issues);

}  // namespace rad::readers
