#include "readers/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "readers/refusals.h"
#include "readers/waiver_comment.h"

namespace rad::readers {
namespace {

// Far above any use; without it, a hostile header would take time by the square of its length.
constexpr std::size_t kMostElements = 1000;

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 16> kTypeNames = {{
    {"char", PlyType::Int8},
    {"uchar", PlyType::Uint8},
    {"short", PlyType::Int16},
    {"ushort", PlyType::Uint16},
    {"int", PlyType::Int32},
    {"uint", PlyType::Uint32},
    {"float", PlyType::Float32},
    {"double", PlyType::Float64},
    {"int8", PlyType::Int8},
    {"uint8", PlyType::Uint8},
    {"int16", PlyType::Int16},
    {"uint16", PlyType::Uint16},
    {"int32", PlyType::Int32},
    {"uint32", PlyType::Uint32},
    {"float32", PlyType::Float32},
    {"float64", PlyType::Float64},
}};

std::optional<PlyType> type_named(std::string_view name) {
  const auto found = std::ranges::find(kTypeNames, name, &TypeName::name);
  return found == kTypeNames.end() ? std::nullopt : std::optional(found->type);
}

bool is_integer(PlyType type) { return type != PlyType::Float32 && type != PlyType::Float64; }

// A binary body may begin with a byte that looks like a line end, so that the first line says which kind is in use.
std::uint64_t offset_after_line(std::string_view bytes, std::uint64_t place) {
  const std::size_t first = bytes.find_first_of("\r\n");
  const bool lone_return = first != std::string_view::npos && bytes[first] == '\r' &&
                           (first + 1 == bytes.size() || bytes[first + 1] != '\n');
  const std::size_t line_end = bytes.find(lone_return ? '\r' : '\n', place);
  return line_end == std::string_view::npos ? bytes.size() : line_end + 1;
}

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const Limits& limits, scene::ReadIssues& issues)
      : bytes_(bytes), cursor_(bytes, limits.line_bytes), issues_(issues) {}

  std::optional<PlyHeader> run() {
    if (!cursor_.next_line() || cursor_.next_token() != "ply") return refuse("the file does not start with 'ply'");
    while (cursor_.next_line()) {
      const std::string_view word = cursor_.next_token();
      if (word == "end_header") return finished();
      if (!read_statement(word)) return std::nullopt;
    }
    return refuse("the header has no end_header");
  }

 private:
  bool read_statement(std::string_view word) {
    if (word == "comment") return read_comment();
    if (word.empty() || word == "obj_info") return true;
    if (word == "format") return read_format();
    if (word == "element") return read_element();
    if (word == "property") return read_property();
    scene::IssuePlace place;
    place.line = cursor_.line();
    issues_.add_unsupported("header lines of no known statement", std::move(place));
    return true;
  }

  bool read_comment() {
    const std::string_view comment = cursor_.rest();
    comments_.read(comment);
    // Faces follow as numbers only: a comment speaks of the file.
    if (auto read = waiver_of_comment(comment)) {
      read->waiver.place.line = cursor_.line();
      waivers_.push_back(std::move(read->waiver));
    }
    return true;
  }

  bool read_format() {
    const std::string_view name = cursor_.next_token();
    if (name == "ascii") {
      encoding_ = PlyEncoding::Text;
    } else if (name == "binary_little_endian") {
      encoding_ = PlyEncoding::LittleEndian;
    } else if (name == "binary_big_endian") {
      encoding_ = PlyEncoding::BigEndian;
    } else {
      return fail(in_quotes(name) + " is not a format of PLY");
    }
    return true;
  }

  bool read_element() {
    PlyElement element;
    element.name = cursor_.next_token();
    element.line = cursor_.line();
    std::int64_t count = 0;
    if (element.name.empty() || cursor_.next_integer(count) != TextCursor::Token::Good || count < 0) {
      return fail("an element needs a name and a count");
    }
    if (std::ranges::find(elements_, element.name, &PlyElement::name) != elements_.end()) {
      return fail("the element " + in_quotes(element.name) + " is declared twice");
    }
    if (elements_.size() == kMostElements) {
      return fail("the header declares more than " + std::to_string(kMostElements) + " elements");
    }
    element.count = static_cast<std::uint64_t>(count);
    elements_.push_back(std::move(element));
    return true;
  }

  bool read_property() {
    if (elements_.empty()) return fail("a property stands before the first element");
    PlyProperty property;
    std::string_view type = cursor_.next_token();
    if (type == "list") {
      const std::string_view count_name = cursor_.next_token();
      property.count_type = type_named(count_name);
      if (!property.count_type || !is_integer(*property.count_type)) {
        return fail(in_quotes(count_name) + " is not an integer type of PLY");
      }
      type = cursor_.next_token();
    }
    const auto value_type = type_named(type);
    if (!value_type) return fail(in_quotes(type) + " is not a type of PLY");
    property.type = *value_type;
    property.name = cursor_.next_token();
    elements_.back().properties.push_back(std::move(property));
    return true;
  }

  std::optional<PlyHeader> finished() {
    if (!encoding_) return refuse("the header names no format");
    return PlyHeader{*encoding_, std::move(elements_), cursor_, offset_after_line(bytes_, cursor_.offset()),
                     comments_,  std::move(waivers_)};
  }

  std::nullopt_t refuse(std::string what) {
    fail(std::move(what));
    return std::nullopt;
  }

  bool fail(std::string what) {
    issues_.add(issue_at_line(scene::ReadIssueKind::ParseError, std::move(what), cursor_.line()));
    return false;
  }

  std::string_view bytes_;
  TextCursor cursor_;
  scene::ReadIssues& issues_;
  std::optional<PlyEncoding> encoding_;
  std::vector<PlyElement> elements_;
  std::vector<scene::Waiver> waivers_;
  HeadComments comments_;
};

}  // namespace

std::uint64_t size_of(PlyType type) {
  switch (type) {
    case PlyType::Int8:
    case PlyType::Uint8:
      return 1;
    case PlyType::Int16:
    case PlyType::Uint16:
      return 2;
    case PlyType::Int32:
    case PlyType::Uint32:
    case PlyType::Float32:
      return 4;
    case PlyType::Float64:
      return 8;
  }
  return 8;
}

const PlyProperty* PlyElement::property(std::string_view wanted) const {
  const auto found = std::ranges::find(properties, wanted, &PlyProperty::name);
  return found == properties.end() ? nullptr : &*found;
}

std::optional<PlyHeader> read_ply_header(std::string_view bytes, const Limits& limits, scene::ReadIssues& issues) {
  return HeaderReader(bytes, limits, issues).run();
}

}  // namespace rad::readers
