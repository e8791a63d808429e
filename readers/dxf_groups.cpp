#include "readers/dxf_groups.h"

#include <limits>

#include "readers/refusals.h"

namespace rad::readers::dxf {
namespace {

constexpr int kComment = 999;
constexpr int kEmbeddedObject = 101;
constexpr int kFirstExtendedData = 1000;
// Of names: the DXF reference allows 255. A longer one, copied to all that a block is placed for, could take any
// memory.
constexpr std::size_t kLongestText = 255;

}  // namespace

bool Groups::next() {
  if (held_) {
    held_ = false;
    return true;
  }
  while (problem_.empty() && cursor_.next_line()) {
    const std::string_view code_text = cursor_.rest();
    const auto code = parse_integer(code_text);
    if (!code || *code < -5 || *code > 1071) {
      // Blank lines at the end of a file are common.
      if (!code_text.empty() || cursor_.bytes_left() > 2) problem_ = in_quotes(code_text) + " is not a group code";
      return false;
    }
    if (!cursor_.next_line()) {
      problem_ = "the file ends within a group";
      return false;
    }
    group_ = {static_cast<int>(*code), cursor_.rest(), cursor_.line()};
    if (group_.code != kComment) return true;
  }
  if (problem_.empty() && cursor_.passed_line_limit()) problem_ = "a line is longer than the limit";
  return false;
}

void Entity::read(Groups& groups) {
  type_ = groups.group().value;
  line_ = groups.group().line;
  groups_.clear();
  bool embedded = false;
  while (groups.next()) {
    const Group& group = groups.group();
    if (group.code == 0) {
      groups.step_back();
      return;
    }
    // What follows is an object of its own, whose codes mean other things.
    embedded |= group.code == kEmbeddedObject;
    if (!embedded && group.code < kFirstExtendedData) groups_.push_back(group);
  }
}

const Group* Entity::find(int code) const {
  for (const Group& group : groups_) {
    if (group.code == code) return &group;
  }
  return nullptr;
}

std::string_view Entity::text(int code) const {
  const Group* const group = find(code);
  return group == nullptr ? std::string_view() : group->value.substr(0, kLongestText);
}

void Entity::refuse(const Group& group) const {
  issues_.add(issue_at_line(scene::ReadIssueKind::ParseError, in_quotes(group.value) + " is not a number", group.line));
}

double Entity::number_of(const Group& group) const {
  if (const auto number = parse_number(group.value)) return *number;
  refuse(group);
  return std::numeric_limits<double>::quiet_NaN();
}

std::int64_t Entity::integer_of(const Group& group) const {
  if (const auto number = parse_integer(group.value)) return *number;
  refuse(group);
  return 0;
}

double Entity::number(int code, double otherwise) const {
  const Group* const group = find(code);
  return group == nullptr ? otherwise : number_of(*group);
}

std::int64_t Entity::integer(int code, std::int64_t otherwise) const {
  const Group* const group = find(code);
  return group == nullptr ? otherwise : integer_of(*group);
}

dvec3 Entity::point(int code, const dvec3& otherwise) const {
  return {number(code, otherwise.x), number(code + 10, otherwise.y), number(code + 20, otherwise.z)};
}

}  // namespace rad::readers::dxf
