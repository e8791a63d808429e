// Wavefront OBJ.
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "readers/head_comments.h"
#include "readers/obj_corner.h"
#include "readers/obj_keywords.h"
#include "readers/obj_libraries.h"
#include "readers/obj_waivers.h"
#include "readers/reader.h"
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
  std::uint32_t smoothing_group = 0;
};

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
    scene::Scene scene = builder_.take();
    report_lost_rows();
    ReadResult result{std::move(scene), std::move(issues_), waivers_.take()};
    comments_.apply(result.scene);
    return result;
  }

 private:
  void read_line() {
    const std::string_view word = cursor_.next_token();
    if (word.empty()) return read_comment();
    const ObjKeyword& keyword = obj_keyword(word);
    known_statement_ |= keyword.statement != ObjStatement::Unknown;
    switch (keyword.statement) {
      case ObjStatement::Vertex:
        return read_vertex();
      case ObjStatement::TextureCoordinates:
        return read_texture_coordinates();
      case ObjStatement::Normal:
        return read_normal();
      case ObjStatement::Face:
        read_face();
        waivers_.face(cursor_.line());
        if (cursor_.at_comment()) waivers_.read_comment_behind_face(cursor_.rest(), cursor_.line());
        return;
      case ObjStatement::SmoothingGroup:
        return read_smoothing_group();
      case ObjStatement::Object:
        has_objects_ = true;
        waivers_.block(ObjWaivers::Block::Object, cursor_.line());
        return builder_.use_object(object_ = builder_.object(cursor_.rest()));
      case ObjStatement::Group:
        waivers_.block(ObjWaivers::Block::Group, cursor_.line());
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

  // A unit and a record belong to the head of the file: after the first vertex they are not looked for.
  void read_comment() {
    if (!cursor_.at_comment()) return;
    const std::string_view comment = cursor_.rest();
    waivers_.read_comment(comment, cursor_.line());
    if (builder_.vertex_count() == 0) comments_.read(comment);
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

  // What is no number makes the row, and with it the faces that name it, go without.
  void read_texture_coordinates() {
    scene::dvec2 value(kMissing, 0);
    for (int axis = 0; axis < 2; ++axis) {
      if (cursor_.next_number(value[axis]) == Token::Bad) value[axis] = kMissing;
    }
    if (has_room(builder_.scene().attributes.texture_coordinates.table.size())) builder_.add_texture_coordinates(value);
  }

  void read_normal() {
    scene::dvec3 value(kMissing);
    for (int axis = 0; axis < 3; ++axis) cursor_.next_number(value[axis]);
    if (has_room(builder_.scene().attributes.normals.table.size())) builder_.add_normal(value);
  }

  bool has_room(std::size_t rows) {
    if (rows < std::min<std::uint64_t>(input_.limits.vertices, kNoObjRow)) return true;
    stop("the limit of " + std::to_string(input_.limits.vertices) +
         " texture coordinates or normals is reached; the rest is left out");
    return false;
  }

  // "off" and what is no number mean none.
  void read_smoothing_group() {
    std::int64_t group = 0;
    const bool is_number = cursor_.next_integer(group) == Token::Good;
    smoothing_group_ = is_number && group > 0 && group <= std::numeric_limits<std::int32_t>::max()
                           ? static_cast<std::uint32_t>(group)
                           : 0;
    builder_.use_smoothing_group(smoothing_group_);
  }

  void read_face() {
    named_.clear();
    bool in_order = true;
    while (true) {
      const std::string_view token = cursor_.next_token();
      if (token.empty()) break;
      const auto corner = obj_corner(token);
      if (!corner) return refuse(in_quotes(token) + " is not a vertex index; the face is left out");
      const auto resolved = resolve(corner->vertex);
      if (!resolved) return;
      in_order &= *resolved < builder_.vertex_count();
      named_.vertices.push_back(*resolved);
      const scene::CornerAttributes& attributes = builder_.scene().attributes;
      named_.texture_rows.push_back(obj_row(corner->texture, attributes.texture_coordinates.table.size()));
      named_.normal_rows.push_back(obj_row(corner->normal, attributes.normals.table.size()));
      if (named_.size() > input_.limits.face_corners) return refuse_corners();
    }
    if (named_.vertices.empty()) return refuse("a face names no vertex; it is left out");
    // Once a face waits, all later ones do: faces keep the order of the file.
    if (in_order && waiting_.empty()) return add_now();
    waiting_.push_back(
        {waiting_corners_.size(), named_.size(), cursor_.line(), material_, object_, group_, smoothing_group_});
    waiting_corners_.append(named_);
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
    const std::string full = limit_before_face(builder_.scene(), named_.size(), input_.limits);
    if (!full.empty()) return stop(full);
    add_face(named_, 0, named_.size(), cursor_.line());
  }

  void add_face(const ObjCorners& corners, std::size_t first, std::size_t count, std::uint64_t line) {
    const auto vertices = std::span(corners.vertices).subspan(first, count);
    ids_.assign(vertices.begin(), vertices.end());
    builder_.add_face(ids_, line);
    const auto texture_rows = std::span(corners.texture_rows).subspan(first, count);
    if (names_rows(texture_rows)) builder_.set_texture_coordinates(texture_rows);
    const auto normal_rows = std::span(corners.normal_rows).subspan(first, count);
    if (names_rows(normal_rows)) builder_.set_normals(normal_rows);
  }

  // Whether there was room for it.
  bool add_waiting(const WaitingFace& face) {
    const auto vertices = std::span(waiting_corners_.vertices).subspan(face.first_index, face.index_count);
    const std::uint64_t largest = *std::max_element(vertices.begin(), vertices.end());
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
    builder_.use_smoothing_group(face.smoothing_group);
    add_face(waiting_corners_, face.first_index, face.index_count, face.line);
    return true;
  }

  void report_lost_rows() {
    const std::size_t faces = builder_.faces_without_rows();
    if (faces == 0) return;
    issues_.add({ReadIssueKind::UnsupportedContent,
                 "faces with texture coordinates or normals that are missing at some corners",
                 {},
                 faces});
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
  ObjWaivers waivers_;
  scene::MaterialId material_ = 0;
  std::string material_name_;
  std::map<scene::MaterialId, std::uint64_t> material_lines_;  // of the first use
  bool has_objects_ = false;
  scene::ObjectId object_ = 0;
  scene::GroupId group_ = 0;
  std::uint32_t smoothing_group_ = 0;
  ObjCorners named_;                  ///< of the face that is being read
  std::vector<scene::VertexId> ids_;  ///< its vertices
  std::vector<WaitingFace> waiting_;
  ObjCorners waiting_corners_;
  std::vector<std::string> unknown_;
  HeadComments comments_;
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
