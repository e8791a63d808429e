// Groups of a DXF file, pairs of a code and a value on a line each, and the entities that they make.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/vec.h"
#include "readers/text_cursor.h"
#include "scene/read_issue.h"

namespace rad::readers::dxf {

using geom::dvec3;

struct Group {
  int code = 0;
  std::string_view value;  ///< without blanks around it
  std::uint64_t line = 0;  ///< of the value

  [[nodiscard]] bool starts(std::string_view record) const { return code == 0 && value == record; }
};

/// Walks over the groups; comments (code 999) are passed over. Copies go on from the same place.
class Groups {
 public:
  Groups(std::string_view text, std::uint64_t line_limit) : cursor_(text, line_limit) {}

  /// Steps to the next group. False at the end of the text, or where a line is no group code: then problem() says why.
  bool next();
  /// Lets the next call of next() stay at this group.
  void step_back() { held_ = true; }
  [[nodiscard]] const Group& group() const { return group_; }
  [[nodiscard]] const std::string& problem() const { return problem_; }
  [[nodiscard]] std::uint64_t line() const { return cursor_.line(); }
  [[nodiscard]] std::uint64_t offset() const { return cursor_.offset(); }

 private:
  TextCursor cursor_;
  Group group_;
  std::string problem_;
  bool held_ = false;
};

/// The groups of one record, from its code 0 to the next one. Numbers that cannot be read are NaN and ParseErrors.
class Entity {
 public:
  /// Reads the record that `groups` stands at the start of; `groups` then stands before the next record.
  Entity(Groups& groups, scene::ReadIssues& issues) : issues_(issues) { read(groups); }
  /// Makes this the record that `groups` stands at the start of, in the same memory.
  void read(Groups& groups);

  [[nodiscard]] std::string_view type() const { return type_; }
  [[nodiscard]] std::uint64_t line() const { return line_; }  ///< of its type
  [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }

  /// The first group of a code.
  [[nodiscard]] const Group* find(int code) const;
  [[nodiscard]] std::string_view text(int code) const;  ///< at most 255 bytes
  [[nodiscard]] double number(int code, double otherwise = 0) const;
  [[nodiscard]] std::int64_t integer(int code, std::int64_t otherwise = 0) const;
  /// Codes `code`, `code` + 10 and `code` + 20.
  [[nodiscard]] dvec3 point(int code, const dvec3& otherwise = {0, 0, 0}) const;

  /// The value of a group of this entity as a number.
  [[nodiscard]] double number_of(const Group& group) const;
  [[nodiscard]] std::int64_t integer_of(const Group& group) const;

 private:
  void refuse(const Group& group) const;

  std::string_view type_;
  std::uint64_t line_ = 0;
  std::vector<Group> groups_;
  scene::ReadIssues& issues_;
};

}  // namespace rad::readers::dxf
