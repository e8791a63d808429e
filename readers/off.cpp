// OFF of Geomview, as text.
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "readers/head_comments.h"
#include "readers/reader.h"
#include "readers/refusals.h"
#include "readers/text_cursor.h"
#include "readers/waiver_comment.h"
#include "scene/scene_builder.h"

namespace rad::readers {

extern const Reader off_reader;

namespace {

using scene::ReadIssueKind;
using Token = TextCursor::Token;

constexpr std::array<std::string_view, 4> kSuffixes = {".off", ".coff", ".noff", ".cnoff"};
// "0 0 0" and a line end, "0" and a line end: no record is shorter.
constexpr std::uint64_t kLeastVertexBytes = 6;
constexpr std::uint64_t kLeastFaceBytes = 2;

/// What the first word of a file says: [ST][C][N][4][n]OFF.
struct Heading {
  bool is_four_dimensional = false;
  bool is_of_any_dimension = false;
};

std::optional<Heading> heading_of(std::string_view word) {
  Heading heading;
  const auto take = [&](std::string_view prefix) {
    const bool found = word.starts_with(prefix);
    if (found) word.remove_prefix(prefix.size());
    return found;
  };
  take("ST");
  take("C");
  take("N");
  heading.is_four_dimensional = take("4");
  heading.is_of_any_dimension = take("n");
  if (word != "OFF") return std::nullopt;
  return heading;
}

class OffReader {
 public:
  explicit OffReader(const Input& input)
      : input_(input), cursor_(input.bytes, input.limits.line_bytes), builder_(input.path, "off") {
    builder_.add_section({input.path, {}, scene::RecordKind::Line});
  }

  ReadResult run() {
    if (read_heading() && read_counts() && fits()) {
      builder_.scene().vertices.reserve(vertices_);
      builder_.scene().vertex_records.reserve(vertices_);
      read_vertices();
    }
    if (cursor_.passed_line_limit()) {
      refuse("a line is longer than the limit of " + std::to_string(input_.limits.line_bytes) +
             " bytes; the rest is left out");
    }
    ReadResult result{builder_.take(), std::move(issues_), std::move(waivers_)};
    comments_.apply(result.scene);
    return result;
  }

 private:
  // Steps to the next line that holds more than blanks and a comment. The word that starts it is not consumed.
  bool next_record() {
    while (cursor_.next_line()) {
      TextCursor ahead = cursor_;
      if (!ahead.next_token().empty()) return true;
      const std::string_view comment = ahead.rest();
      read_waiver(comment, ahead.line());
      if (builder_.vertex_count() == 0) comments_.read(comment);
    }
    return false;
  }

  // Without blocks that it could speak of, a comment speaks of the file.
  void read_waiver(std::string_view comment, std::uint64_t line) {
    auto read = waiver_of_comment(comment);
    if (!read) return;
    read->waiver.place.line = line;
    waivers_.push_back(std::move(read->waiver));
  }

  // The word OFF may be missing: then the counts come first.
  bool read_heading() {
    if (!next_record()) return refuse("the file holds no OFF header");
    TextCursor ahead = cursor_;
    const std::string_view word = ahead.next_token();
    if (parse_integer(word)) return true;
    const auto heading = heading_of(word);
    if (!heading) return refuse(in_quotes(word) + " is not an OFF header");
    if (heading->is_four_dimensional) return refuse("4OFF (four coordinates) is not read; export OFF");
    if (heading->is_of_any_dimension) return refuse("nOFF (any number of coordinates) is not read; export OFF");
    cursor_ = ahead;
    if (ahead.next_token() == "BINARY") return refuse("binary OFF is not read; export OFF as text, or PLY");
    return true;
  }

  bool read_counts() {
    std::int64_t vertices = 0;
    Token token = cursor_.next_integer(vertices);
    if (token == Token::Absent && next_record()) token = cursor_.next_integer(vertices);
    std::int64_t faces = 0;
    const bool good = token == Token::Good && cursor_.next_integer(faces) == Token::Good;
    if (!good || vertices < 0 || faces < 0) return refuse("the header does not state counts of vertices and faces");
    vertices_ = static_cast<std::uint64_t>(vertices);
    faces_ = static_cast<std::uint64_t>(faces);
    return true;
  }

  // Vertices that cannot be there are not looked for. Missing faces are: what is there can still be judged.
  bool fits() {
    const std::uint64_t left = cursor_.bytes_left();
    if (vertices_ > input_.limits.vertices || vertices_ > left / kLeastVertexBytes + 1) {
      return refuse("the header states " + std::to_string(vertices_) + " vertices, the " + std::to_string(left) +
                    " bytes that follow cannot hold them");
    }
    if (faces_ > left / kLeastFaceBytes + 1) {
      refuse("the header states " + std::to_string(faces_) + " faces, the " + std::to_string(left) +
             " bytes that follow cannot hold them");
    }
    return true;
  }

  void read_vertices() {
    for (std::uint64_t i = 0; i < vertices_; ++i) {
      if (!next_record()) return end_early("vertices", i, vertices_);
      read_vertex();
    }
    for (std::uint64_t i = 0; i < faces_; ++i) {
      if (!next_record()) return end_early("faces", i, faces_);
      if (!read_face()) return;
    }
  }

  void read_vertex() {
    scene::dvec3 position(std::numeric_limits<double>::quiet_NaN());
    for (int axis = 0; axis < 3; ++axis) {
      const Token token = cursor_.next_number(position[axis]);
      if (token == Token::Good) continue;
      refuse(token == Token::Bad ? in_quotes(cursor_.bad_token()) + " is not a number"
                                 : "a vertex needs three coordinates, this one has " + std::to_string(axis));
      if (token == Token::Absent) break;
    }
    builder_.add_vertex(position, cursor_.line());
  }

  // Whether there was room for it. A colour that follows the indices is not looked at.
  bool read_face() {
    std::int64_t count = 0;
    const Token token = cursor_.next_integer(count);
    if (token != Token::Good || count < 1 || static_cast<std::uint64_t>(count) > input_.limits.face_corners) {
      refuse("a face does not start with the number of its vertices; it is left out");
      return true;
    }
    corners_.clear();
    for (std::int64_t i = 0; i < count; ++i) {
      if (!read_corner()) return true;
    }
    std::string full = limit_before_face(builder_.scene(), corners_.size(), input_.limits);
    if (!full.empty()) return refuse(std::move(full));
    builder_.add_face(corners_, cursor_.line());
    return true;
  }

  bool read_corner() {
    std::int64_t index = 0;
    const Token token = cursor_.next_integer(index);
    if (token == Token::Absent) return refuse("a face names fewer vertices than it states; it is left out");
    if (token == Token::Bad) {
      return refuse(in_quotes(cursor_.bad_token()) + " is not a vertex index; the face is left out");
    }
    if (index >= 0 && static_cast<std::uint64_t>(index) < builder_.vertex_count()) {
      corners_.push_back(static_cast<scene::VertexId>(index));
      return true;
    }
    issues_.add(
        issue_at_line(ReadIssueKind::IndexOutOfRange, index_outside(index, builder_.vertex_count()), cursor_.line()));
    return false;
  }

  void end_early(std::string_view records, std::uint64_t read, std::uint64_t stated) {
    if (cursor_.passed_line_limit()) return;
    refuse("the file ends after " + std::to_string(read) + " of " + std::to_string(stated) + " " +
           std::string(records));
  }

  bool refuse(std::string what) {
    issues_.add(issue_at_line(ReadIssueKind::ParseError, std::move(what), cursor_.line()));
    return false;
  }

  const Input& input_;
  TextCursor cursor_;
  scene::SceneBuilder builder_;
  scene::ReadIssues issues_;
  std::vector<scene::Waiver> waivers_;
  HeadComments comments_;
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
  std::vector<scene::VertexId> corners_;
};

bool sniff(std::string_view head) {
  TextCursor cursor(head);
  while (cursor.next_line()) {
    const std::string_view word = cursor.next_token();
    if (!word.empty()) return heading_of(word).has_value();
  }
  return false;
}

ReadResult read(const Input& input) { return OffReader(input).run(); }

}  // namespace

const Reader off_reader{"off", kSuffixes, sniff, read};

}  // namespace rad::readers
