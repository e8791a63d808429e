// Wavefront OBJ.
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "readers/obj_keywords.h"
#include "readers/obj_libraries.h"
#include "readers/obj_unit_comment.h"
#include "readers/reader.h"
#include "readers/recorded_comment.h"
#include "readers/refusals.h"
#include "readers/text_cursor.h"
#include "scene/scene_builder.h"

namespace rad::readers {

extern const Reader obj_reader;

namespace {

using scene::ReadIssueKind;
using Token = TextCursor::Token;

constexpr std::array<std::string_view, 1> kSuffixes = {".obj"};
constexpr std::size_t kNamedUnknownKeywords = 5;
constexpr std::uint64_t kNamedMaterials = 5;
constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// A face that waits for the end of the file, because it names a vertex that was not read before it.
struct WaitingFace {
  std::size_t first_index = 0;
  std::size_t index_count = 0;
  std::uint64_t line = 0;
  scene::MaterialId material = 0;
  scene::ObjectId object = 0;
  scene::GroupId group = 0;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// What may follow the vertex number of a corner: indices of texture coordinates and normals, which are not looked at.
bool is_sound_tail(std::string_view tail) {
  return std::ranges::all_of(tail, [](char c) { return is_digit(c) || c == '/' || c == '-' || c == '+'; });
}

/// Vertex number of "7", "7/1", "7//3" or "7/1/3"; nothing where the token is none of these.
std::optional<std::int64_t> vertex_of_corner(std::string_view token) {
  // Nearly every index is a few plain digits: read here, at a fraction of the general price.
  constexpr std::size_t kPlainDigits = 18;
  std::int64_t index = 0;
  std::size_t length = 0;
  for (; length < token.size() && length < kPlainDigits && is_digit(token[length]); ++length) {
    index = index * 10 + (token[length] - '0');
  }
  const bool is_plain = length > 0 && (length == token.size() || token[length] == '/');
  if (!is_plain) length = std::min(token.find('/'), token.size());
  if (!is_sound_tail(token.substr(length))) return std::nullopt;
  return is_plain ? index : parse_integer(token.substr(0, length));
}

class ObjReader {
 public:
  explicit ObjReader(const Input& input)
      : input_(input),
        cursor_(input.bytes, input.limits.line_bytes, TextCursor::Continuation::Backslash),
        builder_(input.path, "obj"),
        libraries_(input, builder_, issues_) {
    builder_.add_section({input.path, {}, scene::RecordKind::Line});
  }

  ReadResult run() {
    while (!stopped_ && cursor_.next_line()) read_line();
    if (cursor_.passed_line_limit()) {
      stop("a line is longer than the limit of " + std::to_string(input_.limits.line_bytes) +
           " bytes; the rest is left out");
    }
    for (const WaitingFace& face : waiting_) {
      if (!add_waiting(face)) break;
    }
    report_unknown_keywords();
    report_undefined_materials();
    ReadResult result{builder_.take(), std::move(issues_)};
    if (!unit_conflict_) result.scene.metres_per_unit = metres_;
    return result;
  }

 private:
  void read_line() {
    const std::string_view word = cursor_.next_token();
    if (word.empty()) {
      if (builder_.vertex_count() == 0) read_head_comment();
      return;
    }
    const ObjKeyword& keyword = obj_keyword(word);
    known_statement_ |= keyword.statement != ObjStatement::Unknown;
    switch (keyword.statement) {
      case ObjStatement::Vertex:
        return read_vertex();
      case ObjStatement::Face:
        return read_face();
      case ObjStatement::Object:
        has_objects_ = true;
        return builder_.use_object(object_ = builder_.object(cursor_.rest()));
      case ObjStatement::Group:
        return use_group(group_name());
      case ObjStatement::UseMaterial:
        return use_material(cursor_.rest());
      case ObjStatement::MaterialLibrary:
        return libraries_.use(cursor_.rest(), cursor_.line());
      case ObjStatement::Harmless:
        return;
      case ObjStatement::Unsupported:
        return issues_.add_unsupported(std::string(keyword.what), place());
      case ObjStatement::Unknown:
        return count_unknown(word);
    }
  }

  // Comments after the first vertex are not looked at: a unit and a record belong to the head of the file.
  void read_head_comment() {
    const std::string_view comment = cursor_.rest();
    if (const auto record = record_of_comment(comment)) builder_.scene().recorded = record;
    const auto metres = metres_of_comment(comment);
    if (!metres) return;
    unit_conflict_ |= metres_ && *metres_ != *metres;
    metres_ = metres;
  }

  void read_vertex() {
    const std::string full = limit_before_vertices(builder_.scene(), 1, input_.limits);
    if (!full.empty()) return stop(full);
    scene::dvec3 position(kMissing);
    for (int axis = 0; axis < 3; ++axis) {
      const Token token = cursor_.next_number(position[axis]);
      if (token == Token::Good) continue;
      refuse(token == Token::Bad ? in_quotes(cursor_.bad_token()) + " is not a number"
                                 : "a vertex needs three coordinates, this one has " + std::to_string(axis));
      if (token == Token::Absent) break;
    }
    builder_.add_vertex(position, cursor_.line());
  }

  void read_face() {
    indices_.clear();
    bool in_order = true;
    while (true) {
      const std::string_view token = cursor_.next_token();
      if (token.empty()) break;
      const auto index = vertex_of_corner(token);
      if (!index) return refuse(in_quotes(token) + " is not a vertex index; the face is left out");
      const auto resolved = resolve(*index);
      if (!resolved) return;
      in_order &= *resolved < builder_.vertex_count();
      indices_.push_back(*resolved);
      if (indices_.size() > input_.limits.face_corners) return refuse_corners();
    }
    if (indices_.empty()) return refuse("a face names no vertex; it is left out");
    // Once a face waits, all later ones do: faces keep the order of the file.
    if (in_order && waiting_.empty()) return add_now();
    waiting_.push_back({waiting_indices_.size(), indices_.size(), cursor_.line(), material_, object_, group_});
    waiting_indices_.insert(waiting_indices_.end(), indices_.begin(), indices_.end());
  }

  // 0-based vertex that an index means; it may not be read yet. Nothing, with an issue, where there can be none.
  std::optional<std::uint64_t> resolve(std::int64_t index) {
    const auto count = static_cast<std::int64_t>(builder_.vertex_count());
    if (index > 0) return static_cast<std::uint64_t>(index - 1);
    if (index < 0 && index >= -count) return static_cast<std::uint64_t>(count + index);
    add_issue(ReadIssueKind::IndexOutOfRange,
              index == 0 ? "vertex index 0 is not valid, vertices count from 1"
                         : "vertex index " + std::to_string(index) + " reaches before the first of the " +
                               std::to_string(count) + " vertices read so far",
              cursor_.line());
    return std::nullopt;
  }

  void add_now() {
    corners_.assign(indices_.begin(), indices_.end());
    const std::string full = limit_before_face(builder_.scene(), corners_.size(), input_.limits);
    if (!full.empty()) return stop(full);
    builder_.add_face(corners_, cursor_.line());
  }

  // Whether there was room for it.
  bool add_waiting(const WaitingFace& face) {
    const auto first = waiting_indices_.begin() + static_cast<std::ptrdiff_t>(face.first_index);
    const auto last = first + static_cast<std::ptrdiff_t>(face.index_count);
    const std::uint64_t largest = *std::max_element(first, last);
    if (largest >= builder_.vertex_count()) {
      add_issue(ReadIssueKind::IndexOutOfRange,
                index_beyond(static_cast<std::int64_t>(largest + 1), builder_.vertex_count()), face.line);
      return true;
    }
    const std::string full = limit_before_face(builder_.scene(), face.index_count, input_.limits);
    if (!full.empty()) {
      add_issue(ReadIssueKind::ParseError, full, face.line);
      return false;
    }
    builder_.use_material(face.material);
    builder_.use_object(face.object);
    builder_.use_group(face.group);
    corners_.assign(first, last);
    builder_.add_face(corners_, face.line);
    return true;
  }

  // Several names mean several groups; joined by one blank they are the name of one here.
  std::string group_name() {
    std::string name;
    for (const char c : cursor_.rest()) {
      const bool is_blank = c == ' ' || c == '\t';
      if (!is_blank || name.empty() || name.back() != ' ') name += is_blank ? ' ' : c;
    }
    return name;
  }

  // Many exporters write a group for each object and no objects: until the first `o`, groups name objects too.
  void use_group(const std::string& name) {
    builder_.use_group(group_ = builder_.group(name));
    if (!has_objects_) builder_.use_object(object_ = builder_.object(name));
  }

  void use_material(std::string_view name) {
    if (name != material_name_) {
      material_name_ = name;
      material_ = builder_.material(name);
      material_lines_.try_emplace(material_, cursor_.line());
    }
    builder_.use_material(material_);
  }

  // A missing library has been reported where it was named; materials are reported where no library was.
  void report_undefined_materials() {
    if (issues_.any(ReadIssueKind::MissingResource)) return;
    std::string names;
    std::uint64_t line = 0, count = 0;
    for (const auto& [material, first_line] : material_lines_) {
      if (material == 0 || libraries_.defines(material)) continue;
      if (count == 0) line = first_line;
      if (count < kNamedMaterials) names += (count == 0 ? "" : ", ") + in_quotes(builder_.material_at(material).name);
      ++count;
    }
    if (count == 0) return;
    if (count > kNamedMaterials) names += " and " + std::to_string(count - kNamedMaterials) + " more";
    issues_.add({ReadIssueKind::MissingResource, "no material library defines " + names, {{}, line, {}, {}}, count});
  }

  void count_unknown(std::string_view word) {
    const auto known = std::ranges::find(unknown_, in_quotes(word));
    if (known != unknown_.end() || unknown_.size() < kNamedUnknownKeywords) {
      if (known == unknown_.end()) unknown_.push_back(in_quotes(word));
      issues_.add_unsupported("statements with the unknown keyword " + in_quotes(word), place());
    } else {
      issues_.add_unsupported("statements with further unknown keywords", place());
    }
  }

  void report_unknown_keywords() {
    if (unknown_.empty() || known_statement_) return;
    issues_.add(issue_at_line(ReadIssueKind::ParseError, "the file holds no statement of OBJ", 1));
  }

  void refuse_corners() {
    refuse("a face has more corners than the limit of " + std::to_string(input_.limits.face_corners) +
           "; it is left out");
  }

  void refuse(std::string what) { add_issue(ReadIssueKind::ParseError, std::move(what), cursor_.line()); }

  void stop(std::string what) {
    stopped_ = true;
    refuse(std::move(what));
  }

  void add_issue(ReadIssueKind kind, std::string what, std::uint64_t line) {
    issues_.add(issue_at_line(kind, std::move(what), line));
  }

  [[nodiscard]] scene::IssuePlace place() const {
    scene::IssuePlace place;
    place.line = cursor_.line();
    return place;
  }

  const Input& input_;
  TextCursor cursor_;
  scene::SceneBuilder builder_;
  scene::ReadIssues issues_;
  ObjLibraries libraries_;
  scene::MaterialId material_ = 0;
  std::string material_name_;
  std::map<scene::MaterialId, std::uint64_t> material_lines_;  // of the first use
  bool has_objects_ = false;
  scene::ObjectId object_ = 0;
  scene::GroupId group_ = 0;
  std::vector<std::uint64_t> indices_;
  std::vector<scene::VertexId> corners_;
  std::vector<WaitingFace> waiting_;
  std::vector<std::uint64_t> waiting_indices_;
  std::vector<std::string> unknown_;
  std::optional<double> metres_;
  bool unit_conflict_ = false;
  bool known_statement_ = false;
  bool stopped_ = false;
};

// Every whole line at the head is a statement of OBJ or a comment, and one of them a vertex.
bool sniff(std::string_view head) {
  const std::size_t last_line_end = head.find_last_of("\r\n");
  if (last_line_end == std::string_view::npos || head.find('\0') != std::string_view::npos) return false;
  TextCursor cursor(head.substr(0, last_line_end));
  bool has_vertex = false;
  while (cursor.next_line()) {
    const std::string_view word = cursor.next_token();
    if (word.empty()) continue;
    const ObjStatement statement = obj_keyword(word).statement;
    if (statement == ObjStatement::Unknown) return false;
    double value = 0;
    has_vertex |= statement == ObjStatement::Vertex && cursor.next_number(value) == Token::Good;
  }
  return has_vertex;
}

ReadResult read(const Input& input) {
  const std::size_t zero = input.bytes.substr(0, kSniffBytes).find('\0');
  if (zero == std::string_view::npos) return ObjReader(input).run();
  ReadResult result;
  result.scene = scene::empty_scene(input.path, "obj");
  result.issues.add(issue_at_byte(ReadIssueKind::ParseError, "OBJ is text, this file is not", zero));
  return result;
}

}  // namespace

const Reader obj_reader{"obj", kSuffixes, sniff, read};

}  // namespace rad::readers
