// The body of a PLY file as a run of values, the same for text and for both binary encodings.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "readers/binary_number.h"
#include "readers/ply_header.h"
#include "scene/read_issue.h"

namespace rad::readers {

/// Good: a value was read. Bad: something else stands in its place and was stepped over. Ended: the record (text) or
/// the file (binary) ends here.
enum class PlyValue : std::uint8_t { Good, Bad, Ended };

/// Records are lines that hold more than blanks.
class PlyText {
 public:
  static constexpr bool kRecordsAreLines = true;

  explicit PlyText(const PlyHeader& header) : cursor_(header.end) {}

  bool next_record() {
    while (cursor_.next_line()) {
      TextCursor ahead = cursor_;
      if (!ahead.next_token().empty()) return true;
    }
    return false;
  }

  PlyValue read(PlyType, double& value) {
    switch (cursor_.next_number(value)) {
      case TextCursor::Token::Good:
        return PlyValue::Good;
      case TextCursor::Token::Bad:
        return PlyValue::Bad;
      case TextCursor::Token::Absent:
        break;
    }
    return PlyValue::Ended;
  }

  PlyValue skip(PlyType, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      if (cursor_.next_token().empty()) return PlyValue::Ended;
    }
    return PlyValue::Good;
  }

  [[nodiscard]] std::uint64_t bytes_left() const { return cursor_.bytes_left(); }
  [[nodiscard]] bool passed_line_limit() const { return cursor_.passed_line_limit(); }
  [[nodiscard]] std::uint64_t record() const { return cursor_.line(); }
  [[nodiscard]] scene::IssuePlace place() const {
    scene::IssuePlace place;
    place.line = cursor_.line();
    return place;
  }

  /// A value and its separator.
  static std::uint64_t least_bytes(const PlyProperty&) { return 2; }

 private:
  TextCursor cursor_;
};

template <std::endian kOrder>
class PlyBinary {
 public:
  static constexpr bool kRecordsAreLines = false;

  PlyBinary(std::string_view bytes, std::uint64_t offset) : bytes_(bytes), offset_(offset), record_(offset) {}

  bool next_record() {
    record_ = offset_;
    return bytes_left() > 0;
  }

  PlyValue read(PlyType type, double& value) {
    if (size_of(type) > bytes_left()) return PlyValue::Ended;
    value = number(type, bytes_.data() + offset_);
    offset_ += size_of(type);
    return PlyValue::Good;
  }

  PlyValue skip(PlyType type, std::uint64_t count) {
    if (count > bytes_left() / size_of(type)) {
      offset_ = bytes_.size();
      return PlyValue::Ended;
    }
    offset_ += count * size_of(type);
    return PlyValue::Good;
  }

  [[nodiscard]] std::uint64_t bytes_left() const { return bytes_.size() - offset_; }
  [[nodiscard]] bool passed_line_limit() const { return false; }
  [[nodiscard]] std::uint64_t record() const { return record_; }
  [[nodiscard]] scene::IssuePlace place() const {
    scene::IssuePlace place;
    place.byte_offset = record_;
    return place;
  }

  static std::uint64_t least_bytes(const PlyProperty& property) {
    return size_of(property.count_type.value_or(property.type));
  }

 private:
  static double number(PlyType type, const char* bytes) {
    switch (type) {
      case PlyType::Int8:
        return binary_number<std::int8_t, kOrder>(bytes);
      case PlyType::Uint8:
        return binary_number<std::uint8_t, kOrder>(bytes);
      case PlyType::Int16:
        return binary_number<std::int16_t, kOrder>(bytes);
      case PlyType::Uint16:
        return binary_number<std::uint16_t, kOrder>(bytes);
      case PlyType::Int32:
        return binary_number<std::int32_t, kOrder>(bytes);
      case PlyType::Uint32:
        return binary_number<std::uint32_t, kOrder>(bytes);
      case PlyType::Float32:
        return static_cast<double>(binary_number<float, kOrder>(bytes));
      case PlyType::Float64:
        return binary_number<double, kOrder>(bytes);
    }
    return 0;
  }

  std::string_view bytes_;
  std::uint64_t offset_;
  std::uint64_t record_;
};

}  // namespace rad::readers
